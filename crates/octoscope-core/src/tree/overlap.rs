//! Whether a primitive meets a cell, decided exactly.
//!
//! Every answer is the sign of a polynomial in the given doubles. It is taken
//! from doubles where their error bound allows it and from integers of any
//! length where not; a sum of absolute values of the terms gives the bound.

use crate::geometry::{Aabb, Scaled};
use crate::scene::Sphere;
use std::cmp::Ordering;

/// Below it a sum of terms may have lost digits to underflow.
const LEAST: f64 = 1e-250;

/// What a sphere's radius is compared with.
#[derive(Clone, Copy)]
enum Reach {
    Nearest,
    Farthest,
}

/// Whether the closed box meets the closed ball.
pub(super) fn meets_ball<const D: usize>(cell: &Aabb<D>, sphere: &Sphere<D>) -> bool {
    distance_against_radius(cell, sphere, Reach::Nearest).is_le()
}

/// Whether the closed box lies in the closed ball.
pub(super) fn lies_in_ball<const D: usize>(cell: &Aabb<D>, sphere: &Sphere<D>) -> bool {
    distance_against_radius(cell, sphere, Reach::Farthest).is_le()
}

/// Whether the closed box meets the sphere's surface.
pub(super) fn meets_surface<const D: usize>(cell: &Aabb<D>, sphere: &Sphere<D>) -> bool {
    meets_ball(cell, sphere) && distance_against_radius(cell, sphere, Reach::Farthest).is_ge()
}

/// Compares the squared distance of the nearest or farthest point of the box
/// from the centre with the squared radius.
fn distance_against_radius<const D: usize>(
    cell: &Aabb<D>,
    sphere: &Sphere<D>,
    reach: Reach,
) -> Ordering {
    // Per axis the planes whose distance may be the wanted one.
    let planes: [[f64; 2]; D] = std::array::from_fn(|e| {
        let (c, low, high) = (sphere.centre[e], cell.min[e], cell.max[e]);
        match reach {
            Reach::Farthest => [low, high],
            Reach::Nearest => [c.clamp(low, high); 2],
        }
    });

    // Each square is rounded three times, the sum and r² once or twice more.
    let square = |e: usize, plane: f64| (sphere.centre[e] - plane) * (sphere.centre[e] - plane);
    let sum: f64 = (0..D).map(|e| square(e, planes[e][0]).max(square(e, planes[e][1]))).sum();
    let radius = sphere.radius * sphere.radius;
    let larger = sum.max(radius);
    if (LEAST..f64::MAX).contains(&larger) && (sum - radius).abs() > 8.0 * f64::EPSILON * larger {
        return sum.total_cmp(&radius);
    }

    let square = |e: usize, plane: f64| {
        let difference = Scaled::difference(sphere.centre[e], plane);
        difference.times(&difference)
    };
    let mut sum = Scaled::of(0.0);
    for (e, [first, second]) in planes.into_iter().enumerate() {
        let [first, second] = [square(e, first), square(e, second)];
        sum = sum.plus(if first.compare(&second).is_ge() { &first } else { &second });
    }
    let radius = Scaled::of(sphere.radius);
    sum.compare(&radius.times(&radius))
}

/// Whether two half-open boxes share a point. Where `solid` is flat it counts
/// as its one coordinate.
pub(super) fn meets_box<const D: usize>(cell: &Aabb<D>, solid: &Aabb<D>) -> bool {
    (0..D).all(|e| {
        let (low, high) = (solid.min[e], solid.max[e]);
        if low == high {
            cell.min[e] <= low && low < cell.max[e]
        } else {
            low < cell.max[e] && cell.min[e] < high
        }
    })
}

/// Whether the half-open cell lies in the half-open box.
pub(super) fn lies_in_box<const D: usize>(cell: &Aabb<D>, solid: &Aabb<D>) -> bool {
    (0..D).all(|e| solid.min[e] <= cell.min[e] && cell.max[e] <= solid.max[e])
}

