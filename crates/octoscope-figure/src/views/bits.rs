//! Codes written as rows of bits under a common row of bit numbers.

use super::sheet::Sheet;
use super::words::on_axis;
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
    /// The bit in a frame, from which something follows: that of the border, whether a code
    /// has left the domain, or the highest in which two differ, up to where.
    pub border: Option<u8>,
    /// Whether a line is drawn above, as under a column of numbers to be added.
    pub rule_above: bool,
}

/// Rows of bits of one width.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BitTable {
    /// Number of bits, the root's constant one included.
    pub width: u8,
    /// The bit whose column is framed in every row.
    pub framed: Option<u8>,
    /// The rows.
    pub rows: Vec<BitRow>,
    /// What is carried from column to column, if anything is.
    pub carries: Option<Carries>,
    /// What is concluded from a bit of the last row, below it.
    pub conclusion: Option<Conclusion>,
    /// Least room beside the bits: tables one below the other have their columns in
    /// line so.
    pub room: Beside,
    /// Whether the row of bit numbers is left out.
    pub headless: bool,
}

/// Room beside the bits of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Beside {
    /// For the names of its rows.
    pub names: f64,
    /// For the notes after them.
    pub notes: f64,
}

impl Beside {
    /// As much as both need.
    fn and(self, other: Self) -> Self {
        Self { names: self.names.max(other.names), notes: self.notes.max(other.notes) }
    }
}

/// Ones that are carried or borrowed, written small above the columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Carries {
    /// What they are called.
    pub name: String,
    /// The columns into which, or from which, as a mask.
    pub bits: i64,
}

/// An arrow from a bit to the next higher one, with a text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Conclusion {
    /// The bit.
    pub bit: u8,
    /// What is written at the arrow.
    pub text: String,
}

/// How close the rows of a table stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Spacing {
    /// As on paper.
    #[default]
    Wide,
    /// As close as the type allows, where much is to be seen at once.
    Close,
}

impl Spacing {
    /// Heights of a row of bits without its note, and of a bit's frame.
    fn heights(self) -> [f64; 2] {
        match self {
            Self::Wide => [29.0, 24.0],
            Self::Close => [20.0, 18.0],
        }
    }
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
        let Beside { names: name_width, notes: note_width } = table.needed().and(table.room);
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
    /// Its name; what stands after a low line is a subscript.
    fn title(&self) -> RichText {
        let mut title = RichText::with_subscripts(&self.name);
        for span in &mut title.0 {
            (span.axis, span.strong) = (self.axis, self.axis.is_none());
        }
        title
    }
}

/// Gives tables that stand one below the other the same room for names and for notes.
pub(super) fn in_line<'a>(tables: impl Iterator<Item = &'a mut BitTable>, room: Beside) {
    tables.for_each(|table| table.room = room);
}

/// The room that names and notes of all of these tables need.
pub(super) fn room_of<'a>(tables: impl Iterator<Item = &'a BitTable>) -> Beside {
    tables.map(BitTable::needed).fold(Beside::default(), Beside::and)
}

impl BitTable {
    /// Height of the row of bit numbers, and of the row of carries.
    pub(super) const HEADER: f64 = 16.0;
    const CARRIES: f64 = 18.0;
    const CONCLUSION: f64 = 20.0;

    /// Height of so many rows with their notes beside them, and of what is carried.
    pub(super) fn height(n_rows: usize, is_carried: bool, spacing: Spacing) -> f64 {
        let carries = if is_carried { Self::CARRIES } else { 0.0 };
        carries + n_rows as f64 * spacing.heights()[0]
    }

    /// Room that its names and notes take.
    pub fn needed(&self) -> Beside {
        Beside { names: self.name_width(), notes: self.note_width() }
    }

    fn name_width(&self) -> f64 {
        let names = self.rows.iter().map(|row| metrics::width(Role::Heading, &row.title()));
        let carries = self.carries.iter();
        let carries = carries.map(|c| metrics::width(Role::Note, &c.name.as_str().into()));
        (names.chain(carries).fold(0.0, f64::max) + 10.0).max(22.0)
    }

    fn note_width(&self) -> f64 {
        let notes = self.rows.iter();
        let notes = notes.map(|row| metrics::width(Role::Note, &row.note.as_str().into()));
        notes.fold(0.0, f64::max) + 10.0
    }

