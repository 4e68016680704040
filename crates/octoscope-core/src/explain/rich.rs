//! Text with colours of axes and subscripts.

use crate::geometry::AXIS_NAMES;

/// Piece of text of one look.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Span {
    /// The text.
    pub text: String,
    /// Axis in whose colour it is shown; 0 = x.
    pub axis: Option<usize>,
    /// Whether it is emphasised.
    pub strong: bool,
    /// Whether it is a subscript.
    pub sub: bool,
    /// The number that the text tells in short, with all its digits; `None` if the
    /// text tells all of them, or is no number.
    pub whole: Option<String>,
}

/// Text of several looks.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RichText(
    /// The pieces, in order.
    pub Vec<Span>,
);

impl<T: Into<String>> From<T> for RichText {
    /// Text of one look.
    fn from(text: T) -> Self {
        let text = text.into();
        Self(if text.is_empty() { Vec::new() } else { vec![Span { text, ..Span::default() }] })
    }
}

/// A space at which no line ends.
const NO_BREAK: char = '\u{a0}';
/// Brackets of more letters may be broken.
const SHORT_BRACKETS: usize = 24;

/// An operator that is a word.
const XOR: [char; 4] = [' ', 'x', 'o', 'r'];

/// Which letters are in brackets so short that they stay on one line.
fn within_short_brackets(letters: &[char]) -> Vec<bool> {
    let mut within = vec![false; letters.len()];
    let mut opened = Vec::new();
    for (at, letter) in letters.iter().enumerate() {
        match letter {
            '(' => opened.push(at),
            ')' => {
                if let Some(from) = opened.pop()
                    && at - from <= SHORT_BRACKETS
                {
                    within[from..at].fill(true);
                }
            }
            _ => {}
        }
    }
    within
}

/// First of three marks that begin a piece in the colour of an axis.
const AXIS: u32 = 0xE000;
const STRONG: char = '\u{E003}';
const SUB: char = '\u{E004}';
/// Begins a number in short.
const SHORT: char = '\u{E005}';
/// Between a number in short and the same with all its digits.
const WHOLE: char = '\u{E006}';
/// Ends what the marks before have begun.
const END: char = '\u{E00F}';

impl RichText {
    /// The text alone; a subscript follows a low line: t_xm.
    pub fn plain(&self) -> String {
        let mut plain = String::new();
        for span in &self.0 {
            if span.sub {
                plain.push('_');
            }
            plain.push_str(&span.text);
        }
        plain
    }

    /// The same with no-break spaces where no line should end: within short brackets,
    /// around an equals sign and an operator, after a relation, and between a word and its
    /// number.
    pub fn unbroken(&self) -> Self {
        let letters: Vec<char> = self.0.iter().flat_map(|span| span.text.chars()).collect();
        let in_brackets = within_short_brackets(&letters);
        let is_kept = |at: usize| {
            let before = at.checked_sub(1).and_then(|before| letters.get(before));
            let after = letters.get(at + 1);
            let is_number = |c: &char| c.is_ascii_digit() || matches!(c, '−' | '∞');
            let is_operator = |c: &char| matches!(c, '+' | '∧' | '=');
            in_brackets[at]
                || before.is_some_and(|c| matches!(c, '<' | '>' | '≤' | '≥' | '≠'))
                || before.is_some_and(is_operator)
                || after.is_some_and(is_operator)
                || letters[..at].ends_with(&XOR)
                || letters[at..].starts_with(&XOR)
                || before.is_some_and(|c| c.is_alphanumeric()) && after.is_some_and(is_number)
        };
        let mut at = 0;
        let mut spans = self.0.clone();
        for span in &mut spans {
            let text = span.text.chars().map(|c| {
                at += 1;
                if c == ' ' && is_kept(at - 1) { NO_BREAK } else { c }
            });
            span.text = text.collect();
        }
        Self(spans)
    }

    /// Reads a text as [`Self::plain`] writes it: the letter before a low line bears what
    /// follows it as a subscript, in the colour of its axis if that begins with one.
    pub fn with_subscripts(plain: &str) -> Self {
        let mut parts = plain.split('_');
        let mut spans = Self::from(parts.next().unwrap_or_default()).0;
        for part in parts {
            let length = part.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(part.len());
            let (sub, rest) = part.split_at(length);
            let axis = AXIS_NAMES.iter().position(|name| sub.starts_with(name));
            if let Some(before) = spans.last_mut()
                && let Some(letter) = before.text.pop()
            {
                spans.push(Span { text: letter.to_string(), axis, ..Span::default() });
            }
            spans.push(Span { text: sub.to_owned(), axis, sub: true, ..Span::default() });
            spans.push(Span { text: rest.to_owned(), ..Span::default() });
        }
        spans.retain(|span| !span.text.is_empty());
        Self(spans)
    }

