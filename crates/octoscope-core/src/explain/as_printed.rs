//! Sentences on steps that follow a misprinted rule.

use super::rich::strong;
use super::words::{Words, approx};
use crate::event::Event;
use crate::geometry::Axes;
use crate::query::Query;
use crate::trace::{Moment, Trace};
use crate::traverse::Algorithm;
use crate::variant::Variant::{
    self, B4, B5, B6, B7, B18, B19, B21, B24a, B24b, B24c, B25Leftmost, B25Rightmost, B28,
};

/// The sentence on a step of `trace`, known what was before: what `tell` says, unless
/// the step follows a misprinted rule. Then the rule is named, and stands in place of
/// reasons that would not be true.
pub(super) fn with_printed_rules<const D: usize>(
    words: &Words<D>,
    trace: &Trace<D>,
    event: &Event<D>,
    before: &Moment<D>,
    tell: impl FnOnce() -> String,
) -> String {
    let query = &trace.query;
    let variants = query.variants_at_work();
    if variants.is_empty() {
        return tell();
    }
    let at_work = |candidates: &[Variant]| {
        let used = |v: &&Variant| variants.has(**v);
        let ids: Vec<String> = candidates.iter().filter(used).map(|v| v.id().to_owned()).collect();
        (!ids.is_empty()).then(|| words.list(ids))
    };
    let misprints: Vec<Variant> = variants.iter().filter(|v| v.is_misprint()).collect();
    match *event {
        Event::Clip { enter, exit, hit, .. } => {
            // Of a miss only B-1 takes other planes than those that are told.
            let rules = [Variant::B1, Variant::B10, Variant::B11];
            if let Some(rule) = at_work(if hit { &rules } else { &rules[..1] }) {
                let interval = [("enter", approx(enter)), ("exit", approx(exit)), ("rule", rule)];
                let key = if hit { "clip-printed" } else { "clip-printed-miss" };
                return words.say(key, &interval);
            }
        }
        Event::First { entry, state, .. } => {
            let of_children: &[Variant] =
                if D == 2 { &[Variant::B3] } else { &[Variant::B2, Variant::B2Morton] };
            // The tables begin at the near planes in any case; by the one rule it
            // makes a difference where these lie behind the origin.
            let clamps = matches!(query, Query::Ray { algorithm: Algorithm::Parametric, .. });
            let of_entry: &[Variant] =
                if clamps && entry < 0.0 { &[Variant::B9, Variant::B10] } else { &[] };
            if let Some(rule) = at_work(&[of_children, of_entry].concat()) {
                let state = strong(&state.0.to_string());
                return words.say("first-printed", &[("state", state), ("rule", rule)]);
            }
        }
        // No branch of the selection as printed is for equal parameters.
        Event::Halve { mid, .. } if D == 2 && mid[0] == mid[1] => {
            if let Some(rule) = at_work(&[Variant::B3]) {
                return tell() + &words.say("halve-unselected", &[("rule", rule)]);
            }
        }
        // What a misprint reports need not be on the ray.
        Event::Leaf { node, enter, exit, .. } => {
            if let Some(rule) = at_work(&misprints) {
                let leaf = words.node(node);
                let interval = [("enter", approx(enter)), ("exit", approx(exit))];
                let arguments = [&interval[..], &[("node", leaf), ("rule", rule)]].concat();
                return words.say("leaf-printed", &arguments);
            }
        }
        // Nor need what it comes to without a length be touched.
        Event::Touch { node, at } => {
            if let Some(rule) = at_work(&misprints) {
                let arguments = [("node", words.node(node)), ("at", approx(at)), ("rule", rule)];
                return words.say("touch-printed", &arguments);
            }
        }
        Event::Difference { xor, level, .. } => {
            let rules = [B24a, B24b, B25Leftmost, B25Rightmost];
            let highest = xor.iter().fold(0, |bits, code| bits | code).checked_ilog2();
            let bit = highest.filter(|bit| bit + 1 != u32::from(level));
            if let (Some(rule), Some(bit)) = (at_work(&rules), bit) {
                let (bit, level) = (strong(&bit.to_string()), strong(&level.to_string()));
                let arguments = [("bit", bit), ("level", level), ("rule", rule)];
                return words.say("difference-printed", &arguments);
            }
        }
        Event::Follow { level, child, node, .. } => {
            let arguments = |rule| {
                let child_index = strong(&child.0.to_string());
                [
                    ("rule", rule),
                    ("bits", words.bits(child)),
                    ("child", child_index),
                    ("node", words.node(node)),
                ]
            };
            if let Some(rule) = at_work(&[B18, B19]) {
                // The bit of the codes as they are told: from the other end, one further on.
                let above = level - 1 + u8::from(variants.has(B19));
                let root_level = words.tree.domain().root_level();
                let bit = if variants.has(B18) { root_level - above } else { above };
                let bit = [("bit", bit.to_string())];
                return words.say("follow-printed", &[&arguments(rule)[..], &bit].concat());
            }
            if let Some(rule) = at_work(&[B24c]) {
                let bit = [("bit", (level - 1).to_string())];
                return words.say("follow-difference", &[&arguments(rule)[..], &bit].concat());
            }
        }
        Event::Test { .. }
        | Event::Sort { .. }
        | Event::Visit { .. }
        | Event::Skip { .. }
        | Event::Halve { .. }
        | Event::Step { .. }
        | Event::Up { .. }
        | Event::Enter { .. }
        | Event::Cuts { .. }
        | Event::Classify { .. }
        | Event::Flip { .. }
        | Event::Split { .. }
        | Event::Pop { .. }
        | Event::Grid { .. }
        | Event::Cross { .. }
        | Event::Parent { .. }
        | Event::Mirror { .. }
        | Event::Facing { .. }
        | Event::Rope { .. }
        | Event::Push { .. }
        | Event::Begin { .. }
        | Event::Encode { .. }
        | Event::Compare { .. }
        | Event::Exits { .. }
        | Event::Target { .. }
        | Event::Border { .. }
        | Event::Leave { .. }
        | Event::Resume { .. }
        | Event::Climb { .. }
        | Event::Corners { .. }
        | Event::Found { .. }
        | Event::End(_) => {}
    }
    let grid_size = words.tree.domain().grid_size();
    let Some(rule) = at_work(&candidates(event, before, grid_size)) else {
        return tell();
    };
    tell() + &words.say("as-printed", &[("rule", rule)])
}

