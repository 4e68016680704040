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
use super::beyond::within;
use super::clip::{Clip, at_planes, clip_root, earliest, halved};
use super::report::{Report, finish, missed};
use crate::event::{Event, Observer, Outcome, Search};
use crate::geometry::{Axes, Parameter, Ray};
use crate::tree::{Child, Code, MAX_ROOT_LEVEL, Node, Tree, branch, common_level};
use std::ops::ControlFlow;

/// What is kept of an inner node while the ray is below it.
#[derive(Clone, Copy)]
struct Level<const D: usize, P> {
    node: Node,
    code: Code<D>,
    mid: [P; D],
    far: [P; D],
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
    let start = Level { node, code, mid: far, far };
    let mut stack = [start; MAX_ROOT_LEVEL as usize + 1];
    observe.observe(entered(node, entry, far));

    loop {
        // Down: into the half of every axis in which the ray is.
        while !node.is_leaf() {
            let half = 1 << (level - 1);
            let mid = at_planes::<D, P>(domain, ray, code.map(|c| c + half));
            observe.observe(halved(ray, mid));
            stack[usize::from(level)] = Level { node, code, mid, far };
            let passed = Child::<D>::from_upper_halves(mid.map(|t| t.not_after(entry)));
            let child = passed.mirrored(mirror);
            observe.observe(Event::Classify { at: entry.value(), piece: None, child });
            (node, code, far) = below(tree, &stack[usize::from(level)], level, child, mirror);
            level -= 1;
            observe.observe(entered(node, entry, far));
        }

        // Leave: through the planes that are met first.
        let exit = earliest(far);
        let reported = report.leaf(node, entry, exit, observe);
        if reported.is_break() {
            return finish(reported, observe);
        }
        let axes = Axes::where_true(far.map(|t| t.not_after(exit)));
        observe.observe(Event::Leave { exits: far.map(P::value), axes });

        // New code: beyond these planes; outside the domain the walk ends.
        let target: [i64; D] = std::array::from_fn(|e| {
            let low = i64::from(code[e]);
            match (axes.contains(e), mirror.contains(e)) {
                (false, _) => low,
                (true, false) => low + (1 << level),
                (true, true) => low - 1,
            }
        });
        let target = (target, Search::NONE);
        let Some(next) = within(domain, level, code, axes, target, observe) else {
            return finish(ControlFlow::Continue(()), observe);
        };

        // Resume: at the ancestor whose level is that of the highest new bit.
        let xor = std::array::from_fn(|e| code[e] ^ next[e]);
        let popped = common_level(code, next) - level;
        level += popped;
        observe.observe(Event::Difference { from: code, to: next, xor, level });
        let ancestor = &stack[usize::from(level)];
        observe.observe(Event::Resume { node: ancestor.node.id, level, popped });
        entry = exit;
        (node, code, far) = below(tree, ancestor, level, branch(next, level), mirror);
        level -= 1;
        observe.observe(entered(node, entry, far));
    }
}

/// A child with its code and the parameters of its far planes.
#[inline]
fn below<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    parent: &Level<D, P>,
    level: u8,
    child: Child<D>,
    mirror: Axes<D>,
) -> (Node, Code<D>, [P; D]) {
    let state = child.mirrored(mirror);
    let half = 1 << (level - 1);
    let code = child.code_in(parent.code, half);
    let far = state.pick(parent.mid, parent.far);
    (tree.child(parent.node, child), code, far)
}

fn entered<const D: usize, P: Parameter>(node: Node, entry: P, far: [P; D]) -> Event<D> {
    let interval = [entry.value(), earliest(far).value()];
    Event::Enter { node: node.id, interval, call: false }
}
