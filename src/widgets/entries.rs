//! What several tables of panels are made of.

use crate::look::Look;
use eframe::egui::{RichText, Ui};
use octoscope_core::explain::{RichText as Coloured, Span};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::tree::Child;

/// The line above the columns of a table, or a few quiet words below it.
pub fn caption(ui: &mut Ui, look: &Look, text: impl Into<String>) {
    ui.label(RichText::new(text).size(look.type_size(12.0)).color(look.palette.quiet));
}

/// A text of one look for each axis, with its letter: x 3  y 5.
pub fn per_axis(texts: impl IntoIterator<Item = String>) -> Coloured {
    let spans = texts.into_iter().enumerate().map(|(axis, text)| {
        let gap = if axis == 0 { "" } else { "  " };
        let text = format!("{gap}{} {text}", AXIS_NAMES[axis]);
        Span { text, axis: Some(axis), ..Span::default() }
    });
    Coloured(spans.collect())
}

/// The bits of a child, x first, each in the colour of its axis.
pub fn bits_of<const D: usize>(child: Child<D>) -> Coloured {
    let bits = (0..D).map(|axis| {
        let gap = if axis == 0 { "" } else { " " };
        let text = format!("{gap}{}", u8::from(child.is_upper(axis)));
        Span { text, axis: Some(axis), ..Span::default() }
    });
    Coloured(bits.collect())
}

/// A range of parameters, its end not in it.
pub fn range([from, to]: [f64; 2]) -> String {
    use octoscope_core::explain::approx;
    format!("[{}, {})", approx(from), approx(to))
}
