//! Maps of rays: for every place of a picture one ray, and what becomes of it.

mod asked;
mod colour;
mod drawing;
mod measure;

pub use asked::{Asked, Colouring, Rays};
pub use colour::{Scale, colours};
pub use drawing::{Drawing, Maps, Raster};
