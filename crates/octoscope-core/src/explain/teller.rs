//! Tells an event in a sentence.

use super::as_printed::with_printed_rules;
use super::rich::{on_axis, strong};
use super::words::{
    Decided, Words, approx, chain, coordinate, distinct, equation, grid_place, point, signs, t,
    tuple,
};
use crate::event::Event;
use crate::explain::number::with_minus;
use crate::geometry::{AXIS_NAMES, Axes, Ray};
use crate::query::Query;
use crate::trace::{Disagreement, Frame, Moment, Trace, double_would_differ};
use crate::traverse::{Algorithm, Variant};
use crate::tree::NodeId;

/// Tells one event, knowing what was before.
pub(super) struct Teller<'a, const D: usize> {
    pub words: &'a Words<'a, D>,
    pub ray: &'a Ray<D>,
    pub trace: &'a Trace<D>,
    pub before: &'a Moment<D>,
}

impl<const D: usize> Teller<'_, D> {
    /// The event, and whether doubles would have decided otherwise.
    pub(super) fn tell_all(&self, event: &Event<D>) -> String {
        let Self { words, ray, trace, before } = *self;
        let told = with_printed_rules(words, trace, event, before, || self.tell(event));
        if !trace.query.is_exact(words.tree.domain(), ray) {
            return told;
        }
        match double_would_differ(words.tree, ray, &trace.query, event, before) {
            None => told,
            Some(Disagreement { ulps, .. }) => {
                told + &words.texts.format("doubles-differ", &[("ulps", ulps.into())])
            }
        }
    }

    /// How this run decides. Whoever takes one of equal planes has not found it to
    /// be the smaller one.
    pub(super) fn decided(&self) -> Decided {
        let query = &self.trace.query;
        if !query.is_exact(self.words.tree.domain(), self.ray) {
            return Decided::InDoubles;
        }
        let by_tables = matches!(query, Query::Ray { algorithm: Algorithm::ParametricTable, .. });
        if by_tables || query.variants_at_work().has(Variant::OneByOne) {
            Decided::ExactlyOneByOne
        } else {
            Decided::Exactly
        }
    }

    fn tell(&self, event: &Event<D>) -> String {
        let words = self.words;
        match *event {
            Event::Clip { near, far, enter, exit, hit, mirror } => {
                self.clip(near, far, [enter, exit], hit, mirror)
            }
            Event::Test { node, interval, touch, .. } => {
                let is_leaf = words.tree.node(node).is_leaf();
                let leaf = if is_leaf { words.leaf(node) } else { words.node_first(node) };
                let Some([enter, exit]) = interval else {
                    return words.say("test-miss", &[("node", leaf)]);
                };
                if touch {
                    return words.say("test-touch", &[("node", leaf), ("at", approx(enter))]);
                }
                self.interval("test-hit", leaf, enter, exit)
            }
            Event::Sort { n_leaves } => words.texts.format("sort", &[("n", n_leaves.into())]),
            Event::Visit { node, state, .. } => {
                let Some(state) = state else {
                    return words.say("visit-root", &[("node", words.node(node))]);
                };
                let mask = self.mask();
                let variants = self.trace.query.variants_at_work();
                let child = strong(&variants.child_of_state(state, mask).0.to_string());
                let mut arguments = vec![("child", child), ("node", words.node(node))];
                if variants.has(Variant::B2Morton) {
                    let rule = Variant::B2Morton.id().to_owned();
                    let number = state.mirrored(mask).0.to_string();
                    arguments.extend([("number", number), ("rule", rule)]);
                    return words.say("visit-morton", &arguments);
                }
                if mask.is_empty() {
                    return words.say("visit-plain", &arguments);
                }
                arguments.extend([("state", state.0.to_string()), ("mask", mask.0.to_string())]);
                words.say("visit-mirrored", &arguments)
            }
            Event::Skip { exit, behind } => {
                let planes = self.before.frame().and_then(Frame::planes);
                let far = planes.map_or([exit; D], |[_, far]| far);
                let axis = (0..D).find(|&e| far[e] == exit).unwrap_or(0);
                let exit = equation(&t(axis, "1"), &approx(exit));
                words.say(if behind { "skip-behind" } else { "skip-ahead" }, &[("exit", exit)])
            }
            Event::Halve { mid, .. } => {
                let values = distinct(&mid);
                let mids = words.list((0..D).map(|e| equation(&t(e, "m"), &values[e])));
                let still = Axes::of(|e| self.ray.direction()[e] == 0.0 && mid[e].is_infinite());
                let mut text = words.say("halve", &[("mid", mids)]);
                let is_mean = self.trace.query.variants_at_work().has(Variant::Averaged);
                if is_mean && !mid.iter().all(|t| t.is_infinite()) {
                    text += &words.texts.get("halve-mean");
                }
                if !still.is_empty() {
                    text += &words.say("halve-still", &[("axes", words.axes(still))]);
                }
                text
            }
            Event::First { entry, entry_axis, compared, state } => {
                self.first(entry, entry_axis, compared, state)
            }
            Event::Step { state, exits, axes, next } => self.step(state, exits, axes, next),
            Event::Up { node: Some(node) } => {
                // What was tested last may lie below it.
                let done = self.before.frame().map(|frame| frame.node);
                let done = done.and_then(|done| words.tree.child_index(done));
                let state = done.map_or(String::new(), |child| child.0.to_string());
                let child = words.say("child", &[("state", state)]);
                let mut arguments = vec![("child", child), ("node", words.node(node))];
                let Some((axis, exit)) = self.left_behind() else {
                    return words.say("up", &arguments);
                };
                arguments.push(("exit", equation(&t(axis, "1"), &approx(exit))));
                words.say("up-behind", &arguments)
            }
            Event::Up { node: None } => words.texts.get("up-none"),
            Event::Enter { node, interval: [enter, exit], .. } => {
                self.interval("enter", words.node(node), enter, exit)
            }
            Event::Cuts { order, inside, .. } => self.cuts(order, inside),
            Event::Classify { at, child, .. } => self.classify(at, child),
            Event::Flip { at, axes, child } => {
                let key = if axes.count() == 1 { "flip-one" } else { "flip-many" };
                let child = strong(&child.0.to_string());
                let arguments = [("at", strong(&approx(at))), ("axes", words.axes(axes))];
                words.say(key, &[&arguments[..], &[("child", child)]].concat())
            }
            Event::Split { axis, at, interval, halves, taken, .. } => {
                self.split(usize::from(axis), at, interval, halves, taken)
            }
            Event::Pop { part, interval: [enter, exit] } => {
                let whole = part.halved.is_empty();
                let key = if whole { "pop-node" } else { "pop-half" };
                self.interval(key, words.node(part.node), enter, exit)
            }
            Event::Grid { cell, next, .. } => {
                let values = distinct(&next);
                let planes = words.list((0..D).map(|e| equation(&t(e, "Max"), &values[e])));
                let cell = tuple(cell.map(|c| c.to_string()));
                words.say("grid", &[("cell", cell), ("planes", planes)])
            }
            Event::Cross { next, axes, cell, outside, .. } => {
                let key = match (axes.count() == 1, outside.is_empty()) {
                    (true, true) => "cross-one",
                    (false, true) => "cross-many",
                    (true, false) => "cross-out-one",
                    (false, false) => "cross-out-many",
                };
                let cell = tuple(cell.map(with_minus));
                let planes = chain(next, ["Max"; D], axes, self.decided());
                let arguments = [("axes", words.axes(axes)), ("cell", cell), ("planes", planes)];
                words.say(key, &arguments) + &self.tie(next, axes)
            }
            Event::Parent { node, child, direction, common, .. } => {
                let mut arguments = vec![
                    ("child", strong(&child.0.to_string())),
                    ("direction", signs(direction)),
                    ("node", words.node(node)),
                ];
                if common == [0; D] {
                    return words.say("parent-holds", &arguments);
                }
                let key = if common == direction { "parent-all" } else { "parent-part" };
                arguments.push(("common", signs(common)));
                words.say(key, &arguments)
            }
            Event::Mirror { child, mirrored, node } => words.say(
                "mirror",
                &[
                    ("child", child.0.to_string()),
                    ("mirrored", strong(&mirrored.0.to_string())),
                    ("node", words.node(node)),
                ],
            ),
            Event::Facing { child, node } => words.say(
                "facing",
                &[("child", strong(&child.0.to_string())), ("node", words.node(node))],
            ),
            Event::Rope { axis, node } => {
                let axis = usize::from(axis);
                let mut arguments = vec![("axis", on_axis(axis, AXIS_NAMES[axis]))];
                let Some(node) = node else {
                    return words.say("rope-border", &arguments);
                };
                arguments.push(("node", words.node(node)));
                let spanned = self.spanned(node, axis);
                let text = words.say("rope", &arguments);
                if spanned.is_empty() {
                    return text;
                }
                text + &words.say("rope-spans", &[("axes", words.axes(spanned))])
            }
            Event::Push { from, to, axis } => {
                let axis = on_axis(usize::from(axis), AXIS_NAMES[usize::from(axis)]);
                // The push may be too short to be seen in few digits.
                let told = |x: [f64; D], n: usize| {
                    tuple::<D>(std::array::from_fn(|e| {
                        let [at, pushed] = [from[e], to[e]];
                        if at == pushed || coordinate(at) != coordinate(pushed) {
                            return coordinate(x[e]);
                        }
                        distinct(&[at, pushed]).swap_remove(n)
                    }))
                };
                let (from, to) = (told(from, 0), told(to, 1));
                words.say("push", &[("from", from), ("to", to), ("axis", axis)])
            }
            Event::Begin { node } => {
                let is_root = node == words.tree.root().id;
                let key = if is_root { "begin-root" } else { "begin-node" };
                words.say(key, &[("node", words.node(node))])
            }
            Event::Encode { point: at, code, after, .. } => {
                let mut arguments = vec![("point", point(at)), ("codes", words.binary(code))];
                let Some(after) = after else {
                    return words.say("encode", &arguments);
                };
                arguments.push(("after", strong(&approx(after))));
                words.say("encode-ray", &arguments)
            }
            Event::Compare { mid, point, child, node } => {
                let comparisons = words.list((0..D).map(|e| {
                    let values = distinct(&[point[e], mid[e]]);
                    let sign = if child.is_upper(e) { "≥" } else { "<" };
                    let left = equation(&on_axis(e, AXIS_NAMES[e]), &values[0]);
                    format!("{left} {sign} {}", strong(&values[1]))
                }));
                words.say(
                    "compare",
                    &[
                        ("comparisons", comparisons),
                        ("child", strong(&child.0.to_string())),
                        ("node", words.node(node)),
                    ],
                )
            }
            Event::Follow { level, child, node, .. } => words.say(
                "follow",
                &[
                    ("bit", (level - 1).to_string()),
                    ("bits", words.bits(child)),
                    ("child", strong(&child.0.to_string())),
                    ("node", words.node(node)),
                ],
            ),
            Event::Exits { planes, exits, axes } => {
                let planes = words.list(axes.iter().map(|e| {
                    let name = on_axis(e, AXIS_NAMES[e]);
                    equation(&name, &coordinate(planes[e]))
                }));
                let key = if axes.count() == 1 { "exits-one" } else { "exits-many" };
                words.say(
                    key,
                    &[("planes", planes), ("exits", chain(exits, ["1"; D], axes, self.decided()))],
                )
            }
            Event::Target { from, to, axes, .. } => words.say(
                "target",
                &[
                    ("axes", words.axes(axes)),
                    ("to", grid_place(to)),
                    ("from", tuple(from.map(|c| c.to_string()))),
                ],
            ),
            Event::Border { outside, .. } if outside.is_empty() => words.texts.get("border-inside"),
            Event::Border { outside, .. } => {
                // A pushed point outside has no codes.
                let pushed = self.before.pushed.is_some();
                let key = if pushed { "border-point-outside" } else { "border-outside" };
                words.say(key, &[("axes", words.axes(outside))])
            }
            Event::Difference { from, to, .. } if from == to => words.texts.get("difference-none"),
            Event::Difference { level, .. } => words.say(
                "difference",
                &[
                    ("bit", strong(&level.saturating_sub(1).to_string())),
                    ("level", strong(&level.to_string())),
                ],
            ),
            Event::Leave { exits, axes } => {
                let key = if axes.count() == 1 { "leave-one" } else { "leave-many" };
                words.say(
                    key,
                    &[
                        ("axes", words.axes(axes)),
                        ("exits", chain(exits, ["1"; D], axes, self.decided())),
                    ],
                )
            }
            Event::Resume { node, .. } => words.say("resume", &[("node", words.node(node))]),
            Event::Climb { node, level } => {
                let goal = self.before.difference.map_or(level, |difference| difference.level);
                let node = words.node(node);
                if level == goal {
                    return words.say("climb-done", &[("node", node)]);
                }
                words.say("climb", &[("node", node), ("level", goal.to_string())])
            }
            Event::Corners { min, max, from, to } => words.say(
                "corners",
                &[
                    ("min", point(min)),
                    ("max", point(max)),
                    ("from", words.binary(from)),
                    ("to", words.binary(to)),
                ],
            ),
            Event::Leaf { node, enter, exit, full } => {
                let key = if full { "leaf-full" } else { "leaf-empty" };
                self.interval(key, words.leaf(node), enter, exit)
            }
            Event::Touch { node, at } => {
                words.say("touch", &[("node", words.leaf(node)), ("at", approx(at))])
            }
            Event::Found { node } => self.found("found", node),
            Event::End(end) => self.end(end),
        }
    }

    /// The far plane by which the node at work lies behind the origin, if it is left
    /// at once for that, without a step of its own that says so.
    fn left_behind(&self) -> Option<(usize, f64)> {
        let by_one_rule =
            matches!(self.trace.query, Query::Ray { algorithm: Algorithm::Parametric, .. });
        let frame = self.before.frame().filter(|frame| by_one_rule && frame.mid.is_none())?;
        let leaf = self.before.leaves.last().is_some_and(|leaf| leaf.node == frame.node);
        let touch = self.before.touches.last().is_some_and(|(node, _)| *node == frame.node);
        let [_, far] = frame.planes().filter(|_| !leaf && !touch)?;
        let exit = frame.exit();
        far.iter().position(|&t| t == exit && exit <= 0.0).map(|axis| (axis, exit))
    }

    /// Axes after `axis` across whose planes no link is followed from `node`, as it
    /// spans what lies beyond them already.
    fn spanned(&self, node: NodeId, axis: usize) -> Axes<D> {
        let (Some(exits), Some(leaf)) = (self.before.exits, self.before.leaves.last()) else {
            return Axes::NONE;
        };
        let tree = self.words.tree;
        let (size, low) = (1 << tree.level(leaf.node), tree.code(leaf.node));
        let (level, code) = (tree.level(node), tree.code(node));
        let later = exits.axes.iter().filter(|&e| e > axis);
        let spans = |&e: &usize| {
            let is_upper = self.ray.direction()[e] > 0.0;
            let beyond = i64::from(low[e]) + if is_upper { size } else { -1 };
            beyond >> level == i64::from(code[e] >> level)
        };
        later.take_while(spans).fold(Axes::NONE, |axes, e| Axes(axes.0 | Axes::<D>::one(e).0))
    }

    pub(super) fn mask(&self) -> Axes<D> {
        self.before.clip.map_or(Axes::NONE, |clip| clip.mirror)
    }

    pub(super) fn interval(&self, key: &str, node: String, enter: f64, exit: f64) -> String {
        let values = distinct(&[enter, exit]);
        let [enter, exit] = [strong(&values[0]), strong(&values[1])];
        self.words.say(key, &[("node", node), ("enter", enter), ("exit", exit)])
    }
}
