//! A formula in the window, with all digits of its numbers under the pointer.

use super::{paint_figure, room};
use crate::look::Look;
use eframe::egui::{Rect, Response, RichText, Sense, Ui, WidgetInfo, accesskit::Role, vec2};
use octoscope_core::explain::{Formula, Misprint, shown_number, spoken_formula};
use octoscope_figure::views::formula_line;
use octoscope_figure::{Figure, ShownNumber};

/// Paints `figure` into `rect`; a number under the pointer tells all its digits.
pub fn paint_formula(ui: &Ui, look: &Look, rect: Rect, figure: &Figure, response: Response) {
    paint_figure(ui, look, rect, figure);
    let Some(pointer) = response.hover_pos() else { return };
    let is_under = |shown: &&ShownNumber| {
        let corner = |at: [f64; 2]| rect.min + vec2(at[0] as f32, at[1] as f32);
        Rect::from_min_max(corner(shown.min), corner(shown.max)).contains(pointer)
    };
    if let Some(shown) = figure.numbers().iter().find(is_under) {
        response.on_hover_text(shown_number(shown.value));
    }
}

/// A rule as it is printed and as it is right, side by side where there is room.
pub fn printed_and_right(ui: &mut Ui, look: &Look, misprint: &Misprint) {
    const GAP: f32 = 16.0;
    let both = [("paper-printed", &misprint.printed), ("paper-right", &misprint.right)];
    let width = ui.available_width();
    let set = |most: f32| {
        both.map(|(_, formula)| formula_line(formula, f64::from(most), f64::from(look.least_type)))
    };
    let half = 0.5 * (width - GAP);
    let natural = set(f32::INFINITY);
    let side_by_side = set(half);
    // Rather one below the other than in smaller type, or broken; in a hall, which has little
    // height, than in much smaller type.
    let most = if look.is_for_hall() { 1.5 * half } else { half };
    let is_wide = natural.iter().any(|figure| figure.page.width as f32 > most)
        || side_by_side.iter().any(|figure| figure.drawn.len() > 1);
    let figures = if is_wide { set(width) } else { side_by_side };
    let one = |ui: &mut Ui, n: usize| {
        let (key, formula) = both[n];
        ui.vertical(|ui| {
            ui.label(RichText::new(look.text(key)).size(13.0).color(look.palette.quiet));
            line(ui, look, formula, &figures[n]);
        });
    };
    if is_wide {
        one(ui, 0);
        one(ui, 1);
    } else {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = GAP;
            let left = ui.cursor().left();
            one(ui, 0);
            let used = ui.cursor().left() - left - GAP;
            ui.add_space((half - used).max(0.0));
            one(ui, 1);
        });
    }
}

fn line(ui: &mut Ui, look: &Look, formula: &Formula, figure: &Figure) {
    let (rect, response) = room(ui, figure.page, Sense::hover());
    let name = spoken_formula(formula, look.texts.language());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, name.as_str()));
    paint_formula(ui, look, rect, figure, response);
}
