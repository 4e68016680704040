//! Charts of what was measured, each a pure function from results to a [`Figure`].

mod growth;
mod marker;
mod names;
mod numbers;
mod processor;
mod published;
mod scenes;

#[cfg(doc)]
use crate::Figure;
pub use growth::{Growth, growth_chart, growth_least_height};
pub use names::{scene_name, way_name};
pub use numbers::{Above, Titled, growth_and_numbers, numbers_chart};
pub use processor::processor_chart;
pub use published::{published_chart, verdict};
pub use scenes::scenes_chart;
