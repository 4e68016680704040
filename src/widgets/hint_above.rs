//! A hint that leaves the bar of its control to be read.

use eframe::egui::{Rangef, Rect, RectAlign, Response, Tooltip, Ui};

/// Shows a hint where `response` is pointed at: above the bar from the first to the last y
/// of `bar`, so that it covers nothing there.
pub fn hint_above(ui: &Ui, response: Response, bar: Rangef, text: &str) -> Response {
    let anchor = Rect::from_x_y_ranges(response.rect.x_range(), bar);
    hint_over(ui, &response, anchor, text);
    response
}

/// Shows a hint above `anchor` where `response` is pointed at.
pub fn hint_over(ui: &Ui, response: &Response, anchor: Rect, text: &str) {
    let mut hint = Tooltip::for_enabled(response);
    hint.popup = hint.popup.anchor(anchor).align(RectAlign::TOP_START);
    hint.show(|ui| {
        ui.set_max_width(ui.spacing().tooltip_width);
        ui.label(text);
    });
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_description(text));
}
