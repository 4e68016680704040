//! What is to be seen of a traversal, as values: [`marks`] in world space,
//! each with a [`Role`]; a [`Camera`] that brings them to a [`Page`]; a
//! [`Style`] for every role in every [`Theme`]; a [`Figure`] of shapes on the
//! page, which [`svg`], [`pdf`], [`png`] and [`tikz`] write, and [`Gif`] and
//! [`Apng`] one after the other.
//!
//! The crate knows no window, file, clock or graphics card.

mod axes;
mod camera;
mod cells;
mod changes;
mod colours;
mod content;
mod dashes;
mod depth_map;
mod diagram;
mod figure;
mod flight;
pub mod fonts;
mod formula;
mod framing;
mod gif;
mod ground;
mod handle;
mod inside;
mod mark;
mod marks;
pub mod metrics;
mod numbers;
mod options;
mod paint;
mod painter;
mod palette;
mod parts;
mod pdf;
mod pixels;
mod png;
mod rasteriser;
mod role;
mod shared;
mod show;
mod sides;
mod slice;
mod space;
mod style;
mod svg;
mod tikz;
mod typeset;
pub mod views;
mod ways;

pub use axes::{axes, axis_names};
pub use camera::{Camera, Lens, Page, Projected, corners};
pub use cells::{cells, role as cell_role, section_role};
pub use content::content;
pub use dashes::Dashes;
pub use diagram::{Diagram, DiagramLens, DiagramNode, DiagramOf, NodeKind, tree_diagram};
pub use figure::{Anchor, Drawn, Extent, Figure, Form, Part};
pub use formula::{FormulaType, SetFormula, ShownNumber};
pub use gif::{Gif, GifError};
pub use handle::{HANDLE_DISTANCE, RayArrow, last_point};
pub use inside::scenario_inside;
pub use mark::{Mark, Shape};
pub use marks::{arrow_end, cross_out, far_end, marks, node_mark};
pub use options::{Background, FileOptions, Scale, Unit};
pub use paint::Paint;
pub use palette::{Colour, Palette, Theme, contrast, ramp};
pub use pdf::{ATTACHMENT, Pdf, PdfError, pdf};
pub use pixels::{Pixels, PixelsError};
pub use png::{Apng, PngError, png, png_of_pixels};
pub use rasteriser::Rasteriser;
pub use role::Role;
pub use show::{Levels, Rest, Show};
pub use slice::{Cut, Slice};
pub use space::{drawn_box, edge_part, space_figure, space_figure_over};
pub use style::{Dash, Lettering, Style, Weight};
pub use svg::svg;
pub use tikz::{Tikz, TikzForm, tikz};
