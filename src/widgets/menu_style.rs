//! How menus and lists look.

use eframe::egui::Style;
use eframe::egui::containers::menu::menu_style;

/// The toolkit's look of menus, in which a focused row is a pale patch, with the ring that
/// focused buttons have.
pub fn menu_style_with_ring(style: &mut Style) {
    let ring = style.visuals.widgets.active.bg_stroke;
    menu_style(style);
    style.visuals.widgets.active.bg_stroke = ring;
}
