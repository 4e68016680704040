//! The parametric traversals with rules as "Ray Tracing mit Octrees" prints them.
//!
//! The walk is that of `parametric` or `parametric_table`; where the options
//! name a misprint, its rule stands in place of the right one. The ray itself
//! is mirrored, as in the paper, and all is in doubles, where 0/0 and −∞ + ∞ are
//! no number. Every node is visited once at most, whatever is misprinted: a
//! state only ever gains bits.

use super::algorithm::Options;
use super::clip::{earliest, latest};
use super::misprinted_rules::{Plane, Rules, first_child, mirrored_origin, selection};
use super::parametric_table::{entry_axes, exit_axis, transition};
use super::report::{Report, finish, missed};
use super::variant::Variant;
use crate::event::{Event, Observer, Outcome};
use crate::geometry::{Axes, Parameter, Ray};
use crate::tree::{Child, Code, Node, Tree};
use std::ops::ControlFlow;

/// The algorithm that has the misprints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Base {
    /// By one rule instead of tables.
    Uniform,
    /// By Tables 1 to 3.
    Tables,
}

/// Leaves of `tree` that the misprinted rules find along `ray`.
pub fn traverse<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    base: Base,
    observe: &mut impl Observer<D>,
) -> Outcome {
    // Mirror the ray about the root, so that no component is negative.
    let domain = tree.domain();
    let rules = Rules(options.variants);
    let mirror = Axes::where_true(ray.direction().map(|d| d < 0.0));
    let origin = mirrored_origin(domain, ray, options.variants);
    let direction = ray.direction().map(f64::abs);

    // Clip: the six (four) parameters of the root.
    let at =
        |e, index, plane| rules.parameter(domain.plane(e, index), origin[e], direction[e], plane);
    let near = std::array::from_fn(|e| at(e, 0, Plane::Near));
    let far = std::array::from_fn(|e| at(e, domain.grid_size(), Plane::Far));
    let [enter, exit] = rules.interval(near, far);
    let in_time = |end: f64| enter.max(0.0) < end;
    let hit = rules.is_crossed(enter, exit) && options.end().is_none_or(in_time);
    observe.observe(Event::Clip { near, far, enter, exit, hit, mirror });
    if !hit {
        return missed(observe);
    }

    let report = Report::of(options);
    let mut walk = Walk { tree, origin, direction, mirror, rules, base, report, observe };
    let root = tree.root();
    walk.observe.observe(Event::Visit { node: root.id, state: None, near, far });
    let root = Place { node: root, level: domain.root_level(), code: [0; D], near, far };
    let walked = walk.visit(root);
    finish(walked, observe)
}

/// What stays the same during a traversal.
struct Walk<'a, const D: usize, O> {
    tree: &'a Tree<D>,
    origin: [f64; D],
    direction: [f64; D],
    mirror: Axes<D>,
    rules: Rules,
    base: Base,
    report: Report<f64>,
    observe: &'a mut O,
}

/// A node on the way, with its code in the mirrored tree.
#[derive(Clone, Copy)]
struct Place<const D: usize> {
    node: Node,
    level: u8,
    code: Code<D>,
    near: [f64; D],
    far: [f64; D],
}

