//! What the algorithm has cost.

use crate::look::Look;
use crate::widgets::heading;
use eframe::egui::{Grid, RichText, Ui};
use octoscope_core::explain::counter_name;
use octoscope_core::trace::{Counter, Counters};

/// Counters of the step, so far, and of the whole run.
pub fn ui(ui: &mut Ui, look: &Look, step: &Counters, so_far: &Counters, total: &Counters) {
    heading(ui, look, &look.text("panel-counters"), "");
    let caption = |key: &str| RichText::new(look.text(key)).size(13.0).color(look.palette.quiet);
    Grid::new("counters")
        .num_columns(4)
        .striped(true)
        .spacing([12.0, 4.0])
        .min_row_height(20.0)
        .show(ui, |ui| {
            ui.label("");
            for key in ["counters-step", "counters-so-far", "counters-total"] {
                ui.label(caption(key));
            }
            ui.end_row();
            let used = Counter::ALL.into_iter().filter(|&counter| total.get(counter) > 0);
            for counter in used {
                ui.label(counter_name(counter, look.texts.language()));
                let now = step.get(counter);
                ui.label(
                    RichText::new(if now == 0 { "·".to_owned() } else { format!("+{now}") })
                        .monospace(),
                );
                ui.label(RichText::new(so_far.get(counter).to_string()).monospace().strong());
                ui.label(
                    RichText::new(total.get(counter).to_string())
                        .monospace()
                        .color(look.palette.quiet),
                );
                ui.end_row();
            }
        });
}
