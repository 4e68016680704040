//! What the step computes and compares, set as formulas under the picture.

use crate::command::Command;
use crate::look::Look;
use crate::shortcut;
use crate::widgets::{hint_over, paint_formula, rich_job, rich_label};
use eframe::egui::{Rect, Sense, Ui, WidgetInfo, accesskit::Role, vec2};
use octoscope_core::explain::{Notation, RichText, Statement, spoken};
use octoscope_figure::Page;
use octoscope_figure::views::{FormulaRows, formula_figure, formula_height};

/// Share of a low picture that formulas take at most.
const SHARE: f32 = 0.34;
/// Below a picture that is lower than so many points there are none.
const LEAST: f32 = 150.0;

/// Height of formulas below a picture of this height without them: the same in every
/// step, so that nothing moves; `None` where there is no room.
pub fn height(picture: f32, rows: FormulaRows) -> Option<f32> {
    (picture >= LEAST).then(|| (formula_height(rows) as f32).min(SHARE * picture))
}

/// Height of formulas below a panel that leaves room of this height in every step: no more
/// than four statements one below the other need; `None` where there is not enough for any.
pub fn height_below_panel(room: f32) -> Option<f32> {
    const MOST: f32 = 212.0;
    const LEAST: f32 = 72.0;
    (room >= LEAST).then_some(room.min(MOST))
}

/// Formulas of a step in all the room there is, in the largest type that fits.
pub fn ui(ui: &mut Ui, look: &Look, statements: &[Statement], notation: Notation) {
    let room = ui.available_size();
    let (rect, response) = ui.allocate_exact_size(room, Sense::hover());
    let name = spoken(statements, look.texts.language());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, name.as_str()));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_author_id("formula"));
    if statements.is_empty() {
        return;
    }
    let most = Page { width: f64::from(room.x), height: f64::from(room.y) };
    let figure = formula_figure(statements, most, f64::from(look.least_type));
    // In the middle, on whole pixels: bars stay crisp.
    let size = vec2(figure.page.width as f32, figure.page.height as f32);
    let spare = (room - size).max(vec2(0.0, 0.0));
    let corner = (rect.min + vec2(0.0, 0.5 * spare.y)).round();
    let key = shortcut::all_shown(look, Command::NextNotation.row().keys);
    let name = look.text(&format!("notation-{notation}"));
    let arguments = [("notation", name.into()), ("key", key.into())];
    let why = look.texts.format("notation-now", &arguments);
    let place = Rect::from_min_size(corner, size);
    let number = paint_formula(ui, look, place, &figure, &response);
    // Above all formulas: what is pointed at and the sentence below are read on.
    let (x_range, hint) = number.map_or((rect.x_range(), why), |(at, told)| (at.x_range(), told));
    hint_over(ui, &response, Rect::from_x_y_ranges(x_range, rect.y_range()), &hint);
}

/// Words in the room of the formulas of a step that has none: the first of them, and of the
/// others those that fit.
pub fn words_instead(ui: &mut Ui, look: &Look, words: &[RichText]) {
    const SIZE: f32 = 13.0;
    let width = ui.available_width();
    for (index, text) in words.iter().enumerate() {
        let height = ui.painter().layout_job(rich_job(text, look, SIZE, width)).size().y;
        if index == 0 || height <= ui.available_height() {
            rich_label(ui, look, text, SIZE, width);
        }
    }
}
