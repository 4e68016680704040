//! Codes written as rows of bits under a common row of bit numbers.

use super::sheet::Sheet;
use super::words::{on_axis, strong};
use crate::{Anchor, Figure, Role, metrics};
use octoscope_core::explain::RichText;

/// One row of bits.
#[derive(Clone, Debug, Default, PartialEq)]
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
#[derive(Clone, Debug, PartialEq)]
pub struct BitTable {
    /// Number of bits, the root's constant one included.
    pub width: u8,
    /// The bit whose column is framed in every row.
    pub framed: Option<u8>,
    /// The rows.
    pub rows: Vec<BitRow>,
    /// What is carried from column to column, if anything is.
    pub carries: Option<Carries>,
    /// Least room for the names of rows: tables one below the other have their
    /// columns so.
    pub name_room: f64,
}

/// Ones that are carried or borrowed, written small above the columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Carries {
    /// What they are called.
    pub name: String,
    /// The columns into which, or from which, as a mask.
    pub bits: i64,
}

/// How a table fills a width.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Measures {
    name_width: f64,
    /// Distance from bit to bit.
    pitch: f64,
    /// Room for a note under its row; 0 if the notes stand beside the bits.
    note_height: f64,
}

impl Measures {
    /// A bit narrower than this cannot be read.
    const NARROWEST: f64 = 9.0;
    /// Notes that leave less than this to a bit go below.
    const NARROW: f64 = 12.0;
    const WIDEST: f64 = 30.0;

    fn of(table: &BitTable, width: f64) -> Self {
        let widest = |of: &dyn Fn(&BitRow) -> f64| table.rows.iter().map(of).fold(0.0, f64::max);
        let name_width = table.name_width().max(table.name_room);
        let note_width =
            widest(&|row| metrics::width(Role::Note, &row.note.as_str().into())) + 10.0;
        let columns = f64::from(table.width);
        let beside = (width - name_width - note_width) / columns;
        let (pitch, note_height) = if beside < Self::NARROW {
            ((width - name_width) / columns, 16.0)
        } else {
            (beside, 0.0)
        };
        Self { name_width, pitch: pitch.clamp(Self::NARROWEST, Self::WIDEST), note_height }
    }
}

impl BitRow {
    fn title(&self) -> RichText {
        match self.axis {
            Some(axis) => on_axis(axis, self.name.as_str()),
            None => strong(self.name.as_str()),
        }
    }
}

impl BitTable {
    /// Height of the row of bit numbers, of a row of bits without its note, and of
    /// the row of carries.
    const HEADER: f64 = 16.0;
    const ROW: f64 = 29.0;
    const CARRIES: f64 = 18.0;

    /// Room that the names of its rows take.
    pub fn name_width(&self) -> f64 {
        let names = self.rows.iter().map(|row| metrics::width(Role::Heading, &row.title()));
        let carries = self.carries.iter();
        let carries = carries.map(|c| metrics::width(Role::Note, &c.name.as_str().into()));
        (names.chain(carries).fold(0.0, f64::max) + 10.0).max(22.0)
    }

