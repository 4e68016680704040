//! The degenerate ray that is nearest to another ray.

use super::rays::{exact_step, is_difference};
use super::texts;
use crate::geometry::{Aabb, Ray};
use crate::query::{Arithmetic, Query};
use crate::text::Language;
use crate::trace::record;
use crate::traverse::{Algorithm, Options};
use crate::tree::{Child, Tree};

/// How a ray became degenerate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Snap {
    /// A component of its direction is 0 now.
    ZeroComponent,
    /// It runs along one axis now; in space more than one component was not 0.
    AxisParallel,
    /// The components of its direction are equal now, but for their signs.
    Diagonal,
    /// It meets a corner of a leaf now.
    ThroughCorner,
    /// Its origin lies on a plane of a leaf now.
    OriginOnPlane,
    /// Its origin is a corner of a leaf now.
    OriginOnCorner,
}

/// A ray made degenerate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Snapped<const D: usize> {
    /// The ray.
    pub ray: Ray<D>,
    /// What is degenerate about it.
    pub snap: Snap,
    /// How far it was from it: the change of the direction, relative to its length,
    /// or of the origin, relative to the side of the root.
    pub change: f64,
}

impl Snap {
    /// All ways, the first of equally near ones first.
    pub const ALL: [Self; 6] = [
        Self::AxisParallel,
        Self::ZeroComponent,
        Self::Diagonal,
        Self::OriginOnCorner,
        Self::OriginOnPlane,
        Self::ThroughCorner,
    ];

    /// What has happened to the ray, in one sentence.
    pub fn told(self, language: Language) -> String {
        texts(language).get(match self {
            Self::ZeroComponent => "snap-zero-component",
            Self::AxisParallel => "snap-axis-parallel",
            Self::Diagonal => "snap-diagonal",
            Self::ThroughCorner => "snap-through-corner",
            Self::OriginOnPlane => "snap-origin-on-plane",
            Self::OriginOnCorner => "snap-origin-on-corner",
        })
    }
}

/// The nearest ray to `ray` that is degenerate in one more way; `None` if there is
/// none. O(leaves on the ray).
pub fn snap<const D: usize>(tree: &Tree<D>, ray: &Ray<D>) -> Option<Snapped<D>> {
    let nearest = |snap: Snap| {
        let candidates = candidates(tree, ray, snap).into_iter();
        let snapped = candidates.filter_map(|(origin, direction)| {
            let snapped = Ray::new(origin, direction).ok()?;
            let change = change(tree, ray, &snapped);
            (change > 0.0).then_some(Snapped { ray: snapped, snap, change })
        });
        snapped.min_by(|a, b| a.change.total_cmp(&b.change))
    };
    Snap::ALL.into_iter().filter_map(nearest).min_by(|a, b| a.change.total_cmp(&b.change))
}

type Numbers<const D: usize> = ([f64; D], [f64; D]);

fn candidates<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, snap: Snap) -> Vec<Numbers<D>> {
    let (origin, direction) = (ray.origin(), ray.direction());
    let largest = direction.iter().fold(0.0f64, |largest, d| largest.max(d.abs()));
    let without = |axis: usize| std::array::from_fn(|e| if e == axis { 0.0 } else { direction[e] });
    match snap {
        Snap::ZeroComponent => (0..D).map(|axis| (origin, without(axis))).collect(),
        Snap::AxisParallel => {
            let along = (0..D).find(|&e| direction[e].abs() == largest);
            let alone = |axis| std::array::from_fn(|e| if e == axis { direction[e] } else { 0.0 });
            along.map(|axis| (origin, alone(axis))).into_iter().collect()
        }
        Snap::Diagonal => vec![(origin, direction.map(|d| largest.copysign(d)))],
        Snap::ThroughCorner => {
            corners(tree, ray).into_iter().filter_map(|corner| through(ray, corner)).collect()
        }
        Snap::OriginOnPlane | Snap::OriginOnCorner => {
            let bounds = leaf_at(tree, origin);
            let moved = |(axis, plane)| {
                let mut moved = origin;
                moved[axis] = plane;
                moved
            };
            let planes = (0..D).flat_map(|e| [(e, bounds.min[e]), (e, bounds.max[e])]);
            // The last coordinate to come onto a plane makes it a corner.
            let is_corner = |point: &[f64; D]| {
                (0..D).all(|e| point[e] == bounds.min[e] || point[e] == bounds.max[e])
            };
            let wanted = snap == Snap::OriginOnCorner;
            let moved = planes.map(moved).filter(|point| is_corner(point) == wanted);
            moved.map(|point| (point, direction)).collect()
        }
    }
}

/// How far `snapped` is from `ray`.
fn change<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, snapped: &Ray<D>) -> f64 {
    let unit = |ray: &Ray<D>| {
        // Scaled first, so that no square leaves the range of doubles.
        let direction = ray.direction();
        let largest = direction.iter().fold(0.0f64, |largest, d| largest.max(d.abs()));
        let scaled = direction.map(|d| d / largest);
        let length = scaled.iter().map(|d| d * d).sum::<f64>().sqrt();
        scaled.map(|d| d / length)
    };
    let distance = |a: [f64; D], b: [f64; D]| {
        let squares = (0..D).map(|e| (a[e] - b[e]).powi(2));
        squares.sum::<f64>().sqrt()
    };
    let turned = distance(unit(ray), unit(snapped));
    turned + distance(ray.origin(), snapped.origin()) / tree.domain().side()
}

