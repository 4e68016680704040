//! The texts of the command line: occupied cells and rays.

use crate::error::ImportError;
use crate::hexadecimal::hexadecimal;
use crate::words::{Line, Word, lines};
use octoscope_core::geometry::Ray;
use octoscope_core::text::Message;
use octoscope_core::tree::{Code, MAX_ROOT_LEVEL};

/// Codes of the occupied cells of a `.cells` text, in its order: one cell a
/// line, D whole numbers in 0 … 2^`depth`−1 between blanks, `#` comments.
///
/// A text without cells gives none: it is the empty tree.
///
/// # Errors
/// Tells line and column of what is wrong.
///
/// # Panics
/// Panics if `depth` is above [`MAX_ROOT_LEVEL`].
pub fn cells<const D: usize>(text: &str, depth: u8) -> Result<Vec<Code<D>>, ImportError> {
    assert!(depth <= MAX_ROOT_LEVEL, "codes have at most {MAX_ROOT_LEVEL} bits");
    let grid_size = 1u32 << depth;
    let mut cells = Vec::new();
    for line in lines(text.as_bytes()).map(Line::without_comment) {
        let words: Vec<_> = line.words().take(D + 1).collect();
        if words.is_empty() {
            continue;
        }
        check_length(&line, &words, D)?;
        let mut code = [0; D];
        for (coordinate, word) in code.iter_mut().zip(&words) {
            *coordinate = cell_number(word, grid_size)?;
        }
        cells.push(code);
    }
    Ok(cells)
}

/// Rays of a `.rays` text, in its order: one ray a line, the D numbers of the
/// origin and the D numbers of the direction, decimal or hexadecimal as C
/// prints them (`0x1.8p-1`), between blanks, `#` comments.
///
/// # Errors
/// Tells line and column of what is wrong.
pub fn rays<const D: usize>(text: &str) -> Result<Vec<Ray<D>>, ImportError> {
    let mut rays = Vec::new();
    for line in lines(text.as_bytes()).map(Line::without_comment) {
        let words: Vec<_> = line.words().take(2 * D + 1).collect();
        if words.is_empty() {
            continue;
        }
        check_length(&line, &words, 2 * D)?;
        let mut numbers = [[0.0; D]; 2];
        for (number, word) in numbers.as_flattened_mut().iter_mut().zip(&words) {
            *number = ray_number(word)?;
        }
        let [origin, direction] = numbers;
        let ray = Ray::new(origin, direction)
            .map_err(|_| ImportError::at(words[D].place, Message::new("import-zero-direction")))?;
        rays.push(ray);
    }
    Ok(rays)
}

fn check_length(line: &Line<'_>, words: &[Word<'_>], due: usize) -> Result<(), ImportError> {
    if words.len() < due {
        let told = Message::new("import-few-numbers").with("n", words.len()).with("due", due);
        return Err(ImportError::at(line.end(), told));
    }
    match words.get(due) {
        None => Ok(()),
        Some(extra) => {
            let told = Message::new("import-many-numbers").with("due", due);
            Err(ImportError::at(extra.place, told))
        }
    }
}

fn cell_number(word: &Word<'_>, grid_size: u32) -> Result<u32, ImportError> {
    let parsed = std::str::from_utf8(word.text).ok().and_then(|text| text.parse::<u32>().ok());
    parsed.filter(|&number| number < grid_size).ok_or_else(|| {
        let told = Message::new("import-cell").with("word", word.short());
        ImportError::at(word.place, told.with("most", (grid_size - 1).to_string()))
    })
}

fn ray_number(word: &Word<'_>) -> Result<f64, ImportError> {
    match std::str::from_utf8(word.text).ok().and_then(hexadecimal) {
        Some(number) => word.finite(Some(number)),
        None => word.number(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_and_rays_are_read_in_order() {
        assert_eq!(cells::<2>("# two\n1 2\r\n\n 3 0 # last", 2), Ok(vec![[1, 2], [3, 0]]));
        let ray = Ray::new([0.75, -2.0], [1.0, 0.0]).expect("a ray");
        assert_eq!(rays::<2>("0x1.8p-1 -2 1 0x0p+0\n#"), Ok(vec![ray]));
        assert_eq!(cells::<3>("", 2), Ok(vec![]));
    }

    #[track_caller]
    fn check_cells(text: &str, message: &str) {
        assert_eq!(cells::<2>(text, 2).expect_err("refused").to_string(), message);
    }

    #[track_caller]
    fn check_rays(text: &str, message: &str) {
        assert_eq!(rays::<2>(text).expect_err("refused").to_string(), message);
    }

    #[test]
    fn mistakes_are_told_with_line_and_column() {
        check_cells(
            "1 2\n1 4",
            "line 2, column 3: “4” is not a whole number in 0 … 3; write cells of the grid, or ask for a greater depth",
        );
        check_cells("1", "line 1, column 2: the line has 1 of 2 numbers; add what is missing");
        check_cells(
            "1 2 3",
            "line 1, column 5: the line has more than 2 numbers; take the rest away, or write # before it",
        );
        check_rays(
            "0 0 0 0",
            "line 1, column 5: the direction is zero; give at least one of its components another value",
        );
        check_rays(
            "0 0 nan 0",
            "line 1, column 5: “nan” is not a finite number; write a number below 1e308",
        );
        check_rays(
            "0 0 0x1.8q 0",
            "line 1, column 5: “0x1.8q” is not a number; write a number such as -1.25 or 3e-4",
        );
        check_rays(
            "0 0 0x1p9999 0",
            "line 1, column 5: “0x1p9999” is not a finite number; write a number below 1e308",
        );
    }
}