impl<const D: usize, O: Observer<D>> Walk<'_, D, O> {
    /// Reports the leaves below a node. Breaks where the traversal stops.
    fn visit(&mut self, place: Place<D>) -> ControlFlow<Outcome> {
        if self.is_behind(&place) {
            return ControlFlow::Continue(());
        }
        if place.node.is_leaf() {
            return self.leaf(&place);
        }

        // Halve: the parameters of the mid planes.
        let half = 1 << (place.level - 1);
        let mid = std::array::from_fn(|e| {
            let plane = self.tree.domain().plane(e, place.code[e] + half);
            let (origin, direction) = (self.origin[e], self.direction[e]);
            self.rules.mid(plane, origin, direction, [place.near[e], place.far[e]])
        });
        let divided = self.rules.divided(self.direction);
        self.observe.observe(Event::Halve { mid, divided });

        if D == 2 && self.rules.has(Variant::B3) {
            self.selected(&place, mid)
        } else {
            self.by_automaton(&place, mid)
        }
    }

    /// Skip: whether the node is left before t = 0, if that is asked at all.
    fn is_behind(&mut self, place: &Place<D>) -> bool {
        let exit = earliest(place.far);
        if self.rules.has(Variant::B10) {
            return false;
        }
        match self.base {
            Base::Uniform => exit <= 0.0 && !self.rules.has(Variant::B11),
            Base::Tables => {
                let behind = exit < 0.0;
                self.observe.observe(Event::Skip { exit, behind });
                behind
            }
        }
    }

    /// Leaf: report it and return.
    fn leaf(&mut self, place: &Place<D>) -> ControlFlow<Outcome> {
        let [enter, exit] = self.rules.interval_of_leaf(place.near, place.far);
        let counts = (D == 2 && self.rules.has(Variant::B3))
            || (self.rules.has(Variant::B11) && enter <= exit);
        if counts {
            self.report.crossed(place.node, enter, exit, self.observe)
        } else {
            self.report.leaf(place.node, enter, exit, self.observe)
        }
    }

    /// Children by the automaton.
    fn by_automaton(&mut self, place: &Place<D>, mid: [f64; D]) -> ControlFlow<Outcome> {
        // Enter: the first child, from the near plane that is reached last.
        let last = latest(place.near);
        let clamped = self.base == Base::Uniform
            && !self.rules.has(Variant::B9)
            && !self.rules.has(Variant::B10);
        let entry = if clamped { last.max(0.0) } else { last };
        let (axis, compared) = match self.base {
            Base::Uniform if clamped => (entry_axis(place.near), Axes::where_true([true; D])),
            Base::Uniform => (Some(f64::index_of_latest(place.near)), Axes::where_true([true; D])),
            Base::Tables => {
                let axis = (0..D).find(|&e| place.near[e] >= last).unwrap_or(0);
                (Some(axis), entry_axes(axis))
            }
        };
        let strict = self.base == Base::Tables || self.rules.has(Variant::OneByOne);
        let passed = |t: f64| if strict { t < entry } else { t <= entry };
        let upper = std::array::from_fn(|e| compared.contains(e) && passed(mid[e]));
        let mut state = first_child(upper, self.rules);
        let entry_axis = axis;
        self.observe.observe(Event::First { entry, entry_axis, compared, state });

        loop {
            let exits = self.child(place, mid, state)?;

            // Step: through the far plane, or all of them, that is reached first.
            let (axes, next) = match self.base {
                Base::Tables => {
                    let axis = exit_axis(exits);
                    (Axes::one(axis), transition(state, axis))
                }
                Base::Uniform => {
                    let axes = self.first_exits(exits);
                    let goes_on = !axes.is_empty() && state.0 & axes.0 == 0;
                    (axes, goes_on.then_some(Child(state.0 | axes.0)))
                }
            };
            self.observe.observe(Event::Step { state, exits, axes, next });
            let Some(next) = next else {
                return ControlFlow::Continue(());
            };
            state = next;
        }
    }

    /// Children by the selection of the plane, as printed.
    fn selected(&mut self, place: &Place<D>, mid: [f64; D]) -> ControlFlow<Outcome> {
        let states = selection::<D>(place.near, mid, place.far);
        let Some(&state) = states.first() else {
            return ControlFlow::Continue(());
        };
        let (entry, entry_axis) = (latest(place.near), entry_axis(place.near));
        let compared = Axes::where_true([true; D]);
        self.observe.observe(Event::First { entry, entry_axis, compared, state });
        for &state in &states {
            self.child(place, mid, state)?;
        }
        ControlFlow::Continue(())
    }

    /// Visits the child of `state`, in the tree's own numbering; returns the
    /// parameters of its far planes.
    fn child(
        &mut self,
        place: &Place<D>,
        mid: [f64; D],
        state: Child<D>,
    ) -> ControlFlow<Outcome, [f64; D]> {
        let half = 1 << (place.level - 1);
        let [halves, child] =
            [Axes::NONE, self.mirror].map(|mask| self.rules.0.child_of_state(state, mask));
        let [near, far] = halves.slabs(&[place.near, mid, place.far]);
        // Where it is a wrong child, it has its own mid planes nevertheless.
        let code = child.mirrored(self.mirror).code_in(place.code, half);
        let node = self.tree.child(place.node, child);
        self.observe.observe(Event::Visit { node: node.id, state: Some(state), near, far });
        self.visit(Place { node, level: place.level - 1, code, near, far })?;
        self.observe.observe(Event::Up { node: Some(place.node.id) });
        ControlFlow::Continue(far)
    }

    /// Axes of the far planes that are reached first.
    fn first_exits(&self, exits: [f64; D]) -> Axes<D> {
        let first = earliest(exits);
        let axes = Axes::where_true(exits.map(|t| t <= first));
        if self.rules.has(Variant::OneByOne) { axes.first() } else { axes }
    }
}

/// Axis of the near plane that is reached last, the first of equal ones; `None`
/// if the origin is past them all. What is no number, as only misprints bring it,
/// comes neither before nor after any other.
fn entry_axis<const D: usize>(near: [f64; D]) -> Option<usize> {
    let last = latest(near);
    if last <= 0.0 {
        return None;
    }
    near.into_iter().position(|t| last.not_after(t))
}
