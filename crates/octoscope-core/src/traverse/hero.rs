//! HERO: children in the order of penetration, by a mask and sorted mid planes
//! [Agate, Grimsdale, Lister 1991].
//!
//! A mask holds the signs of the direction. Where the ray enters a node, the mask
//! and the mid planes that are passed already give the first child; every later
//! mid plane that lies in the node's interval flips the bit of its axis. So only
//! the children on the ray are ever looked at, in order. O(visited nodes), D
//! divisions and at most D(D−1)/2 comparisons for sorting in each.
//!
//! The method was meant for hardware, whose details are not known; this is its
//! rule in doubles. Two things are settled here: mid planes at the same parameter
//! flip together, so that no cell is merely touched; and without motion along an
//! axis the side of the origin decides.

use super::algorithm::Options;
use super::clip::{Clip, at_planes, clip_root, halved, middle};
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
    // Mask: the signs of the direction, and the interval of the root.
    let Some(Clip { enter, exit, mirror: mask, .. }) =
        clip_root::<D, P>(tree.domain(), ray, options, observe)
    else {
        return missed(observe);
    };
    let mut walk = Walk { tree, ray, mask, report: Report::of(options), observe };
    let walked = walk.visit(tree.root(), tree.domain().root_level(), [0; D], enter, exit);
    finish(walked, observe)
}

/// What stays the same during a traversal.
struct Walk<'a, const D: usize, P, O> {
    tree: &'a Tree<D>,
    ray: &'a Ray<D>,
    mask: Axes<D>,
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
        // Mid planes.
        let half = 1 << (level - 1);
        let mid = at_planes::<D, P>(self.tree.domain(), self.ray, middle(code, half));
        self.observe.observe(halved(self.ray, mid));

        // First child: the mask, with the bits flipped whose planes are passed.
        let passed = P::passed(mid, enter);
        let mut child = Child::in_upper_halves(passed).mirrored(self.mask);
        self.observe.observe(Event::Classify { at: enter.value(), piece: None, child });

        // Sort: the planes that are still to be met, in their order.
        let (order, sorting) = sorted(mid);
        let inside = Axes::of(|e| !passed.contains(e) & mid[e].before(exit));
        let ranging = (D - passed.count()) as u8;
        let axes = order.map(|axis| axis as u8);
        self.observe.observe(Event::Cuts { order: axes, inside, sorting, ranging });

        let mut from = enter;
        let mut ahead = order.into_iter().filter(|&axis| inside.contains(axis)).peekable();
        loop {
            // Visit the child up to the next plane.
            let next = ahead.peek().map(|&axis| mid[axis]);
            let child_node = self.tree.child(node, child);
            let child_code = child.code_in(code, half);
            self.visit(child_node, level - 1, child_code, from, next.unwrap_or(exit))?;
            self.observe.observe(Event::Up { node: Some(node.id) });

            // Flip: the bits of all planes that are met there.
            let (Some(at), Some(axis)) = (next, ahead.next()) else {
                return ControlFlow::Continue(());
            };
            let mut axes = Axes::<D>::one(axis);
            while let Some(axis) = ahead.next_if(|&axis| mid[axis].not_after(at)) {
                axes = Axes(axes.0 | Axes::<D>::one(axis).0);
            }
            child = child.mirrored(axes);
            self.observe.observe(Event::Flip { at: at.value(), axes, child });
            from = at;
        }
    }
}

/// The axes in the order of these parameters, by insertion; equal ones in the
/// order of the axes. With the number of comparisons that it took.
#[inline]
pub fn sorted<const D: usize, P: Parameter>(parameters: [P; D]) -> ([usize; D], u8) {
    let mut order = std::array::from_fn(|axis| axis);
    let mut n_comparisons = 0;
    for end in 1..D {
        let mut place = end;
        while place > 0 {
            n_comparisons += 1;
            if !parameters[order[place]].before(parameters[order[place - 1]]) {
                break;
            }
            order.swap(place, place - 1);
            place -= 1;
        }
    }
    (order, n_comparisons)
}

#[cfg(test)]
mod tests {
    use super::sorted;

    #[test]
    fn axes_are_sorted_by_their_parameters() {
        assert_eq!(sorted([3.0, 1.0, 2.0]), ([1, 2, 0], 3));
        assert_eq!(sorted([1.0, 2.0, 3.0]), ([0, 1, 2], 2));
        assert_eq!(sorted([1.0, f64::NEG_INFINITY, 1.0]).0, [1, 0, 2]);
    }
}
