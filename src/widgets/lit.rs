//! Entries of tables, lit where the algorithm uses them.

use crate::look::Look;
use eframe::egui::{RichText, Ui};
use octoscope_core::explain::RichText as Coloured;

/// How much an entry of a table has to do with the present step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lit {
    /// It is out of the question.
    Quiet,
    /// Nothing in particular.
    No,
    /// It is in the line that is used.
    Line,
    /// It is used.
    Used,
}

/// An entry of a table.
pub fn lit(look: &Look, text: impl Into<String>, lit: Lit) -> RichText {
    let text = RichText::new(text).monospace().size(13.0);
    let palette = &look.palette;
    match lit {
        Lit::Quiet => text.color(palette.quiet),
        Lit::No => text.color(palette.ink),
        Lit::Line => text.color(palette.ink).background_color(palette.current_fill),
        Lit::Used => {
            let fill = palette.current_line.gamma_multiply(0.55);
            text.color(palette.ink).strong().background_color(fill)
        }
    }
}

/// The line above the columns of a table, or a few quiet words below it.
pub fn caption(ui: &mut Ui, look: &Look, text: impl Into<String>) {
    ui.label(RichText::new(text).size(look.type_size(12.0)).color(look.palette.quiet));
}

/// A text of one look for each axis, with its letter: x 3  y 5.
pub fn per_axis(texts: impl IntoIterator<Item = String>) -> Coloured {
    use octoscope_core::explain::Span;
    use octoscope_core::geometry::AXIS_NAMES;
    let spans = texts.into_iter().enumerate().map(|(axis, text)| {
        let gap = if axis == 0 { "" } else { "  " };
        let text = format!("{gap}{} {text}", AXIS_NAMES[axis]);
        Span { text, axis: Some(axis), ..Span::default() }
    });
    Coloured(spans.collect())
}
