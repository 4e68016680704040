//! What the space view shows.

mod cells;

use crate::look::Look;
use crate::show_change::ShownPart;
use crate::widgets::heading;
use eframe::egui::{FontId, Grid, RichText, Ui};
use octoscope_core::tree::Tree;
use octoscope_figure::Show;

/// Size of type.
const SIZE: f32 = 14.0;

/// The tree that is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Of {
    /// Its dimension.
    pub dimension: usize,
    /// Level of its root.
    pub root_level: u8,
}

impl Of {
    /// That of a tree.
    pub fn tree<const D: usize>(tree: &Tree<D>) -> Self {
        Self { dimension: D, root_level: tree.domain().root_level() }
    }
}

/// One box to tick for every part, in two columns where there is room, and below them
/// which cells off the path are shown, and how.
pub fn ui(ui: &mut Ui, look: &Look, show: &mut Show, of: Of) {
    heading(ui, look, &look.text("panel-show"), "");
    let font = FontId::proportional(SIZE);
    let names = ShownPart::ALL.map(|part| look.text(part.id()));
    let width = |name: &String| {
        ui.painter().layout_no_wrap(name.clone(), font.clone(), look.palette.ink).size().x
    };
    let widths: Vec<f32> = names.iter().map(|name| width(name) + 20.0).collect();
    let widest = |first: usize| widths.iter().skip(first).step_by(2).copied().fold(0.0, f32::max);
    let gap = 8.0;
    let n_columns = if widest(0) + gap + widest(1) <= ui.available_width() { 2 } else { 1 };
    let grid = Grid::new("show").num_columns(n_columns).spacing([gap, 0.0]);
    grid.show(ui, |ui| {
        for (n, (part, name)) in ShownPart::ALL.into_iter().zip(names).enumerate() {
            let why = look.text(&format!("{}-why", part.id()));
            ui.checkbox(part.of(show), RichText::new(name).size(SIZE)).on_hover_text(why);
            if (n + 1) % n_columns == 0 {
                ui.end_row();
            }
        }
    });
    cells::ui(ui, look, show, of);
}
