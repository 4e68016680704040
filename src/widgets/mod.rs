//! Controls and drawings that several panels share.

mod bits;
mod cell_text;
mod child_bits;
mod heading;
mod lit;
mod number_field;
mod panel_heading;
mod rich;
mod segments;

pub use bits::{BitRow, BitTable, bit_table};
pub use cell_text::cell_text;
pub use child_bits::child_bits;
pub use heading::heading;
pub use lit::{Lit, caption, lit, per_axis};
pub use number_field::number_field;
pub use panel_heading::{Place, panel_heading};
pub use rich::{rich_job, rich_label};
pub use segments::segments;
