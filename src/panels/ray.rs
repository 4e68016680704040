//! The ray in numbers.

use crate::look::Look;
use crate::widgets::{heading, number_field};
use eframe::egui::{FontId, Grid, RichText, Ui};
use octoscope_core::geometry::{AXIS_NAMES, Ray};

/// Fields for origin and direction; writes to `ray` what makes a ray. Returns
/// why the last entry makes none.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, ray: &mut Ray<D>, side: f64) -> Option<String> {
    let (mut origin, mut direction) = (ray.origin(), ray.direction());
    const GAP: f32 = 12.0;
    let title = look.text("panel-ray");
    let font = FontId::new(14.0, look.strong_family());
    let name = ui.painter().layout_no_wrap(title.clone(), font, look.palette.ink).size().x;
    let name = name.max(ui.spacing().interact_size.x);
    // Whole points: what is rounded up must not widen the column.
    let width = (0.5 * (ui.available_width() - name) - GAP).floor();
    let grid = Grid::new("ray").num_columns(3).spacing([GAP, 4.0]);
    grid.max_col_width(width).show(ui, |ui| {
        heading(ui, look, &title, "");
        for key in ["ray-origin", "ray-direction"] {
            ui.label(RichText::new(look.text(key)).size(13.0).color(look.palette.quiet));
        }
        ui.end_row();
        for axis in 0..D {
            let color = look.palette.axes[axis];
            ui.label(RichText::new(AXIS_NAMES[axis]).strong().color(color));
            for (key, value) in
                [("ray-origin", &mut origin[axis]), ("ray-direction", &mut direction[axis])]
            {
                let name = format!("{} {}", look.text(key), AXIS_NAMES[axis]);
                number_field(ui, look, &name, value, side / 256.0, color);
            }
            ui.end_row();
        }
    });
    if (origin, direction) == (ray.origin(), ray.direction()) {
        // Equal as numbers, but −0 and 0 are told apart.
        let bits = |r: &Ray<D>| (r.origin().map(f64::to_bits), r.direction().map(f64::to_bits));
        if (origin.map(f64::to_bits), direction.map(f64::to_bits)) == bits(ray) {
            return None;
        }
    }
    match Ray::new(origin, direction) {
        Ok(edited) => {
            *ray = edited;
            None
        }
        Err(_) => Some(look.text("ray-refused")),
    }
}
