//! All algorithms on the same ray, side by side.

use crate::comparison::Run;
use crate::look::Look;
use eframe::egui::{Align, FontId, Grid, Layout, RichText, Ui, WidgetInfo, accesskit::Role};
use octoscope_core::explain::algorithm_name;
use octoscope_core::trace::Counter;
use octoscope_core::traverse::Algorithm;

/// Room between two columns.
const GAP: f32 = 10.0;
/// Room inside the button of a name, and a little more.
const BUTTON: f32 = 20.0;

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
    let n_numbers = n_fitting(ui, look, runs);
    let quiet = |text: String| RichText::new(text).size(12.0).color(look.palette.quiet);
    let grid = Grid::new("compare").num_columns(7).striped(true).min_row_height(22.0);
    grid.spacing([GAP, 2.0]).min_col_width(16.0).show(ui, |ui| {
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

/// Number of the columns of numbers for which there is room.
fn n_fitting(ui: &Ui, look: &Look, runs: &[Run]) -> usize {
    let width = |text: String, font: FontId| {
        ui.painter().layout_no_wrap(text, font, look.palette.ink).size().x
    };
    let widest = |widths: &mut dyn Iterator<Item = f32>| widths.fold(16.0, f32::max);
    let name = |run: &Run| width(run.algorithm.id().to_owned(), FontId::proportional(13.0));
    let names = widest(&mut runs.iter().map(name)) + BUTTON;
    let columns = HEADS.iter().enumerate().scan(names, |end, (n, key)| {
        let head = width(look.text(key), FontId::proportional(12.0));
        let number = |run: &Run| width(numbers(run)[n].clone(), FontId::monospace(13.0));
        *end += GAP + widest(&mut runs.iter().map(number)).max(head);
        Some(*end)
    });
    let room = ui.available_width();
    columns.take_while(|&end| end <= room).count().max(1)
}

/// What is told of a run, column by column.
fn numbers(run: &Run) -> [String; HEADS.len()] {
    let sign = if run.agrees { "=" } else { "≠" };
    [
        format!("{sign} {}", run.counters.get(Counter::Leaves)),
        run.n_steps.to_string(),
        run.counters.get(Counter::NodeTouches).to_string(),
        run.counters.comparisons().to_string(),
        run.counters.get(Counter::Divisions).to_string(),
    ]
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
    for (n, number) in numbers(run).into_iter().enumerate().take(n_numbers) {
        let is_wrong = n == 0 && !run.agrees;
        let color = if is_wrong { look.palette.ray } else { look.palette.ink };
        let spoken = if n == 0 { verdict.as_str() } else { "" };
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let label = ui.label(RichText::new(number).monospace().size(13.0).color(color));
            if !spoken.is_empty() {
                label.widget_info(|| WidgetInfo::labeled(Role::Label, true, spoken));
                label.on_hover_text(spoken);
            }
        });
    }
    clicked
}