    /// The table on a page of this width; the bit numbers stand above, the most
    /// significant at the left.
    pub fn figure(&self, width: f64, spacing: Spacing) -> Figure {
        let [row_height, bit_height] = spacing.heights();
        let Measures { name_width, pitch, note_height } = Measures::of(self, width);
        let cell = [pitch - if pitch > 16.0 { 4.0 } else { 1.0 }, bit_height];
        let middle_of =
            |bit: u8| name_width + f64::from(self.width - 1 - bit) * pitch + 0.5 * cell[0];
        let mut sheet = Sheet::default();

        // Two digits need more room than a narrow bit has.
        let every = if pitch < 16.0 { 2 } else { 1 };
        let header = if self.headless { 0.0 } else { Self::HEADER };
        for bit in (0..self.width).filter(|bit| !self.headless && bit % every == 0) {
            let at = [middle_of(bit), 0.5 * header];
            sheet.text(Role::Note, at, Anchor::Middle, bit.to_string());
        }
        let mut top = header;
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
        let mut frames = Vec::new();
        for row in &self.rows {
            let middle = top + 0.5 * row_height;
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
            if let Some(bit) = row.border {
                // As far as neither touches the cells beside it.
                let around = (0.25 * (pitch - cell[0])).max(1.0) + 1.0;
                let corner =
                    [middle_of(bit) - 0.5 * cell[0] - around, middle - 0.5 * cell[1] - around];
                let size = cell.map(|side| side + 2.0 * around);
                frames.push((corner, size));
            }
            let beside = if note_height > 0.0 { middle + 0.5 * bit_height + 8.0 } else { middle };
            // Below the bits it ends with them.
            let end = name_width + pitch * f64::from(self.width);
            if note_height > 0.0 {
                sheet.text(Role::Note, [end, beside], Anchor::End, row.note.as_str());
            } else {
                sheet.text(Role::Note, [end + 6.0, beside], Anchor::Start, row.note.as_str());
            }
            top += row_height + note_height;
        }
        // Over the rule and the bits of the row below, which they touch where rows stand close.
        for (corner, size) in frames {
            sheet.rect(Role::BorderBit, corner, size);
        }
        if let Some(conclusion) = &self.conclusion {
            let [from, to] = [conclusion.bit, conclusion.bit + 1].map(middle_of);
            conclusion.draw(&mut sheet, [from, to], top - note_height, width);
            top += (Self::CONCLUSION - note_height).max(0.0);
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

impl Conclusion {
    /// Draws the arrow below the columns with these middles, and the text where there
    /// is room.
    fn draw(&self, sheet: &mut Sheet, [from, to]: [f64; 2], top: f64, width: f64) {
        const HEAD: f64 = 7.0;
        const ROOM: f64 = 8.0;
        let (start, bend) = (top - 1.0, top + 12.0);
        sheet.line(Role::Conclusion, [[from, start], [from, bend], [to, bend]]);
        sheet.arrow(Role::Conclusion, [[to, bend], [to, start]], HEAD);
        let wide = metrics::width(Role::Conclusion, &self.text.as_str().into());
        let (x, anchor) = if from + ROOM + wide <= width {
            (from + ROOM, Anchor::Start)
        } else {
            (to - ROOM, Anchor::End)
        };
        sheet.text(Role::Conclusion, [x, bend - 2.0], anchor, self.text.as_str());
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
    use crate::{Drawn, Form, Part};

    fn table(width: u8, name: &str, note: &str) -> BitTable {
        let row = BitRow { name: name.to_owned(), note: note.to_owned(), ..BitRow::default() };
        BitTable { width, rows: vec![row], ..BitTable::default() }
    }

    #[test]
    fn an_arrow_goes_from_a_bit_to_the_next_higher_one() {
        for (bit, width) in [(0, 360.0), (4, 360.0), (0, 160.0)] {
            let text = "+1 = level".to_owned();
            let table =
                BitTable { conclusion: Some(Conclusion { bit, text }), ..table(6, "or", "2") };
            let figure = table.figure(width, Spacing::Wide);
            let head = figure.drawn.iter().find(|drawn| drawn.part == Part::Head);
            let Some(Drawn { form: Form::Polygon(head), role: Role::Conclusion, .. }) = head else {
                panic!("{figure:?}")
            };
            // The number of the column above.
            let number = (bit + 1).to_string();
            let column = figure.drawn.iter().find_map(|drawn| match &drawn.form {
                Form::Text { at, text, .. } if text.plain() == number => Some(at[0]),
                Form::Text { .. }
                | Form::Polygon(_)
                | Form::Polyline(_)
                | Form::Circle { .. }
                | Form::Formula { .. } => None,
            });
            assert_eq!(column, Some(head[0][0]), "{bit}");
            let extent = figure.extent().unwrap();
            assert!(extent.max[0] <= width && extent.max[1] <= figure.page.height, "{extent:?}");
        }
    }

    #[test]
    fn a_frame_is_drawn_round_the_border_bit() {
        let mut table = table(6, "=", "16");
        (table.rows[0].border, table.rows[0].marked) = (Some(5), 1 << 5);
        let figure = table.figure(360.0, Spacing::Close);
        let corners = |role: Role| {
            figure.drawn.iter().find_map(|drawn| match &drawn.form {
                Form::Polygon(points) if drawn.role == role => Some([points[0], points[2]]),
                Form::Polygon(_)
                | Form::Polyline(_)
                | Form::Circle { .. }
                | Form::Text { .. }
                | Form::Formula { .. } => None,
            })
        };
        let [frame, bit] = [Role::BorderBit, Role::LitEntry].map(|role| corners(role).unwrap());
        assert!((0..2).all(|e| frame[0][e] < bit[0][e] && frame[1][e] > bit[1][e]));
    }

    #[test]
    fn nothing_of_the_row_below_is_drawn_over_a_frame() {
        let mut table = table(6, "=", "16");
        table.rows[0].border = Some(5);
        let name = "xor".to_owned();
        table.rows.push(BitRow { name, rule_above: true, ..BitRow::default() });
        let figure = table.figure(360.0, Spacing::Close);
        let last = figure.drawn.last().map(|drawn| drawn.role);
        assert_eq!(last, Some(Role::BorderBit));
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
