//! Fields for text, and the button that does what a dialog is for.

use crate::look::Look;
use eframe::egui::{Button, Color32, Response, RichText, Stroke, StrokeKind, TextEdit, Ui};

/// Width of the border of a field that is edited.
const BORDER: f32 = 1.5;

/// Shows a field for text; while it is typed into, its border is that of what is chosen.
pub fn text_field(ui: &mut Ui, look: &Look, field: TextEdit<'_>) -> Response {
    let shown = ui.scope(|ui| {
        while_edited(ui, look, look.palette.accent);
        ui.add(field)
    });
    outline_if_edited(ui, &shown.inner, look.palette.accent);
    shown.inner
}

/// Sets what is selected in a field on a ground of this colour. The toolkit gives the
/// border of the field the colour of those letters: [`outline_if_edited`] paints over it.
pub(super) fn while_edited(ui: &mut Ui, look: &Look, color: Color32) {
    let selection = &mut ui.visuals_mut().selection;
    selection.stroke = Stroke::new(BORDER, look.palette.on_accent);
    selection.bg_fill = color;
}

/// Gives a field a border of this colour while it is typed into.
pub(super) fn outline_if_edited(ui: &Ui, field: &Response, color: Color32) {
    if field.has_focus() {
        let corners = ui.visuals().widgets.active.corner_radius;
        let stroke = Stroke::new(BORDER, color);
        ui.painter().rect_stroke(field.rect, corners, stroke, StrokeKind::Inside);
    }
}

/// The button that Enter presses.
pub fn default_button(look: &Look, name: String) -> Button<'static> {
    let name = RichText::new(name).color(look.palette.on_accent).family(look.strong_family());
    Button::new(name).fill(look.palette.accent)
}
