//! A slider with a field beside it.

use super::ranged_field::field_in_range;
use crate::look::Look;
use eframe::egui::emath::Numeric;
use eframe::egui::{Response, Slider, SliderClamping, Stroke, Ui, WidgetInfo};

/// Slider for a number from the first to the last of `range`, `set` as it is to be, with
/// a field to type it into; both are called `name` by a screen reader. Dragging the field
/// changes the number by `drag_speed` a point. A number outside of the range stays as it
/// is until it is changed. Returns the slider.
pub fn slider_field<N: Numeric>(
    ui: &mut Ui,
    look: &Look,
    name: &str,
    value: &mut N,
    range: [N; 2],
    drag_speed: f64,
    set: impl FnOnce(Slider<'_>) -> Slider<'_>,
) -> Response {
    /// Widths of the field, and of the shortest slider.
    const FIELD: f32 = 52.0;
    const SHORTEST: f32 = 60.0;
    /// Width of the border of the knob.
    const KNOB: f32 = 5.0;
    let row = ui.horizontal(|ui| {
        let spacing = ui.spacing_mut();
        spacing.interact_size.x = FIELD;
        let room = FIELD + spacing.item_spacing.x;
        ui.spacing_mut().slider_width = (ui.available_width() - room).max(SHORTEST);
        let clamping = SliderClamping::Edits;
        let slider = Slider::new(value, range[0]..=range[1]).clamping(clamping);
        let response = ui
            .scope(|ui| {
                let widgets = &mut ui.visuals_mut().widgets;
                widgets.inactive.bg_fill = look.palette.rail;
                // The knob is all but filled by its border: it has the fill of the rail.
                for knob in [&mut widgets.inactive, &mut widgets.hovered, &mut widgets.active] {
                    knob.fg_stroke = Stroke::new(KNOB, look.palette.ink);
                }
                ui.add(set(slider).show_value(false))
            })
            .inner;
        let shown = value.to_f64();
        response.widget_info(|| WidgetInfo::slider(true, shown, name));
        field_in_range(ui, look, name, value, range, drag_speed, clamping);
        response
    });
    row.inner
}
