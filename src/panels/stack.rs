//! Nodes on the stack of a top-down traversal.

use crate::look::Look;
use eframe::egui::{FontId, Grid, RichText, ScrollArea, Ui};
use octoscope_core::explain::approx;
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::trace::{Counter, Moment};
use octoscope_core::tree::Tree;

/// Height of the stack, and its greatest so far.
pub fn note<const D: usize>(moment: &Moment<D>) -> String {
    let deepest = moment.counters.get(Counter::StackDepth);
    format!("{} / {deepest}", moment.stack.len().max(moment.pending.len()))
}

/// The stack, its top first.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, tree: &Tree<D>, moment: &Moment<D>) {
    if !moment.pending.is_empty() {
        pending(ui, look, tree, moment);
        return;
    }
    if moment.stack.is_empty() {
        ui.label(RichText::new(look.text("stack-empty")).color(look.palette.quiet));
        return;
    }
    // Codes of deep trees may be wider than the panel.
    ScrollArea::horizontal().show(ui, |ui| {
        let grid = Grid::new("stack").num_columns(4).striped(true);
        grid.spacing([8.0, 0.0]).min_col_width(24.0).min_row_height(18.0).show(ui, |ui| {
            for key in ["stack-level", "stack-codes", "stack-state", "stack-interval"] {
                ui.label(RichText::new(look.text(key)).size(12.0).color(look.palette.quiet));
            }
            ui.end_row();
            for frame in moment.stack.iter().rev() {
                let mono = |text: String| RichText::new(text).font(FontId::monospace(12.0));
                ui.label(mono(tree.level(frame.node).to_string()));
                ui.label(mono(tree.code(frame.node).map(|c| c.to_string()).join(", ")));
                ui.label(mono(frame.state.map_or("–".to_owned(), |state| state.0.to_string())));
                ui.label(mono(format!("[{}, {})", approx(frame.enter()), approx(frame.exit()))));
                ui.end_row();
            }
        });
    });
}

/// Parts that wait on the stack of a binary space partition, its top first.
fn pending<const D: usize>(ui: &mut Ui, look: &Look, tree: &Tree<D>, moment: &Moment<D>) {
    let mono = |text: String| RichText::new(text).font(FontId::monospace(12.0));
    let grid = Grid::new("pending").num_columns(4).striped(true);
    grid.spacing([8.0, 0.0]).min_col_width(24.0).min_row_height(18.0).show(ui, |ui| {
        for key in ["stack-level", "stack-codes", "stack-half", "stack-interval"] {
            ui.label(RichText::new(look.text(key)).size(12.0).color(look.palette.quiet));
        }
        ui.end_row();
        for (part, [enter, exit]) in moment.pending.iter().rev() {
            ui.label(mono(tree.level(part.node).to_string()));
            ui.label(mono(tree.code(part.node).map(|c| c.to_string()).join(", ")));
            let half = |e: usize| {
                let sign = if part.upper.contains(e) { '+' } else { '−' };
                format!("{}{sign}", AXIS_NAMES[e])
            };
            let halves: Vec<String> = part.halved.iter().map(half).collect();
            ui.label(mono(if halves.is_empty() { "–".to_owned() } else { halves.join(" ") }));
            ui.label(mono(format!("[{}, {})", approx(*enter), approx(*exit))));
            ui.end_row();
        }
    });
}
