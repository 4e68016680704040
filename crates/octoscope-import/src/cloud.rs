//! Point clouds as text: XYZ and CSV.

use crate::error::ImportError;
use crate::shape::{Shape, check_points};
use crate::words::{Line, Word, lines};
use octoscope_core::progress::Progress;
use octoscope_core::text::Message;

/// Most columns that a line may have; a file that is no list of points may be
/// one endless line.
const MOST_COLUMNS: usize = 1000;

/// Points of an XYZ file: one a line, its coordinates first, between blanks or
/// commas; `#` starts a comment. Two columns are points in the plane; of more,
/// the first three are taken.
///
/// # Errors
/// Tells line and column of what is wrong; every line needs as many columns as
/// the first.
pub fn read_xyz(bytes: &[u8], progress: &Progress) -> Result<Shape, ImportError> {
    let rows = lines(bytes).map(Line::without_comment).filter(|line| !is_blank(line));
    progress.start(bytes.len() as u64);
    let mut rows = rows.map(|line| (line, coordinates(line))).peekable();
    let Some((line, first)) = rows.peek() else { return Err(ImportError::NoPoints) };
    match first.len() {
        0 | 1 => Err(too_few(line)),
        n if n > MOST_COLUMNS => Err(too_many(line)),
        2 => Ok(Shape::PlanePoints(points(rows, [0, 1], 2, progress)?)),
        n => Ok(Shape::Points(points(rows, [0, 1, 2], n, progress)?)),
    }
}

/// Points of a CSV file: fields between commas, semicolons or tabs, with or
/// without a first line that names the columns.
///
/// The columns x, y and, if there is one, z are taken; where no columns have
/// these names, the first two or three. Lines that start with `#` are comments.
///
/// # Errors
/// Tells line and column of what is wrong; every line needs as many fields as
/// the first.
pub fn read_csv(bytes: &[u8], progress: &Progress) -> Result<Shape, ImportError> {
    let is_row = |line: &Line<'_>| !is_blank(line) && !line.text.trim_ascii().starts_with(b"#");
    let mut rows = lines(bytes).filter(is_row).peekable();
    let Some(&line) = rows.peek() else { return Err(ImportError::NoPoints) };
    let separator = separator(line);
    let first = fields(line, separator);
    let named = |name: &[u8]| first.iter().position(|field| field.text.eq_ignore_ascii_case(name));
    let has_names = first.iter().take(3).any(|field| !is_number(field));
    let (x, y, z) = match (named(b"x"), named(b"y")) {
        (Some(x), Some(y)) => (x, y, named(b"z")),
        _ => (0, 1, (first.len() > 2).then_some(2)),
    };
    if first.len() < 2 {
        return Err(too_few(&line));
    }
    if first.len() > MOST_COLUMNS {
        return Err(too_many(&line));
    }
    if has_names {
        rows.next();
    }
    progress.start(bytes.len() as u64);
    let n = first.len();
    let rows = rows.map(|line| (line, fields(line, separator)));
    match z {
        None => Ok(Shape::PlanePoints(points(rows, [x, y], n, progress)?)),
        Some(z) => Ok(Shape::Points(points(rows, [x, y, z], n, progress)?)),
    }
}

/// One point of `columns` for each row; every row has `n_columns` words.
fn points<'a, const D: usize>(
    rows: impl Iterator<Item = (Line<'a>, Vec<Word<'a>>)>,
    columns: [usize; D],
    n_columns: usize,
    progress: &Progress,
) -> Result<Vec<[f64; D]>, ImportError> {
    let mut points = Vec::new();
    for (line, words) in rows {
        progress.advance(line.text.len() as u64 + 1)?;
        if words.len() != n_columns {
            let told = Message::new("import-columns").with("n", words.len());
            return Err(ImportError::at(line.end(), told.with("first", n_columns)));
        }
        let mut point = [0.0; D];
        for (coordinate, &column) in point.iter_mut().zip(&columns) {
            *coordinate = words[column].number()?;
        }
        points.push(point);
        check_points(points.len())?;
    }
    if points.is_empty() { Err(ImportError::NoPoints) } else { Ok(points) }
}

