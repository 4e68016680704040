//! The record of one run, the debugger's state at any point of it, and what it
//! has cost until then.

mod counters;
mod moment;
mod record;
mod state;

pub use counters::{Counter, Counters};
pub use moment::Moment;
pub use record::{Trace, record, record_within};
pub use state::{
    Codes, Cuts, Detour, Difference, Exits, Extent, Frame, GridCell, LeafOnRay, RootClip, Target,
};
