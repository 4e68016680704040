//! One sentence for every step.

use super::as_printed::with_printed_rules;
use super::number::{approx, distinct};
use super::rich::{RichText, on_axis, strong};
use super::rounding::{Disagreement, double_would_differ};
use super::words::{Words, chain, equation, point, relation, signs, t, tuple, typographic};
use crate::event::{End, Event, Halves};
use crate::geometry::{AXIS_NAMES, Axes, Ray};
use crate::locate::NeighbourMethod;
use crate::query::{PointMethod, Query};
use crate::text::Language;
use crate::trace::{Frame, Moment, Trace};
use crate::tree::{Child, NodeId, Part, Tree};

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
pub(super) fn sentences<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    trace: &Trace<D>,
    language: Language,
) -> Vec<RichText> {
    let words = Words::new(tree, language);
    let mut sentences = vec![RichText::parse(&start(&words, ray, trace))];
    let mut before = Moment::default();
    for event in &trace.events {
        let marked = Teller { words: &words, ray, trace, before: &before }.tell_all(event);
        sentences.push(RichText::parse(&marked));
        before.apply(tree, event);
    }
    sentences
}

/// What is about to happen.
fn start<const D: usize>(words: &Words<D>, ray: &Ray<D>, trace: &Trace<D>) -> String {
    let tree = words.texts.get(if D == 2 { "quadtree" } else { "octree" });
    match trace.query {
        Query::Ray { algorithm, .. } => words.say(
            "start-ray",
            &[
                ("origin", point(ray.origin())),
                ("direction", point(ray.direction())),
                ("tree", tree),
                ("algorithm", words.texts.get(&format!("by-{}", algorithm.id()))),
            ],
        ),
        Query::Point { method: PointMethod::Codes, .. } => words.texts.get("start-point-codes"),
        Query::Point { method: PointMethod::Comparison, .. } => {
            words.texts.get("start-point-comparison")
        }
        Query::Region { .. } => words.texts.get("start-region"),
        Query::Neighbour { method: NeighbourMethod::Codes, .. } => {
            words.texts.get("start-neighbour")
        }
        Query::Neighbour { method: NeighbourMethod::Tables, .. } => {
            words.texts.get("start-neighbour-tables")
        }
    }
}

/// Tells one event, knowing what was before.
struct Teller<'a, const D: usize> {
    words: &'a Words<'a, D>,
    ray: &'a Ray<D>,
    trace: &'a Trace<D>,
    before: &'a Moment<D>,
}

