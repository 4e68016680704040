//! A formula in the window, with all digits of its numbers under the pointer.

use super::{paint_figure, room};
use crate::look::Look;
use eframe::egui::{Rect, Response, RichText, Sense, Ui, WidgetInfo, accesskit::Role, vec2};
use octoscope_core::explain::{Formula, Misprint, shown_number, spoken_formula};
use octoscope_figure::views::formulas_alike;
use octoscope_figure::{Figure, ShownNumber};

/// Paints `figure` into `rect`. Returns where the number under the pointer is, and all its
/// digits.
pub fn paint_formula(
    ui: &Ui,
    look: &Look,
    rect: Rect,
    figure: &Figure,
    response: &Response,
) -> Option<(Rect, String)> {
    paint_figure(ui, look, rect, figure);
    let pointer = response.hover_pos()?;
    let corner = |at: [f64; 2]| rect.min + vec2(at[0] as f32, at[1] as f32);
    let place = |shown: &ShownNumber| Rect::from_min_max(corner(shown.min), corner(shown.max));
    let numbers = figure.numbers();
    let shown = numbers.iter().find(|shown| place(shown).contains(pointer))?;
    Some((place(shown), shown_number(shown.value)))
}

/// Distance of two rules that stand side by side.
const GAP: f32 = 16.0;

/// Two rules as they are set.
enum BothSet {
    SideBySide([Figure; 2]),
    OneBelowTheOther([Figure; 2]),
}

/// A rule as it is printed and as it is right, in a room of this width.
fn set_both(look: &Look, misprint: &Misprint, width: f32) -> BothSet {
    let both = [&misprint.printed, &misprint.right];
    let set = |most: f32| formulas_alike(both, f64::from(most), f64::from(look.least_type));
    let half = half(width);
    let natural = set(f32::INFINITY);
    let side_by_side = set(half);
    // Rather one below the other than in smaller type, or broken; in a hall, which has little
    // height, than in much smaller type.
    let most = if look.is_for_hall() { 1.5 * half } else { half };
    let is_wide = natural.iter().any(|figure| figure.page.width as f32 > most)
        || side_by_side.iter().any(|figure| figure.drawn.len() > 1);
    if is_wide { BothSet::OneBelowTheOther(set(width)) } else { BothSet::SideBySide(side_by_side) }
}

fn half(width: f32) -> f32 {
    0.5 * (width - GAP)
}

/// Height of the formulas of a rule as it is printed and as it is right, with as much for
/// each caption above them, in a room of this width.
pub fn height_of_both(look: &Look, misprint: &Misprint, width: f32, caption: f32) -> f32 {
    let height = |figure: &Figure| caption + figure.page.height as f32;
    match set_both(look, misprint, width) {
        BothSet::SideBySide(both) => both.iter().map(height).fold(0.0, f32::max),
        BothSet::OneBelowTheOther(both) => both.iter().map(height).sum(),
    }
}

/// A rule as it is printed and as it is right, side by side where there is room.
pub fn printed_and_right(ui: &mut Ui, look: &Look, misprint: &Misprint) {
    let both = [("paper-printed", &misprint.printed), ("paper-right", &misprint.right)];
    let width = ui.available_width();
    let one = |ui: &mut Ui, (key, formula): (&str, &Formula), figure: &Figure| {
        ui.vertical(|ui| {
            ui.label(RichText::new(look.text(key)).size(13.0).color(look.palette.quiet));
            line(ui, look, formula, figure);
        });
    };
    match set_both(look, misprint, width) {
        BothSet::OneBelowTheOther(figures) => {
            both.into_iter().zip(&figures).for_each(|(rule, figure)| one(ui, rule, figure));
        }
        BothSet::SideBySide([printed, right]) => {
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = GAP;
                let left = ui.cursor().left();
                one(ui, both[0], &printed);
                let used = ui.cursor().left() - left - GAP;
                ui.add_space((half(width) - used).max(0.0));
                one(ui, both[1], &right);
            });
        }
    }
}

fn line(ui: &mut Ui, look: &Look, formula: &Formula, figure: &Figure) {
    let (rect, response) = room(ui, figure.page, Sense::hover());
    let name = spoken_formula(formula, look.texts.language());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, name.as_str()));
    if let Some((_, digits)) = paint_formula(ui, look, rect, figure, &response) {
        response.on_hover_text(digits);
    }
}
