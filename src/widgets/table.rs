//! Tables of the views, entry by entry.

use super::rich_job;
use crate::look::Look;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{Align, Color32, FontFamily, FontId, Grid, Ui, vec2};
use octoscope_figure::views::{Entry, Table, Tone};

/// How a table is set in a panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Tells the table apart from others in the same panel.
    pub id: &'static str,
    /// Room between columns.
    pub gap: f32,
    /// Least width of a column.
    pub least: f32,
}

/// Shows a table.
pub fn table(ui: &mut Ui, look: &Look, table: &Table, setting: Setting) {
    let n_columns = table.columns.len();
    let grid = Grid::new(setting.id).num_columns(n_columns).spacing(vec2(setting.gap, 0.0));
    grid.min_col_width(setting.least).min_row_height(18.0).show(ui, |ui| {
        for head in &table.head {
            ui.label(rich_job(head, look, 13.0, f32::INFINITY));
        }
        if !table.head.is_empty() {
            ui.end_row();
        }
        for row in &table.rows {
            for entry in row {
                ui.label(job(look, entry));
            }
            ui.end_row();
        }
    });
}

fn job(look: &Look, entry: &Entry) -> LayoutJob {
    let palette = &look.palette;
    let background = match entry.tone {
        Tone::Quiet | Tone::Plain => Color32::TRANSPARENT,
        Tone::Line => palette.current_fill,
        Tone::Used => palette.current_line.gamma_multiply(0.55),
    };
    let color = if entry.tone == Tone::Quiet { palette.quiet } else { palette.ink };
    let mut job = LayoutJob::default();
    for span in &entry.text.0 {
        let strong = span.strong || span.axis.is_some() || entry.tone == Tone::Used;
        let family = if strong { look.mono_strong_family() } else { FontFamily::Monospace };
        let font_id = FontId::new(if span.sub { look.type_size(10.0) } else { 13.0 }, family);
        let color = span.axis.map_or(color, |axis| palette.axes[axis]);
        let valign = if span.sub { Align::BOTTOM } else { Align::Center };
        let format = TextFormat { font_id, color, background, valign, ..TextFormat::default() };
        job.append(&span.text, 0.0, format);
    }
    job
}
