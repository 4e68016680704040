//! Parametric traversal by tables [Revelles 2000, §3], as corrected.
//!
//! As the paper tells it: Table 2 finds the first child from the plane through
//! which the node is entered, Table 3 leads from child to child by the plane
//! through which each is left; in the plane one without a number does. O(visited nodes).
//!
//! Differences from the uniform rule of `parametric`, all of them the paper's:
//! comparisons are strict and cross one plane at a time, so that a ray through
//! an edge or a corner also walks through cells that it only touches; the walk
//! begins at the near planes even if the origin is inside, and nodes behind the
//! origin are skipped.
//!
//! Differences from the paper: Table 2 sets the x bit for x and the z bit for z,
//! as its authors corrected it; mid planes from their coordinate.

use super::algorithm::Options;
use super::clip::{Clip, clip_root, earliest, latest, middle};
use super::misprint::{self, Base};
use super::parametric::halve;
use super::report::{Report, finish, missed};
use super::variant::Variant;
use crate::event::{Event, Observer, Outcome};
use crate::geometry::{Axes, Parameter, Ray};
use crate::tree::{Child, Code, Node, Tree};
use std::ops::ControlFlow;

/// What Table 3 is in the plane: next state of the quadtree automaton when a child is left through
/// its far x or y plane; 4 is the end.
pub const TABLE_IN_PLANE: [[u8; 2]; 4] = [[2, 1], [3, 4], [4, 3], [4, 4]];

/// Table 2, corrected: for entry through the near plane of axis x, y, z, the
/// axes whose mid planes are compared with the entry, in the order of the rows.
pub const TABLE_2: [[usize; 2]; 3] = [[1, 2], [0, 2], [0, 1]];

/// Table 3: next state of the octree automaton when a child is left through its
/// far x (YZ), y (XZ) or z (XY) plane; 8 is the end.
pub const TABLE_3: [[u8; 3]; 8] =
    [[4, 2, 1], [5, 3, 8], [6, 8, 3], [7, 8, 8], [8, 6, 5], [8, 7, 8], [8, 8, 7], [8, 8, 8]];

/// Next state of the automaton that leaves `state` through its far plane of
/// `axis`, by Table 3 or what it is in the plane; `None` at the end.
#[inline]
pub fn transition<const D: usize>(state: Child<D>, axis: usize) -> Option<Child<D>> {
    let next = if D == 2 {
        TABLE_IN_PLANE[usize::from(state.0)][axis]
    } else {
        TABLE_3[usize::from(state.0)][axis]
    };
    (usize::from(next) < Child::<D>::COUNT).then_some(Child(next))
}

/// Axes whose mid planes decide over the first child of a node that is entered
/// through its near plane of `axis`, by Table 2.
#[inline]
pub fn entry_axes<const D: usize>(axis: usize) -> Axes<D> {
    if D == 2 {
        return Axes::one(1 - axis);
    }
    let [a, b] = TABLE_2[axis];
    Axes(Axes::<D>::one(a).0 | Axes::<D>::one(b).0)
}

/// Leaves of `tree` along `ray`, in order, and the touches on the way.
pub fn traverse<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Outcome {
    if options.variants.iter().any(Variant::is_misprint) {
        return misprint::traverse(tree, ray, options, Base::Tables, observe);
    }

    // Clip: the six (four) parameters of the root.
    let Some(Clip { near, far, mirror, .. }) =
        clip_root::<D, P>(tree.domain(), ray, options, observe)
    else {
        return missed(observe);
    };

    let report = Report::of(options);
    let mut walk = Walk { tree, ray, mirror, options, report, observe };
    let root = tree.root();
    let [near_values, far_values] = [near.map(P::value), far.map(P::value)];
    walk.observe.observe(Event::Visit {
        node: root.id,
        state: None,
        near: near_values,
        far: far_values,
    });
    let walked = walk.visit(root, tree.domain().root_level(), [0; D], near, far);
    finish(walked, observe)
}

