//! A box to tick, and a circle to choose by.

use crate::look::Look;
use eframe::egui::{Checkbox, IntoAtoms, RadioButton, Response, Stroke, Ui, Widget};

/// A box to tick, with its name.
pub fn tick<'a>(ui: &mut Ui, look: &Look, on: &'a mut bool, name: impl IntoAtoms<'a>) -> Response {
    with_border(ui, look, Checkbox::new(on, name))
}

/// A circle to choose one of several things by that exclude each other, with its name.
pub fn choose<'a>(ui: &mut Ui, look: &Look, on: bool, name: impl IntoAtoms<'a>) -> Response {
    with_border(ui, look, RadioButton::new(on, name))
}

/// A border in menus, too, where the toolkit leaves borders away.
fn with_border(ui: &mut Ui, look: &Look, widget: impl Widget) -> Response {
    ui.scope(|ui| {
        let widgets = &mut ui.visuals_mut().widgets;
        for widget in [&mut widgets.inactive, &mut widgets.hovered] {
            widget.bg_stroke = Stroke::new(1.0, look.palette.quiet);
        }
        widgets.active.bg_stroke = Stroke::new(2.0, look.palette.accent);
        ui.add(widget)
    })
    .inner
}
