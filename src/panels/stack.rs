//! Nodes on the stack of a top-down traversal.

use crate::look::Look;
use crate::widgets::heading;
use eframe::egui::{Grid, RichText, Ui};
use octoscope_core::explain::approx;
use octoscope_core::trace::{Counter, Moment};
use octoscope_core::tree::Tree;

/// The stack, its top first.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, tree: &Tree<D>, moment: &Moment<D>) {
    let deepest = moment.counters.get(Counter::StackDepth);
    let note = format!("{} / {}", moment.stack.len(), deepest);
    heading(ui, look, &look.text("panel-stack"), &note);
    if moment.stack.is_empty() {
        ui.label(RichText::new(look.text("stack-empty")).color(look.palette.quiet));
        return;
    }
    Grid::new("stack").num_columns(4).striped(true).spacing([14.0, 3.0]).min_row_height(20.0).show(
        ui,
        |ui| {
            for key in ["stack-level", "stack-codes", "stack-state", "stack-interval"] {
                ui.label(RichText::new(look.text(key)).size(13.0).color(look.palette.quiet));
            }
            ui.end_row();
            for frame in moment.stack.iter().rev() {
                let mono = |text: String| RichText::new(text).monospace();
                ui.label(mono(tree.level(frame.node).to_string()));
                ui.label(mono(tree.code(frame.node).map(|c| c.to_string()).join(", ")));
                ui.label(mono(frame.state.map_or("–".to_owned(), |state| state.0.to_string())));
                ui.label(mono(format!("[{}, {})", approx(frame.enter()), approx(frame.exit()))));
                ui.end_row();
            }
        },
    );
}
