//! Location codes, bit by bit.

use crate::look::Look;
use crate::widgets::bit_table;
use eframe::egui::{RichText, Ui};
use octoscope_core::trace::Moment;
use octoscope_core::traverse::Variants;
use octoscope_core::tree::Tree;
use octoscope_figure::views::{Spacing, child_rule, code_table};

/// How the bits of a level number the children.
pub fn note<const D: usize>(look: &Look) -> String {
    child_rule::<D>(&look.texts)
}

/// Codes of the place that is looked for, as the rules of the query take them, else of
/// the current node.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    tree: &Tree<D>,
    moment: &Moment<D>,
    variants: Variants,
) {
    let codes = code_table(&look.texts, tree, moment, variants);
    bit_table(ui, look, &codes.table, Spacing::Wide, &look.text("panel-codes"));
    if let Some(child) = codes.child {
        ui.label(RichText::new(child).size(14.0));
    }
    ui.label(RichText::new(codes.morton).size(13.0).color(look.palette.quiet));
}