/// Whether the closed box meets the closed triangle, by separating axes
/// [Akenine-Möller 2001].
///
/// A plane that separates them is parallel to a side of the box, or holds the
/// triangle, or is parallel to an axis and to an edge. The last kind is seen
/// along that axis: there box and triangle are flat, and only the outer side
/// of each edge matters. A triangle without area has two outer sides.
pub(super) fn meets_triangle<const D: usize>(cell: &Aabb<D>, corners: &[[f64; D]; 3]) -> bool {
    let beside = |e: usize| {
        corners.iter().all(|c| c[e] < cell.min[e]) || corners.iter().all(|c| c[e] > cell.max[e])
    };
    let cut_off = |p: usize, q: usize, i: usize| {
        let (inner, [least, greatest]) = edge_sides(cell, corners, [p, q], i);
        (inner >= 0 && greatest < 0) || (inner <= 0 && least > 0)
    };
    let apart = (0..D).any(beside)
        || (0..D).any(|p| (p + 1..D).any(|q| (0..3).any(|i| cut_off(p, q, i))))
        || (D == 3 && plane_misses(cell, corners));
    !apart
}

/// Whether the closed box lies in the closed triangle, which has an area; only
/// in the plane.
pub(super) fn lies_in_triangle<const D: usize>(cell: &Aabb<D>, corners: &[[f64; D]; 3]) -> bool {
    D == 2
        && (0..3).all(|i| {
            let (inner, [least, greatest]) = edge_sides(cell, corners, [0, 1], i);
            (inner > 0 && least >= 0) || (inner < 0 && greatest <= 0)
        })
}

/// Seen in the plane of two axes: the side of edge `i` on which the third
/// corner lies, and the least and greatest side of the box's corners.
fn edge_sides<const D: usize>(
    cell: &Aabb<D>,
    corners: &[[f64; D]; 3],
    [p, q]: [usize; 2],
    i: usize,
) -> (i8, [i8; 2]) {
    let flat = |c: [f64; D]| [c[p], c[q]];
    let [from, to, third] = [0, 1, 2].map(|k| flat(corners[(i + k) % 3]));
    // The side grows with the second coordinate where the edge runs up the
    // first one, and falls with the first where it runs up the second.
    let (low, high) = (flat(cell.min), flat(cell.max));
    let ordered = |e: usize, up: bool| if up { [low[e], high[e]] } else { [high[e], low[e]] };
    let [least_p, most_p] = ordered(0, to[1] < from[1]);
    let [least_q, most_q] = ordered(1, to[0] > from[0]);
    let sides = [[least_p, least_q], [most_p, most_q]].map(|corner| side(from, to, corner));
    (side(from, to, third), sides)
}

/// Sign of the area of the triangle `from`, `to`, `point`: 1 if it lies to the
/// left of the edge.
fn side(from: [f64; 2], to: [f64; 2], point: [f64; 2]) -> i8 {
    let left = (to[0] - from[0]) * (point[1] - from[1]);
    let right = (to[1] - from[1]) * (point[0] - from[0]);
    let magnitude = left.abs() + right.abs();
    let sum = left - right;
    if (LEAST..f64::MAX).contains(&magnitude) && sum.abs() > 4.0 * f64::EPSILON * magnitude {
        return if sum > 0.0 { 1 } else { -1 };
    }
    area(from, to, point).sign()
}

/// Twice the signed area of a triangle.
fn area(from: [f64; 2], to: [f64; 2], point: [f64; 2]) -> Scaled {
    let difference = |a: [f64; 2], e: usize| Scaled::difference(a[e], from[e]);
    let left = difference(to, 0).times(&difference(point, 1));
    left.plus(&difference(to, 1).times(&difference(point, 0)).negated())
}

