//! How far a work is, as a bar with its percentage.

use eframe::egui::{Align, Layout, ProgressBar, Ui, vec2};

/// A bar as wide as there is room, with the part that is done, 0 to 1, behind it: within
/// the bar no colour would be read on both of its parts.
pub fn progress_bar(ui: &mut Ui, part: f64) {
    const PERCENTAGE: f32 = 48.0;
    let row = vec2(ui.available_width(), ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(row, Layout::left_to_right(Align::Center), |ui| {
        let width = ui.available_width() - PERCENTAGE - ui.spacing().item_spacing.x;
        ui.add(ProgressBar::new(part as f32).desired_width(width).desired_height(10.0));
        ui.label(format!("{} %", (part * 100.0) as usize));
    });
}
