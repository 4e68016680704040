//! One line of text, letter by letter.

use crate::{Anchor, Form, Lettering, Theme, Weight, fonts};
use octoscope_core::explain::RichText;
use std::ops::Range;
use std::sync::LazyLock;
use ttf_parser::Face;

/// A line of text.
pub(crate) struct Line<'a> {
    /// The point of it that `anchor` tells, at half the height of its capitals.
    pub(crate) at: [f64; 2],
    /// Which point of it that is.
    pub(crate) anchor: Anchor,
    /// What is written.
    pub(crate) text: &'a RichText,
}

impl<'a> Line<'a> {
    /// The line of a form that is one.
    pub(crate) fn of(form: &'a Form) -> Option<Self> {
        match form {
            Form::Text { at, anchor, text } => Some(Self { at: *at, anchor: *anchor, text }),
            Form::Polygon(_) | Form::Polyline(_) | Form::Circle { .. } | Form::Formula { .. } => {
                None
            }
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
        let drop = if span.sub { Lettering::SUB_DROP * look.size } else { 0.0 };
        let look = look.of_span(theme, span);
        let first = font_of(look.weight);
        for letter in span.text.chars() {
            // The mono has the most signs.
            let mut order = [first, 2, 0].into_iter();
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
        Weight::MonoStrong => 3,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Colour, Role, Style, metrics};
    use octoscope_core::explain::Span;

    fn plain(text: &str) -> Span {
        Span { text: text.to_owned(), ..Span::default() }
    }

    #[test]
    fn letters_that_a_typeface_lacks_come_from_another() {
        let look = Lettering { colour: Colour::hex(0), size: 10.0, weight: Weight::Regular };
        let runs = runs(
            Theme::Print,
            look,
            &RichText(vec![plain("a∧t"), Span { sub: true, ..plain("x") }]),
        );
        let fonts: Vec<_> = runs.iter().map(|run| (run.font, run.drop > 0.0)).collect();
        assert_eq!(fonts, [(0, false), (2, false), (0, false), (0, true)]);
        assert!(runs.iter().flat_map(|run| &run.glyphs).all(|g| g.id > 0 && g.advance > 0.1));
    }

    #[test]
    fn pieces_have_the_looks_and_the_widths_of_the_figure() {
        let text = RichText(vec![
            Span { axis: Some(1), ..plain("t") },
            Span { axis: Some(1), sub: true, ..plain("ym") },
            plain(" = ∞ and "),
            Span { strong: true, ..plain("so") },
        ]);
        for role in [Role::Note, Role::Code, Role::Words] {
            let look = Style::of(Theme::Light, role).text.unwrap();
            let runs = runs(Theme::Light, look, &text);
            let axis = Style::of(Theme::Light, Role::AxisLabel(1)).text.unwrap().colour;
            assert_eq!((runs[0].look.colour, runs[1].look.colour), (axis, axis));
            let bold = font_of(look.weight.bolder());
            assert_eq!((runs[0].font, runs[runs.len() - 1].font), (bold, bold));
            let wide: f64 = runs.iter().map(Run::width).sum();
            assert!((wide - metrics::width(role, &text)).abs() < 1e-9, "{role:?}");
        }
    }
}