impl<const D: usize> Teller<'_, D> {
    /// The event, and whether doubles would have decided otherwise.
    fn tell_all(&self, event: &Event<D>) -> String {
        let Self { words, ray, trace, before } = *self;
        let told = with_printed_rules(words, &trace.query, event, || self.tell(event));
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

    fn tell(&self, event: &Event<D>) -> String {
        let words = self.words;
        match *event {
            Event::Clip { near, far, enter, exit, hit, mirror } => {
                self.clip(near, far, [enter, exit], hit, mirror)
            }
            Event::Test { node, interval } => {
                let is_leaf = words.tree.node(node).is_leaf();
                let leaf = if is_leaf { words.leaf(node) } else { words.node_first(node) };
                let Some([enter, exit]) = interval else {
                    return words.say("test-miss", &[("node", leaf)]);
                };
                let touch = |e: &Event<D>| matches!(e, Event::Touch { node: n, .. } if *n == node);
                if enter == exit || self.trace.events.iter().any(touch) {
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
                let child = strong(&state.mirrored(mask).0.to_string());
                let mut arguments = vec![("child", child), ("node", words.node(node))];
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
            Event::Halve { mid } => {
                let values = distinct(&mid);
                let mids = words.list((0..D).map(|e| equation(&t(e, "m"), &values[e])));
                let still = Axes::where_true(self.ray.direction().map(|d| d == 0.0));
                let mut text = words.say("halve", &[("mid", mids)]);
                if !still.is_empty() {
                    text += &words.say("halve-still", &[("axes", words.axes(still))]);
                }
                text
            }
            Event::First { entry, entry_axis, compared, state } => {
                self.first(entry, entry_axis, compared, state)
            }
            Event::Step { state, exits, axes, next } => self.step(state, exits, axes, next),
            Event::Up { node: Some(node) } => words.say("up", &[("node", words.node(node))]),
            Event::Up { node: None } => words.texts.get("up-none"),
            Event::Enter { node, interval: [enter, exit] } => {
                self.interval("enter", words.node(node), enter, exit)
            }
            Event::Cuts { order, inside } => self.cuts(order, inside),
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
            Event::Grid { cell, next } => {
                let values = distinct(&next);
                let planes = words.list((0..D).map(|e| equation(&t(e, "max"), &values[e])));
                let cell = tuple(cell.map(|c| c.to_string()));
                words.say("grid", &[("cell", cell), ("planes", planes)])
            }
            Event::Cross { next, axes, cell } => {
                let key = if axes.count() == 1 { "cross-one" } else { "cross-many" };
                let cell = tuple(cell.map(|c| c.to_string().replace('-', "−")));
                let planes = chain(next, "max", axes);
                words.say(key, &[("axes", words.axes(axes)), ("cell", cell), ("planes", planes)])
            }
            Event::Father { node, son, direction, common, .. } => {
                let mut arguments = vec![
                    ("son", strong(&son.0.to_string())),
                    ("direction", signs(direction)),
                    ("node", words.node(node)),
                ];
                if common == [0; D] {
                    return words.say("father-holds", &arguments);
                }
                let key = if common == direction { "father-all" } else { "father-part" };
                arguments.push(("common", signs(common)));
                words.say(key, &arguments)
            }
            Event::Mirror { son, mirrored, node } => words.say(
                "mirror",
                &[
                    ("son", son.0.to_string()),
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
                words.say("rope", &arguments)
            }
            Event::Push { from, to, axis } => {
                let axis = on_axis(usize::from(axis), AXIS_NAMES[usize::from(axis)]);
                words.say("push", &[("from", point(from)), ("to", point(to)), ("axis", axis)])
            }
            Event::Begin { node } => {
                let is_root = node == words.tree.root().id;
                let key = if is_root { "begin-root" } else { "begin-node" };
                words.say(key, &[("node", words.node(node))])
            }
            Event::Encode { point: at, code } => {
                words.say("encode", &[("point", point(at)), ("codes", words.binary(code))])
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
            Event::Follow { level, child, node, .. } => {
                let bits = words.list((0..D).map(|e| {
                    let value = strong(if child.is_upper(e) { "1" } else { "0" });
                    let axis = on_axis(e, AXIS_NAMES[e]);
                    words.say("bit-of", &[("value", value), ("axis", axis)])
                }));
                words.say(
                    "follow",
                    &[
                        ("bit", (level - 1).to_string()),
                        ("bits", bits),
                        ("child", strong(&child.0.to_string())),
                        ("node", words.node(node)),
                    ],
                )
            }
            Event::Exits { planes, exits, axes } => {
                let planes = words.list(axes.iter().map(|e| {
                    let name = on_axis(e, AXIS_NAMES[e]);
                    equation(&name, &typographic(planes[e]))
                }));
                let key = if axes.count() == 1 { "exits-one" } else { "exits-many" };
                words.say(key, &[("planes", planes), ("exits", chain(exits, "1", axes))])
            }
            Event::Target { from, to, axes, .. } => words.say(
                "target",
                &[
                    ("axes", words.axes(axes)),
                    ("to", tuple(to.map(|c| c.to_string().replace('-', "−")))),
                    ("from", tuple(from.map(|c| c.to_string()))),
                ],
            ),
            Event::Border { outside } if outside.is_empty() => words.texts.get("border-inside"),
            Event::Border { outside } => {
                words.say("border-outside", &[("axes", words.axes(outside))])
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
                words.say(key, &[("axes", words.axes(axes)), ("exits", chain(exits, "1", axes))])
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
            Event::End(End::Missed) => words.texts.get("end-missed"),
            Event::End(End::LeftRoot) => {
                let n = self.before.leaves.len() as u64;
                words.texts.format("end-left-root", &[("n", n.into())])
            }
            Event::End(End::FirstFull) => words.texts.get("end-first-full"),
            Event::End(End::SegmentEnd) => {
                let n = self.before.leaves.len() as u64;
                words.texts.format("end-segment", &[("n", n.into())])
            }
            Event::End(End::Looped) => words.texts.get("end-looped"),
            Event::End(End::Cut) => {
                let n = self.before.step as u64;
                words.texts.format("end-cut", &[("n", n.into())])
            }
            Event::End(End::Found) => {
                // A search that ends so has found a node before.
                let node = self.before.found.unwrap_or(words.tree.root().id);
                self.found("end-found", node)
            }
            Event::End(End::Outside) => {
                match self.before.target.and_then(|target| target.outside) {
                    Some(axes) => words.say("end-outside-axes", &[("axes", words.axes(axes))]),
                    None => words.texts.get("end-outside"),
                }
            }
        }
    }

    /// The sentence of `key` about a node that is found.
    fn found(&self, key: &str, node: NodeId) -> String {
        let is_leaf = self.words.tree.node(node).is_leaf();
        let key = format!("{key}-{}", if is_leaf { "leaf" } else { "node" });
        self.words.say(&key, &[("node", self.words.node(node))])
    }

    fn mask(&self) -> Axes<D> {
        self.before.clip.map_or(Axes::NONE, |clip| clip.mirror)
    }

    fn interval(&self, key: &str, node: String, enter: f64, exit: f64) -> String {
        let values = distinct(&[enter, exit]);
        let [enter, exit] = [strong(&values[0]), strong(&values[1])];
        self.words.say(key, &[("node", node), ("enter", enter), ("exit", exit)])
    }

    fn clip(
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
            if exit <= 0.0 {
                return words.say("clip-behind", &arguments);
            }
            if enter < exit {
                return words.say("clip-short", &arguments);
            }
            arguments.push(("relation", relation(exit, enter).to_owned()));
            return words.say("clip-miss", &arguments);
        }
        let key = if enter <= 0.0 { "clip-inside" } else { "clip-hit" };
        let mut text = words.say(key, &arguments);
        if !mirror.is_empty() {
            let mask = strong(&mirror.0.to_string());
            text += &words.say("clip-mirror", &[("axes", words.axes(mirror)), ("mask", mask)]);
        }
        text
    }

    fn cuts(&self, order: [u8; D], inside: Axes<D>) -> String {
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

    fn classify(&self, at: f64, child: Child<D>) -> String {
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

    fn split(
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
        let key = match halves {
            Halves::Near => "split-near",
            Halves::Far => "split-far",
            Halves::Both => "split-both",
        };
        words.say(
            key,
            &[
                ("at", equation(&t(axis, "m"), &values[0])),
                ("enter", strong(&values[1])),
                ("exit", strong(&values[2])),
                ("axis", on_axis(axis, AXIS_NAMES[axis])),
                ("half", words.texts.get(if is_upper { "upper-half" } else { "lower-half" })),
            ],
        )
    }

    fn first(
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
            format!("{left} {} {right}", relation(mid[e], entry))
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

    fn step(
        &self,
        state: Child<D>,
        exits: [f64; D],
        axes: Axes<D>,
        next: Option<Child<D>>,
    ) -> String {
        let words = self.words;
        let name = if self.mask().is_empty() { "child" } else { "state" };
        let child = words.say(name, &[("state", state.0.to_string())]);
        let mut arguments =
            vec![("child", child), ("axes", words.axes(axes)), ("exits", chain(exits, "1", axes))];
        let one = axes.count() == 1;
        if let Some(next) = next {
            arguments.push(("next", strong(&next.0.to_string())));
            return words.say(if one { "step-one" } else { "step-many" }, &arguments);
        }
        arguments.push(("done", words.axes(Axes(axes.0 & state.0))));
        words.say(if one { "step-end-one" } else { "step-end-many" }, &arguments)
    }
}
