//! The record of one run, the debugger's state at any point of it, what it has
//! cost until then, and what has become of every node.

mod counters;
mod fate;
mod moment;
mod record;
mod state;

pub use counters::{Counter, Counters};
pub use fate::{Crossing, Fate, ParentPlane, Reason, deciding_fate, fate};
pub use moment::Moment;
pub use record::{Trace, record, record_within};
pub use state::{
    Codes, Cuts, Detour, Difference, Exits, Extent, Frame, GridCell, HalvingPlane, LeafOnRay,
    RootClip, Target, Towards,
};
