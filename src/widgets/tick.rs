//! A box to tick.

use crate::look::Look;
use eframe::egui::{Response, Stroke, Ui, WidgetText};

/// A box to tick, with its name; it has a border in menus, too, where the toolkit
/// leaves borders away.
pub fn tick(ui: &mut Ui, look: &Look, on: &mut bool, name: impl Into<WidgetText>) -> Response {
    let name = name.into();
    ui.scope(|ui| {
        let widgets = &mut ui.visuals_mut().widgets;
        for widget in [&mut widgets.inactive, &mut widgets.hovered, &mut widgets.active] {
            widget.bg_stroke = Stroke::new(1.0, look.palette.quiet);
        }
        ui.checkbox(on, name)
    })
    .inner
}
