//! Location codes, bit by bit.

use crate::look::Look;
use crate::widgets::bit_table;
use eframe::egui::{RichText, Ui};
use octoscope_core::event::Event;
use octoscope_core::explain::RichText as Rich;
use octoscope_core::trace::Moment;
use octoscope_core::traverse::Variants;
use octoscope_core::tree::Tree;
use octoscope_figure::views::{Spacing, child_rule, code_table};

/// Whose codes they are.
pub fn note<const D: usize>(
    look: &Look,
    tree: &Tree<D>,
    moment: &Moment<D>,
    variants: Variants,
) -> String {
    code_table(&look.texts, tree, moment, None, variants).of
}

/// The height that it takes in a lecture, in points.
pub fn lecture_height<const D: usize>() -> f32 {
    100.0 + 22.0 * D as f32
}

/// Codes of the place that is looked for, as the rules of the query take them, else of
/// the current node. `event` is what has just happened.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    tree: &Tree<D>,
    moment: &Moment<D>,
    event: Option<&Event<D>>,
    variants: Variants,
) {
    let codes = code_table(&look.texts, tree, moment, event, variants);
    bit_table(ui, look, &codes.table, Spacing::Wide, &look.text("panel-codes"));
    let known = if codes.of.is_empty() {
        codes.morton
    } else {
        format!("{}; {}", codes.morton, child_rule::<D>(&look.texts))
    };
    let known = Rich::from(known).unbroken().plain();
    ui.label(RichText::new(known).size(13.0).color(look.palette.quiet));
    if let Some(child) = codes.child {
        ui.label(RichText::new(Rich::from(child).unbroken().plain()).size(14.0));
    }
}