/// Whether the whole box lies strictly on one side of the triangle's plane;
/// only in space.
fn plane_misses<const D: usize>(cell: &Aabb<D>, corners: &[[f64; D]; 3]) -> bool {
    // The normal's component along an axis is the area seen along that axis.
    let seen = |e: usize| corners.map(|c| [c[(e + 1) % D], c[(e + 2) % D]]);
    let normal: [i8; D] = std::array::from_fn(|e| {
        let [a, b, c] = seen(e);
        side(a, b, c)
    });
    let corner = |up: i8| {
        std::array::from_fn(|e| if normal[e] * up > 0 { cell.max[e] } else { cell.min[e] })
    };
    above(corners, corner(1)) < 0 || above(corners, corner(-1)) > 0
}

/// Sign of the volume that the triangle spans with `point`: 1 on the side to
/// which its normal points.
fn above<const D: usize>(corners: &[[f64; D]; 3], point: [f64; D]) -> i8 {
    let [a, b, c] = *corners;
    let (mut sum, mut magnitude) = (0.0, 0.0);
    for e in 0..D {
        let (p, q) = ((e + 1) % D, (e + 2) % D);
        let left = (b[p] - a[p]) * (c[q] - a[q]);
        let right = (b[q] - a[q]) * (c[p] - a[p]);
        let height = point[e] - a[e];
        sum += (left - right) * height;
        magnitude += (left.abs() + right.abs()) * height.abs();
    }
    if (LEAST..f64::MAX).contains(&magnitude) && sum.abs() > 16.0 * f64::EPSILON * magnitude {
        return if sum > 0.0 { 1 } else { -1 };
    }
    let mut sum = Scaled::of(0.0);
    for e in 0..D {
        let seen = |x: [f64; D]| [x[(e + 1) % D], x[(e + 2) % D]];
        let height = Scaled::difference(point[e], a[e]);
        sum = sum.plus(&area(seen(a), seen(b), seen(c)).times(&height));
    }
    sum.sign()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Corners on a lattice of eighths, far from 0, where differences are exact.
    fn lattice<const D: usize>(random: &mut Random, offset: f64) -> [f64; D] {
        [(); D].map(|()| offset + random.below(9) as f64 / 8.0)
    }

    /// Box of side `step`, aligned to it.
    fn cell<const D: usize>(random: &mut Random, offset: f64) -> Aabb<D> {
        let min = [(); D].map(|()| offset + random.below(4) as f64 / 4.0);
        Aabb { min, max: min.map(|x| x + 0.25) }
    }

    #[test]
    fn spheres_on_a_lattice_agree_with_integers() {
        let mut random = Random::new(1);
        for _ in 0..20_000 {
            let (cell, centre) = (cell::<3>(&mut random, 0.0), lattice::<3>(&mut random, 0.0));
            let radius = random.below(9) as f64 / 8.0;
            let eighths = |x: f64| (x * 8.0) as i64;
            let (mut nearest, mut farthest) = (0, 0);
            for (e, middle) in centre.map(eighths).into_iter().enumerate() {
                let gaps = [cell.min[e], cell.max[e]].map(|x| eighths(x) - middle);
                let outside = gaps[0].max(-gaps[1]).max(0);
                nearest += outside * outside;
                farthest += gaps.map(|g| g * g).into_iter().max().unwrap();
            }
            let (square, sphere) = (eighths(radius).pow(2), Sphere { centre, radius });
            assert_eq!(meets_ball(&cell, &sphere), nearest <= square);
            assert_eq!(meets_surface(&cell, &sphere), nearest <= square && square <= farthest);
            assert_eq!(lies_in_ball(&cell, &sphere), farthest <= square);
        }
    }

    #[test]
    fn a_sphere_one_bit_too_small_does_not_touch() {
        let cell = Aabb { min: [1.0; 3], max: [2.0; 3] };
        // 2² + 3² + 6² = 7².
        let touch = Sphere { centre: [-1.0, -2.0, -5.0], radius: 7.0 };
        let short = Sphere { radius: 7f64.next_down(), ..touch };
        assert!(meets_ball(&cell, &touch) && !meets_ball(&cell, &short));
    }

    /// Whether box and triangle meet, by cutting the triangle with the box's
    /// half-spaces in rational numbers: vertices are integers over `w`.
    fn cut<const D: usize>(cell: &Aabb<D>, corners: &[[f64; D]; 3]) -> bool {
        let integer = |x: f64| (x * 8.0) as i128;
        let mut polygon: Vec<([i128; D], i128)> =
            corners.iter().map(|c| (c.map(integer), 1)).collect();
        for e in 0..D {
            for (bound, sign) in [(integer(cell.min[e]), 1), (-integer(cell.max[e]), -1)] {
                let height = |(p, w): &([i128; D], i128)| sign * p[e] - bound * w;
                let mut kept = Vec::new();
                for (i, a) in polygon.iter().enumerate() {
                    let b = &polygon[(i + 1) % polygon.len()];
                    let (h, k) = (height(a), height(b));
                    if h >= 0 {
                        kept.push(*a);
                    }
                    if h.signum() * k.signum() < 0 {
                        // a/w + (b/v − a/w)·t with t = (h/w) / (h/w − k/v).
                        let (w, v) = (a.1, b.1);
                        let below = w * (h * v - k * w);
                        let point = std::array::from_fn(|f| {
                            a.0[f] * (h * v - k * w) + (b.0[f] * w - a.0[f] * v) * h
                        });
                        kept.push(reduced((point, below)));
                    }
                }
                polygon = kept;
            }
        }
        !polygon.is_empty()
    }

    fn reduced<const D: usize>((p, w): ([i128; D], i128)) -> ([i128; D], i128) {
        let gcd = |mut a: i128, mut b: i128| {
            while b != 0 {
                (a, b) = (b, a % b);
            }
            a.abs()
        };
        let divisor = p.iter().fold(w, |d, &x| gcd(d, x)).max(1) * w.signum();
        (p.map(|x| x / divisor), w / divisor)
    }

    fn triangles_agree_with_cutting<const D: usize>(seed: u64) {
        let mut random = Random::new(seed);
        let mut met = 0;
        for _ in 0..20_000 {
            let cell = cell::<D>(&mut random, 0.0);
            let corners = [(); 3].map(|()| lattice::<D>(&mut random, 0.0));
            let meets = meets_triangle(&cell, &corners);
            assert_eq!(meets, cut(&cell, &corners), "{cell:?} {corners:?}");
            met += usize::from(meets);
            // Moved far away, where doubles alone no longer decide.
            let far = |p: [f64; D]| p.map(|x| x + 2f64.powi(40));
            let moved = Aabb { min: far(cell.min), max: far(cell.max) };
            assert_eq!(meets_triangle(&moved, &corners.map(far)), meets);
        }
        assert!((2_000..18_000).contains(&met), "{met} of 20000 meet");
    }

    #[test]
    fn triangles_in_the_plane_agree_with_cutting() {
        triangles_agree_with_cutting::<2>(2);
    }

    #[test]
    fn triangles_in_space_agree_with_cutting() {
        triangles_agree_with_cutting::<3>(3);
    }

    #[test]
    fn a_cell_lies_in_a_triangle_if_its_corners_do() {
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let square = |side: f64| Aabb { min: [0.0; 2], max: [side; 2] };
        assert!(lies_in_triangle(&square(0.5), &corners));
        assert!(!lies_in_triangle(&square(0.5f64.next_up()), &corners));
    }

    #[test]
    fn boxes_do_not_fill_the_cells_that_they_only_touch() {
        let solid = Aabb { min: [0.25, 0.5], max: [0.5, 0.5] };
        let at = |x: f64, y: f64| Aabb { min: [x, y], max: [x + 0.25, y + 0.25] };
        assert!(meets_box(&at(0.25, 0.5), &solid));
        assert!(!meets_box(&at(0.5, 0.5), &solid) && !meets_box(&at(0.25, 0.25), &solid));
    }
}
