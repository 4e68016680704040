//! The bench lab: the published comparison, repeated in the window.

mod choice;
mod page;
mod settings;
mod shown;
mod write;

pub use choice::{Choice, Tab};
pub use page::{Answer, Shown, State, ui};
pub use shown::{SIZE_OF_FILES, figure, lines};
pub use write::{ENDINGS, Ending, write};
