//! Controls and drawings that several panels share.

mod acted_at;
mod beside;
mod bits;
mod child_bits;
mod figure;
mod formula;
mod heading;
mod lit;
mod node_note;
mod number_field;
mod panel_heading;
mod ranged_field;
mod rich;
mod segments;
mod step_slider;
mod table;
mod tick;
mod typed_field;

pub use acted_at::acted_at;
pub use beside::beside_or_below;
pub use bits::bit_table;
pub use child_bits::child_bits;
pub use figure::{paint_figure, room};
pub use formula::{paint_formula, printed_and_right};
pub use heading::heading;
pub use lit::{Lit, caption, lit, per_axis};
pub use node_note::node_note;
pub use number_field::number_field;
pub use panel_heading::{Place, panel_heading};
pub use ranged_field::{MOST_SEED, ranged_field};
pub use rich::{rich_job, rich_label};
pub use segments::{explained_segments, segments};
pub use step_slider::step_slider;
pub use table::{Setting, table};
pub use tick::tick;
pub use typed_field::refused_number;
