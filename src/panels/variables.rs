//! Variables of the algorithm, with what the last step changed.

use crate::look::Look;
use crate::widgets::rich_job;
use eframe::egui::{CornerRadius, Frame, Grid, Label, Margin, Ui};
use octoscope_core::tree::NodeId;
use octoscope_figure::views::Changed;

/// Names longer than this are broken.
const NAMES_WIDTH: f32 = 72.0;

/// The variables; what the last step has changed is lit. Returns the node that is
/// pointed at.
pub fn ui(ui: &mut Ui, look: &Look, variables: &[Changed]) -> Option<NodeId> {
    let mut pointed = None;
    let most_width = (ui.available_width() - NAMES_WIDTH - 24.0).max(80.0);
    Grid::new("variables").num_columns(2).spacing([8.0, 0.0]).min_row_height(18.0).show(ui, |ui| {
        for Changed { variable, is_changed } in variables {
            ui.add(Label::new(rich_job(&variable.name, look, 13.0, NAMES_WIDTH)));
            let fill = if *is_changed { look.palette.lit } else { look.palette.panel };
            let frame = Frame::new().fill(fill).corner_radius(CornerRadius::same(3));
            let shown = frame.inner_margin(Margin::symmetric(5, 0)).show(ui, |ui| {
                ui.add(Label::new(rich_job(&variable.value, look, 13.0, most_width)));
            });
            let whole: Vec<&str> =
                variable.value.0.iter().filter_map(|span| span.whole.as_deref()).collect();
            if !whole.is_empty() {
                shown.response.clone().on_hover_text(whole.join(", "));
            }
            if ui.rect_contains_pointer(shown.response.rect) {
                pointed = variable.node;
            }
            ui.end_row();
        }
    });
    pointed
}
