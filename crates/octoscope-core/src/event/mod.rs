//! What algorithms tell of themselves: events, who watches them, how they end.

mod about;
mod observer;
mod outcome;
mod steps;

pub use observer::Observer;
pub use outcome::{End, Outcome};
pub use steps::{Event, Halves, Lookup, Search};
