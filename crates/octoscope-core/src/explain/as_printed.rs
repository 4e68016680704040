//! Sentences on steps that follow a misprinted rule.

use super::number::approx;
use super::rich::strong;
use super::words::Words;
use crate::event::Event;
use crate::query::Query;
use crate::traverse::{Algorithm, Variant};

/// The sentence on a step of `query`: what `tell` says, unless the step follows
/// a misprinted rule. Then the rule is named, and stands in place of reasons
/// that would not be true.
pub(super) fn with_printed_rules<const D: usize>(
    words: &Words<D>,
    query: &Query<D>,
    event: &Event<D>,
    tell: impl FnOnce() -> String,
) -> String {
    let variants = query.variants();
    if variants.is_empty() {
        return tell();
    }
    let at_work = |candidates: &[Variant]| {
        let used = |v: &&Variant| variants.has(**v) && query.takes(**v);
        let ids: Vec<String> = candidates.iter().filter(used).map(|v| v.id().to_owned()).collect();
        (!ids.is_empty()).then(|| words.list(ids))
    };
    match *event {
        Event::Clip { enter, exit, hit: true, .. } => {
            if let Some(rule) = at_work(&[Variant::B1, Variant::B10, Variant::B11]) {
                let interval = [("enter", approx(enter)), ("exit", approx(exit)), ("rule", rule)];
                return words.say("clip-printed", &interval);
            }
        }
        Event::First { state, .. } => {
            let of_children = if D == 2 { Variant::B3 } else { Variant::B2 };
            // The tables begin at the near planes in any case.
            let clamps = matches!(query, Query::Ray { algorithm: Algorithm::Parametric, .. });
            let rules = [of_children, Variant::B9, Variant::B10];
            if let Some(rule) = at_work(if clamps { &rules } else { &rules[..1] }) {
                let state = strong(&state.0.to_string());
                return words.say("first-printed", &[("state", state), ("rule", rule)]);
            }
        }
        // What a misprint reports need not be on the ray.
        Event::Leaf { node, enter, exit, .. } => {
            let misprints: Vec<Variant> = variants.iter().filter(|v| v.is_misprint()).collect();
            if let Some(rule) = at_work(&misprints) {
                let leaf = words.leaf(node);
                let interval = [("enter", approx(enter)), ("exit", approx(exit))];
                let arguments = [&interval[..], &[("node", leaf), ("rule", rule)]].concat();
                return words.say("leaf-printed", &arguments);
            }
        }
        _ => {}
    }
    let Some(rule) = at_work(candidates(event)) else {
        return tell();
    };
    tell() + &words.say("as-printed", &[("rule", rule)])
}

/// Rules that an event may follow without making its reasons untrue.
fn candidates<const D: usize>(event: &Event<D>) -> &'static [Variant] {
    use Variant::{
        B4, B5, B6, B7, B18, B19, B21, B24a, B24b, B24c, B25Leftmost, B25Rightmost, B28,
    };
    match *event {
        Event::Clip { near, far, mirror, .. } => {
            let no_number = near.iter().chain(&far).any(|t| t.is_nan());
            match (no_number, mirror.is_empty()) {
                (true, true) => &[B5],
                (true, false) => &[B5, B7],
                (false, true) => &[],
                (false, false) => &[B7],
            }
        }
        Event::Halve { mid, .. } if mid.iter().any(|t| t.is_nan()) => &[B4, B5, B6],
        Event::Halve { .. } => &[B4],
        Event::Encode { .. } => &[B21],
        Event::Follow { .. } => &[B18, B19, B24c],
        Event::Difference { .. } => &[B24a, B24b, B25Leftmost, B25Rightmost],
        Event::Target { .. } => &[B28],
        _ => &[],
    }
}
