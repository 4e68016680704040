//! How wide texts are, from the typefaces themselves.

use crate::style::Lettering;
use crate::{Role, Style, Theme, Weight, fonts};
use octoscope_core::explain::{RichText, Span};
use std::sync::LazyLock;
use ttf_parser::Face;

/// Width of a text of a role, in page units; 0 for roles without letters. The
/// same in every theme.
pub fn width(role: Role, text: &RichText) -> f64 {
    width_of_least(role, text, 0.0)
}

/// The same where no type is smaller than `least` page units.
pub fn width_of_least(role: Role, text: &RichText, least: f64) -> f64 {
    let Some(lettering) = Style::of(Theme::Light, role).text else { return 0.0 };
    let spans = text.0.iter().map(|span| {
        let Lettering { size, weight, .. } = lettering.of_span(Theme::Light, span);
        size.max(least) * span.text.chars().map(|c| advance(weight, c)).sum::<f64>()
    });
    spans.sum()
}

/// Height of the type of a role, in page units; 0 for roles without letters.
pub fn size(role: Role) -> f64 {
    Style::of(Theme::Light, role).text.map_or(0.0, |text| text.size)
}

/// Advance of a letter in units of the type's height; of one that the typeface
/// lacks, that of the next one of the family.
fn advance(weight: Weight, c: char) -> f64 {
    static FACES: LazyLock<[Option<Face<'static>>; 4]> =
        LazyLock::new(|| fonts::ALL.map(|font| Face::parse(font, 0).ok()));
    let first = match weight {
        Weight::Regular => 0,
        Weight::Strong => 1,
        Weight::Mono => 2,
        Weight::MonoStrong => 3,
    };
    let advance = |index: usize| {
        let face = FACES[index].as_ref()?;
        let glyph = face.glyph_index(c)?;
        let units = face.glyph_hor_advance(glyph)?;
        Some(f64::from(units) / f64::from(face.units_per_em()))
    };
    [first, 2, 0].into_iter().find_map(advance).unwrap_or(0.6)
}

/// Text in lines of at most `most` page units, broken between words; a word that
/// is wider has a line of its own. Equations and what stands in brackets are kept
/// together where they fit into a line. The looks of all pieces stay.
pub fn wrapped(role: Role, text: &RichText, most: f64) -> Vec<RichText> {
    let fits = |word: &RichText| width(role, &trimmed(word)) <= most;
    let units = kept_together(&words(text)).into_iter().flat_map(|unit| {
        let whole = RichText(unit.iter().flat_map(|word| word.0.clone()).collect());
        if fits(&whole) { vec![whole] } else { unit }
    });
    let mut lines: Vec<RichText> = Vec::new();
    let mut left = 0.0;
    for word in units {
        // The blank at its end does not count.
        let bare = width(role, &trimmed(&word));
        let wide = width(role, &word);
        match lines.last_mut() {
            Some(line) if bare <= left => {
                line.0.extend(word.0);
                left -= wide;
            }
            Some(_) | None => {
                lines.push(word);
                left = most - wide;
            }
        }
    }
    lines.iter().map(trimmed).map(merged).collect()
}

/// The same with neighbouring pieces of one look as one.
fn merged(line: RichText) -> RichText {
    let mut spans: Vec<Span> = Vec::new();
    for span in line.0 {
        let look = |span: &Span| (span.axis, span.strong, span.sub);
        match spans.last_mut() {
            Some(last) if look(last) == look(&span) => last.text += &span.text,
            Some(_) | None => spans.push(span),
        }
    }
    RichText(spans)
}

/// Words that are better not parted: both sides of an equals sign, and brackets.
fn kept_together(words: &[RichText]) -> Vec<Vec<RichText>> {
    let mut units: Vec<Vec<RichText>> = Vec::new();
    let (mut is_open, mut depth) = (false, 0);
    for word in words {
        let plain = word.plain();
        let is_equals = plain.trim() == "=";
        match units.last_mut() {
            Some(unit) if is_open || is_equals || depth > 0 => unit.push(word.clone()),
            Some(_) | None => units.push(vec![word.clone()]),
        }
        depth += plain.matches('(').count();
        depth = depth.saturating_sub(plain.matches(')').count());
        is_open = is_equals;
    }
    units
}

/// Words with the blank that follows, each of one or more pieces.
fn words(text: &RichText) -> Vec<RichText> {
    let mut words = vec![RichText::default()];
    for span in &text.0 {
        for piece in span.text.split_inclusive(' ') {
            let ends = piece.ends_with(' ');
            if let Some(word) = words.last_mut() {
                word.0
                    .push(octoscope_core::explain::Span { text: piece.to_owned(), ..span.clone() });
            }
            if ends {
                words.push(RichText::default());
            }
        }
    }
    words.retain(|word| !word.0.is_empty());
    words
}

/// The text without blanks at its end.
fn trimmed(text: &RichText) -> RichText {
    let mut text = text.clone();
    while let Some(last) = text.0.last_mut() {
        let kept = last.text.trim_end().len();
        last.text.truncate(kept);
        if kept > 0 {
            break;
        }
        text.0.pop();
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_of_one_width_in_every_typeface() {
        for weight in [Weight::Regular, Weight::Strong, Weight::Mono, Weight::MonoStrong] {
            let widths: Vec<f64> = ('0'..='9').map(|c| advance(weight, c)).collect();
            assert!(widths.iter().all(|w| *w == widths[0] && *w > 0.4), "{weight:?} {widths:?}");
        }
        assert!(advance(Weight::Regular, 'i') < advance(Weight::Regular, 'm'));
        assert_eq!(advance(Weight::Regular, '∧'), advance(Weight::Mono, '∧'), "it is lent");
    }

    #[test]
    fn lines_are_broken_between_words_and_keep_all_of_them() {
        let text = RichText::from("The ray enters the root at t = 0.25 and leaves it");
        let lines = wrapped(Role::Note, &text, 90.0);
        assert!(lines.len() > 2);
        let wide = lines.iter().map(|line| width(Role::Note, line)).fold(0.0, f64::max);
        assert!(wide <= 90.0, "{wide}");
        let joined = lines.iter().map(RichText::plain).collect::<Vec<_>>().join(" ");
        assert_eq!(joined, text.plain());
        assert_eq!(wrapped(Role::Note, &text, 1.0).len(), 12, "a word a line at least");
        assert_eq!(wrapped(Role::Note, &RichText::default(), 90.0), []);
    }

    #[test]
    fn words_of_one_look_are_one_piece_of_a_line() {
        let piece = |text: &str, strong| Span { text: text.to_owned(), strong, ..Span::default() };
        let text = RichText(vec![piece("in the domain, ", true), piece("it goes on", false)]);
        assert_eq!(wrapped(Role::Words, &text, 400.0), [text]);
    }

    #[test]
    fn equations_and_brackets_are_kept_together() {
        let text = RichText::from("beyond the node (0, 16, 8) of level 3 at t = 0.25 again");
        for most in [60.0, 80.0, 100.0, 150.0] {
            for line in wrapped(Role::Note, &text, most) {
                let plain = line.plain();
                assert_eq!(plain.contains('('), plain.contains(')'), "{plain}");
                assert!(!plain.ends_with('=') && !plain.starts_with('='), "{plain}");
            }
        }
    }
}
