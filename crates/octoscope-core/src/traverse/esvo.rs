//! Parametric traversal without recursion [Laine, Karras 2010]: the uniform rule
//! downwards, the common ancestor upwards.
//!
//! Where the ray is, is kept as a location code. Down from a node, every mid plane
//! that is passed selects an upper half, as in the parametric traversal. Where a
//! leaf is left, the code changes along the crossed axes, and the highest bit that
//! changes is the level to go back to [Frisken, Perry 2002, §5], however far up,
//! in one step. O(visited nodes), D divisions in each, one small stack.
//!
//! Difference from the source: planes are numbered from their coordinates in
//! doubles, not in the fixed range [1, 2) of single floats, so that all planes that
//! are met at once are crossed at once.

use super::algorithm::Options;
use super::clip::{Clip, at_planes, clip_root, earliest, first, halved, middle};
use super::report::{Report, finish, missed};
use crate::event::{Event, Observer, Outcome, Search};
use crate::geometry::{Axes, Parameter, Ray, either, per_axis};
use crate::tree::{Child, Code, MAX_ROOT_LEVEL, Node, Tree, branch, common_level};
use std::ops::ControlFlow;

/// What is kept of an inner node while the ray is below it. Its code is that of
/// whatever is below it, without the low bits.
#[derive(Clone, Copy)]
struct Level<const D: usize, P> {
    node: Node,
    /// Parameters at which the ray leaves the lower and the upper half along each axis.
    halves: [[P; D]; 2],
}

/// Leaves of `tree` along `ray`, in order.
pub fn traverse<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Outcome {
    // Clip: where the ray is in the root.
    let domain = tree.domain();
    let Some(Clip { enter: mut entry, mut far, mirror, .. }) =
        clip_root::<D, P>(domain, ray, options, observe)
    else {
        return missed(observe);
    };
    let report = Report::of(options);
    let mut node = tree.root();
    let mut level = domain.root_level();
    let mut code: Code<D> = [0; D];
    let mut stack = [Level { node, halves: [far; 2] }; MAX_ROOT_LEVEL as usize + 1];
    enter(node, entry, far, observe);

    loop {
        // Down: into the half of every axis in which the ray is.
        while !node.is_leaf() {
            let half = 1 << (level - 1);
            let mid = at_planes::<D, P>(domain, ray, middle(code, half));
            observe.observe(halved(ray, mid));
            let halves = [mid, far];
            stack[usize::from(level)] = Level { node, halves };
            let state = Child::in_upper_halves(P::passed(mid, entry));
            let child = state.mirrored(mirror);
            observe.observe(Event::Classify { at: entry.value(), piece: None, child });
            node = tree.child(node, child);
            code = child.code_in(code, half);
            far = state.pick(&halves);
            level -= 1;
            enter(node, entry, far, observe);
        }

        // Leave: through the planes that are met first.
        let (exit, axes) = first(far);
        let reported = report.leaf(node, entry, exit, observe);
        if reported.is_break() {
            return finish(reported, observe);
        }
        observe.observe(Event::Leave { exits: far.map(P::value), axes });

        // New code: beyond these planes; outside the domain the walk ends. Below 0
        // is outside as well: −1 is the largest number of 32 bits.
        let next: Code<D> = per_axis(|e| {
            let step = either(mirror.contains(e), u32::MAX, 1 << level);
            code[e].wrapping_add(either(axes.contains(e), step, 0))
        });
        let (from, to) = (code, signed(next));
        observe.observe(Event::Target { level, from, to, axes, search: Search::NONE });
        let outside = Axes::<D>::of(|e| next[e] >= domain.grid_size());
        observe.observe(Event::Border { tested: axes, outside });
        if !outside.is_empty() {
            return finish(ControlFlow::Continue(()), observe);
        }

        // Resume: at the ancestor whose level is that of the highest new bit.
        let common = common_level(code, next);
        let xor = per_axis(|e| code[e] ^ next[e]);
        observe.observe(Event::Difference { from: code, to: next, xor, level: common });
        let ancestor = &stack[usize::from(common)];
        let popped = common - level;
        observe.observe(Event::Resume { node: ancestor.node.id, level: common, popped });
        level = common - 1;
        let child = branch(next, common);
        let state = child.mirrored(mirror);
        node = tree.child(ancestor.node, child);
        code = per_axis(|e| next[e] >> level << level);
        far = state.pick(&ancestor.halves);
        entry = exit;
        enter(node, entry, far, observe);
    }
}

/// Codes with −1 instead of the largest number.
#[inline(always)]
fn signed<const D: usize>(code: Code<D>) -> [i64; D] {
    per_axis(|e| i64::from(code[e] as i32))
}

/// Tells that a node is entered; if nobody looks, its exit is not even looked for.
#[inline(always)]
fn enter<const D: usize, P: Parameter, O: Observer<D>>(
    node: Node,
    entry: P,
    far: [P; D],
    observe: &mut O,
) {
    if O::LOOKS {
        let interval = [entry.value(), earliest(far).value()];
        observe.observe(Event::Enter { node: node.id, interval, call: false });
    }
}
