//! The record of one run, the debugger's state at any point of it, and what it
//! has cost until then.

mod counters;
mod moment;
mod record;

pub use counters::{Counter, Counters};
pub use moment::{Codes, Difference, Exits, Frame, LeafOnRay, Moment, RootClip, Target};
pub use record::{Trace, record};
