//! Tables of the views, entry by entry.

use crate::look::Look;
use eframe::egui::text::LayoutJob;
use eframe::egui::{
    FontFamily, Galley, Label, Painter, Rect, Response, Sense, Stroke, StrokeKind, Ui, WidgetInfo,
    accesskit::Role, pos2, text::TextFormat, vec2,
};
use octoscope_core::explain::RichText;
use octoscope_figure::views::{Entry, EntryKind, Table, Tone};
use std::sync::Arc;

/// How a table is set in a panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Room between columns.
    pub gap: f32,
    /// Least width of a column.
    pub least: f32,
    /// Least height of a row.
    pub row: f32,
}

/// Height of type in a table.
const SIZE: f32 = 13.0;
/// Height of a row without subscripts.
pub const ROW: f32 = 18.0;
/// How far the ground of a lit entry may reach beyond the table.
const BEYOND: f32 = 4.0;

/// Shows a table: what is lit fills its cells, and what is used bears a frame. Returns its
/// entries row by row, without the head.
pub fn table(ui: &mut Ui, look: &Look, table: &Table, setting: Setting) -> Vec<Vec<Response>> {
    let painter = ui.painter().clone();
    let letters = Letters::of(&painter, look, table);
    let (widths, height) = (letters.widths(setting), letters.height(setting.row));
    let Letters { head, rows } = letters;
    let n_lines = rows.len() + usize::from(!head.is_empty());
    let size = vec2(whole(&widths, setting), height * n_lines as f32);
    let (room, _) = ui.allocate_exact_size(size, Sense::hover());
    let cell = |line: usize, column: usize| {
        let before: f32 = widths[..column].iter().map(|wide| wide + setting.gap).sum();
        let corner = room.min + vec2(before, height * line as f32);
        Rect::from_min_size(corner, vec2(widths[column], height))
    };
    let put = |ui: &mut Ui, cell: Rect, column: usize, galley: &Arc<Galley>| {
        let share = table.columns[column].share() as f32;
        let x = cell.left() + share * (cell.width() - galley.size().x);
        // The middle of its capitals is that of the row.
        let y = cell.center().y + 0.36 * look.type_size(SIZE) - baseline(galley);
        let place = Rect::from_min_size(pos2(x, y.round()), galley.size());
        ui.put(place, Label::new(Arc::clone(galley)))
    };
    for (column, galley) in head.iter().enumerate().filter(|(_, galley)| !galley.is_empty()) {
        put(ui, cell(0, column), column, galley);
    }
    let n_heads = n_lines - rows.len();
    let mut shown = Vec::new();
    for (n, (row, galleys)) in table.rows.iter().zip(&rows).enumerate() {
        for run in runs(row) {
            let [first, last] = [run.first, run.last].map(|column| cell(n + n_heads, column));
            let beyond = (0.5 * setting.gap).min(BEYOND);
            let ground = first.union(last).expand2(vec2(beyond, 0.0));
            light(&painter, look, ground, run.tone);
        }
        let entries = row.iter().zip(galleys).enumerate().map(|(column, (entry, galley))| {
            let response = put(ui, cell(n + n_heads, column), column, galley);
            let spoken = entry.text.plain();
            response.widget_info(|| WidgetInfo::labeled(Role::Label, true, spoken.as_str()));
            response
        });
        shown.push(entries.collect());
    }
    shown
}

/// How wide a table is when it is shown.
pub fn table_width(ui: &Ui, look: &Look, table: &Table, setting: Setting) -> f32 {
    whole(&Letters::of(ui.painter(), look, table).widths(setting), setting)
}

/// How high every row of a table is when it is shown.
pub fn row_height(ui: &Ui, look: &Look, table: &Table) -> f32 {
    Letters::of(ui.painter(), look, table).height(ROW)
}

/// What is written in a table, laid out.
struct Letters {
    head: Vec<Arc<Galley>>,
    rows: Vec<Vec<Arc<Galley>>>,
}

impl Letters {
    fn of(painter: &Painter, look: &Look, table: &Table) -> Self {
        let row = |row: &Vec<Entry>| row.iter().map(|e| galley_of(painter, look, e)).collect();
        Self {
            head: table.head.iter().map(|text| head_of(painter, look, text)).collect(),
            rows: table.rows.iter().map(row).collect(),
        }
    }

