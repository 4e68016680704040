//! The net of links between neighbours.

use crate::look::Look;
use crate::widgets::{ROW, Setting, caption, node_note, per_axis, table, table_width};
use eframe::egui::Ui;
use octoscope_core::event::Event;
use octoscope_core::explain::{RichText, Span};
use octoscope_core::geometry::{AXIS_NAMES, Ray};
use octoscope_core::trace::{Moment, Trace};
use octoscope_core::tree::{Code, NodeId, Tree};
use octoscope_figure::Anchor;
use octoscope_figure::views::{Entry, Table, Tone};

/// A tree, and the ray that goes through it along links.
#[derive(Clone, Copy, Debug)]
pub struct Net<'a, const D: usize> {
    /// The tree.
    pub tree: &'a Tree<D>,
    /// The ray.
    pub ray: &'a Ray<D>,
}

/// The leaf that is left.
pub fn note<const D: usize>(
    look: &Look,
    tree: &Tree<D>,
    trace: &Trace<D>,
    moment: &Moment<D>,
) -> String {
    node_note(look, tree, left(trace, moment).map(|(node, _)| node))
}

/// The leaf that is left, and the axis of the link that is followed.
fn left<const D: usize>(trace: &Trace<D>, moment: &Moment<D>) -> Option<(NodeId, Option<usize>)> {
    // Only an algorithm that follows links has had them made; and not while the
    // first leaf is still looked for.
    let has_links = trace.events.iter().any(|event| matches!(event, Event::Rope { .. }));
    let leaf = moment.leaves.last().filter(|_| has_links)?;
    let past = &trace.events[..moment.step.min(trace.events.len())];
    let left = moment.detour.links.last().map(|link| link[0]);
    let since_leaf = past.iter().rev().take_while(|event| !matches!(event, Event::Leaf { .. }));
    let mut followed = since_leaf.filter_map(|event| {
        if let Event::Rope { axis, node } = event {
            Some((usize::from(*axis), *node))
        } else {
            None
        }
    });
    Some(match followed.next() {
        // At the border a link leads nowhere, and the node stays.
        Some((axis, None)) => (moment.current.unwrap_or(leaf.node), Some(axis)),
        Some((axis, Some(_))) => (left.unwrap_or(leaf.node), Some(axis)),
        None => (leaf.node, None),
    })
}

/// The height that it takes in a lecture, in points.
pub fn lecture_height<const D: usize>() -> f32 {
    18.0 + 36.0 * D as f32
}

/// Where the links of the leaf that is left lead to, a row each; the one that is
/// followed is lit.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    Net { tree, ray }: Net<'_, D>,
    trace: &Trace<D>,
    moment: &Moment<D>,
) {
    let Some((from, followed)) = left(trace, moment) else {
        caption(ui, look, look.text("links-none"));
        return;
    };
    let across = |axis, upper| tree.neighbour_across(from, axis, upper);
    let all = (0..D).flat_map(|axis| [across(axis, false), across(axis, true)]);
    let digits = most_digits(all.flatten().map(|node| tree.code(node)));
    let row = |axis: usize, upper: bool| {
        let forward = ray.direction()[axis] > 0.0;
        let used = followed == Some(axis) && forward == upper;
        let tone = if used { Tone::Used } else { Tone::Plain };
        let side = format!("{}{}", if upper { "+" } else { "−" }, AXIS_NAMES[axis]);
        let side = RichText(vec![Span { text: side, axis: Some(axis), ..Span::default() }]);
        let [level, codes, size] = match across(axis, upper) {
            Some(node) => {
                let key = if tree.level(node) > tree.level(from) {
                    "links-larger"
                } else if tree.node(node).is_leaf() {
                    "links-equal"
                } else {
                    "links-divided"
                };
                let code = tree.code(node);
                let codes = per_axis((0..D).map(|e| format!("{:>1$}", code[e], digits[e])));
                [
                    Entry::new(tree.level(node).to_string(), tone),
                    Entry::new(codes, tone),
                    Entry::words(look.text(key), tone),
                ]
            }
            None => [
                Entry::new("–", tone),
                Entry::words(look.text("links-border"), tone),
                Entry::new("", tone),
            ],
        };
        vec![Entry::new(side, tone), level, codes, size]
    };
    let head = ["links-side", "stack-level", "stack-codes", "links-size"];
    let links = Table {
        columns: vec![Anchor::Start, Anchor::Middle, Anchor::Start, Anchor::Start],
        head: head.map(|key| look.text(key).into()).to_vec(),
        rows: (0..D).flat_map(|axis| [row(axis, false), row(axis, true)]).collect(),
    };
    let close = Setting { gap: 0.0, least: 20.0, row: ROW };
    // What is left of the width, between the columns.
    let left = ui.available_width() - table_width(ui, look, &links, close);
    let gap = (left / 3.0).clamp(4.0, 14.0);
    table(ui, look, &links, Setting { gap, ..close });
}

/// Number of digits of the largest code of every axis.
fn most_digits<const D: usize>(codes: impl Iterator<Item = Code<D>>) -> [usize; D] {
    let largest = codes.fold([0; D], |most, code| std::array::from_fn(|e| code[e].max(most[e])));
    largest.map(|code| code.to_string().len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_of_an_axis_stand_below_each_other() {
        assert_eq!(most_digits([[4, 10], [16, 8]].into_iter()), [2, 2]);
        assert_eq!(most_digits([[4, 1], [0, 128]].into_iter()), [1, 3]);
    }
}
