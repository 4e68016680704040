//! The bits of a child, each in the colour of its axis.

use super::{bits_of, rich_job};
use crate::look::Look;
use eframe::egui::{Ui, WidgetInfo, accesskit::Role};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::tree::Child;

/// Shows the bits of `child`, x first.
pub fn child_bits<const D: usize>(ui: &mut Ui, look: &Look, child: Child<D>) {
    let spoken: Vec<_> = (0..D)
        .map(|axis| format!("{} {}", AXIS_NAMES[axis], u8::from(child.is_upper(axis))))
        .collect();
    let label = ui.label(rich_job(&bits_of(child), look, 13.0, f32::INFINITY));
    label.widget_info(|| WidgetInfo::labeled(Role::Label, true, spoken.join(", ")));
}
