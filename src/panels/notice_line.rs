//! What has just happened, in a place of its own: nothing is covered, nothing moves.

use crate::look::Look;
use crate::notice::Notice;
use crate::widgets::{fitting_size, rich_label};
use eframe::egui::{
    Align, Align2, Area, Context, FontId, Frame, Id, Key, Label, Layout, Margin, Order, Ui,
    text::LayoutJob, vec2,
};
use octoscope_core::explain::{RichText as Words, Span};
use std::time::Duration;

/// Height of type in the slot.
const SIZE: f32 = 15.0;
/// Height of the slot: that of a line.
const LINE: f32 = 20.0;
/// The slot takes at most so many lines from the sentence, which needs the rest; all of a
/// longer text is told where it is pointed at.
const MOST_LINES: usize = 2;
/// Width of what takes the line away, and of the gap before it.
const CLOSE: f32 = 90.0;
/// Room above a line over a dialog.
const ABOVE: f32 = 12.0;

/// Height of the slot below the sentence in a column of this width: of a line where nothing
/// is said, too, so that nothing moves; what takes more than that takes it from the sentence.
pub fn slot_height(ui: &Ui, look: &Look, said: Option<&Notice>, width: f32) -> f32 {
    let lines = said.filter(|notice| !notice.is_empty()).map(|notice| {
        ui.painter().layout_job(job(look, notice, width - CLOSE, MOST_LINES)).size().y
    });
    lines.unwrap_or(0.0).max(LINE)
}

/// The slot, of this height. A click takes the line away, and so does time.
pub fn slot(ui: &mut Ui, look: &Look, said: Option<&mut Notice>, height: f32) {
    let width = ui.available_width();
    ui.allocate_ui_with_layout(vec2(width, height), Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_height(height);
        let Some(notice) = said else { return };
        let Some(strength) = strength(ui.ctx(), notice) else { return };
        ui.multiply_opacity(strength);
        line(ui, look, notice, width - CLOSE, MOST_LINES);
    });
}

/// The same in a hall, in the place and the type of the sentence, if it is of this step:
/// the sentence gives way to it then. Whether anything was shown.
pub fn for_sentence(ui: &mut Ui, look: &Look, notice: &mut Notice, step: usize) -> bool {
    let Some(strength) = strength(ui.ctx(), notice).filter(|_| notice.is_of(step)) else {
        return false;
    };
    const BAR: f32 = 4.0;
    const BESIDE: f32 = 12.0;
    let most = ui.available_width() - CLOSE - BAR - BESIDE;
    let height = ui.min_size().y;
    let text = Words(vec![Span { text: notice.text().to_owned(), ..Span::default() }]);
    let size = fitting_size(ui, look, &text, vec2(most, height), f32::INFINITY);
    ui.multiply_opacity(strength);
    let shown = ui.horizontal(|ui| {
        ui.add_space(BAR + BESIDE);
        ui.scope(|ui| {
            ui.set_max_width(most);
            rich_label(ui, look, &text, size, most);
        });
        ui.button(look.text("dialog-close")).clicked()
    });
    let bar = shown.response.rect.with_max_x(shown.response.rect.left() + BAR);
    ui.painter().rect_filled(bar, 2.0, look.palette.accent);
    close(ui, notice, shown.inner);
    true
}

/// The same at the upper edge of the window, over a dialog that it may be about.
pub fn over_dialog(context: &Context, look: &Look, notice: &mut Notice) {
    let Some(strength) = strength(context, notice) else { return };
    let window = context.content_rect();
    let area = Area::new(Id::unique("status")).order(Order::Tooltip);
    let area = area.pivot(Align2::CENTER_TOP).fixed_pos(window.center_top() + vec2(0.0, ABOVE));
    area.show(context, |ui| {
        ui.multiply_opacity(strength);
        let frame =
            Frame::popup(ui.style()).inner_margin(Margin::same(10)).fill(look.palette.field);
        let most = (window.width() - CLOSE).clamp(160.0, 420.0);
        frame.show(ui, |ui| ui.horizontal(|ui| line(ui, look, notice, most, usize::MAX)));
    });
}

/// How strong the notice is now; `None` if there is none.
fn strength(context: &Context, notice: &mut Notice) -> Option<f32> {
    if notice.is_empty() {
        return None;
    }
    let (strength, secs) = notice.strength(context.input(|input| input.time));
    context.request_repaint_after(Duration::from_secs_f64(secs));
    (!notice.is_empty()).then_some(strength)
}

/// What has happened, in so many lines of at most this width.
fn job(look: &Look, notice: &Notice, most: f32, max_rows: usize) -> LayoutJob {
    let font = FontId::proportional(look.type_size(SIZE));
    let mut job = LayoutJob::simple(notice.text().to_owned(), font, look.palette.ink, most);
    job.wrap.max_rows = max_rows;
    job
}

/// The same, and what takes it away.
fn line(ui: &mut Ui, look: &Look, notice: &mut Notice, most: f32, max_rows: usize) {
    ui.scope(|ui| {
        ui.set_max_width(most);
        ui.add(Label::new(job(look, notice, most, max_rows)).wrap());
    });
    let clicked = ui.small_button(look.text("dialog-close")).clicked();
    close(ui, notice, clicked);
}

fn close(ui: &Ui, notice: &mut Notice, clicked: bool) {
    if clicked || ui.input(|input| input.key_pressed(Key::Escape)) {
        notice.clear();
    }
}
