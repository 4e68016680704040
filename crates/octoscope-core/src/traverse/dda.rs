//! Traversal of the finest grid, cell by cell [Amanatides, Woo 1987], and of the
//! tree with it [Fujimoto, Tanaka, Iwata 1986; Sung 1991].
//!
//! Along every axis the parameter of the next grid plane is kept; the smallest of
//! them tells through which side the ray goes on, and only that one changes. D−1
//! comparisons and one step a cell, O(cells on the ray): the size of the leaves
//! makes no difference, so that the cost doubles with every level of depth.
//!
//! Differences from the original, with reasons: planes that are met at once are
//! crossed at once, so that no cell is merely touched (the variant `one-by-one`
//! crosses one); the parameter of a plane is computed from the plane and not by
//! adding up steps, whose rounding adds up as well; the first cell is the one into
//! which the ray moves. A leaf is reported in its first cell, with the parameter of
//! its own far planes, not in its last: whoever looks for the first full one need
//! not cross it.

use super::algorithm::Options;
use super::beyond::{code_of_entry, exit_of};
use super::clip::{Clip, at_planes, clip_root, first};
use super::report::{Report, finish, go_on, missed};
use super::variant::Variant;
use crate::event::{Event, Observer, Outcome};
use crate::geometry::{Parameter, Ray};
use crate::locate::descend;
use crate::tree::{Code, Node, Tree};
use std::ops::ControlFlow;

/// Leaves of `tree` along `ray`, in order, by walking through its finest grid.
///
/// A grid knows what is in its cells; here the tree stands in for that array. The
/// look-ups are not counted as work, but whoever takes the time takes it with them.
pub fn on_grid<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Outcome {
    walk::<D, P, _>(tree, ray, options, observe, |code, _| {
        tree.node_at(0, code).expect("cells of the grid lie in the domain")
    })
}

/// Leaves of `tree` along `ray`, in order: every cell of the finest grid is
/// looked up in the tree, from the root.
pub fn in_tree<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Outcome {
    walk::<D, P, _>(tree, ray, options, observe, |code, observe| {
        let root = tree.root();
        observe.observe(Event::Begin { node: root.id });
        descend(tree, root, tree.domain().root_level(), code, 0, observe).0
    })
}

/// Walks through the grid; `look_up` finds the leaf of a cell.
fn walk<const D: usize, P: Parameter, O: Observer<D>>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut O,
    look_up: impl Fn(Code<D>, &mut O) -> Node,
) -> Outcome {
    let domain = tree.domain();
    let Some(Clip { enter, .. }) = clip_root::<D, P>(domain, ray, options, observe) else {
        return missed(observe);
    };
    let report = Report::of(options);
    let one_by_one = options.variants.has(Variant::OneByOne);
    let rising = ray.direction().map(|d| d >= 0.0);

    // Init: the first cell, and the planes ahead.
    let (mut cell, search) = code_of_entry(domain, ray, enter);
    let mut next = at_planes::<D, P>(domain, ray, planes_ahead(cell, rising));
    // Without motion along an axis no plane is ahead.
    let still = ray.direction().map(|d| d == 0.0);
    next = std::array::from_fn(|e| if still[e] { P::BEYOND_ALL } else { next[e] });
    observe.observe(Event::Grid { cell, next: next.map(P::value), search });
    let mut leaf = look_up(cell, observe);
    let mut now = enter;
    let begun = report_leaf(tree, ray, leaf, enter, &report, observe);
    if begun.is_break() {
        return finish(begun, observe);
    }

    loop {
        // Smallest tMax: the plane that is met next.
        let (exit, mut axes) = first(next);
        if one_by_one {
            axes = axes.first();
        }

        // Step: into the cell beyond it.
        let beyond: [i64; D] = std::array::from_fn(|e| {
            let step = i64::from(axes.contains(e)) * if rising[e] { 1 } else { -1 };
            i64::from(cell[e]) + step
        });
        let outside = domain.outside(beyond, axes);
        let met = next.map(P::value);
        if outside.is_empty() {
            cell = beyond.map(|c| c as u32);
            let ahead = planes_ahead(cell, rising);
            for axis in axes.iter() {
                let plane = domain.plane(axis, ahead[axis]);
                next[axis] = P::at_plane(plane, ray.origin()[axis], ray.direction()[axis]);
            }
        }
        let ahead = next.map(P::value);
        observe.observe(Event::Cross { next: met, axes, cell: beyond, outside, ahead });
        if !outside.is_empty() {
            return finish(ControlFlow::Continue(()), observe);
        }

        // A new leaf? Then the ray comes into it.
        now = now.later(exit);
        let found = look_up(cell, observe);
        let walked = if found == leaf {
            go_on(observe)
        } else {
            leaf = found;
            report_leaf(tree, ray, leaf, now, &report, observe)
        };
        if walked.is_break() {
            return finish(walked, observe);
        }
    }
}

/// Reports that the ray comes into `leaf` at `entry`.
fn report_leaf<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    leaf: Node,
    entry: P,
    report: &Report<P>,
    observe: &mut impl Observer<D>,
) -> ControlFlow<Outcome> {
    let exit = exit_of::<D, P>(tree.domain(), ray, tree.level(leaf.id), tree.code(leaf.id));
    report.leaf(leaf, entry, entry.later(exit.at), observe)
}

/// Grid indices of the planes that a ray meets next from a cell.
fn planes_ahead<const D: usize>(cell: Code<D>, rising: [bool; D]) -> [u32; D] {
    std::array::from_fn(|e| cell[e] + u32::from(rising[e]))
}
