//! The record of one run, the debugger's state at any point of it, what it has
//! cost until then, what has become of every node, and where doubles would err.

mod counters;
mod fate;
mod moment;
mod reason;
mod record;
mod right;
mod rounding;
mod state;

pub use counters::{Counter, Counters};
pub use fate::{Fate, deciding_fate, fate};
pub use moment::Moment;
pub use reason::{Crossing, ParentPlane, Reason, met};
pub use record::{Trace, record, record_within};
pub(crate) use right::{corrected, on_the_ray, results, slivers};
pub use rounding::{Disagreement, double_would_differ, rounded_steps};
pub use state::{
    Codes, Cuts, Detour, Difference, Exits, Extent, Frame, GridCell, HalvingPlane, LeafOnRay,
    RootClip, Target, Towards,
};
