//! Pseudocode in step with the algorithm.

use crate::look::Look;
use eframe::egui::{
    CornerRadius, FontId, Frame, Margin, Rect, RichText, Ui, WidgetInfo, accesskit::Role,
};
use octoscope_core::explain::Listing;

/// The listing; of its lines those that are `lit`, in the order of the lines, were at
/// work in the last step. Returns where these are.
pub fn ui(ui: &mut Ui, look: &Look, listing: &Listing, lit: &[bool]) -> Vec<Rect> {
    let mut places = Vec::new();
    ui.spacing_mut().item_spacing.y = 0.0;
    for (line, &lit) in listing.lines.iter().zip(lit) {
        let fill = if lit { look.palette.current_fill } else { look.palette.panel };
        let frame = Frame::new().fill(fill).corner_radius(CornerRadius::same(3));
        let shown = frame.inner_margin(Margin::symmetric(4, 1)).show(ui, |ui| {
            ui.set_width(ui.available_width());
            let code = format!("{}{}", "  ".repeat(usize::from(line.indent)), line.code);
            let code = RichText::new(code).font(FontId::monospace(12.5)).color(look.palette.ink);
            let row = ui.label(code);
            if lit && !line.comment.is_empty() {
                ui.label(RichText::new(&line.comment).size(13.0).color(look.palette.quiet));
            }
            row
        });
        let text = format!("{}{}", if lit { "▶ " } else { "" }, line.code);
        shown.inner.widget_info(|| WidgetInfo::labeled(Role::Label, true, text.as_str()));
        if lit {
            places.push(shown.response.rect);
        } else if !line.comment.is_empty() {
            shown.response.on_hover_text(&line.comment);
        }
    }
    places
}
