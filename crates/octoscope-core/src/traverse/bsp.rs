//! Traversal of the binary tree that emulates the octree [Jansen 1985; Sung,
//! Shirley 1992].
//!
//! A node is halved across x, the halves across y, their halves across z: D
//! binary levels for one of the octree. At each the parameter of one plane,
//! compared with the interval in which the ray is in the part, tells whether the
//! ray is in the half on the side of its origin, in the other one, or in both; in
//! the last case the farther half waits on a stack. O(visited binary nodes), each
//! of them entered once [Arvo 1988], one division and up to three comparisons.
//!
//! Differences from the gem, with reasons: the origin may lie on the plane, where
//! the direction decides which half is near; at equal parameters no half is
//! entered in which the ray has no length; without motion along the axis the side
//! of the origin decides. The variant `gem` compares as it was printed.

use super::algorithm::Options;
use super::clip::{Clip, clip_root};
use super::report::{Report, finish, missed};
use super::variant::Variant;
use crate::event::{Event, Halves, Observer, Outcome};
use crate::geometry::{Parameter, Ray};
use crate::tree::{Node, Part, Tree};
use std::ops::ControlFlow;

/// Part of a node, with the parameters between which the ray is in it.
struct Pending<const D: usize, P> {
    node: Node,
    part: Part<D>,
    from: P,
    to: P,
}

/// Leaves of `tree` along `ray`, in order.
pub fn traverse<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Outcome {
    let domain = tree.domain();
    let Some(Clip { enter, exit, .. }) = clip_root::<D, P>(domain, ray, options, observe) else {
        return missed(observe);
    };
    let report = Report::of(options);
    let is_gem = options.variants.has(Variant::Gem);
    let decide = if is_gem { as_in_the_gem } else { halves };
    let root = tree.root();
    let mut stack =
        vec![Pending::<D, P> { node: root, part: Part::whole(root.id), from: enter, to: exit }];

    // Pop: the part that waits on top of the stack.
    while let Some(Pending { mut node, mut part, from, mut to }) = stack.pop() {
        observe.observe(Event::Pop { part, interval: [from.value(), to.value()] });
        let mut level = tree.level(node.id);
        let mut code = tree.code(node.id);

        while !node.is_leaf() {
            // Split: the plane in the middle of the next axis.
            let axis = part.next_axis().expect("a part with all axes halved is a child");
            let half = 1 << (level - 1);
            let plane = domain.plane(axis, code[axis] + half);
            let (origin, direction) = (ray.origin()[axis], ray.direction()[axis]);
            let divided = direction != 0.0 || is_gem;
            let at = if divided {
                P::at_plane(plane, origin, direction)
            } else if plane <= origin {
                P::BEFORE_ALL
            } else {
                P::BEYOND_ALL
            };
            let (halves, near_is_upper) = decide(plane, at, [origin, direction], [from, to]);

            // Near, far, or first the near and later the far half.
            let near = part.half(axis, near_is_upper);
            let far = part.half(axis, !near_is_upper);
            let (taken, kept) = match halves {
                Halves::Near => (near, None),
                Halves::Far => (far, None),
                Halves::Both => (near, Some(far)),
            };
            let child = taken.as_child();
            let (taken_node, taken) = as_node(tree, node, taken);
            let kept = kept.map(|kept| as_node(tree, node, kept));
            observe.observe(Event::Split {
                axis: axis as u8,
                plane,
                at: at.value(),
                divided,
                interval: [from.value(), to.value()],
                halves,
                taken,
                kept: kept.map(|(_, kept)| kept),
            });
            if let Some((node, part)) = kept {
                stack.push(Pending { node, part, from: at, to });
                to = at;
            }
            (node, part) = (taken_node, taken);
            if part.halved.is_empty() {
                code = child.code_in(code, half);
                level -= 1;
            }
        }

        let reported = report.leaf(node, from, to, observe);
        if reported.is_break() {
            return finish(reported, observe);
        }
    }
    finish(ControlFlow::Continue(()), observe)
}

/// The same part with its node: once all axes are halved, a whole child.
fn as_node<const D: usize>(tree: &Tree<D>, node: Node, part: Part<D>) -> (Node, Part<D>) {
    if part.next_axis().is_some() {
        return (node, part);
    }
    let child = tree.child(node, part.as_child());
    (child, Part::whole(child.id))
}

/// Halves that the ray is in between `from` and `to`, and whether the near one
/// is the upper one. `at` is the parameter of the plane.
#[inline]
pub fn halves<P: Parameter>(
    plane: f64,
    at: P,
    [origin, direction]: [f64; 2],
    [from, to]: [P; 2],
) -> (Halves, bool) {
    if direction == 0.0 {
        return (Halves::Near, plane <= origin);
    }
    let near_is_upper = plane < origin || (plane == origin && direction > 0.0);
    // The ray never meets the plane, or only after the part.
    let halves = if at.not_after(P::ORIGIN) || !at.before(to) {
        Halves::Near
    } else if at.not_after(from) {
        Halves::Far
    } else {
        Halves::Both
    };
    (halves, near_is_upper)
}

/// The same as the gem compares, in doubles: an origin on the plane counts as
/// below it whatever the direction, equal parameters are not told apart, and a
/// parameter that is no number passes as in both halves.
fn as_in_the_gem<P: Parameter>(
    plane: f64,
    at: P,
    [origin, _]: [f64; 2],
    [from, to]: [P; 2],
) -> (Halves, bool) {
    let (at, from, to) = (at.value(), from.value(), to.value());
    let halves = if at > to || at < 0.0 {
        Halves::Near
    } else if at < from {
        Halves::Far
    } else {
        Halves::Both
    };
    (halves, plane < origin)
}