/// Box of the leaf that owns `point`, or of the root outside of it.
fn leaf_at<const D: usize>(tree: &Tree<D>, point: [f64; D]) -> Aabb<D> {
    let leaf = tree.domain().encode_point(point).and_then(|code| tree.node_at(0, code));
    tree.node_box(leaf.unwrap_or(tree.root()).id)
}

fn corners_of<const D: usize>(bounds: Aabb<D>) -> impl Iterator<Item = [f64; D]> {
    Child::<D>::all().map(move |child| {
        std::array::from_fn(|e| if child.is_upper(e) { bounds.max[e] } else { bounds.min[e] })
    })
}

/// Corners of the leaves on the ray, ahead of its origin; if it misses, of the root.
fn corners<const D: usize>(tree: &Tree<D>, ray: &Ray<D>) -> Vec<[f64; D]> {
    let (algorithm, options) = (Algorithm::Parametric, Options::default());
    let query = Query::Ray { algorithm, options, arithmetic: Arithmetic::Exact };
    let mut boxes: Vec<Aabb<D>> =
        record(tree, ray, &query).leaves().map(|(leaf, _)| tree.node_box(leaf)).collect();
    if boxes.is_empty() {
        boxes.push(tree.domain().root_box());
    }
    let ahead = |corner: &[f64; D]| {
        let along = |e: usize| (corner[e] - ray.origin()[e]) * ray.direction()[e].signum();
        (0..D).map(along).fold(0.0, f64::max) > 0.0
    };
    boxes.into_iter().flat_map(corners_of).filter(ahead).collect()
}

/// The ray turned, and moved by the rounding of doubles if need be, so that it
/// meets `corner` exactly at t = 1.
fn through<const D: usize>(ray: &Ray<D>, corner: [f64; D]) -> Option<Numbers<D>> {
    let old = ray.direction();
    // Already through it?
    let mut origin = ray.origin();
    let mut direction = [0.0; D];
    for e in 0..D {
        let step = corner[e] - origin[e];
        let exact = step == 0.0 || is_difference(step, corner[e], origin[e]);
        direction[e] = if exact { step } else { exact_step(corner[e], step) };
        if !exact {
            origin[e] = corner[e] - direction[e];
        }
    }
    // A ray that meets the corner already has nowhere to go.
    let parallel = (1..D).all(|e| direction[0] * old[e] == direction[e] * old[0]);
    (!parallel).then_some((origin, direction))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Progress;
    use crate::tree::{Domain, Split, grow};

    fn full<const D: usize>(levels: u8) -> Tree<D> {
        grow(Domain::unit(levels), (), &Progress::default(), |cell, ()| match cell.level {
            0 => Split::Empty,
            _ => Split::Inner(vec![(); 1 << D]),
        })
        .unwrap()
    }

    fn check<const D: usize>(ray: Numbers<D>, snap_expected: Snap, expected: Numbers<D>) {
        let ray = Ray::new(ray.0, ray.1).unwrap();
        let snapped = snap(&full(2), &ray).unwrap();
        let found = (snapped.ray.origin(), snapped.ray.direction());
        assert_eq!((snapped.snap, found), (snap_expected, expected));
    }

    #[test]
    fn a_small_component_becomes_zero() {
        check(([-1.0, 0.3], [1.0, 1e-5]), Snap::AxisParallel, ([-1.0, 0.3], [1.0, 0.0]));
        check(
            ([-1.1, 0.3, 0.4], [1.0, 1e-5, 0.07]),
            Snap::ZeroComponent,
            ([-1.1, 0.3, 0.4], [1.0, 0.0, 0.07]),
        );
    }

    #[test]
    fn almost_equal_components_become_equal() {
        check(([-1.0, 0.3], [-1.0, 1.00001]), Snap::Diagonal, {
            ([-1.0, 0.3], [-1.00001, 1.00001])
        });
    }

    #[test]
    fn an_origin_near_a_plane_moves_onto_it_and_near_a_corner_into_it() {
        check(([0.2500001, 0.4], [0.31, 1.1]), Snap::OriginOnPlane, ([0.25, 0.4], [0.31, 1.1]));
        check(([0.25, 0.4999999], [0.31, 1.1]), Snap::OriginOnCorner, ([0.25, 0.5], [0.31, 1.1]));
    }

    #[test]
    fn a_ray_near_a_corner_meets_it_exactly() {
        let ray = Ray::new([-0.3, 0.1], [0.8, 0.400001]).unwrap();
        let snapped = snap(&full(2), &ray).unwrap();
        assert_eq!(snapped.snap, Snap::ThroughCorner);
        assert_eq!(snapped.ray.at(1.0), [0.0, 0.25]);
        assert!(snapped.change < 1e-5);
    }

    #[test]
    fn what_is_degenerate_already_becomes_so_in_another_way() {
        let tree = full::<3>(2);
        let mut ray = Ray::new([-0.31, 0.12, 0.57], [0.8, 0.4, -0.31]).unwrap();
        for _ in 0..4 {
            let snapped = snap(&tree, &ray).unwrap();
            assert!(snapped.ray != ray && snapped.change > 0.0, "{snapped:?}");
            ray = snapped.ray;
        }
    }
}
