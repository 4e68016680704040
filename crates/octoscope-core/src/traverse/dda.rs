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
//! which the ray moves.

use super::algorithm::Options;
use super::beyond::code_of_entry;
use super::clip::{Clip, at_planes, clip, first};
use super::report::{Report, finish, missed};
use super::variant::Variant;
use crate::event::{Event, Observer, Outcome};
use crate::geometry::{Parameter, Ray};
use crate::locate::descend;
use crate::tree::{Code, Node, Tree};

/// Leaves of `tree` along `ray`, in order, by walking through its finest grid.
///
/// A grid knows what is in its cells; here the tree stands in for that array,
/// which is not counted as work.
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
    let (clip, event) = clip::<D, P>(domain, ray, options);
    observe.observe(event);
    let Some(Clip { enter, .. }) = clip else {
        return missed(observe);
    };
    let report = Report::of(options);
    let one_by_one = options.variants.has(Variant::OneByOne);
    let rising = ray.direction().map(|d| d >= 0.0);

    // Init: the first cell, and the planes ahead.
    let mut cell = code_of_entry(domain, ray, enter);
    let mut next = at_planes::<D, P>(domain, ray, planes_ahead(cell, rising));
    // Without motion along an axis no plane is ahead.
    let still = ray.direction().map(|d| d == 0.0);
    next = std::array::from_fn(|e| if still[e] { P::BEYOND_ALL } else { next[e] });
    observe.observe(Event::Grid { cell, next: next.map(P::value) });
    let mut leaf = look_up(cell, observe);
    let (mut entry, mut now) = (enter, enter);

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
        observe.observe(Event::Cross { next: next.map(P::value), axes, cell: beyond });
        let is_inside = beyond.iter().all(|c| (0..i64::from(domain.grid_size())).contains(c));
        if !is_inside {
            return finish(report.leaf(leaf, entry, exit, observe), observe);
        }
        cell = beyond.map(|c| c as u32);
        let ahead = planes_ahead(cell, rising);
        for axis in axes.iter() {
            let plane = domain.plane(axis, ahead[axis]);
            next[axis] = P::at_plane(plane, ray.origin()[axis], ray.direction()[axis]);
        }

        // A new leaf? Then the one before is left.
        now = now.later(exit);
        let found = look_up(cell, observe);
        if found != leaf {
            let reported = report.leaf(leaf, entry, now, observe);
            if reported.is_break() {
                return finish(reported, observe);
            }
            (leaf, entry) = (found, now);
        }
    }
}

/// Grid indices of the planes that a ray meets next from a cell.
fn planes_ahead<const D: usize>(cell: Code<D>, rising: [bool; D]) -> [u32; D] {
    std::array::from_fn(|e| cell[e] + u32::from(rising[e]))
}
