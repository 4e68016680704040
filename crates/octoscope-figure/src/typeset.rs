//! One line of text, letter by letter.

use crate::{Form, Lettering, Role, Style, Theme, Weight, fonts};
use octoscope_core::explain::{RichText, Span};
use std::ops::Range;
use std::sync::LazyLock;
use ttf_parser::Face;

/// Height of subscripts against the type they stand in.
const SUB_SIZE: f64 = 0.72;
/// How far below its line they stand, in heights of that type.
const SUB_DROP: f64 = 0.2;

/// A line of text.
pub(crate) struct Line {
    /// The point of it that `share` tells, at half the height of its capitals.
    pub(crate) at: [f64; 2],
    /// Share of its width that lies before that point.
    pub(crate) share: f64,
    /// What is written.
    pub(crate) text: RichText,
}

impl Line {
    /// The line of a form that is one.
    pub(crate) fn of(form: &Form) -> Option<Self> {
        match form {
            Form::Text { at, text } => Some(Self { at: *at, share: 0.5, text: rich(text) }),
            Form::Polygon(_) | Form::Polyline(_) | Form::Circle { .. } => None,
        }
    }
}

/// Letters of one typeface and look, side by side.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Run {
    /// Index in [`fonts::ALL`].
    pub(crate) font: usize,
    /// Its look.
    pub(crate) look: Lettering,
    /// How far below the line it stands, in page units.
    pub(crate) drop: f64,
    /// What is written.
    pub(crate) text: String,
    /// Its letters.
    pub(crate) glyphs: Vec<Glyph>,
}

/// A letter: its number in the typeface, its place in the text, and its width
/// as a share of the height of the type.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Glyph {
    pub(crate) id: u16,
    pub(crate) range: Range<usize>,
    pub(crate) advance: f64,
}

impl Run {
    /// Its width in page units.
    pub(crate) fn width(&self) -> f64 {
        self.look.size * self.glyphs.iter().map(|glyph| glyph.advance).sum::<f64>()
    }
}

/// `text` as runs from left to right. A letter that the typeface lacks is taken
/// from another one.
pub(crate) fn runs(theme: Theme, look: Lettering, text: &RichText) -> Vec<Run> {
    static FACES: LazyLock<Vec<Face<'static>>> = LazyLock::new(|| {
        let face = |font| Face::parse(font, 0).expect("the typefaces of the program are sound");
        fonts::ALL.into_iter().map(face).collect()
    });
    let mut runs: Vec<Run> = Vec::new();
    for span in &text.0 {
        let drop = if span.sub { SUB_DROP * look.size } else { 0.0 };
        let look = of_span(theme, look, span);
        let first = font_of(look.weight);
        for letter in span.text.chars() {
            let mut order = [first].into_iter().chain(0..FACES.len());
            let found = order.find_map(|font| Some((font, FACES[font].glyph_index(letter)?)));
            let (font, glyph) = found.unwrap_or_default();
            let fits = |run: &&mut Run| (run.font, run.look, run.drop) == (font, look, drop);
            let run = match runs.last_mut().filter(fits) {
                Some(run) => run,
                None => {
                    runs.push(Run { font, look, drop, text: String::new(), glyphs: Vec::new() });
                    let last = runs.len() - 1;
                    &mut runs[last]
                }
            };
            let face = &FACES[font];
            let advance = face.glyph_hor_advance(glyph).unwrap_or_default();
            let start = run.text.len();
            run.text.push(letter);
            run.glyphs.push(Glyph {
                id: glyph.0,
                range: start..run.text.len(),
                advance: f64::from(advance) / f64::from(face.units_per_em()),
            });
        }
    }
    runs
}

/// Index of a typeface in [`fonts::ALL`].
fn font_of(weight: Weight) -> usize {
    match weight {
        Weight::Regular => 0,
        Weight::Strong => 1,
        Weight::Mono => 2,
    }
}

/// Look of a piece of a text of this look.
fn of_span(theme: Theme, look: Lettering, span: &Span) -> Lettering {
    let of_axis = span.axis.and_then(|axis| Style::of(theme, Role::AxisLabel(axis)).text);
    let is_bold = span.strong || of_axis.is_some();
    Lettering {
        colour: of_axis.map_or(look.colour, |axis| axis.colour),
        size: if span.sub { SUB_SIZE * look.size } else { look.size },
        weight: match look.weight {
            Weight::Regular if is_bold => Weight::Strong,
            weight => weight,
        },
    }
}

/// Text with subscripts: what follows the low line behind a letter that stands
/// alone, as in t_x0.
fn rich(text: &str) -> RichText {
    let mut spans = Vec::new();
    let mut rest = text;
    let mut push = |text: &str, sub| {
        if !text.is_empty() {
            spans.push(Span { text: text.to_owned(), sub, ..Span::default() });
        }
    };
    while let Some((before, sub, after)) = next_subscript(rest) {
        push(before, false);
        push(sub, true);
        rest = after;
    }
    push(rest, false);
    RichText(spans)
}

/// What stands before the first subscript, the subscript, and the rest.
fn next_subscript(text: &str) -> Option<(&str, &str, &str)> {
    for (line, _) in text.match_indices('_') {
        let (before, sub) = (&text[..line], &text[line + 1..]);
        let mut backwards = before.chars().rev();
        let is_alone = backwards.next().is_some_and(char::is_alphabetic)
            && !backwards.next().is_some_and(char::is_alphanumeric);
        let end = sub.find(|c: char| !c.is_alphanumeric()).unwrap_or(sub.len());
        if is_alone && end > 0 {
            return Some((before, &sub[..end], &sub[end..]));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Colour;

    #[test]
    fn a_low_line_behind_a_single_letter_begins_a_subscript() {
        let check = |text, expected: &[(&str, bool)]| {
            let spans = rich(text).0;
            let found: Vec<_> = spans.iter().map(|span| (span.text.as_str(), span.sub)).collect();
            assert_eq!(found, expected, "{text}");
        };
        check("t_x0 = 3", &[("t", false), ("x0", true), (" = 3", false)]);
        check("(t_m)", &[("(t", false), ("m", true), (")", false)]);
        check("near_x", &[("near_x", false)]);
        check("t_", &[("t_", false)]);
        check("", &[]);
    }

    #[test]
    fn letters_that_a_typeface_lacks_come_from_another() {
        let look = Lettering { colour: Colour::hex(0), size: 10.0, weight: Weight::Regular };
        let runs = runs(Theme::Print, look, &rich("a∧t_x"));
        let fonts: Vec<_> = runs.iter().map(|run| (run.font, run.drop > 0.0)).collect();
        assert_eq!(fonts, [(0, false), (2, false), (0, false), (0, true)]);
        assert!(runs.iter().flat_map(|run| &run.glyphs).all(|g| g.id > 0 && g.advance > 0.1));
    }
}
