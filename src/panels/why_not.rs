//! What becomes of the children of a node, and what rules them out.

use crate::look::Look;
use crate::view::Hover;
use crate::widgets::{caption, child_bits, node_note, rich_label};
use eframe::egui::{Grid, RichText, Ui};
use octoscope_core::explain::{Naming, fate_name, fate_numbers, fate_sentence};
use octoscope_core::text::Language;
use octoscope_core::trace::{Fate, fate};
use octoscope_core::tree::{Child, NodeId};
use octoscope_figure::DiagramOf;

/// Panels of less than this, in points, have no room for the bits of children.
const WITH_BITS: f32 = 340.0;

/// The node whose children are chosen among.
pub fn note<const D: usize>(look: &Look, of: &DiagramOf<D>) -> String {
    node_note(look, of.tree, of.moment.at_work(of.tree))
}

/// A row a child, with the comparison that rules it out or the interval of the
/// ray in it; below, one of them in words.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    of: &DiagramOf<D>,
    language: Language,
    hover: &mut Hover,
) {
    let DiagramOf { tree, ray, query, moment, .. } = *of;
    let Some(parent) = moment.at_work(tree) else {
        caption(ui, look, look.text("why-not-leaf"));
        return;
    };
    let children = Child::<D>::all().zip(tree.children(tree.node(parent)));
    let fates: Vec<(Child<D>, NodeId, Fate)> = children
        .filter_map(|(child, node)| {
            Some((child, node.id, fate(tree, ray, query, moment, node.id)?))
        })
        .collect();
    if fates.is_empty() {
        caption(ui, look, look.text("why-not-none"));
        return;
    }
    let has_bits = ui.available_width() >= WITH_BITS;
    let pointed = hover.lit(tree);
    let is_pointed = |node: NodeId| pointed.is_some_and(|inner| tree.holds(node, inner));
    let n_columns = if has_bits { 4 } else { 3 };
    let grid = Grid::new("why-not").num_columns(n_columns).spacing([12.0, 0.0]).min_col_width(18.0);
    let are_lit: Vec<bool> = fates.iter().map(|&(_, node, _)| is_pointed(node)).collect();
    let ground = look.palette.lit;
    let grid = grid
        .with_row_color(move |row, _| are_lit.get(row).copied().unwrap_or(false).then_some(ground));
    grid.min_row_height(20.0).show(ui, |ui| {
        for &(child, node, fate) in &fates {
            let top = ui.cursor().min;
            ui.label(RichText::new(child.0.to_string()).monospace().size(13.0));
            if has_bits {
                child_bits(ui, look, child);
            }
            let color = match fate {
                Fate::RuledOut(_) | Fate::Strayed(_) | Fate::PassedBy(_) => look.palette.rejected,
                Fate::Visited(_) | Fate::Entered(_) => look.palette.ink,
                Fate::Ahead(_) => look.palette.quiet,
            };
            ui.label(RichText::new(fate_name(fate, language)).size(13.0).color(color));
            rich_label(ui, look, &fate_numbers(fate), 13.0, f32::INFINITY);
            let mut row = ui.max_rect();
            (row.min.y, row.max.y) = (top.y, top.y + 20.0);
            if ui.rect_contains_pointer(row) {
                hover.offer(node);
            }
            ui.end_row();
        }
    });
    let of_pointed = fates.iter().find(|(_, node, _)| is_pointed(*node));
    match of_pointed.or_else(|| first_ruled_out(&fates)) {
        Some(&(_, node, fate)) => {
            let text = fate_sentence(tree, node, fate, Naming::ByIndex, language);
            let width = ui.available_width();
            rich_label(ui, look, &text, 14.0, width);
        }
        None => caption(ui, look, look.text("why-not-all")),
    }
}

fn first_ruled_out<const D: usize>(
    fates: &[(Child<D>, NodeId, Fate)],
) -> Option<&(Child<D>, NodeId, Fate)> {
    fates.iter().find(|(_, _, fate)| match fate {
        Fate::RuledOut(_) | Fate::Strayed(_) | Fate::PassedBy(_) => true,
        Fate::Visited(_) | Fate::Entered(_) | Fate::Ahead(_) => false,
    })
}
