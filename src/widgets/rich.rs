//! Text with axis colours and subscripts.

use crate::look::Look;
use eframe::egui::text::LayoutJob;
use eframe::egui::{FontFamily, Label, Response, Ui, Vec2, WidgetInfo, accesskit::Role};
use octoscope_core::explain::RichText;

/// Shows `text` in type of `size` points, wrapped at `width`; a screen reader says
/// its subscripts as such.
pub fn rich_label(ui: &mut Ui, look: &Look, text: &RichText, size: f32, width: f32) -> Response {
    let label = Label::new(rich_job(text, look, size, width));
    let response = ui.add(if width.is_finite() { label.wrap() } else { label.extend() });
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text.plain()));
    response
}

/// The index of the span under the pointer in a text that [`rich_label`] has shown.
pub fn span_under(
    ui: &Ui,
    look: &Look,
    text: &RichText,
    size: f32,
    width: f32,
    shown: &Response,
) -> Option<usize> {
    let pointer = shown.hover_pos()? - shown.rect.min.to_vec2();
    let galley = ui.painter().layout_job(rich_job(text, look, size, width));
    let mut n_before = 0;
    for row in &galley.rows {
        if row.rect().y_range().contains(pointer.y) {
            let mut lefts = row.glyphs.iter().map(|glyph| row.pos.x + glyph.pos.x);
            let is_inside = row.rect().x_range().contains(pointer.x);
            let letter = lefts.rposition(|left| left <= pointer.x).filter(|_| is_inside)?;
            let letter = n_before + letter;
            let ends = text.0.iter().scan(0, |end, span| {
                *end += span.text.chars().count();
                Some(*end)
            });
            return ends.into_iter().position(|end| letter < end);
        }
        n_before += row.char_count_including_newline().0;
    }
    None
}

/// Layout of `text` in type of `size` points; wraps at `width`.
pub fn rich_job(text: &RichText, look: &Look, size: f32, width: f32) -> LayoutJob {
    let mut job = LayoutJob::default();
    job.wrap.max_width = width;
    // Only where lines are broken.
    let text = if width.is_finite() { text.unbroken() } else { text.clone() };
    for span in &text.0 {
        let family = if span.strong || span.axis.is_some() {
            look.strong_family()
        } else {
            FontFamily::Proportional
        };
        let mut format = look.set(span, size, family);
        format.color = span.axis.map_or(look.palette.ink, |axis| look.palette.axes[axis]);
        job.append(&span.text, 0.0, format);
    }
    job
}

/// Height of the largest type of a sentence, none larger than `largest`, in which `text` fits
/// into a room, in points; of the smallest where it fits in none.
pub fn fitting_size(ui: &Ui, look: &Look, text: &RichText, room: Vec2, largest: f32) -> f32 {
    const SIZES: [f32; 7] = [22.0, 20.0, 18.0, 17.0, 16.0, 15.0, SMALLEST];
    const SMALLEST: f32 = 14.0;
    let height = |size| {
        let job = rich_job(text, look, size, room.x);
        ui.painter().layout_job(job).size().y
    };
    let mut sizes = SIZES.into_iter().filter(|&size| size <= largest);
    sizes.find(|&size| height(size) <= room.y).unwrap_or(SMALLEST)
}
