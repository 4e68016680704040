//! The sentence of the step, readable from the back row.

use crate::look::Look;
use crate::widgets::rich_job;
use eframe::egui::{Label, Ui, WidgetInfo, accesskit::Role};
use octoscope_core::explain::{RichText, Span};

/// The sentence of `step`, in large type, before the first step with the key
/// that begins; a screen reader is told when it changes.
pub fn ui(ui: &mut Ui, look: &Look, mut sentence: RichText, step: usize) {
    if step == 0 {
        let text = format!(" {}", look.text("sentence-begin"));
        sentence.0.push(Span { text, ..Span::default() });
    }
    let job = rich_job(&sentence, look, 22.0, ui.available_width());
    let response = ui.add(Label::new(job));
    let text = sentence.plain();
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text.as_str()));
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_live(eframe::egui::accesskit::Live::Polite);
        node.set_author_id("sentence");
    });
}