    /// Reads a text that was put together from marked-up pieces.
    pub fn parse(marked: &str) -> Self {
        let mut spans: Vec<Span> = Vec::new();
        let mut span = Span::default();
        for c in marked.chars() {
            match c {
                WHOLE => span.whole = Some(String::new()),
                '\u{E000}'..=END => {
                    let done = std::mem::take(&mut span);
                    if c != END {
                        (span.axis, span.strong, span.sub) = (done.axis, done.strong, done.sub);
                        if !done.text.is_empty() {
                            span = Span::default();
                        }
                        match c {
                            STRONG => span.strong = true,
                            SUB => span.sub = true,
                            SHORT => {}
                            _ => span.axis = Some((u32::from(c) - AXIS) as usize),
                        }
                    }
                    if !done.text.is_empty() {
                        spans.push(done);
                    }
                }
                _ => span.whole.as_mut().unwrap_or(&mut span.text).push(c),
            }
        }
        if !span.text.is_empty() {
            spans.push(span);
        }
        Self(spans)
    }
}

/// `text` in the colour of `axis`, marked up.
pub(super) fn on_axis(axis: usize, text: &str) -> String {
    let mark = char::from_u32(AXIS + axis as u32).unwrap_or(STRONG);
    format!("{mark}{text}{END}")
}

/// `text` with `sub` below it, both in the colour of `axis`, marked up.
pub(super) fn with_sub(axis: usize, text: &str, sub: &str) -> String {
    format!("{}{SUB}{}", on_axis(axis, text), on_axis(axis, sub))
}

/// Emphasised `text`, marked up.
pub(super) fn strong(text: &str) -> String {
    format!("{STRONG}{text}{END}")
}

/// A number in short, with all its digits behind it, marked up.
pub(super) fn shortened(short: &str, whole: &str) -> String {
    format!("{SHORT}{short}{WHOLE}{whole}{END}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_belongs_together_is_not_broken() {
        let check = |text: &str, lines: &[&str]| {
            let unbroken = RichText::from(text).unbroken().plain();
            let parts: Vec<_> =
                unbroken.split(' ').map(|part| part.replace(NO_BREAK, " ")).collect();
            assert_eq!(parts, lines);
        };
        check("up to (16, 16, 8) of level 3.", &["up", "to", "(16, 16, 8)", "of", "level 3."]);
        check("t = 0.66 < s = −1 ends", &["t = 0.66", "< s = −1", "ends"]);
        check("child 6 (3 in Morton order)", &["child 6", "(3 in Morton order)"]);
        check("at 0.25, 0.5", &["at 0.25,", "0.5"]);
        check("as f(i) = i xor 3 holds", &["as", "f(i) = i xor 3", "holds"]);
        check("t = ∞ = s, read as x + 2y", &["t = ∞ = s,", "read", "as", "x + 2y"]);
    }

    #[test]
    fn subscripts_are_read_as_they_are_written() {
        for text in ["", "t_xm", "t_ym < t_y1 always holds", "a = 4a_x + 2a_y, x_0 (q1)."] {
            let read = RichText::with_subscripts(text);
            assert_eq!(read.plain(), text);
            assert!(read.0.iter().all(|span| !span.text.contains('_')));
        }
        let RichText(spans) = RichText::with_subscripts("4a_x + x_0");
        let told = spans.iter().map(|span| (span.text.as_str(), span.sub, span.axis));
        assert!(told.eq([
            ("4", false, None),
            ("a", false, Some(0)),
            ("x", true, Some(0)),
            (" + ", false, None),
            ("x", false, None),
            ("0", true, None),
        ]));
    }

    #[test]
    fn a_number_in_short_has_its_digits_behind_it() {
        let third = shortened("0.3333", "0.333333");
        for marked in [format!("At t = {third}, so"), format!("At t = {}, so", strong(&third))] {
            let text = RichText::parse(&marked);
            assert_eq!(text.plain(), "At t = 0.3333, so");
            let whole: Vec<_> = text.0.iter().map(|span| span.whole.as_deref()).collect();
            assert_eq!(whole, [None, Some("0.333333"), None], "{text:?}");
        }
    }

    #[test]
    fn marks_become_spans() {
        let text = RichText::parse(&format!("{} is {}.", with_sub(0, "t", "xm"), strong("1")));
        assert_eq!(text.plain(), "t_xm is 1.");
        assert_eq!(text.0[0].axis, Some(0));
        assert!(text.0[1].sub && text.0[1].axis == Some(0));
        assert!(text.0[3].strong);
        assert_eq!(text.0[4], Span { text: ".".to_owned(), ..Span::default() });
    }
}
