//! A choice of few alternatives, side by side.

use eframe::egui::{RichText, Ui, vec2};

/// Shows `choices` in a row; a click writes to `value`. Returns whether it changed.
pub fn segments<T: Copy + PartialEq>(ui: &mut Ui, value: &mut T, choices: &[(T, String)]) -> bool {
    let before = *value;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        ui.spacing_mut().button_padding = vec2(6.0, 4.0);
        for (choice, name) in choices {
            ui.selectable_value(value, *choice, RichText::new(name).size(14.0));
        }
    });
    *value != before
}

/// The same with what every choice means, shown where it is pointed at.
pub fn explained_segments<T: Copy + PartialEq>(
    ui: &mut Ui,
    value: &mut T,
    choices: &[(T, String, String)],
) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        ui.spacing_mut().button_padding = vec2(6.0, 4.0);
        for (choice, name, why) in choices {
            let name = RichText::new(name).size(14.0);
            let segment = ui.selectable_value(value, *choice, name);
            segment.on_hover_text(why).on_disabled_hover_text(why);
        }
    });
}
