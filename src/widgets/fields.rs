//! Fields for text, and the button that does what a dialog is for.

use crate::look::Look;
use eframe::egui::{Button, Color32, Response, RichText, Stroke, TextEdit, Ui};

/// Shows a field for text; while it is typed into, its border is that of what is chosen.
pub fn text_field(ui: &mut Ui, look: &Look, field: TextEdit<'_>) -> Response {
    let shown = ui.scope(|ui| {
        border_while_edited(ui, look, look.palette.accent);
        ui.add(field)
    });
    shown.inner
}

/// Gives a field for text a border of this colour while it is typed into.
pub(super) fn border_while_edited(ui: &mut Ui, look: &Look, color: Color32) {
    let selection = &mut ui.visuals_mut().selection;
    selection.stroke = Stroke::new(1.5, color);
    // Selected letters are in the colour of the border.
    selection.bg_fill = look.palette.lit;
}

/// The button that Enter presses.
pub fn default_button(look: &Look, name: String) -> Button<'static> {
    let name = RichText::new(name).color(look.palette.on_accent).family(look.strong_family());
    Button::new(name).fill(look.palette.accent)
}
