//! Which cells off the path are shown, and how; and the children moved apart.

use super::{Of, SIZE, part_box};
use crate::look::Look;
use crate::show_change::{ShownPart, set_levels};
use crate::widgets::{explained_segments, ranged_field, slider_field};
use eframe::egui::{Grid, Response, RichText, Ui};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_figure::{Rest, Show, Slice};

/// A row for every choice: its name, and what is chosen.
pub(super) fn ui(ui: &mut Ui, look: &Look, show: &mut Show, of: Of) {
    Grid::new("show-cells").num_columns(2).spacing([8.0, 2.0]).show(ui, |ui| {
        name(ui, look, "show-levels");
        ui.horizontal(|ui| {
            levels(ui, look, show, of.root_level);
            let inner = ShownPart::InnerNodes;
            part_box(ui, look, show, inner, look.text(inner.id()));
        });
        ui.end_row();

        name(ui, look, "show-rest");
        let choices = Rest::ALL.map(|rest| {
            let key = format!("show-rest-{}", rest.id());
            (rest, look.text(&key), look.text(&format!("{key}-why")))
        });
        explained_segments(ui, &mut show.rest, &choices);
        ui.end_row();

        if of.dimension == 3 {
            name(ui, look, "show-slice");
            ui.vertical(|ui| slice(ui, look, show));
            ui.end_row();
        }

        name(ui, look, "show-apart");
        let (spoken, range) = (look.text("show-apart"), [0.0, Show::MOST_APART]);
        slider_field(ui, look, &spoken, &mut show.explosion, range, 0.01, |s| s.step_by(0.1));
        ui.end_row();
    });
    if of.dimension == 3 {
        let sides = ShownPart::HalfOpenSides;
        part_box(ui, look, show, sides, look.text(sides.id()));
    }
}

/// The name of a choice, with what it means.
fn name(ui: &mut Ui, look: &Look, key: &str) -> Response {
    let label = ui.label(RichText::new(look.text(key)).size(SIZE));
    label.on_hover_text(look.text(&format!("{key}-why")))
}

fn levels(ui: &mut Ui, look: &Look, show: &mut Show, root_level: u8) {
    let shown = show.levels.up_to(root_level);
    let [mut least, mut most] = [shown.least, shown.most];
    ui.spacing_mut().interact_size.x = 32.0;
    let field = |ui: &mut Ui, value: &mut u8, range: [u8; 2], key: &str| {
        let spoken = look.text(key);
        ranged_field(ui, look, &spoken, value, range, 0.05);
    };
    field(ui, &mut least, [0, most], "show-levels-least");
    ui.label(RichText::new("–").size(SIZE));
    field(ui, &mut most, [least, root_level], "show-levels-most");
    if [least, most] != [shown.least, shown.most] {
        set_levels(show, root_level, [least, most]);
    }
}

fn slice(ui: &mut Ui, look: &Look, show: &mut Show) {
    let mut axis = show.slice.map(|slice| slice.axis);
    let off = (None, look.text("show-slice-off"), look.text("show-slice-off-why"));
    let across = (0..3u8).map(|axis| {
        let name = AXIS_NAMES[usize::from(axis)].to_owned();
        let why = look.texts.format("show-slice-across", &[("axis", name.clone().into())]);
        (Some(axis), name, why)
    });
    let choices: Vec<_> = std::iter::once(off).chain(across).collect();
    explained_segments(ui, &mut axis, &choices);
    let at = show.slice.map_or(Slice::MIDDLE.at, |slice| slice.at);
    show.slice = axis.map(|axis| Slice { axis, at });
    if let Some(slice) = &mut show.slice {
        let spoken = look.text("show-slice-at");
        let step = 1.0 / 256.0;
        let range = [0.0, 1.0];
        slider_field(ui, look, &spoken, &mut slice.at, range, step, |s| s.step_by(step))
            .on_hover_text(spoken.as_str());
    }
}
