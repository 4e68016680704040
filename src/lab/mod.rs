//! The bench lab: what is chosen of the published comparison, what is shown of its
//! results, and what is saved.

mod choice;
mod shown;
mod write;

pub use choice::{Choice, Tab};
pub use shown::{SIZE_OF_FILES, figure, figure_in};
pub use write::{ENDINGS, Ending, write};
