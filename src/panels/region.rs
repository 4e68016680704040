//! Region location by XOR.

use crate::look::Look;
use crate::widgets::bit_table;
use eframe::egui::{RichText, Ui};
use octoscope_core::trace::Moment;
use octoscope_core::tree::Tree;
use octoscope_figure::views::{Spacing, region_table};

/// The height that it takes in a lecture, in points.
pub fn lecture_height<const D: usize>() -> f32 {
    56.0 + 60.0 * D as f32
}

/// Corner codes, their XOR, the OR of those, and the level that follows.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, tree: &Tree<D>, moment: &Moment<D>) {
    let Some((table, result)) = region_table(&look.texts, tree, moment) else {
        ui.label(RichText::new(look.text("region-none")).color(look.palette.quiet));
        return;
    };
    bit_table(ui, look, &table, Spacing::Wide, &look.text("panel-region"));
    // In a hall the sentence says it.
    if let Some(result) = result.filter(|_| !look.is_for_hall()) {
        ui.label(RichText::new(result).strong());
    }
}
