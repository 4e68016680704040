//! Traversal by location codes, bottom-up and without a stack [Frisken, Perry
//! 2002, §6].
//!
//! From a leaf the ray's exit gives the codes of the cell just beyond it. XOR of
//! both codes tells how far up their common ancestor is; from there the bits of
//! the new codes lead down to the next leaf. O(visited leaves × distance to the
//! common ancestor), D divisions a leaf, no look-up tables.
//!
//! The report only sketches this walk. What it leaves open is settled so:
//! * A coordinate on a plane belongs to the cell into which the ray moves.
//! * All planes that are met at once are crossed at once.
//! * The codes of the other axes are found by comparing parameters, not by
//!   rounding a point, and stay within the cell that is left: rounding cannot
//!   throw the ray into a wrong cell.

use super::algorithm::{Options, StopAt};
use super::clip::{Clip, at_planes, clip, earliest};
use crate::event::{End, Event, Observer, Outcome};
use crate::geometry::{Axes, Parameter, Ray};
use crate::locate::climb;
use crate::tree::{Code, Domain, Tree, branch, last_where};

/// Leaves of `tree` along `ray`, in order.
pub fn traverse<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Outcome {
    // Enter: the codes of the point where the ray comes in, and their leaf.
    let domain = tree.domain();
    let (clip, event) = clip::<D, P>(domain, ray);
    observe.observe(event);
    let Some(Clip { enter: mut entry, .. }) = clip else {
        observe.observe(Event::End(End::Missed));
        return Outcome::without_node(End::Missed);
    };
    let grid = [0, domain.grid_size() - 1];
    let mut code = std::array::from_fn(|e| code_at(domain, ray, e, entry, grid));
    observe.observe(Event::Encode { point: ray.at(entry.value()), code });
    let mut node = tree.root();
    let mut level = domain.root_level();
    observe.observe(Event::Begin { node: node.id });

    loop {
        // Descend: one bit of every code a level.
        while !node.is_leaf() {
            let child = branch(code, level);
            node = tree.child(node, child);
            observe.observe(Event::Follow { level, code, child, node: node.id });
            level -= 1;
        }
        let corner = tree.code(node.id);

        // Exit planes: the far planes of the leaf, and the first of them.
        let planes = std::array::from_fn(|e| {
            let moves_down = ray.direction()[e] < 0.0;
            if moves_down { corner[e] } else { corner[e] + (1 << level) }
        });
        let exits = at_planes::<D, P>(domain, ray, planes);
        let exit = earliest(exits);
        let full = node.is_full();
        observe.observe(Event::Leaf {
            node: node.id,
            enter: entry.value(),
            exit: exit.value(),
            full,
        });
        if full && options.stop_at == StopAt::FirstFull {
            observe.observe(Event::End(End::FirstFull));
            return Outcome::at(End::FirstFull, node.id);
        }
        let axes = Axes::where_true(exits.map(|t| t.not_after(exit)));
        observe.observe(Event::Exits {
            planes: std::array::from_fn(|e| domain.plane(e, planes[e])),
            exits: exits.map(P::value),
            axes,
        });

        // New codes: beyond the planes that are crossed, within the cell elsewhere.
        let target: [i64; D] = std::array::from_fn(|e| {
            let [first, last] = [corner[e], corner[e] + ((1 << level) - 1)];
            match (axes.contains(e), ray.direction()[e] > 0.0) {
                (true, true) => i64::from(last) + 1,
                (true, false) => i64::from(first) - 1,
                (false, _) => i64::from(code_at(domain, ray, e, exit, [first, last])),
            }
        });
        observe.observe(Event::Target { level, from: corner, to: target, axes });

        // Border: any code outside ends the walk.
        let outside = target.map(|c| c < 0 || c >= i64::from(domain.grid_size()));
        observe.observe(Event::Border { outside: Axes::where_true(outside) });
        if outside.contains(&true) {
            observe.observe(Event::End(End::LeftRoot));
            return Outcome::without_node(End::LeftRoot);
        }
        let next: Code<D> = target.map(|c| c as u32);

        // Climb: up to the common ancestor.
        (node, level) = climb(tree, node, level, corner, next, observe);
        code = next;
        entry = exit;
    }
}

/// Index on `axis` of the smallest cell, between `first` and `last`, in which
/// the ray is just after parameter `t`. The rounded point is but a first guess;
/// the parameters of the grid planes decide.
fn code_at<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    axis: usize,
    t: P,
    [first, last]: [u32; 2],
) -> u32 {
    let (origin, direction) = (ray.origin()[axis], ray.direction()[axis]);
    let passed = |plane| P::at_plane(domain.plane(axis, plane), origin, direction).not_after(t);
    let guess = domain.nearest_index(axis, ray.at(t.value())[axis]);
    if direction > 0.0 {
        last_where([first, last], guess, passed)
    } else if direction < 0.0 {
        // The same, counted from above: the upper plane of the cell is passed.
        last - last_where([0, last - first], last.saturating_sub(guess), |n| passed(last - n + 1))
    } else {
        last_where([first, last], guess, |plane| domain.plane(axis, plane) <= origin)
    }
}
