//! Controls and drawings that several panels share.

mod beside;
mod bits;
mod child_bits;
mod heading;
mod lit;
mod number_field;
mod panel_heading;
mod rich;
mod segments;

pub use beside::beside_or_below;
pub use bits::{BitRow, BitTable, bit_table};
pub use child_bits::child_bits;
pub use heading::heading;
pub use lit::{Lit, caption, lit, per_axis};
pub use number_field::number_field;
pub use panel_heading::{Place, panel_heading};
pub use rich::rich_job;
pub use segments::segments;
