//! Exporting what a view shows: a [`Request`] is the same from the window and from
//! the command line.

mod choice;
mod format;
mod frames;
mod made;
mod moving;
mod order;
mod origin;
mod preview;
mod request;
mod size;
mod steps;
mod table;
mod write;

pub use choice::{Choice, ExerciseChoice, Extent, MomentChoice, StepChoice};
pub use format::Format;
pub use order::Order;
pub use origin::Origin;
pub use preview::{OneOf, Preview};
pub use request::{Request, shell_line};
pub use size::Size;
pub use steps::{MOST_STEPS, Steps, StepsError};
pub use write::{Series, write};
