//! Variables of the algorithm, with what the last step changed.

use crate::look::Look;
use crate::widgets::{heading, rich_job};
use eframe::egui::{CornerRadius, Frame, Grid, Label, Margin, Ui};
use octoscope_core::explain::Variable;

/// Variables `now`; those that differ from `before` are lit.
pub fn ui(ui: &mut Ui, look: &Look, now: &[Variable], before: &[Variable]) {
    heading(ui, look, &look.text("panel-variables"), "");
    Grid::new("variables").num_columns(2).spacing([14.0, 3.0]).min_row_height(20.0).show(
        ui,
        |ui| {
            for variable in now {
                let was = before.iter().find(|v| v.name == variable.name);
                let changed = was.is_none_or(|was| was.value != variable.value);
                ui.add(Label::new(rich_job(&variable.name, look, 14.0, 160.0)));
                let fill = if changed { look.palette.current_fill } else { look.palette.panel };
                let frame = Frame::new().fill(fill).corner_radius(CornerRadius::same(3));
                frame.inner_margin(Margin::symmetric(5, 1)).show(ui, |ui| {
                    let width = ui.available_width().max(120.0);
                    ui.add(Label::new(rich_job(&variable.value, look, 14.0, width)));
                });
                ui.end_row();
            }
        },
    );
}