fn coordinates(line: Line<'_>) -> Vec<Word<'_>> {
    // A comma between blanks separates once.
    let words = line.split(|b| b == b',' || b.is_ascii_whitespace());
    words.filter(|word| !word.text.is_empty()).take(MOST_COLUMNS + 1).collect()
}

fn fields(line: Line<'_>, separator: u8) -> Vec<Word<'_>> {
    line.split(|b| b == separator).map(bare).take(MOST_COLUMNS + 1).collect()
}

fn is_blank(line: &Line<'_>) -> bool {
    line.text.trim_ascii().is_empty()
}

fn is_number(word: &Word<'_>) -> bool {
    std::str::from_utf8(word.text).is_ok_and(|text| text.parse::<f64>().is_ok())
}

fn too_few(line: &Line<'_>) -> ImportError {
    ImportError::at(line.end(), Message::new("import-one-column"))
}

fn too_many(line: &Line<'_>) -> ImportError {
    ImportError::at(line.place(0), Message::new("import-many-columns").with("most", MOST_COLUMNS))
}

/// The separator that occurs in the first line; a decimal comma counts last.
fn separator(line: Line<'_>) -> u8 {
    [b'\t', b';'].into_iter().find(|b| line.text.contains(b)).unwrap_or(b',')
}

/// Field without the blanks and quotation marks around it.
fn bare(word: Word<'_>) -> Word<'_> {
    let trimmed = word.text.trim_ascii();
    let text = trimmed
        .strip_prefix(b"\"")
        .and_then(|rest| rest.strip_suffix(b"\""))
        .map_or(trimmed, <[u8]>::trim_ascii);
    Word { text, ..word }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn xyz(text: &str) -> Result<Shape, ImportError> {
        read_xyz(text.as_bytes(), &Progress::default())
    }

    fn csv(text: &str) -> Result<Shape, ImportError> {
        read_csv(text.as_bytes(), &Progress::default())
    }

    #[test]
    fn xyz_takes_blanks_and_commas() {
        let space = Ok(Shape::Points(vec![[1.0, 2.0, 3.0], [-4.0, 0.5, 600.0]]));
        assert_eq!(xyz("1 2 3\n-4 .5 6e2"), space);
        assert_eq!(xyz("# cloud\n\n 1,2,3 # first\r\n-4 , .5 , 6e2\n"), space);
        assert_eq!(xyz("1\t2 3 255\n-4 .5 600 7"), space);
        assert_eq!(xyz("1 2\n3 4"), Ok(Shape::PlanePoints(vec![[1.0, 2.0], [3.0, 4.0]])));
    }

    #[test]
    fn csv_finds_its_columns() {
        let space = Ok(Shape::Points(vec![[1.0, 2.0, 3.0]]));
        assert_eq!(csv("1,2,3\n"), space);
        assert_eq!(csv("x,y,z\n1,2,3"), space);
        assert_eq!(csv("name;Z; \"Y\" ;X\nfirst;3;2;1"), space);
        assert_eq!(csv("east\tnorth\tup\tred\n1\t2\t3\t4"), space);
        let plane = Ok(Shape::PlanePoints(vec![[1.0, 2.0], [3.0, 4.0]]));
        assert_eq!(csv("# note\n1,2\n\"3\",4"), plane);
        assert_eq!(csv("id,x,y\n7,1,2\n8,3,4"), plane);
    }

    #[track_caller]
    fn check(read: Result<Shape, ImportError>, message: &str) {
        assert_eq!(read.expect_err("the file is refused").to_string(), message);
    }

    #[test]
    fn mistakes_are_told_with_line_and_column() {
        const NUMBER: &str = "write a number such as -1.25 or 3e-4";
        const COLUMNS: &str = "give every line the same columns";
        check(xyz("1 2 3\n1 b 3"), &format!("line 2, column 3: “b” is not a number; {NUMBER}"));
        check(
            xyz("1 2 3\n1 2"),
            &format!("line 2, column 4: the line has 2 columns, the first has 3; {COLUMNS}"),
        );
        check(
            xyz("12\nwater\nO 0 0 0"),
            "line 1, column 3: the line has one column; write two or three coordinates a line",
        );
        check(
            xyz("1 2 1e999"),
            "line 1, column 5: “1e999” is not a finite number; write a number below 1e308",
        );
        check(csv("x,y\n1,"), &format!("line 2, column 3: a number is missing; {NUMBER}"));
        check(csv("x;y\n1;2,5"), &format!("line 2, column 3: “2,5” is not a number; {NUMBER}"));
        check(
            csv("x,y\n1,2,3"),
            &format!("line 2, column 6: the line has 3 columns, the first has 2; {COLUMNS}"),
        );
        check(
            csv("x\n1"),
            "line 1, column 2: the line has one column; write two or three coordinates a line",
        );
    }

    #[test]
    fn endless_lines_are_refused() {
        let message =
            "line 1, column 1: the line has more than 1000 columns; write one point a line";
        check(xyz(&"1 ".repeat(2000)), message);
        check(csv(&"1,".repeat(2000)), message);
        assert!(xyz(&"1 ".repeat(1000)).is_ok());
    }

    #[test]
    fn texts_without_rows_hold_no_points() {
        for nothing in [xyz("\n# nothing\n"), csv(" \n"), csv("x,y,z\n")] {
            assert_eq!(nothing, Err(ImportError::NoPoints));
        }
    }
}
