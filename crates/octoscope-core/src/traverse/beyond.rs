//! From a leaf to the cell just beyond it: what all bottom-up walks share.
//!
//! A coordinate on a plane belongs to the cell into which the ray moves. All
//! planes that are met at once are crossed at once. The codes along the other
//! axes are found by comparing parameters, not by rounding a point, and stay
//! within the cell that is left: rounding cannot throw the ray into a wrong cell.

use super::algorithm::Options;
use super::clip::{at_planes, clip_root, first};
use crate::event::{Event, Observer, Search};
use crate::geometry::{Axes, Parameter, Ray, per_axis};
use crate::locate::descend;
use crate::tree::{Code, Domain, Node, Tree, last_where};
use std::cell::Cell;

/// Where the ray leaves a leaf.
#[derive(Clone, Copy, Debug)]
pub struct Exit<const D: usize, P> {
    /// Grid indices of the far planes.
    pub planes: [u32; D],
    /// Their parameters; +∞ along axes without motion.
    pub exits: [P; D],
    /// The earliest of them.
    pub at: P,
    /// The planes that are met then.
    pub axes: Axes<D>,
}

/// Where the ray leaves the cell with this level and code.
#[inline]
pub fn exit_of<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    level: u8,
    code: Code<D>,
) -> Exit<D, P> {
    let planes = per_axis(|e| {
        let moves_down = ray.direction()[e] < 0.0;
        if moves_down { code[e] } else { code[e] + (1 << level) }
    });
    let exits = at_planes::<D, P>(domain, ray, planes);
    let (at, axes) = first(exits);
    Exit { planes, exits, at, axes }
}

impl<const D: usize, P: Parameter> Exit<D, P> {
    /// The step of finding the exit.
    pub fn event(&self, domain: &Domain<D>) -> Event<D> {
        Event::Exits {
            planes: std::array::from_fn(|e| domain.plane(e, self.planes[e])),
            exits: self.exits.map(P::value),
            axes: self.axes,
        }
    }
}

/// Codes of the place just beyond the cell with this level and code, which the
/// ray leaves by `exit`; −1 or 2^R outside the domain.
pub fn target_of<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    level: u8,
    code: Code<D>,
    exit: &Exit<D, P>,
) -> ([i64; D], Search) {
    let mut search = Search::NONE;
    let target = per_axis(|e| {
        let [first, last] = [code[e], code[e] + ((1 << level) - 1)];
        match (exit.axes.contains(e), ray.direction()[e] > 0.0) {
            (true, true) => i64::from(last) + 1,
            (true, false) => i64::from(first) - 1,
            (false, _) => {
                let (found, work) = code_at(domain, ray, e, exit.at, [first, last]);
                search = search.and(work);
                i64::from(found)
            }
        }
    });
    (target, search)
}

/// The same as a step, with the test whether the place is in the domain; `None`
/// if it is not.
pub fn beyond<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    level: u8,
    code: Code<D>,
    exit: &Exit<D, P>,
    observe: &mut impl Observer<D>,
) -> Option<Code<D>> {
    // New codes: beyond the planes that are crossed, within the cell elsewhere.
    let found = target_of(domain, ray, level, code, exit);
    within(domain, level, code, exit.axes, found, observe)
}

/// The step to `target`, beyond the planes of `axes` of the cell with this level
/// and code, and the test whether that is in the domain; `None` if it is not.
fn within<const D: usize>(
    domain: &Domain<D>,
    level: u8,
    code: Code<D>,
    axes: Axes<D>,
    (target, search): ([i64; D], Search),
    observe: &mut impl Observer<D>,
) -> Option<Code<D>> {
    observe.observe(Event::Target { level, from: code, to: target, axes, search });

    // Border: a code outside ends the walk. Only crossed axes can lead there.
    let outside = domain.outside(target, axes);
    observe.observe(Event::Border { tested: axes, outside });
    outside.is_empty().then(|| per_axis(|e| target[e] as u32))
}

/// A leaf on the way of a ray.
#[derive(Clone, Copy, Debug)]
pub struct Reached<P> {
    /// The leaf.
    pub leaf: Node,
    /// Its level.
    pub level: u8,
    /// Where the ray enters it.
    pub entry: P,
}

/// Enters the tree: cuts the ray with the root and locates the first leaf from
/// there, by codes. `None` if the ray misses the root.
pub fn enter<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Option<Reached<P>> {
    let domain = tree.domain();
    let entry = clip_root::<D, P>(domain, ray, options, observe)?.enter;
    let (code, search) = code_of_entry(domain, ray, entry);
    observe.observe(encoded(ray, entry, code, search));
    let root = tree.root();
    observe.observe(Event::Begin { node: root.id });
    let (leaf, level) = descend(tree, root, domain.root_level(), code, 0, observe);
    Some(Reached { leaf, level, entry })
}

/// Leaf below `node` into which the ray goes on from the leaf with this level and
/// code, which it leaves by `exit`. Codes are looked for only if `node` is divided.
pub fn locate_below<const D: usize, P: Parameter>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    node: Node,
    (level, code): (u8, Code<D>),
    exit: &Exit<D, P>,
    observe: &mut impl Observer<D>,
) -> Reached<P> {
    let entry = exit.at;
    let level_of_node = tree.level(node.id);
    if node.is_leaf() {
        return Reached { leaf: node, level: level_of_node, entry };
    }
    let (target, search) = target_of(tree.domain(), ray, level, code, exit);
    let target = target.map(|c| c as u32);
    observe.observe(encoded(ray, entry, target, search));
    let (leaf, level) = descend(tree, node, level_of_node, target, 0, observe);
    Reached { leaf, level, entry }
}

/// Code of the smallest cell in which the ray is just after parameter `t`.
pub fn code_of_entry<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    t: P,
) -> (Code<D>, Search) {
    let grid = [0, domain.grid_size() - 1];
    let mut search = Search::NONE;
    let code = per_axis(|e| {
        let (found, work) = code_at(domain, ray, e, t, grid);
        search = search.and(work);
        found
    });
    (code, search)
}

/// The step of finding the codes of the smallest cell in which the ray is just
/// after parameter `t`, with what it took.
fn encoded<const D: usize, P: Parameter>(
    ray: &Ray<D>,
    t: P,
    code: Code<D>,
    search: Search,
) -> Event<D> {
    Event::Encode { point: ray.at(t.value()), code, after: Some(t.value()), search }
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
) -> (u32, Search) {
    let n_planes = Cell::new(0);
    let (origin, direction) = (ray.origin()[axis], ray.direction()[axis]);
    let count = || n_planes.set(n_planes.get() + 1);
    let passed = |plane| {
        count();
        P::at_plane(domain.plane(axis, plane), origin, direction).not_after(t)
    };
    let below_origin = |plane| {
        count();
        domain.plane(axis, plane) <= origin
    };
    let guess = domain.nearest_index(axis, ray.at(t.value())[axis]);
    let code = if direction > 0.0 {
        last_where([first, last], guess, passed)
    } else if direction < 0.0 {
        // The same, counted from above: the upper plane of the cell is passed.
        last - last_where([0, last - first], last.saturating_sub(guess), |n| passed(last - n + 1))
    } else {
        last_where([first, last], guess, below_origin)
    };
    let n = n_planes.get();
    let [parameters, coordinates] = if direction == 0.0 { [0, n] } else { [n, 0] };
    (code, Search { guesses: 1, parameters, coordinates })
}
