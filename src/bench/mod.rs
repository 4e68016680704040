//! The bench: algorithms × scenes × depths, measured in one run. A [`Plan`] is the
//! same from the command line and from the window.

mod plan;
mod run;
mod table;

pub use plan::{MOST_DEPTH, MOST_RAYS, MOST_REPEATS, Plan};
pub use run::run;
pub use table::{Column, GROUPS, csv, markdown, summary, text};
