//! Two things side by side where there is room for them.

use eframe::egui::Ui;

/// Sides of less than this, in points, have no room for two tables side by side.
const NARROW: f32 = 330.0;

/// Shows what `add` shows from left to right, or in a narrow side from top to bottom.
pub fn beside_or_below(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    if ui.available_width() < NARROW {
        ui.vertical(add);
    } else {
        ui.horizontal_top(add);
    }
}
