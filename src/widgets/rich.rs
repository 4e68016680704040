//! Text with axis colours and subscripts.

use crate::look::Look;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{Align, FontFamily, FontId, Label, Response, Ui, WidgetInfo, accesskit::Role};
use octoscope_core::explain::RichText;

/// Layout of `text` in type of `size` points; wraps at `width`.
pub fn rich_job(text: &RichText, look: &Look, size: f32, width: f32) -> LayoutJob {
    let mut job = LayoutJob::default();
    job.wrap.max_width = width;
    for span in &text.0 {
        let family = if span.strong || span.axis.is_some() {
            look.strong_family()
        } else {
            FontFamily::Proportional
        };
        let size = if span.sub { size * 0.72 } else { size };
        let color = span.axis.map_or(look.palette.ink, |axis| look.palette.axes[axis]);
        let valign = if span.sub { Align::BOTTOM } else { Align::Center };
        let font_id = FontId::new(size, family);
        job.append(&span.text, 0.0, TextFormat { font_id, color, valign, ..TextFormat::default() });
    }
    job
}

/// A sentence in type of this size; a screen reader hears it in plain letters.
pub fn rich_label(ui: &mut Ui, look: &Look, sentence: &RichText, size: f32) -> Response {
    let job = rich_job(sentence, look, size, ui.available_width());
    let response = ui.add(Label::new(job).wrap());
    let text = sentence.plain();
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text.as_str()));
    response
}
