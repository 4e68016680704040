//! Lines and words of a text, each with its place.

use crate::error::{ImportError, Place};
use octoscope_core::text::Message;

/// One line of a text, without its end.
#[derive(Clone, Copy, Debug)]
pub struct Line<'a> {
    /// Number, counted from 1.
    pub number: usize,
    /// Bytes, in UTF-8 where they are not of ASCII.
    pub text: &'a [u8],
}

/// Part of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word<'a> {
    /// Bytes of the word.
    pub text: &'a [u8],
    /// Where it starts.
    pub place: Place,
}

/// Lines of `bytes`; a byte order mark is left out. Lines end in a line feed or,
/// in a text without any, in a carriage return.
pub fn lines(bytes: &[u8]) -> impl Iterator<Item = Line<'_>> {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let end = if text.contains(&b'\n') { b'\n' } else { b'\r' };
    text.split(move |&b| b == end).zip(1..).map(|(text, number)| Line { number, text })
}

impl<'a> Line<'a> {
    /// The line up to the first `#`.
    pub fn without_comment(self) -> Self {
        let end = self.text.iter().position(|&b| b == b'#').unwrap_or(self.text.len());
        Self { text: &self.text[..end], ..self }
    }

    /// Place of byte `offset` of the line.
    pub fn place(&self, offset: usize) -> Place {
        let is_start = |b: &&u8| (**b & 0xc0) != 0x80;
        let column = self.text[..offset].iter().filter(is_start).count() + 1;
        Place::Line { line: self.number, column }
    }

    /// Place behind the last character that is not blank.
    pub fn end(&self) -> Place {
        self.place(self.text.trim_ascii_end().len())
    }

    /// Words between blanks; neighbouring blanks count once.
    pub fn words(self) -> impl Iterator<Item = Word<'a>> {
        self.split(|b| b.is_ascii_whitespace()).filter(|word| !word.text.is_empty())
    }

    /// Words between separators, which are single bytes; a word may be empty.
    pub fn split(self, is_separator: impl Fn(u8) -> bool) -> impl Iterator<Item = Word<'a>> {
        // The column is counted along, so that a long line takes linear time.
        let (mut counted, mut column) = (0, 1);
        self.text.split(move |&b| is_separator(b)).map(move |text| {
            let start = text.as_ptr() as usize - self.text.as_ptr() as usize;
            column += self.text[counted..start].iter().filter(|&&b| (b & 0xc0) != 0x80).count();
            counted = start;
            Word { text, place: Place::Line { line: self.number, column } }
        })
    }
}

impl Word<'_> {
    /// The word between quotation marks, cut to a length that fits a message.
    pub fn short(&self) -> String {
        let text = String::from_utf8_lossy(&self.text[..self.text.len().min(160)]);
        let short: String = text.chars().filter(|c| !c.is_control()).take(30).collect();
        let dots = if text.chars().count() > 30 { "…" } else { "" };
        format!("{short}{dots}")
    }

    /// Finite number, written in decimal.
    ///
    /// # Errors
    /// Tells what is there instead of a number, or that the number is not finite.
    pub fn number(&self) -> Result<f64, ImportError> {
        let parsed = std::str::from_utf8(self.text).ok().and_then(|text| text.parse().ok());
        self.finite(parsed)
    }

    /// `parsed` if it is a finite number, otherwise the reason why not.
    pub fn finite(&self, parsed: Option<f64>) -> Result<f64, ImportError> {
        let Some(number) = parsed else {
            let told = match self.text {
                [] => Message::new("import-no-number"),
                _ => Message::new("import-not-a-number").with("word", self.short()),
            };
            return Err(ImportError::at(self.place, told));
        };
        if !number.is_finite() {
            let told = Message::new("import-not-finite").with("word", self.short());
            return Err(ImportError::at(self.place, told));
        }
        Ok(number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_know_their_line_and_column_in_characters() {
        let text = "\u{feff}a\n  ä b\r\n".as_bytes();
        let places: Vec<_> = lines(text)
            .flat_map(Line::words)
            .map(|w| (String::from_utf8_lossy(w.text).into_owned(), w.place.to_string()))
            .collect();
        let expected =
            [("a", "line 1, column 1"), ("ä", "line 2, column 3"), ("b", "line 2, column 5")];
        assert_eq!(places, expected.map(|(a, b)| (a.to_owned(), b.to_owned())));
    }

    #[test]
    fn lines_end_as_on_any_system() {
        for text in ["a\nb", "a\r\nb", "a\rb"] {
            let words = lines(text.as_bytes()).map(|line| line.words().count());
            assert_eq!(words.collect::<Vec<_>>(), [1, 1], "{text:?}");
        }
    }

    #[test]
    fn long_words_are_cut_in_messages() {
        let line = Line { number: 1, text: &[b'x'; 500] };
        let word = line.words().next().expect("the line has a word");
        assert_eq!(word.short(), format!("{}…", "x".repeat(30)));
    }
}
