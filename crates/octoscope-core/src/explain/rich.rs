//! Text with colours of axes and subscripts.

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

/// First of three marks that begin a piece in the colour of an axis.
const AXIS: u32 = 0xE000;
const STRONG: char = '\u{E003}';
const SUB: char = '\u{E004}';
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

    /// Reads a text that was put together from marked-up pieces.
    pub fn parse(marked: &str) -> Self {
        let mut spans: Vec<Span> = Vec::new();
        let mut span = Span::default();
        for c in marked.chars() {
            match c {
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
                            _ => span.axis = Some((u32::from(c) - AXIS) as usize),
                        }
                    }
                    if !done.text.is_empty() {
                        spans.push(done);
                    }
                }
                _ => span.text.push(c),
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

#[cfg(test)]
mod tests {
    use super::*;

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
