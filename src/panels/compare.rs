//! All algorithms on the same ray, side by side.

use crate::comparison::Run;
use crate::look::Look;
use eframe::egui::{Grid, RichText, Ui};
use octoscope_core::explain::{algorithm_name, counter_name};
use octoscope_core::trace::Counter;
use octoscope_core::traverse::Algorithm;

/// Costs of every algorithm and whether it finds the right leaves; a click on a
/// name chooses the algorithm. Returns the chosen one.
pub fn ui(ui: &mut Ui, look: &Look, runs: &[Run], shown: Option<Algorithm>) -> Option<Algorithm> {
    if runs.is_empty() {
        ui.label(RichText::new(look.text("compare-none")).color(look.palette.quiet));
        return None;
    }
    let language = look.texts.language();
    let mut chosen = None;
    for run in runs {
        let name = algorithm_name(run.algorithm, language);
        if ui.selectable_label(shown == Some(run.algorithm), name).clicked() {
            chosen = Some(run.algorithm);
        }
        let key = if run.agrees { "compare-agrees" } else { "compare-differs" };
        let color = if run.agrees { look.palette.quiet } else { look.palette.ray };
        let verdict = look.texts.format(key, &[("steps", run.n_steps.into())]);
        ui.label(RichText::new(verdict).size(13.0).color(color));
        let grid = Grid::new(("compare", run.algorithm.id())).num_columns(4);
        grid.spacing([8.0, 0.0]).min_col_width(24.0).min_row_height(18.0).show(ui, |ui| {
            let one = |counter| (counter_name(counter, language), run.counters.get(counter));
            let compared = (look.text("counters-comparisons"), run.counters.comparisons());
            for pair in
                [[one(Counter::Leaves), one(Counter::Divisions)], [one(Counter::Touches), compared]]
            {
                for (name, number) in pair {
                    entry(ui, &name, number);
                }
                ui.end_row();
            }
            let (name, number) = one(Counter::NodeTouches);
            entry(ui, &name, number);
            ui.end_row();
        });
        ui.add_space(8.0);
    }
    if !runs.iter().any(|run| run.algorithm == Algorithm::Exhaustive) {
        let hint = look.text("compare-too-many");
        ui.label(RichText::new(hint).size(13.0).color(look.palette.quiet));
    }
    chosen
}

fn entry(ui: &mut Ui, name: &str, number: u64) {
    ui.label(RichText::new(name).size(13.0));
    ui.label(RichText::new(number.to_string()).monospace().strong());
}
