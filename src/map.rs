//! Maps of rays: for every place of a picture one ray, and what becomes of it.

mod asked;
mod axes;
mod colour;
mod drawing;
mod measure;

pub use asked::{Asked, Colouring, Rays};
pub use axes::{Axis, Tick};
pub use colour::{Scale, colours};
pub use drawing::{Drawing, Maps, Raster};
pub use measure::{NOTHING, RIGHT, UNKNOWN, WRONG};
