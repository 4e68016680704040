//! Codes written as rows of bits.

use super::figure::{paint_figure, room};
use crate::look::Look;
use eframe::egui::{Sense, Ui, WidgetInfo, accesskit::Role};
use octoscope_figure::views::BitTable;

/// Shows the table, which has a name for readers that cannot see it.
pub fn bit_table(ui: &mut Ui, look: &Look, table: &BitTable, name: &str) {
    let figure = table.figure(f64::from(ui.available_width()));
    let (rect, response) = room(ui, figure.page, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Table, true, table.spoken(name)));
    paint_figure(ui, look, rect, &figure);
}
