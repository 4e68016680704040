//! The steps of a trace, as a table.

use super::sheet::{Sheet, line_height};
use super::subject::Subject;
use super::words::{codes, joined};
use crate::{Anchor, Figure, Role, metrics};
use octoscope_core::explain::{RichText, sentence};
use octoscope_core::trace::Moment;
use std::ops::RangeInclusive;

/// The steps that a table of those up to `step` shows: the last ones, as many as a page
/// has rows; the one before the first event only by itself.
pub fn rows_of_table(step: usize) -> RangeInclusive<usize> {
    const MOST: usize = 24;
    let first = (step + 1).saturating_sub(MOST).max(1).min(step);
    first..=step
}

/// Number, node and sentence of the last steps, the present one lit, as a figure
/// of this width.
pub(super) fn view<const D: usize>(subject: &Subject<D>, width: f64) -> Figure {
    let shown = rows_of_table(subject.moment.step.min(subject.trace.events.len()));
    let before = shown.start().saturating_sub(1);
    let mut moment = Moment::after(subject.tree, subject.trace, before);
    let mut rows = Vec::new();
    for step in shown {
        if let Some(event) = step.checked_sub(1).map(|index| &subject.trace.events[index]) {
            moment.apply(subject.tree, event);
        }
        let said = sentence(subject.tree, subject.ray, subject.trace, step, subject.language());
        let node = moment.current.map(|node| {
            let level = subject.tree.level(node);
            joined([format!("{level}: ").into(), codes(subject.tree, node)])
        });
        rows.push((step, node.unwrap_or_else(|| "–".into()), said));
    }
    draw(subject, &rows, width)
}

fn draw<const D: usize>(
    subject: &Subject<D>,
    rows: &[(usize, RichText, RichText)],
    width: f64,
) -> Figure {
    const GAP: f64 = 12.0;
    const INSET: f64 = 6.0;
    let texts = subject.texts;
    let heads =
        ["table-step", "table-node", "table-what"].map(|key| RichText::from(texts.get(key)));
    let number = |step: usize| RichText::from(step.to_string());
    let widest = |role: Role, head: &RichText, texts: &mut dyn Iterator<Item = RichText>| {
        texts
            .map(|text| metrics::width(role, &text))
            .fold(metrics::width(Role::Note, head), f64::max)
    };
    let step_width = widest(Role::Note, &heads[0], &mut rows.iter().map(|row| number(row.0)));
    let node_width = widest(Role::Note, &heads[1], &mut rows.iter().map(|row| row.1.clone()));
    let node_x = INSET + step_width + GAP;
    let what_x = node_x + node_width + GAP;
    let mut sheet = Sheet::default();
    let [step_head, node_head, what_head] = heads;
    sheet.text(Role::Note, [INSET + step_width, 8.0], Anchor::End, step_head);
    sheet.text(Role::Note, [node_x, 8.0], Anchor::Start, node_head);
    sheet.text(Role::Note, [what_x, 8.0], Anchor::Start, what_head);
    sheet.line(Role::Rule, [[0.0, 17.0], [width, 17.0]]);
    let mut top = 19.0;
    let line = line_height(Role::Words);
    for (step, node, said) in rows {
        let lines = metrics::wrapped(Role::Words, said, width - INSET - what_x);
        let height = line * lines.len() as f64 + 5.0;
        if *step == subject.moment.step {
            sheet.rect(Role::LitLine, [0.0, top], [width, height]);
        }
        let y = top + 2.5 + 0.5 * line;
        sheet.text(Role::Note, [INSET + step_width, y], Anchor::End, number(*step));
        sheet.text(Role::Note, [node_x, y], Anchor::Start, node.clone());
        for (n, piece) in lines.iter().enumerate() {
            let at = [what_x, y + line * n as f64];
            sheet.text(Role::Words, at, Anchor::Start, piece.clone());
        }
        top += height;
    }
    sheet.line(Role::Rule, [[0.0, top + 1.0], [width, top + 1.0]]);
    sheet.figure([width, top + 2.0])
}
