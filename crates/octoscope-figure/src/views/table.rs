//! Tables, lit where the algorithm uses them: as values, which panels show
//! entry by entry, and as parts of figures.

use super::sheet::Sheet;
use crate::{Anchor, Role, metrics};
use octoscope_core::explain::RichText;

/// A table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// How the entries of each column stand.
    pub columns: Vec<Anchor>,
    /// Heads of the columns; none if empty.
    pub head: Vec<RichText>,
    /// The entries, row by row.
    pub rows: Vec<Vec<Entry>>,
}

/// Entry of a table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Entry {
    /// What is written.
    pub text: RichText,
    /// How much it has to do with the present step.
    pub tone: Tone,
    /// What kind of text it is.
    pub kind: EntryKind,
}

/// What kind of text an entry of a table is, by which a panel chooses its typeface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum EntryKind {
    /// Numbers, signs and letters that stand below each other.
    #[default]
    Columns,
    /// Words.
    Words,
}

/// How much an entry of a table has to do with the present step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tone {
    /// It is out of the question.
    Quiet,
    /// Nothing in particular.
    #[default]
    Plain,
    /// It is in the line that is used.
    Line,
    /// It is used.
    Used,
}

impl Entry {
    /// Entry of numbers, signs or letters, of this tone.
    pub fn new(text: impl Into<RichText>, tone: Tone) -> Self {
        Self { text: text.into(), tone, kind: EntryKind::Columns }
    }

    /// Entry of words, of this tone.
    pub fn words(text: impl Into<RichText>, tone: Tone) -> Self {
        Self { kind: EntryKind::Words, ..Self::new(text, tone) }
    }
}

/// How a table is set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Setting {
    /// Look of the entries.
    pub role: Role,
    /// Height of a row.
    pub row: f64,
    /// Room between the text of two columns.
    pub gap: f64,
    /// Least width of a column's text.
    pub least: f64,
}

impl Default for Setting {
    fn default() -> Self {
        Self { role: Role::Code, row: 17.0, gap: 14.0, least: 8.0 }
    }
}

impl Table {
    /// Widths of the columns, without the gaps.
    fn widths(&self, setting: Setting) -> Vec<f64> {
        let of = |column: usize| {
            let entries = self.rows.iter().filter_map(|row| row.get(column));
            let entries = entries.map(|entry| metrics::width(setting.role, &entry.text));
            let head = self.head.get(column).map(|head| metrics::width(Role::Note, head));
            entries.chain(head).fold(setting.least, f64::max)
        };
        (0..self.columns.len()).map(of).collect()
    }

    /// Width and height that it takes.
    pub(crate) fn size(&self, setting: Setting) -> [f64; 2] {
        let width = self.widths(setting).iter().map(|w| w + setting.gap).sum();
        let n_rows = self.rows.len() + usize::from(!self.head.is_empty());
        [width, setting.row * n_rows as f64]
    }

    /// Draws it with its upper left corner at a point.
    pub(crate) fn draw(&self, sheet: &mut Sheet, [left, top]: [f64; 2], setting: Setting) {
        let widths = self.widths(setting);
        let place = |column: usize| -> [f64; 2] {
            let before: f64 = widths[..column].iter().map(|w| w + setting.gap).sum();
            [left + before, widths[column] + setting.gap]
        };
        let put = |sheet: &mut Sheet, role, column: usize, y: f64, text: &RichText| {
            let ([x, wide], anchor) = (place(column), self.columns[column]);
            let inset = 0.5 * setting.gap;
            let x = x + inset + anchor.share() * (wide - setting.gap);
            sheet.text(role, [x, y], anchor, text.clone());
        };
        let mut y = top;
        if !self.head.is_empty() {
            for (column, head) in self.head.iter().enumerate() {
                put(sheet, Role::Note, column, y + 0.5 * setting.row - 1.0, head);
            }
            y += setting.row;
            let [width, _] = self.size(setting);
            sheet.line(Role::Rule, [[left, y - 1.0], [left + width, y - 1.0]]);
        }
        for row in &self.rows {
            for (column, entry) in row.iter().enumerate() {
                let ([x, wide], size) = (place(column), setting.row);
                match entry.tone {
                    Tone::Quiet | Tone::Plain => {}
                    Tone::Line => sheet.rect(Role::LitLine, [x, y], [wide, size]),
                    Tone::Used => {
                        sheet.rect(Role::LitEntry, [x + 1.0, y + 1.0], [wide - 2.0, size - 2.0]);
                    }
                }
            }
            for (column, entry) in row.iter().enumerate() {
                let role = if entry.tone == Tone::Quiet { Role::Note } else { setting.role };
                put(sheet, role, column, y + 0.5 * setting.row, &entry.text);
            }
            y += setting.row;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Form;

    #[test]
    fn columns_are_as_wide_as_their_widest_entry_and_numbers_end_alike() {
        let row = |n: &str| vec![Entry::new("a", Tone::Plain), Entry::new(n, Tone::Used)];
        let table = Table {
            columns: vec![Anchor::Start, Anchor::End],
            head: vec!["name".into(), "n".into()],
            rows: vec![row("1"), row("10000000")],
        };
        let mut sheet = Sheet::default();
        table.draw(&mut sheet, [0.0, 0.0], Setting::default());
        let [width, height] = table.size(Setting::default());
        assert_eq!(height, 3.0 * 17.0);
        let ends: Vec<f64> = sheet
            .figure([width, height])
            .drawn
            .into_iter()
            .filter_map(|drawn| match drawn.form {
                Form::Text { at, anchor: Anchor::End, .. } => Some(at[0]),
                _ => None,
            })
            .collect();
        assert!(ends.len() == 3 && ends.iter().all(|x| *x == ends[0] && *x < width));
    }
}
