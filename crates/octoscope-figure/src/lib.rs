//! What is to be seen of a traversal, as values: [`marks`] in world space,
//! each with a [`Role`]; a [`Camera`] that brings them to a [`Page`]; a
//! [`Style`] for every role in every [`Theme`].
//!
//! The crate knows no window, file, clock or graphics card.

mod camera;
mod mark;
mod marks;
mod palette;
mod role;
mod style;

pub use camera::{Camera, Lens, Page, Projected};
pub use mark::{Mark, Shape};
pub use marks::{Show, leaves, marks};
pub use palette::{Colour, Palette, Theme, contrast};
pub use role::Role;
pub use style::{Dash, Lettering, Style, Weight};
