//! Nodes on the stack of a top-down traversal.

use crate::look::Look;
use eframe::egui::{FontId, Grid, RichText, ScrollArea, Ui};
use octoscope_core::explain::approx;
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::trace::{Counter, Moment};
use octoscope_core::tree::{NodeId, Tree};

/// Height of the stack, and its greatest so far.
pub fn note<const D: usize>(moment: &Moment<D>) -> String {
    let deepest = moment.counters.get(Counter::StackDepth);
    format!("{} / {deepest}", moment.stack.len().max(moment.pending.len()))
}

/// The stack, its top first. Returns the node that is pointed at.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    tree: &Tree<D>,
    moment: &Moment<D>,
) -> Option<NodeId> {
    if !moment.pending.is_empty() {
        return pending(ui, look, tree, moment);
    }
    if moment.stack.is_empty() {
        ui.label(RichText::new(look.text("stack-empty")).color(look.palette.quiet));
        return None;
    }
    let mut pointed = None;
    // Codes of deep trees may be wider than the panel.
    ScrollArea::horizontal().show(ui, |ui| {
        let grid = Grid::new("stack").num_columns(4).striped(true);
        grid.spacing([12.0, 0.0]).min_col_width(24.0).min_row_height(18.0).show(ui, |ui| {
            for key in ["stack-level", "stack-codes", "stack-state", "stack-interval"] {
                ui.label(
                    RichText::new(look.text(key))
                        .size(look.type_size(12.0))
                        .color(look.palette.quiet),
                );
            }
            ui.end_row();
            for frame in moment.stack.iter().rev() {
                let mono = |text: String| {
                    RichText::new(text).font(FontId::monospace(look.type_size(12.0)))
                };
                let state = frame.child_state.map_or("–".to_owned(), |state| state.0.to_string());
                let interval = format!("[{}, {})", approx(frame.enter()), approx(frame.exit()));
                let row = [level(tree, frame.node), codes(tree, frame.node), state, interval];
                if row.map(|text| ui.label(mono(text)).contains_pointer()).contains(&true) {
                    pointed = Some(frame.node);
                }
                ui.end_row();
            }
        });
    });
    pointed
}

fn level<const D: usize>(tree: &Tree<D>, node: NodeId) -> String {
    tree.level(node).to_string()
}

fn codes<const D: usize>(tree: &Tree<D>, node: NodeId) -> String {
    tree.code(node).map(|code| code.to_string()).join(", ")
}

/// Parts that wait on the stack of a binary space partition, its top first.
fn pending<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    tree: &Tree<D>,
    moment: &Moment<D>,
) -> Option<NodeId> {
    let mut pointed = None;
    let mono = |text: String| RichText::new(text).font(FontId::monospace(look.type_size(12.0)));
    let grid = Grid::new("pending").num_columns(4).striped(true);
    grid.spacing([12.0, 0.0]).min_col_width(24.0).min_row_height(18.0).show(ui, |ui| {
        for key in ["stack-level", "stack-codes", "stack-half", "stack-interval"] {
            ui.label(
                RichText::new(look.text(key)).size(look.type_size(12.0)).color(look.palette.quiet),
            );
        }
        ui.end_row();
        for (part, [enter, exit]) in moment.pending.iter().rev() {
            let half = |e: usize| {
                let sign = if part.upper.contains(e) { '+' } else { '−' };
                format!("{sign}{}", AXIS_NAMES[e])
            };
            let halves: Vec<String> = part.halved.iter().map(half).collect();
            let halves =
                if halves.is_empty() { look.text("stack-whole") } else { halves.join(" ") };
            let interval = format!("[{}, {})", approx(*enter), approx(*exit));
            let row = [level(tree, part.node), codes(tree, part.node), halves, interval];
            if row.map(|text| ui.label(mono(text)).contains_pointer()).contains(&true) {
                pointed = Some(part.node);
            }
            ui.end_row();
        }
    });
    pointed
}
