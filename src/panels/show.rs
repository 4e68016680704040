//! What the space view shows.

use crate::look::Look;
use crate::widgets::heading;
use eframe::egui::{FontId, Grid, RichText, Ui};
use octoscope_figure::Show;

/// Size of type.
const SIZE: f32 = 14.0;

/// One box to tick for every option, in two columns where there is room.
pub fn ui(ui: &mut Ui, look: &Look, show: &mut Show, dimension: usize) {
    heading(ui, look, &look.text("panel-show"), "");
    let font = FontId::proportional(SIZE);
    let options = options(show, dimension);
    let options: Vec<_> = options
        .into_iter()
        .map(|(value, key)| (value, look.text(key), look.text(&format!("{key}-why"))))
        .collect();
    let width = |name: &String| {
        ui.painter().layout_no_wrap(name.clone(), font.clone(), look.palette.ink).size().x
    };
    let widths: Vec<f32> = options.iter().map(|(_, name, _)| width(name) + 20.0).collect();
    let widest = |first: usize| widths.iter().skip(first).step_by(2).copied().fold(0.0, f32::max);
    let gap = 8.0;
    let n_columns = if widest(0) + gap + widest(1) <= ui.available_width() { 2 } else { 1 };
    let grid = Grid::new("show").num_columns(n_columns).spacing([gap, 0.0]);
    grid.show(ui, |ui| {
        for (n, (value, name, why)) in options.into_iter().enumerate() {
            ui.checkbox(value, RichText::new(name).size(SIZE)).on_hover_text(why);
            if (n + 1) % n_columns == 0 {
                ui.end_row();
            }
        }
    });
}

fn options(show: &mut Show, dimension: usize) -> Vec<(&mut bool, &'static str)> {
    // The longer names stand to the left.
    let mut options = vec![
        (&mut show.order_numbers, "show-order-numbers"),
        (&mut show.content, "show-content"),
        (&mut show.empty_leaves, "show-empty-leaves"),
        (&mut show.ancestors, "show-ancestors"),
        (&mut show.mirrored_ray, "show-mirrored-ray"),
        (&mut show.children, "show-children"),
    ];
    if dimension == 2 {
        options.push((&mut show.half_open_sides, "show-half-open-sides"));
    }
    options.push((&mut show.codes, "show-codes"));
    options
}
