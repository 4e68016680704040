//! What the algorithm has cost.

use crate::look::Look;
use eframe::egui::{CollapsingHeader, Grid, RichText, Ui};
use octoscope_core::explain::counter_name;
use octoscope_core::trace::{Counter, Counters};

/// Costs at one moment of a run.
#[derive(Clone, Copy, Debug)]
pub struct Costs<'a> {
    /// Of the last step.
    pub step: &'a Counters,
    /// Of all steps so far.
    pub so_far: &'a Counters,
    /// Of the whole run.
    pub total: &'a Counters,
    /// Leaves that were met, in this step and so far, where they are reported only at the
    /// end.
    pub met: [u64; 2],
}

/// What is shown of the costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detail {
    /// The most important ones, large; the others on demand.
    Summary,
    /// All.
    Full,
}

/// The counters that the run uses.
pub fn ui(ui: &mut Ui, look: &Look, costs: Costs<'_>, detail: Detail) {
    match detail {
        Detail::Summary => {
            summary(ui, look, costs);
            let all = RichText::new(look.text("counters-all")).size(13.0);
            CollapsingHeader::new(all).id_salt("all-counters").show(ui, |ui| {
                table(ui, look, costs);
            });
        }
        Detail::Full => table(ui, look, costs),
    }
}

/// Number of counters in the summary.
const N_LARGE: usize = 4;

fn summary(ui: &mut Ui, look: &Look, costs: Costs<'_>) {
    let name = |counter| counter_name(counter, look.texts.language());
    let one = |counter| (name(counter), [costs.step, costs.so_far].map(|c| c.get(counter)));
    let compared = [costs.step, costs.so_far].map(Counters::comparisons);
    let is_any_reported = costs.so_far.get(Counter::Leaves) > 0;
    let leaves = if is_any_reported || costs.met[1] == 0 {
        one(Counter::Leaves)
    } else {
        (look.text("counters-met"), costs.met)
    };
    let counters = [one(Counter::NodeTouches), leaves].into_iter();
    let counters = counters
        .chain([(look.text("counters-comparisons"), compared)])
        .chain([Counter::Divisions, Counter::BitOperations, Counter::Descends].map(one));
    let in_total = [
        costs.total.get(Counter::NodeTouches),
        costs.total.get(Counter::Leaves),
        costs.total.comparisons(),
        costs.total.get(Counter::Divisions),
        costs.total.get(Counter::BitOperations),
        costs.total.get(Counter::Descends),
    ];
    let used = counters.zip(in_total).filter(|(_, total)| *total > 0).take(N_LARGE);
    let used: Vec<_> = used.collect();
    // Few have room for longer names.
    ui.columns(used.len().clamp(N_LARGE - 1, N_LARGE), |columns| {
        for (column, ((name, [step, so_far]), _)) in columns.iter_mut().zip(used) {
            column.spacing_mut().item_spacing.y = 0.0;
            column.horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = 4.0;
                let number = RichText::new(so_far.to_string()).size(20.0);
                ui.label(number.family(look.strong_family()).color(look.palette.ink));
                if step > 0 {
                    let added = RichText::new(format!("+{step}")).size(look.type_size(12.0));
                    ui.label(added.color(look.palette.quiet));
                }
            });
            let caption = RichText::new(name).size(look.type_size(12.0)).color(look.palette.quiet);
            let caption = column.add(eframe::egui::Label::new(caption).truncate());
            caption.on_hover_text(look.text("counters-why"));
        }
    });
}

fn table(ui: &mut Ui, look: &Look, costs: Costs<'_>) {
    let caption = |key: &str| {
        RichText::new(look.text(key)).size(look.type_size(12.0)).color(look.palette.quiet)
    };
    let grid = Grid::new("counters").num_columns(4).striped(true);
    grid.spacing([8.0, 0.0]).min_col_width(24.0).min_row_height(18.0).show(ui, |ui| {
        ui.label("");
        for key in ["counters-step", "counters-so-far", "counters-total"] {
            ui.label(caption(key)).on_hover_text(look.text("counters-why"));
        }
        ui.end_row();
        let used = Counter::ALL.into_iter().filter(|&counter| costs.total.get(counter) > 0);
        for counter in used {
            let name = counter_name(counter, look.texts.language());
            ui.label(RichText::new(name).size(13.0));
            let now = costs.step.get(counter);
            let now = if now == 0 { "·".to_owned() } else { format!("+{now}") };
            ui.label(RichText::new(now).monospace());
            ui.label(RichText::new(costs.so_far.get(counter).to_string()).monospace().strong());
            let total = RichText::new(costs.total.get(counter).to_string()).monospace();
            ui.label(total.color(look.palette.quiet));
            ui.end_row();
        }
    });
}
