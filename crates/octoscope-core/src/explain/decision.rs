//! Sentences on what is decided by comparing numbers.

use super::number::shown_number;
use super::rich::{on_axis, strong};
use super::teller::Teller;
use super::words::{Decided, chain, distinct, equation, far_planes, relation, t};
use crate::event::Halves;
use crate::geometry::{AXIS_NAMES, Axes};
use crate::query::Query;
use crate::traverse::{Algorithm, Variant};
use crate::tree::{Child, Part};

impl<const D: usize> Teller<'_, D> {
    pub(super) fn clip(
        &self,
        near: [f64; D],
        far: [f64; D],
        [enter, exit]: [f64; 2],
        hit: bool,
        mirror: Axes<D>,
    ) -> String {
        let words = self.words;
        let beside = Axes::where_true(std::array::from_fn(|e| {
            near[e] == f64::INFINITY || far[e] == f64::NEG_INFINITY
        }));
        if !hit && !beside.is_empty() {
            return words.say("clip-parallel", &[("axes", words.axes(beside))]);
        }
        let values = distinct(&[enter, exit, 0.0]);
        let axis_in = (0..D).find(|&e| near[e] == enter).unwrap_or(0);
        let axis_out = (0..D).find(|&e| far[e] == exit).unwrap_or(0);
        let mut arguments = vec![
            ("enter", equation(&t(axis_in, "0"), &values[0])),
            ("exit", equation(&t(axis_out, "1"), &values[1])),
        ];
        if !hit {
            let end = match self.trace.query {
                Query::Ray { options, .. } => options.end(),
                Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => None,
            };
            // What the line has no part in is missed, wherever the ray begins.
            if exit >= enter {
                if exit <= 0.0 {
                    return words.say("clip-behind", &arguments);
                }
                if let Some(end) = end.filter(|&end| enter.max(0.0) >= end) {
                    arguments.push(("end", equation("t", &shown_number(end))));
                    let key = if enter > 0.0 { "clip-short" } else { "clip-no-length" };
                    return words.say(key, &arguments);
                }
            }
            // Exact numbers may be equal where the doubles differ.
            let relation = if exit > enter { "≤" } else { relation(exit, enter) };
            arguments.push(("relation", relation.to_owned()));
            return words.say("clip-miss", &arguments);
        }
        let key = if enter <= 0.0 { "clip-inside" } else { "clip-hit" };
        let mut text = words.say(key, &arguments);
        if !mirror.is_empty() {
            let mask = strong(&mirror.0.to_string());
            let key = match self.trace.query {
                Query::Ray { algorithm, .. } => mirror_key(algorithm),
                Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => {
                    "clip-falls"
                }
            };
            text += &words.say(key, &[("axes", words.axes(mirror)), ("mask", mask)]);
        }
        text
    }

    pub(super) fn cuts(&self, order: [u8; D], inside: Axes<D>) -> String {
        let words = self.words;
        let mid = self.before.frame().and_then(|frame| frame.mid).unwrap_or([f64::NAN; D]);
        let values = distinct(&mid);
        let name = |e: usize| equation(&t(e, "m"), &values[e]);
        let kept = order.map(usize::from).into_iter().filter(|&e| inside.contains(e));
        let kept: Vec<String> = kept.map(name).collect();
        let (n, cuts) = (kept.len() as u64, words.list(kept));
        let values = [("n", n.into()), ("cuts", cuts.as_str().into())];
        words.texts.format("cuts", &values)
    }

    pub(super) fn classify(&self, at: f64, child: Child<D>) -> String {
        let words = self.words;
        let mid = self.before.frame().and_then(|frame| frame.mid).unwrap_or([f64::NAN; D]);
        let numbers: Vec<f64> = mid.into_iter().chain([at]).collect();
        let values = distinct(&numbers);
        let passed = Axes::<D>(child.0 ^ self.mask().0);
        let comparisons = words.list((0..D).map(|e| {
            let sign = if passed.contains(e) { "≤" } else { ">" };
            format!("{} {sign} {}", equation(&t(e, "m"), &values[e]), strong(&values[D]))
        }));
        words.say(
            "classify",
            &[
                ("at", strong(&values[D])),
                ("comparisons", comparisons),
                ("child", strong(&child.0.to_string())),
            ],
        )
    }

    pub(super) fn split(
        &self,
        axis: usize,
        at: f64,
        [enter, exit]: [f64; 2],
        halves: Halves,
        taken: Part<D>,
    ) -> String {
        let words = self.words;
        let values = distinct(&[at, enter, exit]);
        // Once all axes are halved the part is a child, whose index tells the half.
        let child = words.tree.child_index(taken.node).filter(|_| taken.halved.is_empty());
        let is_upper = child.map_or(taken.upper.contains(axis), |child| child.is_upper(axis));
        let is_gem = self.trace.query.variants_at_work().has(Variant::Gem);
        let key = match (halves, is_gem) {
            (Halves::Near, false) if self.ray.direction()[axis] == 0.0 => "split-still",
            (Halves::Near, false) if at <= 0.0 => "split-behind",
            (Halves::Near, false) => "split-near",
            (Halves::Far, false) => "split-far",
            (Halves::Both, false) => "split-both",
            (Halves::Near, true) if at > exit => "split-gem-after",
            (Halves::Near, true) => "split-gem-behind",
            (Halves::Far, true) => "split-gem-far",
            (Halves::Both, true) if at.is_nan() => "split-gem-no-number",
            (Halves::Both, true) => "split-gem-both",
        };
        let axis_name = on_axis(axis, AXIS_NAMES[axis]);
        let half = if is_upper { "upper-half" } else { "lower-half" };
        words.say(
            key,
            &[
                ("at", equation(&t(axis, "m"), &values[0])),
                ("enter", strong(&values[1])),
                ("exit", strong(&values[2])),
                ("half", words.say(half, &[("axis", axis_name.clone())])),
                ("axis", axis_name),
            ],
        )
    }

    pub(super) fn first(
        &self,
        entry: f64,
        entry_axis: Option<usize>,
        compared: Axes<D>,
        state: Child<D>,
    ) -> String {
        let words = self.words;
        let mid = self.before.frame().and_then(|frame| frame.mid).unwrap_or([entry; D]);
        let numbers: Vec<f64> = mid.into_iter().chain([entry]).collect();
        let values = distinct(&numbers);
        let entry_name = entry_axis.map_or("t".to_owned(), |axis| t(axis, "0"));
        let upper = Axes::<D>(state.0);
        // What decided: the mid planes that are passed, or that none is. The
        // mid plane behind the entry plane itself cannot be passed yet.
        let told = if upper.is_empty() {
            Axes::where_true(std::array::from_fn(|e| compared.contains(e) && entry_axis != Some(e)))
        } else {
            upper
        };
        let comparisons = words.list(told.iter().map(|e| {
            let left = equation(&t(e, "m"), &values[e]);
            let right = equation(&entry_name, &values[D]);
            // Exact numbers may differ where the doubles are the same.
            let sign = match (self.decided(), upper.contains(e)) {
                (Decided::Exactly, true) if mid[e] == entry => "≤",
                (Decided::Exactly, false) if mid[e] == entry => ">",
                (Decided::ExactlyOneByOne, true) if mid[e] == entry => "<",
                (Decided::Exactly | Decided::ExactlyOneByOne | Decided::InDoubles, _) => {
                    relation(mid[e], entry)
                }
            };
            format!("{left} {sign} {right}")
        }));
        let key = match upper.count() {
            0 => "first-none",
            1 => "first-one",
            _ => "first-many",
        };
        let mut arguments = vec![
            ("comparisons", comparisons),
            ("inside", if entry_axis.is_none() { "yes" } else { "no" }.to_owned()),
        ];
        if !upper.is_empty() {
            arguments.push(("axes", words.axes(upper)));
            arguments.push(("state", strong(&state.0.to_string())));
        }
        words.say(key, &arguments)
    }

    pub(super) fn step(
        &self,
        state: Child<D>,
        exits: [f64; D],
        axes: Axes<D>,
        next: Option<Child<D>>,
    ) -> String {
        let words = self.words;
        let variants = self.trace.query.variants_at_work();
        let is_child = self.mask().is_empty() && !variants.has(Variant::B2Morton);
        let name = if is_child { "child" } else { "state" };
        let child = words.say(name, &[("state", state.0.to_string())]);
        let planes = far_planes(variants.child_of_state(state, Axes::NONE));
        let mut arguments = vec![
            ("child", child),
            ("axes", words.axes(axes)),
            ("exits", chain(exits, planes, axes, self.decided())),
        ];
        let one = axes.count() == 1;
        if let Some(next) = next {
            arguments.push(("next", strong(&next.0.to_string())));
            let key = if one { "step-one" } else { "step-many" };
            return words.say(key, &arguments) + &self.tie(exits, axes);
        }
        arguments.push(("done", words.axes(Axes(axes.0 & state.0))));
        let key = if one { "step-end-one" } else { "step-end-many" };
        words.say(key, &arguments) + &self.tie(exits, axes)
    }

    /// Which of the planes that are met at once is crossed, where only one is.
    pub(super) fn tie(&self, parameters: [f64; D], axes: Axes<D>) -> String {
        let by_tables =
            matches!(self.trace.query, Query::Ray { algorithm: Algorithm::ParametricTable, .. });
        let one_by_one = self.trace.query.variants_at_work().has(Variant::OneByOne);
        let key = match (by_tables, one_by_one) {
            (true, _) => "tie-last",
            (false, true) => "tie-first",
            (false, false) => return String::new(),
        };
        let Some(crossed) = axes.iter().next() else {
            return String::new();
        };
        let equal = Axes::<D>::where_true(parameters.map(|t| t == parameters[crossed]));
        if equal.count() > 1 { self.words.texts.get(key) } else { String::new() }
    }
}

/// Key of what a negative direction means to an algorithm: to its states, to the
/// order of its halves, or only to which planes are far.
fn mirror_key(algorithm: Algorithm) -> &'static str {
    match algorithm {
        Algorithm::Parametric | Algorithm::ParametricTable | Algorithm::AllChildren => {
            "clip-mirror"
        }
        Algorithm::Esvo | Algorithm::Hero | Algorithm::Gargantini => "clip-mask",
        Algorithm::Codes
        | Algorithm::Glassner
        | Algorithm::Samet
        | Algorithm::SametCorner
        | Algorithm::SametNet
        | Algorithm::Bsp
        | Algorithm::Dda
        | Algorithm::DdaOctree
        | Algorithm::Exhaustive => "clip-falls",
    }
}
