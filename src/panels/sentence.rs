//! The sentence of the step, readable from the back row.

use crate::look::Look;
use crate::widgets::rich_label;
use eframe::egui::Ui;
use octoscope_core::explain::{RichText, Span};

/// With less room than this, in points, the type is smaller.
const NARROW: f32 = 640.0;

/// The sentence of `step`, in large type, before the first step with the key
/// that begins; a screen reader is told when it changes.
pub fn ui(ui: &mut Ui, look: &Look, mut sentence: RichText, step: usize) {
    if step == 0 {
        let text = format!(" {}", look.text("sentence-begin"));
        sentence.0.push(Span { text, ..Span::default() });
    }
    let width = ui.available_width();
    let size = if width < NARROW { 18.0 } else { 22.0 };
    let response = rich_label(ui, look, &sentence, size, width);
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_live(eframe::egui::accesskit::Live::Polite);
        node.set_author_id("sentence");
    });
}
