//! The sentence of the step, readable from the back row.

use crate::look::Look;
use crate::widgets::rich_job;
use eframe::egui::{Label, Ui, WidgetInfo, accesskit::Role};
use octoscope_core::explain::RichText;

/// The sentence, in large type; a screen reader is told when it changes.
pub fn ui(ui: &mut Ui, look: &Look, sentence: &RichText) {
    let job = rich_job(sentence, look, 22.0, ui.available_width());
    let response = ui.add(Label::new(job));
    let text = sentence.plain();
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text.as_str()));
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_live(eframe::egui::accesskit::Live::Polite);
        node.set_author_id("sentence");
    });
}
