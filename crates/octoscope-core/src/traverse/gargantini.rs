//! Top-down by sorted cuts, whose pieces are classified [Gargantini, Atkinson
//! 1993].
//!
//! The mid planes cut the node's interval into at most D + 1 pieces; where the
//! middle of a piece lies relative to the mid planes tells in which child the
//! piece is. No neighbours are looked for. O(visited nodes), D divisions in each,
//! and D comparisons for each child on top of sorting.
//!
//! Unlike HERO, which flips bits, order and classification are independent of
//! each other and could contradict each other in doubles where cuts lie close
//! together. So equal cuts are merged, and a piece is classified by its middle,
//! by the parameters of the planes and not by the coordinates of a rounded point.
//! Where comparisons are exact, no middle is formed: as no plane is met within the
//! piece, those passed in its middle are those not after its beginning.

use super::algorithm::Options;
use super::clip::{Clip, at_planes, clip_root, halved, middle};
use super::hero::sorted;
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
    let Some(Clip { enter, exit, mirror, .. }) =
        clip_root::<D, P>(tree.domain(), ray, options, observe)
    else {
        return missed(observe);
    };
    let mut walk = Walk { tree, ray, mirror, report: Report::of(options), observe };
    let walked = walk.visit(tree.root(), tree.domain().root_level(), [0; D], enter, exit);
    finish(walked, observe)
}

/// What stays the same during a traversal.
struct Walk<'a, const D: usize, P, O> {
    tree: &'a Tree<D>,
    ray: &'a Ray<D>,
    /// Axes along which the upper half is met first.
    mirror: Axes<D>,
    report: Report<P>,
    observe: &'a mut O,
}

impl<const D: usize, P: Parameter, O: Observer<D>> Walk<'_, D, P, O> {
    /// Reports the leaves below `node`, in which the ray is from `enter` to
    /// `exit`. Breaks where the traversal stops.
    #[inline(always)]
    fn visit(
        &mut self,
        node: Node,
        level: u8,
        code: Code<D>,
        enter: P,
        exit: P,
    ) -> ControlFlow<Outcome> {
        let interval = [enter.value(), exit.value()];
        self.observe.observe(Event::Enter { node: node.id, interval, call: true });
        if node.is_leaf() {
            return self.report.leaf(node, enter, exit, self.observe);
        }
        self.visit_inner(node, level, code, enter, exit)
    }

    /// The same for an inner node.
    fn visit_inner(
        &mut self,
        node: Node,
        level: u8,
        code: Code<D>,
        enter: P,
        exit: P,
    ) -> ControlFlow<Outcome> {
        // Cut: sort the mid planes, leave out those beyond the interval.
        let half = 1 << (level - 1);
        let mid = at_planes::<D, P>(self.tree.domain(), self.ray, middle(code, half));
        self.observe.observe(halved(self.ray, mid));
        let (order, sorting) = sorted(mid);
        let ahead = Axes::<D>::of(|e| enter.before(mid[e]));
        let inside = Axes::of(|e| ahead.contains(e) & mid[e].before(exit));
        let ranging = D as u8 + ahead.count() as u8;
        let axes = order.map(|axis| axis as u8);
        self.observe.observe(Event::Cuts { order: axes, inside, sorting, ranging });

        let cuts = order.into_iter().filter(|&axis| inside.contains(axis)).map(|axis| mid[axis]);
        let mut from = enter;
        for to in cuts.chain([exit]) {
            // Equal cuts leave no piece between them.
            if !from.before(to) {
                continue;
            }

            // Classify: on which side of the mid planes is the middle of the piece?
            let passed = Child::<D>::in_upper_half_where(|e| P::passed_midway(mid[e], from, to));
            let child = passed.mirrored(self.mirror);
            let ends = [from.value(), to.value()];
            let middle = 0.5 * ends[0] + 0.5 * ends[1];
            self.observe.observe(Event::Classify { at: middle, piece: Some(ends), child });

            // Recurse with the piece.
            let child_node = self.tree.child(node, child);
            let child_code = child.code_in(code, half);
            self.visit(child_node, level - 1, child_code, from, to)?;
            self.observe.observe(Event::Up { node: Some(node.id) });
            from = to;
        }
        ControlFlow::Continue(())
    }
}
