//! Neighbour computation, written out as on paper.

use crate::look::Look;
use crate::widgets::bit_table;
use eframe::egui::{RichText, Ui};
use octoscope_core::trace::Moment;
use octoscope_core::tree::Tree;
use octoscope_figure::views::neighbour_tables;

/// The sum or difference of every crossed axis with its carries, the border, the
/// XOR with its run of ones, and the climb to the common ancestor.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, tree: &Tree<D>, moment: &Moment<D>) {
    let Some(computed) = neighbour_tables(&look.texts, tree, moment) else {
        ui.label(RichText::new(look.text("neighbour-none")).color(look.palette.quiet));
        return;
    };
    for table in &computed.tables {
        bit_table(ui, look, table, &look.text("panel-neighbour"));
        ui.add_space(6.0);
    }
    if let Some(border) = computed.border {
        ui.label(RichText::new(border).strong());
    }
    if let Some(climb) = computed.climb {
        ui.label(climb);
    }
}
