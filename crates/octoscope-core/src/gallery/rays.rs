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

/// The ray of this kind; in the plane of those that exist there.
pub fn ray<const D: usize>(kind: Degenerate, tree: &Tree<D>) -> Ray<D> {
    let domain = tree.domain();
    let (bounds, side) = (domain.root_box(), domain.side());
    let corner = corner(tree);
    let free = axes(|e| domain.min()[e] + side * FREE[e]);
    let before = axes(|e| if e == 0 { domain.min()[e] - 0.25 * side } else { free[e] });
    let along_x = axes(|e| if e == 0 { side } else { 0.0 });
    let scaled = |components: [f64; 3]| axes(|e| side * components[e]);

    let (origin, direction) = match kind {
        Degenerate::AxisParallel => (before, along_x),
        Degenerate::FacePlane => (with(before, 1, corner[1]), scaled([1.0, 0.0, 0.3])),
        Degenerate::LowerFace => (with(before, 1, bounds.min[1]), scaled([1.0, 0.0, 0.3])),
        Degenerate::UpperFace => (with(before, 1, bounds.max[1]), scaled([1.0, 0.0, 0.3])),
        Degenerate::Edge => (axes(|e| if e == 0 { before[e] } else { corner[e] }), along_x),
        Degenerate::Corner => towards(corner, scaled([1.25, 0.625, 0.3125])),
        Degenerate::Centre => towards(centre(tree), scaled([1.0; 3])),
        Degenerate::Diagonal => towards(centre(tree), scaled([-1.0; 3])),
        Degenerate::NegativeZero => {
            (with(before, 1, corner[1]), axes(|e| if e == 0 { side } else { -0.0 }))
        }
        Degenerate::Tiny => (with(before, 1, corner[1]), scaled([1.0, 1e-7, -1e-7])),
        Degenerate::OnFace => {
            // Beside the corner the plane lies between two of the smallest leaves;
            // elsewhere a larger one may reach across it.
            let side_of_leaf = domain.cell_side(smallest(tree).map_or(0, |id| tree.level(id)));
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
            (axes(|e| bounds.min[e] + side * [-0.5, 0.9, 0.3][e]), { scaled([1.0, 1.0, 0.1]) })
        }
        Degenerate::Lattice => {
            let (origin, direction) = towards(corner, scaled([0.75, -0.375, 0.1]));
            // In space the third axis does not take part: the ray meets the edge
            // above the corner, in the middle of a smallest leaf's side.
            let half = 0.5 * domain.cell_side(smallest(tree).map_or(0, |id| tree.level(id)));
            let aside = |e: usize| if e == 2 { origin[e] + half } else { origin[e] };
            (axes(aside), direction)
        }
        Degenerate::LatticeSpace => towards(corner, scaled([0.75, 0.5, -0.25])),
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
    Ray::new(origin, direction).expect("finite numbers, with motion along x at least")
}

/// The corner in which the smallest children meet that come first in the tree.
fn corner<const D: usize>(tree: &Tree<D>) -> [f64; D] {
    let parent = smallest(tree).and_then(|id| tree.parent(id));
    middle(tree, parent.unwrap_or(tree.root().id))
}

/// The first of the smallest leaves.
fn smallest<const D: usize>(tree: &Tree<D>) -> Option<NodeId> {
    tree.leaves().map(|leaf| leaf.id).min_by_key(|&id| tree.level(id))
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

/// Ray that is at `point` at t = 1 in exact arithmetic, about by this step.
fn towards<const D: usize>(point: [f64; D], step: [f64; D]) -> ([f64; D], [f64; D]) {
    let exact = axes_of(|e| exact_step(point[e], step[e]));
    (axes(|e| point[e] - exact[e]), exact)
}

/// About `step`, such that `point − step` is a double: halved until it is.
pub(super) fn exact_step(point: f64, step: f64) -> f64 {
    let mut wanted = step;
    // A step no larger than the point is exact once it is rounded to its digits.
    for _ in 0..64 {
        let origin = point - wanted;
        let step = point - origin;
        if step != 0.0 && is_difference(step, point, origin) {
            return step;
        }
        wanted *= 0.5;
    }
    step
}

/// Whether `difference` is exactly `a − b`, of which it is the nearest double
/// [Knuth, TAOCP 2, §4.2.2].
pub(super) fn is_difference(difference: f64, a: f64, b: f64) -> bool {
    let about_b = a - difference;
    (a - (difference + about_b)) + (about_b - b) == 0.0
}

/// Ray in thirds of a lattice vector. Exactly it runs beside corners that it would
/// meet; where doubles take it for one of them, they decide otherwise.
fn thirds<const D: usize>(tree: &Tree<D>) -> Ray<D> {
    let (domain, mut random) = (tree.domain(), Random::new(1));
    let size = u64::from(domain.grid_size().min(16));
    let step = domain.side() / size as f64;
    let (algorithm, options) = (Algorithm::Parametric, Options::default());
    let query = Query::Ray { algorithm, options, arithmetic: Arithmetic::Exact };
    let mut candidates = (0..2000).filter_map(|_| {
        let mut point = |from: i64, n: u64| -> [f64; D] {
            axes_of(|e| domain.min()[e] + step * (from + random.below(n) as i64) as f64)
        };
        let (from, to) = (point(-(size as i64) / 2, size / 2 + 1), point(0, size + 1));
        let direction = axes(|e| (to[e] - from[e]) / 3.0);
        let oblique = direction.iter().all(|&d| d != 0.0);
        Ray::new(from, direction).ok().filter(|_| oblique)
    });
    let first = candidates.next();
    let rounded = |ray: &Ray<D>| !rounded_steps(tree, ray, &record(tree, ray, &query)).is_empty();
    let found = first.filter(rounded).or_else(|| candidates.find(rounded)).or(first);
    found.unwrap_or_else(|| ray(Degenerate::Corner, tree))
}

fn with<const D: usize>(mut point: [f64; D], axis: usize, x: f64) -> [f64; D] {
    point[axis] = x;
    point
}

fn axes<const D: usize>(f: impl Fn(usize) -> f64) -> [f64; D] {
    std::array::from_fn(f)
}

fn axes_of<const D: usize>(f: impl FnMut(usize) -> f64) -> [f64; D] {
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