    /// Width of every column.
    fn widths(&self, setting: Setting) -> Vec<f32> {
        let lines = || self.rows.iter().chain([&self.head]);
        let n_columns = lines().map(Vec::len).max().unwrap_or(0);
        let widest = |column: usize| {
            let galleys = lines().filter_map(|line| line.get(column));
            galleys.map(|galley| galley.size().x).fold(setting.least, f32::max)
        };
        (0..n_columns).map(widest).collect()
    }

    /// Height of every row, at least `least`.
    fn height(&self, least: f32) -> f32 {
        let all = self.rows.iter().chain([&self.head]).flatten();
        all.map(|galley| galley.size().y).fold(least, f32::max).ceil()
    }
}

fn whole(widths: &[f32], setting: Setting) -> f32 {
    widths.iter().sum::<f32>() + setting.gap * widths.len().saturating_sub(1) as f32
}

/// Neighbouring entries of a row that are lit alike.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Run {
    first: usize,
    last: usize,
    tone: Tone,
}

fn runs(row: &[Entry]) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for (column, entry) in row.iter().enumerate() {
        match (runs.last_mut(), entry.tone) {
            (_, Tone::Quiet | Tone::Plain) => {}
            (Some(run), tone) if run.tone == tone && run.last + 1 == column => run.last = column,
            (_, tone @ (Tone::Line | Tone::Used)) => {
                runs.push(Run { first: column, last: column, tone });
            }
        }
    }
    runs
}

fn light(painter: &Painter, look: &Look, ground: Rect, tone: Tone) {
    painter.rect_filled(ground, 2.0, look.palette.lit);
    if tone == Tone::Used {
        let frame = Stroke::new(1.5, look.palette.current_line);
        painter.rect_stroke(ground, 2.0, frame, StrokeKind::Inside);
    }
}

/// How far below its top the first line of a text stands.
fn baseline(galley: &Galley) -> f32 {
    let row = galley.rows.first();
    row.and_then(|row| Some(row.pos.y + row.glyphs.first()?.pos.y)).unwrap_or(0.0)
}

/// The head of a column.
fn head_of(painter: &Painter, look: &Look, text: &RichText) -> Arc<Galley> {
    let mut job = LayoutJob::default();
    for span in &text.0 {
        let is_axis = span.axis.is_some();
        let family = if is_axis { look.strong_family() } else { FontFamily::Proportional };
        let mut format = look.set(span, 12.0, family);
        format.color = span.axis.map_or(look.palette.quiet, |axis| look.palette.axes[axis]);
        job.append(&span.text, 0.0, format);
    }
    painter.layout_job(job)
}

fn galley_of(painter: &Painter, look: &Look, entry: &Entry) -> Arc<Galley> {
    let palette = &look.palette;
    let is_quiet = entry.tone == Tone::Quiet;
    let ink = if is_quiet { palette.quiet } else { palette.ink };
    let mut job = LayoutJob::default();
    for span in &entry.text.0 {
        // What is out of the question has no colour either.
        let axis = span.axis.filter(|_| !is_quiet);
        let is_strong = span.strong || axis.is_some() || entry.tone == Tone::Used;
        let color = axis.map_or(ink, |axis| palette.axes[axis]);
        let format = look.set(span, SIZE, family(look, entry.kind, is_strong));
        job.append(&span.text, 0.0, TextFormat { color, ..format });
    }
    painter.layout_job(job)
}

/// Numbers and what stands in columns is in the mono, words in the sans.
fn family(look: &Look, kind: EntryKind, is_strong: bool) -> FontFamily {
    match (kind, is_strong) {
        (EntryKind::Words, false) => FontFamily::Proportional,
        (EntryKind::Words, true) => look.strong_family(),
        (EntryKind::Columns, false) => FontFamily::Monospace,
        (EntryKind::Columns, true) => look.mono_strong_family(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_that_are_lit_alike_share_a_ground() {
        let row = [Tone::Used, Tone::Used, Tone::Line, Tone::Plain, Tone::Line];
        let row = row.map(|tone| Entry::new("0", tone));
        let told: Vec<_> = runs(&row).iter().map(|run| (run.first, run.last, run.tone)).collect();
        assert_eq!(told, [(0, 1, Tone::Used), (2, 2, Tone::Line), (4, 4, Tone::Line)]);
    }
}
