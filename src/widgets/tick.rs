//! A box to tick.

use crate::look::Look;
use eframe::egui::{Checkbox, IntoAtoms, Response, Stroke, Ui};

/// A box to tick, with its name; it has a border in menus, too, where the toolkit
/// leaves borders away.
pub fn tick<'a>(ui: &mut Ui, look: &Look, on: &'a mut bool, name: impl IntoAtoms<'a>) -> Response {
    ui.scope(|ui| {
        let widgets = &mut ui.visuals_mut().widgets;
        for widget in [&mut widgets.inactive, &mut widgets.hovered] {
            widget.bg_stroke = Stroke::new(1.0, look.palette.quiet);
        }
        widgets.active.bg_stroke = Stroke::new(2.0, look.palette.accent);
        ui.add(Checkbox::new(on, name))
    })
    .inner
}