/// Rules that an event may follow without making its reasons untrue.
fn candidates<const D: usize>(
    event: &Event<D>,
    before: &Moment<D>,
    grid_size: u32,
) -> Vec<Variant> {
    let has_no_number = |parameters: &[f64]| parameters.iter().any(|t| t.is_nan());
    // Along mirrored axes all parameters are those of the mirrored origin.
    let mirror = if let Event::Clip { mirror, .. } = *event {
        mirror
    } else {
        before.clip.map_or(Axes::NONE, |clip| clip.mirror)
    };
    let mirrored = (!mirror.is_empty()).then_some(B7);
    let if_no_number = |parameters: &[f64], rules: &[Variant]| {
        if has_no_number(parameters) { rules.to_vec() } else { Vec::new() }
    };
    let with_mirrored = |rules: Vec<Variant>| rules.into_iter().chain(mirrored).collect();
    match *event {
        Event::Clip { near, far, .. } => {
            let planes: Vec<f64> = near.into_iter().chain(far).collect();
            with_mirrored(if_no_number(&planes, &[B5]))
        }
        Event::Halve { mid, .. } => {
            let rules = [vec![B4], if_no_number(&mid, &[B5, B6])].concat();
            with_mirrored(rules)
        }
        Event::First { .. } => {
            let mid = before.frame().and_then(|frame| frame.mid);
            with_mirrored(mid.map_or_else(Vec::new, |mid| if_no_number(&mid, &[B5, B6])))
        }
        // Table 3 counts in another order than the state is read.
        Event::Step { exits, .. } => {
            let rules = [vec![Variant::B2Morton], if_no_number(&exits, &[B5, B6])].concat();
            with_mirrored(rules)
        }
        // Only the code of an upper face is one by the printed rule.
        Event::Encode { code, .. } if code.contains(&grid_size) => vec![B21],
        Event::Difference { .. } => vec![B24a, B24b, B25Leftmost, B25Rightmost],
        Event::Target { .. } => vec![B28],
        Event::Encode { .. }
        | Event::Test { .. }
        | Event::Sort { .. }
        | Event::Visit { .. }
        | Event::Skip { .. }
        | Event::Up { .. }
        | Event::Enter { .. }
        | Event::Cuts { .. }
        | Event::Classify { .. }
        | Event::Flip { .. }
        | Event::Split { .. }
        | Event::Pop { .. }
        | Event::Grid { .. }
        | Event::Cross { .. }
        | Event::Parent { .. }
        | Event::Mirror { .. }
        | Event::Facing { .. }
        | Event::Rope { .. }
        | Event::Push { .. }
        | Event::Begin { .. }
        | Event::Compare { .. }
        | Event::Follow { .. }
        | Event::Exits { .. }
        | Event::Border { .. }
        | Event::Leave { .. }
        | Event::Resume { .. }
        | Event::Climb { .. }
        | Event::Corners { .. }
        | Event::Leaf { .. }
        | Event::Touch { .. }
        | Event::Found { .. }
        | Event::End(_) => Vec::new(),
    }
}