    /// The table on a page of this width; the bit numbers stand above, the most
    /// significant at the left.
    pub fn figure(&self, width: f64) -> Figure {
        let Measures { name_width, pitch, note_height } = Measures::of(self, width);
        let cell = [pitch - if pitch > 16.0 { 4.0 } else { 1.0 }, 24.0];
        let middle_of =
            |bit: u8| name_width + f64::from(self.width - 1 - bit) * pitch + 0.5 * cell[0];
        let mut sheet = Sheet::default();

        // Two digits need more room than a narrow bit has.
        let every = if pitch < 16.0 { 2 } else { 1 };
        for bit in (0..self.width).filter(|bit| bit % every == 0) {
            let at = [middle_of(bit), 0.5 * Self::HEADER];
            sheet.text(Role::Note, at, Anchor::Middle, bit.to_string());
        }
        let mut top = Self::HEADER;
        if let Some(carries) = &self.carries {
            let y = top + 0.5 * Self::CARRIES;
            sheet.text(Role::Note, [0.0, y], Anchor::Start, carries.name.as_str());
            let axis = self.rows.first().and_then(|row| row.axis);
            for bit in (0..self.width).filter(|bit| carries.bits >> bit & 1 == 1) {
                let one = axis.map_or_else(|| "1".into(), |axis| on_axis(axis, "1"));
                sheet.text(Role::Note, [middle_of(bit), y], Anchor::Middle, one);
            }
            top += Self::CARRIES;
        }
        for row in &self.rows {
            let middle = top + 0.5 * Self::ROW;
            sheet.text(Role::Heading, [0.0, middle], Anchor::Start, row.title());
            if row.rule_above {
                let [left, right] =
                    [middle_of(self.width - 1) - 0.5 * cell[0], middle_of(0) + 0.5 * cell[0]];
                sheet.line(Role::Rule, [[left, top], [right, top]]);
            }
            for bit in 0..self.width {
                let centre = [middle_of(bit), middle];
                let is_lit = row.marked >> bit & 1 == 1 || self.framed == Some(bit);
                let role = if is_lit { Role::LitEntry } else { Role::Entry };
                let corner = [centre[0] - 0.5 * cell[0], centre[1] - 0.5 * cell[1]];
                sheet.rect(role, corner, cell);
                let digit = row.digit(bit);
                match row.axis.filter(|_| bit >= row.known_from) {
                    Some(axis) => {
                        sheet.text(Role::Bit, centre, Anchor::Middle, on_axis(axis, digit))
                    }
                    None => sheet.text(Role::Bit, centre, Anchor::Middle, digit),
                };
            }
            let beside = if note_height > 0.0 { middle + 20.0 } else { middle };
            // Below the bits it ends with them.
            let end = name_width + pitch * f64::from(self.width);
            if note_height > 0.0 {
                sheet.text(Role::Note, [end, beside], Anchor::End, row.note.as_str());
            } else {
                sheet.text(Role::Note, [end + 6.0, beside], Anchor::Start, row.note.as_str());
            }
            top += Self::ROW + note_height;
        }
        sheet.figure([width, top])
    }

    /// The table as a screen reader says it.
    pub fn spoken(&self, name: &str) -> String {
        let carries = self.carries.iter().map(|Carries { name, bits }| {
            let columns = (0..self.width).rev().filter(|bit| bits >> bit & 1 == 1);
            let columns: Vec<String> = columns.map(|bit| bit.to_string()).collect();
            format!("{name} {}", columns.join(", "))
        });
        let rows = self.rows.iter().map(|row| {
            let bits: String = (0..self.width).rev().map(|bit| row.digit(bit)).collect();
            format!("{} {bits} {}", row.name, row.note)
        });
        std::iter::once(name.to_owned()).chain(carries).chain(rows).collect::<Vec<_>>().join("; ")
    }
}

impl BitRow {
    fn digit(&self, bit: u8) -> &'static str {
        match (bit >= self.known_from, self.bits >> bit & 1 == 1) {
            (false, _) => "·",
            (true, true) => "1",
            (true, false) => "0",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(width: u8, name: &str, note: &str) -> BitTable {
        let row = BitRow { name: name.to_owned(), note: note.to_owned(), ..BitRow::default() };
        BitTable { width, framed: None, rows: vec![row], carries: None, name_room: 0.0 }
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
        let note = metrics::width(Role::Note, &"20 = 0.625".into());
        assert!(measures.name_width + measures.pitch * 6.0 + 6.0 + note <= 268.0, "{measures:?}");
    }

    #[test]
    fn the_spoken_table_has_every_bit() {
        assert_eq!(table(3, "x", "5").spoken("Codes"), "Codes; x 000 5");
    }
}
