//! What the space view shows.

use crate::look::Look;
use crate::widgets::heading;
use eframe::egui::Ui;
use octoscope_figure::Show;

/// One box to tick for every option.
pub fn ui(ui: &mut Ui, look: &Look, show: &mut Show, dimension: usize) {
    heading(ui, look, &look.text("panel-show"), "");
    for (value, key) in options(show, dimension) {
        ui.checkbox(value, look.text(key));
    }
}

fn options(show: &mut Show, dimension: usize) -> Vec<(&mut bool, &'static str)> {
    let mut options = vec![
        (&mut show.order_numbers, "show-order-numbers"),
        (&mut show.children, "show-children"),
        (&mut show.ancestors, "show-ancestors"),
        (&mut show.content, "show-content"),
        (&mut show.empty_leaves, "show-empty-leaves"),
        (&mut show.mirrored_ray, "show-mirrored-ray"),
        (&mut show.codes, "show-codes"),
    ];
    if dimension == 2 {
        options.push((&mut show.half_open_sides, "show-half-open-sides"));
    }
    options
}
