//! The plain recursion: every child of every node on the ray is tested.
//!
//! A child is on the ray if the latest of its near planes comes before the
//! earliest of its far planes. O(visited nodes), but 2^D box tests a node with
//! 2D divisions each: the baseline for whatever finds only the children on the
//! ray.
//!
//! The children are tested in the order of their mirrored index. Those on a ray
//! form a chain in which bits are only ever set, so that this is the order in
//! which the ray meets them.

use super::algorithm::Options;
use super::clip::{Clip, clip_root, earliest, latest, slabs};
use super::report::{Report, finish, missed};
use crate::event::{Event, Observer, Outcome};
use crate::geometry::{Axes, Parameter, Ray};
use crate::tree::{Child, Code, Node, Tree};
use std::ops::ControlFlow;

/// Leaves of `tree` along `ray`, in order.
pub fn traverse<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Outcome {
    // Clip: is the root on the ray?
    let Some(Clip { near, far, mirror, .. }) =
        clip_root::<D, P>(tree.domain(), ray, options, observe)
    else {
        return missed(observe);
    };
    let mut walk = Walk { tree, ray, mirror, report: Report::of(options), observe };
    let walked = walk.visit(tree.root(), None, tree.domain().root_level(), [0; D], near, far);
    finish(walked, observe)
}

/// What stays the same during a traversal.
struct Walk<'a, const D: usize, P, O> {
    tree: &'a Tree<D>,
    ray: &'a Ray<D>,
    mirror: Axes<D>,
    report: Report<P>,
    observe: &'a mut O,
}

impl<const D: usize, P: Parameter, O: Observer<D>> Walk<'_, D, P, O> {
    /// Reports the leaves below `node`, which is on the ray. Breaks where the
    /// traversal stops.
    fn visit(
        &mut self,
        node: Node,
        state: Option<Child<D>>,
        level: u8,
        code: Code<D>,
        near: [P; D],
        far: [P; D],
    ) -> ControlFlow<Outcome> {
        self.observe.observe(Event::Visit {
            node: node.id,
            state,
            near: near.map(P::value),
            far: far.map(P::value),
        });
        if node.is_leaf() {
            let entry = latest(near).later(P::ORIGIN);
            return self.report.leaf(node, entry, earliest(far), self.observe);
        }

        let half = 1 << (level - 1);
        for state in Child::all() {
            // Test: both planes of every axis, as if nothing were known of them.
            let child = state.mirrored(self.mirror);
            let child_node = self.tree.child(node, child);
            let child_code = child.code_in(code, half);
            let domain = self.tree.domain();
            let (near, far) = slabs::<D, P>(domain, self.ray, level - 1, child_code);
            let (enter, exit) = (latest(near).later(P::ORIGIN), earliest(far));
            let crossed = enter.before(exit);
            let touch = !crossed && enter.not_after(exit);
            self.observe.observe(Event::Test {
                node: child_node.id,
                interval: (crossed || touch).then_some([enter.value(), exit.value()]),
                touch,
                divided: Axes::where_true(self.ray.direction().map(|d| d != 0.0)),
            });

            // Visit what is on the ray; what it only touches is not.
            if crossed {
                self.visit(child_node, Some(state), level - 1, child_code, near, far)?;
                self.observe.observe(Event::Up { node: Some(node.id) });
            }
        }
        ControlFlow::Continue(())
    }
}
