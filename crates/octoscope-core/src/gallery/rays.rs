//! The degenerate rays of a tree.

use super::Degenerate;
use crate::geometry::Ray;
use crate::query::{Arithmetic, Query};
use crate::random::Random;
use crate::trace::{record, rounded_steps};
use crate::traverse::{Algorithm, Options};
use crate::tree::{NodeId, Tree};

/// Shares of the root's side that are on no plane of any grid.
const FREE: [f64; 3] = [0.3, 0.45, 0.6];

/// The ray of this kind, if `tree` has one.
///
/// All that is said of a ray holds exactly, wherever the planes of the tree lie; but
/// the origin of a ray from one lattice point to another is one only where it is a
/// double.
pub fn ray<const D: usize>(kind: Degenerate, tree: &Tree<D>) -> Option<Ray<D>> {
    if !kind.exists_in(tree) {
        return None;
    }
    let domain = tree.domain();
    let (bounds, side) = (domain.root_box(), domain.side());
    let smallest = smallest(tree);
    let corner = corner(tree, smallest);
    let side_of_leaf = domain.cell_side(tree.level(smallest));
    let free = axes(|e| domain.min()[e] + side * FREE[e]);
    let before = with(free, 0, domain.min()[0] - 0.25 * side);
    let along_x = axes(|e| if e == 0 { side } else { 0.0 });
    let scaled = |components: [f64; 3]| axes(|e| side * components[e]);
    // Before the root, in the plane in which the lower faces of the smallest leaves
    // above the corner lie, and on the way through the middle of one of them.
    let before_face = |rise: f64| {
        let way = corner[0] + 0.5 * side_of_leaf - before[0];
        axes(|e| [before[0], corner[1], corner[D - 1] + 0.5 * side_of_leaf - rise * way][e])
    };
    // Steps on the lattice of the tree, and on that of the halves of its sides.
    let lattice = side * if domain.root_level() > 1 { 0.25 } else { 0.5 };

    let (origin, direction) = match kind {
        Degenerate::AxisParallel => (before, along_x),
        Degenerate::FacePlane => (before_face(0.3), scaled([1.0, 0.0, 0.3])),
        Degenerate::LowerFace => (with(before, 1, bounds.min[1]), scaled([1.0, 0.0, 0.3])),
        Degenerate::UpperFace => (with(before, 1, bounds.max[1]), scaled([1.0, 0.0, 0.3])),
        Degenerate::Edge => (with(corner, 0, before[0]), along_x),
        Degenerate::Corner => towards(corner, scaled([1.25, 0.625, 0.3125])),
        Degenerate::Centre => along_diagonal(centre(tree), side)?,
        Degenerate::Diagonal => along_diagonal(centre(tree), -side)?,
        Degenerate::NegativeZero => (before_face(0.0), axes(|e| if e == 0 { side } else { -0.0 })),
        Degenerate::Tiny => (before_face(0.0), scaled([1.0, 1e-7, -1e-7])),
        Degenerate::OnFace => {
            // Beside the corner the plane lies between two of the smallest leaves;
            // elsewhere a larger one may reach across it.
            let beside = axes(|e| corner[e] + 0.3 * side_of_leaf);
            (with(beside, 0, corner[0]), scaled([-1.0, 0.4, 0.3]))
        }
        Degenerate::OnCorner => (corner, scaled([-1.0, 0.5, -0.25])),
        Degenerate::Inside => (free, scaled([1.0, 0.6, -0.4])),
        Degenerate::Behind => {
            let away = scaled([1.0, 0.5, 0.25]);
            (axes(|e| free[e] + away[e]), away)
        }
        Degenerate::Leaving => (with(free, 0, bounds.min[0]), scaled([-1.0, 0.2, 0.1])),
        Degenerate::Grazing => {
            // Through the edge, in the plane the corner, of low x and high y.
            let edge = with(with(free, 0, bounds.min[0]), 1, bounds.max[1]);
            towards(edge, scaled([0.5, 0.5, 0.25]))
        }
        Degenerate::Miss => {
            (axes(|e| bounds.min[e] + side * [-0.5, 0.9, 0.3][e]), scaled([1.0, 1.0, 0.1]))
        }
        Degenerate::Lattice => {
            // In space the third axis does not take part: the ray meets the edge
            // above the corner, in the middle of a smallest leaf's side.
            let half = axes(|e| [side, -0.5 * side, 0.5 * side_of_leaf][e]);
            let (origin, half) = towards(corner, half);
            let raised = axes(|e| if e == 2 { origin[e] + 0.5 * side_of_leaf } else { origin[e] });
            (raised, half.map(|d| 2.0 * d))
        }
        Degenerate::LatticeSpace => towards(corner, axes(|e| lattice * [4.0, 2.0, -1.0][e])),
        Degenerate::Thirds => return thirds(tree),
        Degenerate::Far => {
            let away = scaled([-1e6, -5e5, -2.5e5]);
            (axes(|e| free[e] + away[e]), away.map(|d| -d))
        }
        Degenerate::Slow => {
            let (origin, direction) = towards(corner, scaled([1.25, 0.625, 0.3125]));
            // A power of two: the ray still meets the corner exactly.
            (origin, direction.map(|d| d * 2f64.powi(-1000)))
        }
    };
    Some(Ray::new(origin, direction).expect("finite numbers, with motion along x at least"))
}

/// The corner in which the smallest children meet that come first in the tree, which
/// is the centre of a root that is not divided.
fn corner<const D: usize>(tree: &Tree<D>, smallest: NodeId) -> [f64; D] {
    middle(tree, tree.parent(smallest).unwrap_or(tree.root().id))
}

