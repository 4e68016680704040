//! Parametric traversal by one rule [Revelles 2000, §3; rule after Laine, Karras
//! 2010].
//!
//! A ray is in a node between the latest of its near planes and the earliest of
//! its far planes. Given these parameters for a node, its mid planes tell those
//! of all children, and comparisons alone find the children on the ray, in
//! order: at most D + 1 of them. O(visited nodes), a constant number of
//! comparisons and D divisions for each.
//!
//! Differences from the paper, with reasons:
//! * *One rule instead of tables.* The first child lies in the upper half of
//!   every axis whose mid plane is not after the entry; the next one follows by
//!   flipping *all* axes whose far plane is reached first. So the origin may be
//!   inside (the entry is at least t = 0), and a ray through an edge or a corner
//!   never visits the cells that it merely touches.
//! * *Mid planes from their coordinate*, not as the mean of two parameters: a
//!   plane then has the same t in all cells that share it, and the mean of −∞
//!   and +∞ does not arise.
//! * *The index is mirrored, not the ray*: a root away from 0 needs no care.

use super::algorithm::Options;
use super::clip::{Clip, at_planes, clip_root, earliest, first, halved, middle};
use super::misprint::{self, Base};
use super::report::{Report, finish, missed};
use super::variant::Variant;
use crate::event::{Event, Observer, Outcome};
use crate::geometry::{Axes, Parameter, Ray};
use crate::tree::{Child, Code, Domain, Node, Tree};
use std::ops::ControlFlow;

/// Leaves of `tree` along `ray`, in order.
pub fn traverse<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Outcome {
    if options.variants.iter().any(Variant::is_misprint) {
        return misprint::traverse(tree, ray, options, Base::Uniform, observe);
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
    walk.observe.observe(Event::Visit {
        node: root.id,
        state: None,
        near: near.map(P::value),
        far: far.map(P::value),
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
    #[inline(always)]
    fn visit(
        &mut self,
        node: Node,
        level: u8,
        code: Code<D>,
        near: [P; D],
        far: [P; D],
    ) -> ControlFlow<Outcome> {
        // The node is entered when the latest near plane is, but not before t = 0.
        let entry_axis = entry_axis(near);
        let entry = entry_axis.map_or(P::ORIGIN, |axis| near[axis]);

        // Leaf: report it and return.
        if node.is_leaf() {
            return self.report.leaf(node, entry, earliest(far), self.observe);
        }
        self.visit_inner(node, level, code, [near, far], entry, entry_axis)
    }

    /// The same for an inner node.
    fn visit_inner(
        &mut self,
        node: Node,
        level: u8,
        code: Code<D>,
        [near, far]: [[P; D]; 2],
        entry: P,
        entry_axis: Option<usize>,
    ) -> ControlFlow<Outcome> {
        // Halve: the parameters of the mid planes.
        let half = 1 << (level - 1);
        let middle = middle(code, half);
        let (mid, event) = halve(self.tree.domain(), self.ray, self.options, [near, far], middle);
        self.observe.observe(event);

        // Enter: the first child is past every mid plane that is not after the entry.
        let one_by_one = self.options.variants.has(Variant::OneByOne);
        let mut state = if one_by_one {
            Child::in_upper_half_where(|e| mid[e].before(entry))
        } else {
            Child::in_upper_halves(P::passed(mid, entry))
        };
        self.observe.observe(Event::First {
            entry: entry.value(),
            entry_axis,
            compared: Axes::where_true([true; D]),
            state,
        });

        let planes = [near, mid, far];
        let children = self.tree.siblings(node);
        loop {
            // Visit the child, in the tree's own numbering.
            let [near_of_child, far_of_child] = state.slabs(&planes);
            let child = state.mirrored(self.mirror);
            let child_node = children.node(child);
            let child_code = child.code_in(code, half);
            self.observe.observe(Event::Visit {
                node: child_node.id,
                state: Some(state),
                near: near_of_child.map(P::value),
                far: far_of_child.map(P::value),
            });
            self.visit(child_node, level - 1, child_code, near_of_child, far_of_child)?;
            self.observe.observe(Event::Up { node: Some(node.id) });

            // Step: through all planes that are reached first at once.
            let (_, mut axes) = first(far_of_child);
            if one_by_one {
                axes = axes.first();
            }
            let next = (state.0 & axes.0 == 0).then_some(Child(state.0 | axes.0));
            self.observe.observe(Event::Step {
                state,
                exits: far_of_child.map(P::value),
                axes,
                next,
            });

            // Leave: beyond an upper half there is no other child.
            let Some(next) = next else {
                return ControlFlow::Continue(());
            };
            state = next;
        }
    }
}

/// Parameters of the mid planes at grid indices `planes`, with the step of finding
/// them: each from its coordinate, or as a mean of `near` and `far`.
#[inline(always)]
pub(super) fn halve<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    options: Options,
    [near, far]: [[P; D]; 2],
    planes: [u32; D],
) -> ([P; D], Event<D>) {
    if options.variants.has(Variant::Averaged) {
        return averaged(domain, ray, near, planes, far);
    }
    let mid = at_planes::<D, P>(domain, ray, planes);
    (mid, halved(ray, mid))
}

/// Parameters of the mid planes as the mean of those of the near and far planes
/// [Revelles 2000, eq. 13], along axes without motion from their coordinate
/// (eq. 15); with the step of finding them. No division in doubles.
#[inline]
fn averaged<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    near: [P; D],
    planes: [u32; D],
    far: [P; D],
) -> ([P; D], Event<D>) {
    let (origin, direction) = (ray.origin(), ray.direction());
    let mid: [P; D] = std::array::from_fn(|e| {
        let plane = domain.plane(e, planes[e]);
        if direction[e] != 0.0 {
            P::mean(near[e], far[e], || P::at_plane(plane, origin[e], direction[e]))
        } else if origin[e] < plane {
            P::BEYOND_ALL
        } else {
            P::BEFORE_ALL
        }
    });
    (mid, Event::Halve { mid: mid.map(P::value), divided: Axes::NONE })
}

/// Axis of the near plane that is reached last, the first of equal ones; `None`
/// if the origin is past them all.
#[inline(always)]
fn entry_axis<const D: usize, P: Parameter>(near: [P; D]) -> Option<usize> {
    let axis = P::index_of_latest(near);
    P::ORIGIN.before(near[axis]).then_some(axis)
}
