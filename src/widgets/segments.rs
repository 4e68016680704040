//! A choice of few alternatives, side by side.

use super::in_rows;
use eframe::egui::{Button, FontId, Response, RichText, TextWrapMode, Ui, vec2};

/// Height of the type, room inside a choice at its sides, and between two.
const SIZE: f32 = 14.0;
const PADDING: f32 = 6.0;
const GAP: f32 = 2.0;

/// Shows `choices` in a row; a click writes to `value`. Returns whether it changed.
pub fn segments<T: Copy + PartialEq>(ui: &mut Ui, value: &mut T, choices: &[(T, String)]) -> bool {
    let before = *value;
    let names: Vec<&str> = choices.iter().map(|(_, name)| name.as_str()).collect();
    in_segments(ui, choices, &names, |ui, (choice, name)| {
        segment(ui, value, *choice, name);
    });
    *value != before
}

/// The same with what every choice means, shown where it is pointed at.
pub fn explained_segments<T: Copy + PartialEq>(
    ui: &mut Ui,
    value: &mut T,
    choices: &[(T, String, String)],
) {
    let names: Vec<&str> = choices.iter().map(|(_, name, _)| name.as_str()).collect();
    in_segments(ui, choices, &names, |ui, (choice, name, why)| {
        segment(ui, value, *choice, name).on_hover_text(why).on_disabled_hover_text(why);
    });
}

fn segment<T: Copy + PartialEq>(ui: &mut Ui, value: &mut T, choice: T, name: &str) -> Response {
    let text = RichText::new(name).size(SIZE);
    let button = Button::selectable(*value == choice, text).wrap_mode(TextWrapMode::Extend);
    let mut response = ui.add(button);
    if response.clicked() && *value != choice {
        *value = choice;
        response.mark_changed();
    }
    response
}

/// Shows every choice whole, in balanced rows where one has no room.
pub fn in_segments<T>(ui: &mut Ui, choices: &[T], names: &[&str], show: impl FnMut(&mut Ui, &T)) {
    let ink = ui.visuals().text_color();
    let wide = |name: &&str| {
        let galley =
            ui.painter().layout_no_wrap((*name).to_owned(), FontId::proportional(SIZE), ink);
        galley.size().x + 2.0 * PADDING
    };
    let widths: Vec<f32> = names.iter().map(wide).collect();
    ui.scope(|ui| {
        ui.spacing_mut().button_padding = vec2(PADDING, 4.0);
        in_rows(ui, choices, &widths, GAP, show);
    });
}