/// The first of the smallest leaves.
fn smallest<const D: usize>(tree: &Tree<D>) -> NodeId {
    let leaves = tree.leaves().map(|leaf| leaf.id);
    leaves.min_by_key(|&id| tree.level(id)).expect("a tree has a leaf")
}

fn centre<const D: usize>(tree: &Tree<D>) -> [f64; D] {
    middle(tree, tree.root().id)
}

/// The point in which a node's mid planes meet.
fn middle<const D: usize>(tree: &Tree<D>, node: NodeId) -> [f64; D] {
    let (domain, level, code) = (tree.domain(), tree.level(node), tree.code(node));
    match level.checked_sub(1) {
        Some(below) => axes(|e| domain.plane(e, code[e] + (1 << below))),
        None => domain.cell_box(level, code).centre(),
    }
}

/// Ray that comes to `point` with equal components, about from this step before it;
/// `None` if no such origin has coordinates that are doubles.
fn along_diagonal<const D: usize>(point: [f64; D], step: f64) -> Option<([f64; D], [f64; D])> {
    let halved = (0..64).map(|n| step * 0.5f64.powi(n));
    let steps = halved.flat_map(|step| point.map(|x| exact_step(x, step)));
    let mut origins = steps.map(|step| (point.map(|x| x - step), step));
    let exact = |origin: &[f64; D], step: f64| {
        (0..D).all(|e| point[e] - origin[e] == step && is_difference(step, point[e], origin[e]))
    };
    let found = origins.find(|&(ref origin, step)| exact(origin, step));
    found.map(|(origin, step)| (origin, [step; D]))
}

/// Ray that is at `point` at t = 1 in exact arithmetic, about by this step: shorter
/// where it must be, in the same direction if that can be.
fn towards<const D: usize>(point: [f64; D], step: [f64; D]) -> ([f64; D], [f64; D]) {
    let halved = (0..64).map(|n| step.map(|d| d * 0.5f64.powi(n)));
    let mut rounded = halved.map(|step| axes(|e| rounded_step(point[e], step[e]).unwrap_or(0.0)));
    let exact = rounded.find(|step| !step.contains(&0.0));
    let exact = exact.unwrap_or_else(|| axes(|e| exact_step(point[e], step[e])));
    (axes(|e| point[e] - exact[e]), exact)
}

/// About `step`, such that `point − step` is a double: halved until it is.
pub(super) fn exact_step(point: f64, step: f64) -> f64 {
    // A step no larger than the point is exact once it is rounded to its digits.
    let mut halved = (0..64).map(|n| step * 0.5f64.powi(n));
    halved.find_map(|step| rounded_step(point, step)).unwrap_or(step)
}

/// `step` rounded so that `point − step` is a double, if it then is one.
fn rounded_step(point: f64, step: f64) -> Option<f64> {
    let origin = point - step;
    let step = point - origin;
    (step != 0.0 && is_difference(step, point, origin)).then_some(step)
}

/// Whether `difference` is exactly `a − b`, of which it is the nearest double
/// [Knuth, TAOCP 2, §4.2.2].
pub(super) fn is_difference(difference: f64, a: f64, b: f64) -> bool {
    let about_b = a - difference;
    (a - (difference + about_b)) + (about_b - b) == 0.0
}

/// Ray in thirds of a lattice vector. Exactly it runs beside corners that it would
/// meet; where doubles take it for one of them, they decide otherwise. `None` if
/// none is found on which they do.
fn thirds<const D: usize>(tree: &Tree<D>) -> Option<Ray<D>> {
    const SIZE: u64 = 16;
    let (domain, mut random) = (tree.domain(), Random::new(1));
    let step = domain.side() / SIZE as f64;
    let (algorithm, options) = (Algorithm::Parametric, Options::default());
    let query = Query::Ray { algorithm, options, arithmetic: Arithmetic::Exact };
    let mut candidates = (0..4000).filter_map(|_| {
        let mut point = |from: i64, n: u64| -> [f64; D] {
            std::array::from_fn(|e| domain.min()[e] + step * (from + random.below(n) as i64) as f64)
        };
        let (from, to) = (point(-(SIZE as i64) / 2, SIZE / 2 + 1), point(0, SIZE + 1));
        let direction = axes(|e| (to[e] - from[e]) / 3.0);
        let oblique = direction.iter().all(|&d| d != 0.0);
        Ray::new(from, direction).ok().filter(|_| oblique)
    });
    candidates.find(|ray| !rounded_steps(tree, ray, &record(tree, ray, &query)).is_empty())
}

fn with<const D: usize>(mut point: [f64; D], axis: usize, x: f64) -> [f64; D] {
    point[axis] = x;
    point
}

fn axes<const D: usize>(f: impl Fn(usize) -> f64) -> [f64; D] {
    std::array::from_fn(f)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_differences_are_told_from_rounded_ones() {
        assert!(is_difference(0.5, 0.75, 0.25));
        assert!(!is_difference(1.0 - 1e-20, 1.0, 1e-20));
        assert!(!is_difference(0.1 + 0.9, 0.1, -0.9));
        for (point, step) in
            [(0.1, 1.25), (-7.7, 0.875), (0.0, 0.3), (1e-17, 1.0), (123.456, -416.0)]
        {
            let exact = exact_step(point, step);
            assert!(is_difference(exact, point, point - exact), "{point} {step}");
            assert_eq!(exact.signum(), f64::signum(step));
        }
    }
}
