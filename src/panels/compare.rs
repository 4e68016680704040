//! All algorithms on the same ray, side by side.

use crate::comparison::Run;
use crate::look::Look;
use eframe::egui::{Align, Grid, Layout, RichText, Ui, WidgetInfo, accesskit::Role};
use octoscope_core::explain::algorithm_name;
use octoscope_core::trace::Counter;
use octoscope_core::traverse::Algorithm;

/// Sides of less than this, in points, show fewer numbers.
const NARROW: f32 = 330.0;

/// Keys of the heads of the numbers' columns.
const HEADS: [&str; 5] =
    ["compare-leaves", "compare-steps", "compare-nodes", "compare-tests", "compare-quotients"];

/// Costs of every algorithm and whether it finds the right leaves, a row each;
/// a click on a name chooses the algorithm. Returns the chosen one.
pub fn ui(ui: &mut Ui, look: &Look, runs: &[Run], shown: Option<Algorithm>) -> Option<Algorithm> {
    if runs.is_empty() {
        ui.label(RichText::new(look.text("compare-none")).color(look.palette.quiet));
        return None;
    }
    let mut chosen = None;
    // In a narrow side there is no room for all of them.
    let n_numbers = if ui.available_width() < NARROW { 3 } else { HEADS.len() };
    let quiet = |text: String| RichText::new(text).size(12.0).color(look.palette.quiet);
    let grid = Grid::new("compare").num_columns(7).striped(true).min_row_height(22.0);
    grid.spacing([10.0, 2.0]).min_col_width(16.0).show(ui, |ui| {
        ui.label("");
        for key in &HEADS[..n_numbers] {
            let head = ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                ui.label(quiet(look.text(key)))
            });
            head.inner.on_hover_text(look.text(&format!("{key}-why")));
        }
        ui.end_row();
        for run in runs {
            if row(ui, look, run, shown == Some(run.algorithm), n_numbers) {
                chosen = Some(run.algorithm);
            }
            ui.end_row();
        }
    });
    if runs.len() < Algorithm::ALL.len() {
        ui.label(quiet(look.text("compare-too-many")));
    }
    chosen
}

/// Row of one algorithm, with the first few of its numbers; true if its name is
/// clicked.
fn row(ui: &mut Ui, look: &Look, run: &Run, is_shown: bool, n_numbers: usize) -> bool {
    let name = algorithm_name(run.algorithm, look.texts.language());
    let id = RichText::new(run.algorithm.id()).size(13.0);
    let response = ui.selectable_label(is_shown, id);
    response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_shown, &name));
    let clicked = response.on_hover_text(&name).clicked();

    let n_leaves = run.counters.get(Counter::Leaves);
    let key = if run.agrees { "compare-agrees" } else { "compare-differs" };
    let verdict = look.texts.format(key, &[("leaves", n_leaves.into())]);
    let (sign, color) =
        if run.agrees { ("=", look.palette.ink) } else { ("≠", look.palette.ray) };
    let leaves = format!("{sign} {n_leaves}");
    let numbers = [
        (leaves, color, verdict),
        (run.n_steps.to_string(), look.palette.ink, String::new()),
        (run.counters.get(Counter::NodeTouches).to_string(), look.palette.ink, String::new()),
        (run.counters.comparisons().to_string(), look.palette.ink, String::new()),
        (run.counters.get(Counter::Divisions).to_string(), look.palette.ink, String::new()),
    ];
    for (number, color, spoken) in numbers.into_iter().take(n_numbers) {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let label = ui.label(RichText::new(number).monospace().size(13.0).color(color));
            if !spoken.is_empty() {
                label.widget_info(|| WidgetInfo::labeled(Role::Label, true, spoken.as_str()));
                label.on_hover_text(spoken);
            }
        });
    }
    clicked
}
