//! Codes written as rows of bits under a common row of bit numbers.

use crate::look::Look;
use eframe::egui::{
    Align2, CornerRadius, FontId, Rect, Sense, Stroke, StrokeKind, Ui, Vec2, WidgetInfo,
    accesskit::Role, pos2, vec2,
};

/// One row of bits.
#[derive(Clone, Debug, Default)]
pub struct BitRow {
    /// What the row is, in front of it.
    pub name: String,
    /// Axis whose colour it has.
    pub axis: Option<usize>,
    /// The bits; of a negative number in two's complement.
    pub bits: i64,
    /// Bits from here on are known; lower ones are shown as dots.
    pub known_from: u8,
    /// Text after the row.
    pub note: String,
    /// Bits that are marked, as a mask.
    pub marked: i64,
    /// Whether a line is drawn above, as under a column of numbers to be added.
    pub rule_above: bool,
}

/// Rows of bits of one width.
#[derive(Clone, Debug)]
pub struct BitTable {
    /// Number of bits, the root's constant one included.
    pub width: u8,
    /// The bit whose column is framed in every row.
    pub framed: Option<u8>,
    /// The rows.
    pub rows: Vec<BitRow>,
}

/// How a table fills a width.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Measures {
    name_width: f32,
    /// Distance from bit to bit.
    pitch: f32,
    /// Room for a note under its row; 0 if the notes stand beside the bits.
    note_height: f32,
}

impl Measures {
    /// A bit narrower than this cannot be read.
    const NARROWEST: f32 = 9.0;
    /// Notes that leave less than this to a bit go below.
    const NARROW: f32 = 12.0;
    const WIDEST: f32 = 30.0;

    fn of(table: &BitTable, width: f32) -> Self {
        let longest = |text: fn(&BitRow) -> &String| {
            table.rows.iter().map(|row| text(row).chars().count()).max().unwrap_or(0) as f32
        };
        let name_width = (longest(|row| &row.name) * 8.0 + 10.0).max(22.0);
        let note_width = longest(|row| &row.note) * 7.4 + 6.0;
        let columns = f32::from(table.width);
        let beside = (width - name_width - note_width) / columns;
        let (pitch, note_height) = if beside < Self::NARROW {
            ((width - name_width) / columns, 16.0)
        } else {
            (beside, 0.0)
        };
        Self { name_width, pitch: pitch.clamp(Self::NARROWEST, Self::WIDEST), note_height }
    }
}

