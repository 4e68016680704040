//! One sentence for every step.

use super::rich::RichText;
use super::teller::Teller;
use super::words::{Words, direction, point, signs};
use crate::geometry::Ray;
use crate::locate::NeighbourMethod;
use crate::query::{PointMethod, Query};
use crate::text::Language;
use crate::trace::{Moment, Trace};
use crate::tree::Tree;

/// What happens in `step` of `trace`, counted from 1, as a sentence with its
/// numbers; step 0 says what is about to happen. Steps after the last are taken
/// for the last.
pub fn sentence<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    trace: &Trace<D>,
    step: usize,
    language: Language,
) -> RichText {
    let words = Words::new(tree, language);
    let step = step.min(trace.events.len());
    let marked = match step.checked_sub(1).map(|index| &trace.events[index]) {
        None => start(&words, ray, trace),
        Some(event) => {
            let before = Moment::after(tree, trace, step - 1);
            Teller { words: &words, ray, trace, before: &before }.tell_all(event)
        }
    };
    RichText::parse(&marked)
}

/// All sentences of `trace`, that of step 0 first. O(events) for a ray, unlike
/// as many calls of [`sentence`].
pub fn sentences<'a, const D: usize>(
    tree: &'a Tree<D>,
    ray: &'a Ray<D>,
    trace: &'a Trace<D>,
    language: Language,
) -> impl Iterator<Item = RichText> + 'a {
    let words = Words::new(tree, language);
    let first = RichText::parse(&start(&words, ray, trace));
    let mut before = Moment::default();
    let others = trace.events.iter().map(move |event| {
        let marked = Teller { words: &words, ray, trace, before: &before }.tell_all(event);
        before.apply(tree, event);
        RichText::parse(&marked)
    });
    std::iter::once(first).chain(others)
}

/// What is about to happen, and which of its rules are in another form.
fn start<const D: usize>(words: &Words<D>, ray: &Ray<D>, trace: &Trace<D>) -> String {
    let at_work = trace.query.variants_at_work();
    let (printed, others): (Vec<_>, Vec<_>) = at_work.iter().partition(|v| v.is_misprint());
    let mut told = question(words, ray, trace);
    for variant in others {
        told += &words.texts.get(&format!("start-{}", variant.id()));
    }
    let key = match printed.len() {
        0 => return told,
        1 => "start-printed-one",
        _ => "start-printed-many",
    };
    let rules = words.list(printed.iter().map(|variant| variant.id().to_owned()));
    told + &words.say(key, &[("rules", rules)])
}

fn question<const D: usize>(words: &Words<D>, ray: &Ray<D>, trace: &Trace<D>) -> String {
    let tree = words.texts.get(if D == 2 { "quadtree" } else { "octree" });
    match trace.query {
        Query::Ray { algorithm, .. } => words.say(
            "start-ray",
            &[
                ("origin", point(ray.origin())),
                ("direction", direction(ray.direction())),
                ("tree", tree),
                ("algorithm", words.texts.get(&format!("by-{}", algorithm.id()))),
            ],
        ),
        Query::Point { at, method, .. } => {
            let key = match method {
                PointMethod::Codes => "start-point-codes",
                PointMethod::Comparison => "start-point-comparison",
            };
            words.say(key, &[("point", point(at))])
        }
        Query::Region { .. } => words.texts.get("start-region"),
        Query::Neighbour { level, code, direction, method, .. } => {
            let key = match method {
                NeighbourMethod::Codes => "start-neighbour",
                NeighbourMethod::Tables => "start-neighbour-tables",
            };
            let level = level.min(words.tree.domain().root_level());
            let node = words.node_at(level, code);
            words.say(key, &[("node", node), ("direction", signs(direction.components()))])
        }
    }
}