/// What stays the same during a traversal.
struct Walk<'a, const D: usize, P, O> {
    tree: &'a Tree<D>,
    ray: &'a Ray<D>,
    mirror: Axes<D>,
    options: Options,
    report: Report<P>,
    observe: &'a mut O,
}

impl<const D: usize, P: Parameter, O: Observer<D>> Walk<'_, D, P, O> {
    /// Reports the leaves below `node`, which has this level and code; `near`
    /// and `far` are the parameters of its planes. Breaks where the traversal
    /// stops.
    fn visit(
        &mut self,
        node: Node,
        level: u8,
        code: Code<D>,
        near: [P; D],
        far: [P; D],
    ) -> ControlFlow<Outcome> {
        // Skip: a node that is left before t = 0 lies behind the origin.
        let exit = earliest(far);
        let behind = exit.before(P::ORIGIN);
        self.observe.observe(Event::Skip { exit: exit.value(), behind });
        if behind {
            return ControlFlow::Continue(());
        }

        // Leaf: report it and return.
        if node.is_leaf() {
            let entry = latest(near).later(P::ORIGIN);
            return self.report.leaf(node, entry, exit, self.observe);
        }

        // Halve: the parameters of the mid planes.
        let half = 1 << (level - 1);
        let middle = middle(code, half);
        let (mid, event) = halve(self.tree.domain(), self.ray, self.options, [near, far], middle);
        self.observe.observe(event);

        // Enter: Table 2, from the near plane that is reached last.
        let axis = P::index_of_latest(near);
        let entry = near[axis];
        let compared = entry_axes::<D>(axis);
        let upper = std::array::from_fn(|e| compared.contains(e) && mid[e].before(entry));
        let mut state = Child::from_upper_halves(upper);
        self.observe.observe(Event::First {
            entry: entry.value(),
            entry_axis: Some(axis),
            compared,
            state,
        });

        let planes = [near, mid, far];
        loop {
            // Visit the child, in the tree's own numbering.
            let [near_of_child, far_of_child] = state.slabs(&planes);
            let child = state.mirrored(self.mirror);
            let child_node = self.tree.child(node, child);
            let child_code = child.code_in(code, half);
            self.observe.observe(Event::Visit {
                node: child_node.id,
                state: Some(state),
                near: near_of_child.map(P::value),
                far: far_of_child.map(P::value),
            });
            self.visit(child_node, level - 1, child_code, near_of_child, far_of_child)?;
            self.observe.observe(Event::Up { node: Some(node.id) });

            // Step: Table 3, by the far plane that is reached first.
            let axis = exit_axis(far_of_child);
            let next = transition(state, axis);
            let axes = Axes::one(axis);
            self.observe.observe(Event::Step {
                state,
                exits: far_of_child.map(P::value),
                axes,
                next,
            });

            // Leave: at the end of the automaton.
            let Some(next) = next else {
                return ControlFlow::Continue(());
            };
            state = next;
        }
    }
}

/// Axis of the far plane that is reached first, by the paper's chain of strict
/// comparisons: of equal ones the last axis.
pub(super) fn exit_axis<const D: usize, P: Parameter>(far: [P; D]) -> usize {
    let mut first = 0;
    for e in 1..D {
        if !far[first].before(far[e]) {
            first = e;
        }
    }
    first
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A state whose bit of the axis is 0 gets it; otherwise the walk ends.
    fn rule<const D: usize>(state: Child<D>, axis: usize) -> Option<Child<D>> {
        (!state.is_upper(axis)).then_some(Child(state.0 | Axes::<D>::one(axis).0))
    }

    #[test]
    fn tables_1_and_3_follow_from_one_rule() {
        for axis in 0..2 {
            for state in Child::<2>::all() {
                assert_eq!(transition(state, axis), rule(state, axis));
            }
        }
        for axis in 0..3 {
            for state in Child::<3>::all() {
                assert_eq!(transition(state, axis), rule(state, axis));
            }
        }
    }

    #[test]
    fn table_2_compares_the_axes_other_than_the_entry() {
        for axis in 0..3 {
            assert_eq!(entry_axes::<3>(axis), Axes(0b111 ^ Axes::<3>::one(axis).0));
        }
    }
}