/// Draws the table; the bit numbers stand above, the most significant at the left.
pub fn bit_table(ui: &mut Ui, look: &Look, table: &BitTable, name: &str) {
    let palette = &look.palette;
    let width = ui.available_width();
    let Measures { name_width, pitch, note_height } = Measures::of(table, width);
    let cell = vec2(pitch - if pitch > 16.0 { 4.0 } else { 1.0 }, 24.0);
    let row_height = 29.0 + note_height;
    let header = 16.0;
    let height = header + row_height * table.rows.len() as f32;
    let (rect, response) = ui.allocate_exact_size(vec2(width, height), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Table, true, spoken(name, table)));
    if !ui.is_rect_visible(rect) {
        return;
    }
    let painter = ui.painter_at(rect.expand(2.0));
    let small = FontId::monospace((pitch * 0.62).clamp(7.0, 11.0));
    let digits = FontId::new((pitch * 0.8).clamp(9.0, 15.0), look.mono_strong_family());
    let left_of = |bit: u8| rect.left() + name_width + f32::from(table.width - 1 - bit) * pitch;
    let every = if pitch < 13.0 { 2 } else { 1 };

    for bit in (0..table.width).filter(|bit| bit % every == 0) {
        let at = pos2(left_of(bit) + cell.x / 2.0, rect.top() + header / 2.0);
        painter.text(at, Align2::CENTER_CENTER, bit.to_string(), small.clone(), palette.quiet);
    }
    for (n, row) in table.rows.iter().enumerate() {
        let top = rect.top() + header + row_height * n as f32;
        let middle = top + (row_height - note_height) / 2.0;
        let color = row.axis.map_or(palette.ink, |axis| palette.axes[axis]);
        let font = FontId::new(14.0, look.strong_family());
        let at = pos2(rect.left(), middle);
        painter.text(at, Align2::LEFT_CENTER, &row.name, font, color);
        if row.rule_above {
            let from = left_of(table.width - 1);
            painter.hline(from..=left_of(0) + cell.x, top, Stroke::new(1.5, palette.quiet));
        }
        for bit in 0..table.width {
            let centre = pos2(left_of(bit) + cell.x / 2.0, middle);
            let place = Rect::from_center_size(centre, cell);
            let known = bit >= row.known_from;
            let marked = row.marked >> bit & 1 == 1;
            let framed = table.framed == Some(bit);
            paint_cell(&painter, look, place, marked || framed);
            let digit = match (known, row.bits >> bit & 1 == 1) {
                (false, _) => "·",
                (true, true) => "1",
                (true, false) => "0",
            };
            let color = if known { color } else { palette.quiet };
            painter.text(centre, Align2::CENTER_CENTER, digit, digits.clone(), color);
        }
        let beside = if note_height > 0.0 { middle + 20.0 } else { middle };
        let at = pos2(rect.right(), beside);
        painter.text(at, Align2::RIGHT_CENTER, &row.note, FontId::monospace(12.0), palette.quiet);
    }
}

fn paint_cell(painter: &eframe::egui::Painter, look: &Look, place: Rect, marked: bool) {
    let palette = &look.palette;
    let corners = CornerRadius::same(3);
    if marked {
        painter.rect_filled(place, corners, palette.current_fill);
        let stroke = Stroke::new(2.0, palette.current_line);
        painter.rect_stroke(place, corners, stroke, StrokeKind::Inside);
    } else {
        painter.rect_filled(place, corners, palette.field);
        let stroke = Stroke::new(1.0, palette.grid);
        painter.rect_stroke(place.shrink2(Vec2::ZERO), corners, stroke, StrokeKind::Inside);
    }
}

/// The table as a screen reader says it.
fn spoken(name: &str, table: &BitTable) -> String {
    let rows = table.rows.iter().map(|row| {
        let bits: String = (0..table.width)
            .rev()
            .map(|bit| match (bit >= row.known_from, row.bits >> bit & 1) {
                (false, _) => '·',
                (true, 1) => '1',
                (true, _) => '0',
            })
            .collect();
        format!("{} {bits} {}", row.name, row.note)
    });
    std::iter::once(name.to_owned()).chain(rows).collect::<Vec<_>>().join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(width: u8, name: &str, note: &str) -> BitTable {
        let row = BitRow { name: name.to_owned(), note: note.to_owned(), ..BitRow::default() };
        BitTable { width, framed: None, rows: vec![row] }
    }

    #[test]
    fn the_deepest_codes_fit_into_a_panel_of_300_points() {
        for (name, note) in [("x", "1048575 = 0.9999990463256836"), ("xor", "level 20")] {
            let table = table(21, name, note);
            // A panel has margins of 16 points.
            let measures = Measures::of(&table, 268.0);
            assert!(measures.name_width + measures.pitch * 21.0 <= 268.0, "{measures:?}");
            assert!(measures.pitch > Measures::NARROWEST, "{measures:?}");
            assert!(measures.note_height > 0.0);
        }
    }

    #[test]
    fn short_codes_have_their_notes_beside_them() {
        let measures = Measures::of(&table(6, "x", "20 = 0.625"), 268.0);
        assert_eq!(measures.note_height, 0.0);
        assert!(measures.name_width + measures.pitch * 6.0 + 80.0 <= 268.0, "{measures:?}");
    }
}
