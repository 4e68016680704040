//! A figure as part of a panel.

use super::{PageInWindow, paint_on_page};
use crate::look::Look;
use eframe::egui::{Rect, Response, Sense, Ui, vec2};
use octoscope_figure::{Figure, Page};

/// Room for a page in a panel; what senses a click or drag is up to the caller.
pub fn room(ui: &mut Ui, page: Page, sense: Sense) -> (Rect, Response) {
    ui.allocate_exact_size(vec2(page.width as f32, page.height as f32), sense)
}

/// Paints `figure` with its upper left corner at that of `rect`.
pub fn paint_figure(ui: &Ui, look: &Look, rect: Rect, figure: &Figure) {
    paint_larger(ui, look, rect, figure, 1.0);
}

/// The same, `scale` times as large.
pub fn paint_larger(ui: &Ui, look: &Look, rect: Rect, figure: &Figure, scale: f32) {
    if ui.is_rect_visible(rect) {
        let frame = PageInWindow { page: figure.page, corner: rect.min, scale };
        paint_on_page(&ui.painter_at(rect.expand(3.0)), look, look.theme, frame, figure);
    }
}
