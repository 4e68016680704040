//! Text in a cell of a table.

use crate::look::Look;
use eframe::egui::RichText;

/// Text of a cell: lit if it is the one that is used, weakly lit if it lies in the
/// same row.
pub fn cell_text(look: &Look, text: String, in_row: bool, used: bool) -> RichText {
    let text = RichText::new(text).monospace().color(look.palette.ink);
    match (in_row, used) {
        (_, true) => text.strong().background_color(look.palette.current_line.gamma_multiply(0.55)),
        (true, false) => text.background_color(look.palette.current_fill),
        (false, false) => text,
    }
}
