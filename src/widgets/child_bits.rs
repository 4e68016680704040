//! The bits of a child, each in the colour of its axis.

use crate::look::Look;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{FontId, Ui, WidgetInfo, accesskit::Role};
use octoscope_core::geometry::{AXIS_NAMES, Axes};
use octoscope_core::tree::Child;

/// Shows the bits of `child`, x first; those of the axes in `flipped` are lit.
pub fn child_bits<const D: usize>(ui: &mut Ui, look: &Look, child: Child<D>, flipped: Axes<D>) {
    let mut job = LayoutJob::default();
    for axis in 0..D {
        let background = match flipped.contains(axis) {
            true => look.palette.current_line.gamma_multiply(0.55),
            false => look.palette.panel.gamma_multiply(0.0),
        };
        let color = if flipped.contains(axis) { look.palette.ink } else { look.palette.axes[axis] };
        let font_id = FontId::new(13.0, look.mono_strong_family());
        let format = TextFormat { font_id, color, background, ..TextFormat::default() };
        job.append(bit(child, axis), if axis == 0 { 0.0 } else { 3.0 }, format);
    }
    let spoken: Vec<_> =
        (0..D).map(|axis| format!("{} {}", AXIS_NAMES[axis], bit(child, axis))).collect();
    let label = ui.label(job);
    label.widget_info(|| WidgetInfo::labeled(Role::Label, true, spoken.join(", ")));
}

fn bit<const D: usize>(child: Child<D>, axis: usize) -> &'static str {
    if child.is_upper(axis) { "1" } else { "0" }
}
