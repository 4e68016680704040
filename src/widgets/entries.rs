//! What several tables of panels are made of.

use super::rich_job;
use crate::look::Look;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{Align, FontId, Label, RichText, Ui};
use octoscope_core::explain::{RichText as Coloured, Span};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::tree::Child;

/// The line above the columns of a table, or a few quiet words below it.
pub fn caption(ui: &mut Ui, look: &Look, text: impl Into<String>) {
    ui.label(RichText::new(text).size(look.type_size(12.0)).color(look.palette.quiet));
}

/// A value behind its caption, and a few quiet words after it, all on one baseline.
pub fn captioned(ui: &mut Ui, look: &Look, caption: &str, value: &Coloured, after: &str) {
    const GAP: f32 = 8.0;
    let font = FontId::proportional(look.type_size(12.0));
    let quiet =
        TextFormat { valign: Align::BOTTOM, ..TextFormat::simple(font, look.palette.quiet) };
    let mut job = LayoutJob::default();
    job.wrap.max_width = ui.available_width();
    job.append(caption, 0.0, quiet.clone());
    let value = rich_job(value, look, 14.0, f32::INFINITY);
    for (n, section) in value.sections.iter().enumerate() {
        let before = if n == 0 { GAP } else { 0.0 };
        let format = TextFormat { valign: Align::BOTTOM, ..section.format.clone() };
        let bytes = section.byte_range.start.0..section.byte_range.end.0;
        job.append(&value.text[bytes], before, format);
    }
    if !after.is_empty() {
        job.append(after, 2.0 * GAP, quiet);
    }
    ui.add(Label::new(job));
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
        let bit = bit_of(child, axis);
        Span { text: format!("{gap}{}", bit.text), ..bit }
    });
    Coloured(bits.collect())
}

/// One of them.
pub fn bit_of<const D: usize>(child: Child<D>, axis: usize) -> Span {
    let text = u8::from(child.is_upper(axis)).to_string();
    Span { text, axis: Some(axis), ..Span::default() }
}

/// A range of parameters, its end not in it.
pub fn range([from, to]: [f64; 2]) -> String {
    use octoscope_core::explain::approx;
    format!("[{}, {})", approx(from), approx(to))
}
