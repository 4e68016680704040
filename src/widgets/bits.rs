//! Codes written as rows of bits.

use super::figure::{paint_figure, room};
use crate::look::Look;
use eframe::egui::{Sense, Ui, WidgetInfo, accesskit::Role};
use octoscope_figure::views::{BitTable, Spacing};

/// Shows the table, which has a name for readers that cannot see it; close where a
/// hall has to see all of it.
pub fn bit_table(ui: &mut Ui, look: &Look, table: &BitTable, spacing: Spacing, name: &str) {
    let spacing = if look.is_for_hall() { Spacing::Close } else { spacing };
    let figure = table.figure(f64::from(ui.available_width()), spacing);
    let (rect, response) = room(ui, figure.page, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Table, true, table.spoken(name)));
    paint_figure(ui, look, rect, &figure);
}
