//! What trees are built from.

mod colour;
mod content;
mod cube;
pub mod made;
mod solids;

pub use colour::{leaf_colours, mean_colour, pixels_of};
pub use content::{Content, Image, Sphere};
pub use cube::{Cube, fit_domain};
