//! What is to be seen of a traversal, as values: [`marks`] in world space,
//! each with a [`Role`]; a [`Camera`] that brings them to a [`Page`]; a
//! [`Style`] for every role in every [`Theme`]; a [`Figure`] of shapes on the
//! page, which [`svg`] and [`png`] write.
//!
//! The crate knows no window, file, clock or graphics card.

mod camera;
mod content;
mod depth_map;
mod diagram;
mod figure;
pub mod fonts;
mod ground;
mod handle;
mod mark;
mod marks;
pub mod metrics;
mod numbers;
mod painter;
mod palette;
mod parts;
mod png;
mod role;
mod sides;
mod space;
mod style;
mod svg;
pub mod views;
mod ways;

pub use camera::{Camera, Lens, Page, Projected};
pub use content::{axes, content};
pub use diagram::{Diagram, DiagramLens, DiagramNode, DiagramOf, NodeKind, tree_diagram};
pub use figure::{Anchor, Drawn, Extent, Figure, Form, Part};
pub use handle::HANDLE_DISTANCE;
pub use mark::{Mark, Shape};
pub use marks::{Show, far_end, leaves, marks};
pub use palette::{Colour, Palette, Theme, contrast};
pub use png::{PngError, png, png_of_pixels};
pub use role::Role;
pub use space::space_figure;
pub use style::{Dash, Lettering, Style, Weight};
pub use svg::{Background, SvgOptions, svg, svg_scaled};
