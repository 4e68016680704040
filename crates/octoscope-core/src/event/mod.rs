//! What algorithms tell of themselves: events, who watches them, how they end.

mod about;
mod halves;
mod lookup;
mod observer;
mod outcome;
mod search;
mod steps;

pub use halves::Halves;
pub use lookup::Lookup;
pub use observer::Observer;
pub use outcome::{End, Outcome};
pub use search::Search;
pub use steps::Event;
