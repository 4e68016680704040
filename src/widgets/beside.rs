//! Two things side by side where there is room for them.

use eframe::egui::Ui;

/// Sides of less than this, in points, have no room for two tables side by side.
const NARROW: f32 = 330.0;

/// Whether a side has no room for two tables side by side.
pub fn is_narrow(ui: &Ui) -> bool {
    ui.available_width() < NARROW
}

/// Shows what `add` shows from left to right, or in a narrow side from top to bottom.
pub fn beside_or_below(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    if is_narrow(ui) {
        ui.vertical(add);
    } else {
        ui.horizontal_top(add);
    }
}
