//! Comparisons of a point with the mid planes of the node that it is in.

use crate::look::Look;
use crate::widgets::{ROW, Setting, bit_of, caption, captioned, table};
use eframe::egui::Ui;
use octoscope_core::event::Event;
use octoscope_core::explain::{RichText, Span, distinct};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::tree::Child;
use octoscope_figure::Anchor;
use octoscope_figure::views::{Entry, Table, Tone};

/// The height that it takes in a lecture, in points.
pub fn lecture_height<const D: usize>() -> f32 {
    26.0 + 18.0 * (D + 1) as f32
}

/// The coordinates of the point, the mid planes that they were compared with last, and the
/// child that follows from it. `past` are the events so far.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, past: &[Event<D>]) {
    let is_compared = |event: &&Event<D>| matches!(event, Event::Compare { .. });
    let Some(&Event::Compare { mid, point, child, .. }) = past.iter().rev().find(is_compared)
    else {
        caption(ui, look, look.text("mid-planes-none"));
        return;
    };
    // A step later it is what was done before.
    let is_now = matches!(past.last(), Some(Event::Compare { .. }));
    let compared = comparisons(look, [point, mid], child, is_now);
    table(ui, look, &compared, Setting { gap: 14.0, least: 0.0, row: ROW });
    let number = RichText(vec![Span { text: child.0.to_string(), ..Span::default() }]);
    captioned(ui, look, &look.text("cuts-child"), &number, "");
}

/// A line an axis, the bits lit if they follow `is_now`.
fn comparisons<const D: usize>(
    look: &Look,
    [point, mid]: [[f64; D]; 2],
    child: Child<D>,
    is_now: bool,
) -> Table {
    let row = |axis: usize| {
        let bit = bit_of(child, axis);
        let told = distinct(&[point[axis], mid[axis]]);
        let sign = if child.is_upper(axis) { "≥" } else { "<" };
        let name = Span { text: AXIS_NAMES[axis].to_owned(), strong: true, ..bit.clone() };
        let tone = if is_now { Tone::Used } else { Tone::Plain };
        vec![
            Entry::new(RichText(vec![name]), Tone::Plain),
            Entry::new(told[0].clone(), Tone::Plain),
            Entry::new(sign, Tone::Plain),
            Entry::new(told[1].clone(), Tone::Plain),
            Entry::new(RichText(vec![bit]), tone),
        ]
    };
    let heads = ["mid-planes-point", "", "mid-planes-plane", "mid-planes-bit"];
    let head = |key: &str| if key.is_empty() { "".into() } else { look.text(key).into() };
    Table {
        columns: vec![Anchor::Start, Anchor::Start, Anchor::Middle, Anchor::Start, Anchor::Middle],
        head: std::iter::once("".into()).chain(heads.map(head)).collect(),
        rows: (0..D).map(row).collect(),
    }
}
