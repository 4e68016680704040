//! Families of rays with two parameters, each a picture with a ray at every place.
//!
//! Places are (u, v) with 0 ≤ u, v ≤ 1, u to the right and v upwards.

use crate::geometry::Ray;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Rays with two parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Family<const D: usize> {
    /// All lines that meet a disc in the plane, begun outside of it: u is the angle of
    /// the direction, 0 … 2π; v the signed distance of the centre to the right of the
    /// line, −radius … radius. In space nothing but the lines parallel to the xy plane.
    Lines {
        /// Centre of the disc.
        centre: [f64; D],
        /// Its radius, above 0.
        radius: f64,
    },
    /// Rays from one point in space: u turns to the right, v upwards.
    Sight {
        /// Where all begin.
        origin: [f64; D],
        /// Unit vectors to the right, up and ahead, at right angles.
        frame: [[f64; D]; 3],
        /// Largest angle to each side and upwards, in radians, at most π and π/2.
        spread: [f64; 2],
        /// Length of the directions, above 0.
        length: f64,
    },
}

impl<const D: usize> Family<D> {
    /// All lines that meet the cube of side `side` at `min`.
    pub fn lines(min: [f64; D], side: f64) -> Self {
        let centre = min.map(|x| x + 0.5 * side);
        Self::Lines { centre, radius: 0.5 * side * (D as f64).sqrt() }
    }

    /// Rays from `origin` towards the cube of side `side` at `min`: all that meet it if
    /// it begins outside, else all there are. Directions have the length `length`.
    pub fn sight(origin: [f64; D], min: [f64; D], side: f64, length: f64) -> Self {
        let radius = 0.5 * side * (D as f64).sqrt();
        let to_centre: [f64; D] = std::array::from_fn(|e| min[e] + 0.5 * side - origin[e]);
        let distance = norm(to_centre);
        let (ahead, spread) = if distance > radius {
            let half = (radius / distance).asin();
            (to_centre.map(|x| x / distance), [half, half])
        } else {
            let mut x = [0.0; D];
            x[0] = 1.0;
            (x, [PI, FRAC_PI_2])
        };
        Self::Sight { origin, frame: upright(ahead), spread, length }
    }

    /// The ray at a place; `None` where its numbers are not finite.
    pub fn ray(&self, [u, v]: [f64; 2]) -> Option<Ray<D>> {
        match *self {
            Self::Lines { centre, radius } => {
                let (sin, cos) = (TAU * u).sin_cos();
                let offset = radius * (2.0 * v - 1.0);
                // A little outside, so that a line never begins in the disc.
                let back = 1.125 * radius;
                let along = |[x, y]: [f64; 2]| {
                    std::array::from_fn(|e| match e {
                        0 => x,
                        1 => y,
                        _ => 0.0,
                    })
                };
                let [direction, left]: [[f64; D]; 2] = [along([cos, sin]), along([-sin, cos])];
                let origin =
                    std::array::from_fn(|e| centre[e] + offset * left[e] - back * direction[e]);
                Ray::new(origin, direction.map(|d| 2.0 * back * d)).ok()
            }
            Self::Sight { origin, frame: [right, up, ahead], spread, length } => {
                let (turn, rise) = ((2.0 * u - 1.0) * spread[0], (2.0 * v - 1.0) * spread[1]);
                let [(st, ct), (sr, cr)] = [turn.sin_cos(), rise.sin_cos()];
                let direction = std::array::from_fn(|e| {
                    length * (cr * (ct * ahead[e] + st * right[e]) + sr * up[e])
                });
                Ray::new(origin, direction).ok()
            }
        }
    }

    /// The place of the line on which `ray` lies, also outside of 0 … 1.
    pub fn place(&self, ray: &Ray<D>) -> [f64; 2] {
        let direction = ray.direction();
        match *self {
            Self::Lines { centre, radius } => {
                let [x, y] = [direction[0], direction[1]];
                let angle = y.atan2(x).rem_euclid(TAU);
                let from_centre = [ray.origin()[0] - centre[0], ray.origin()[1] - centre[1]];
                let offset = (x * from_centre[1] - y * from_centre[0]) / x.hypot(y);
                [angle / TAU, 0.5 * (1.0 + offset / radius)]
            }
            Self::Sight { frame, spread, .. } => {
                let [right, up, ahead] = frame.map(|axis| dot(axis, direction));
                let (turn, rise) = (right.atan2(ahead), up.atan2(right.hypot(ahead)));
                [0.5 * (1.0 + turn / spread[0]), 0.5 * (1.0 + rise / spread[1])]
            }
        }
    }
}

/// Unit vectors to the right and up for one that points ahead; up is z as far as it can.
fn upright<const D: usize>(ahead: [f64; D]) -> [[f64; D]; 3] {
    let [x, y] = [ahead[0], ahead[1]];
    let level = x.hypot(y);
    let mut right = [0.0; D];
    // Straight up or down, any side is the right one.
    [right[0], right[1]] = if level > 0.0 { [y / level, -x / level] } else { [1.0, 0.0] };
    let mut up = [0.0; D];
    if D > 2 {
        up[0] = right[1] * ahead[2];
        up[1] = -right[0] * ahead[2];
        up[2] = right[0] * ahead[1] - right[1] * ahead[0];
    }
    [right, up, ahead]
}

fn dot<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    (0..D).map(|e| a[e] * b[e]).sum()
}

fn norm<const D: usize>(a: [f64; D]) -> f64 {
    dot(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check_places<const D: usize>(family: Family<D>) {
        for i in 1..20 {
            for j in 1..20 {
                let place = [f64::from(i) / 20.0, f64::from(j) / 20.0];
                let found = family.place(&family.ray(place).unwrap());
                assert!((0..2).all(|e| (found[e] - place[e]).abs() < 1e-12), "{place:?} {found:?}");
            }
        }
    }

    #[test]
    fn every_place_is_that_of_its_ray() {
        check_places(Family::lines([-1.0, 2.0], 4.0));
        check_places(Family::sight([3.0, -2.0, 5.0], [0.0; 3], 1.0, 2.0));
        check_places(Family::sight([0.25; 3], [0.0; 3], 1.0, 2.0));
        check_places(Family::sight([0.5, 0.5, 9.0], [0.0; 3], 1.0, 2.0));
    }

    #[test]
    fn lines_begin_outside_and_end_beyond_the_disc() {
        let Family::Lines { centre, radius } = Family::lines([0.0; 2], 1.0) else { panic!() };
        let family = Family::Lines { centre, radius };
        for i in 0..=20 {
            let ray = family.ray([f64::from(i) / 20.0, 0.3]).unwrap();
            for t in [0.0, 1.0] {
                let end = ray.at(t);
                assert!((end[0] - centre[0]).hypot(end[1] - centre[1]) > radius);
            }
        }
    }

    #[test]
    fn the_corners_of_a_cube_before_the_origin_are_in_sight() {
        let (origin, min, side) = ([3.0, 0.2, -1.0], [0.0; 3], 1.0);
        let family = Family::sight(origin, min, side, 1.0);
        for corner in 0..8 {
            let at: [f64; 3] = std::array::from_fn(|e| f64::from(corner >> e & 1) * side);
            let ray = Ray::new(origin, std::array::from_fn(|e| at[e] - origin[e])).unwrap();
            let [u, v] = family.place(&ray);
            assert!((0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v), "{u} {v}");
        }
    }

    #[test]
    fn a_line_through_the_centre_lies_in_the_middle() {
        let family = Family::lines([0.0; 2], 1.0);
        let ray = Ray::new([0.0, 0.5], [0.0, 0.25]).unwrap();
        assert_eq!(family.place(&ray)[0], 0.25);
        let middle = Ray::new([0.5, -3.0], [0.0, 1.0]).unwrap();
        assert_eq!(family.place(&middle), [0.25, 0.5]);
        // The centre lies to the right of what goes up at its left.
        assert!(family.place(&ray)[1] > 0.5);
    }
}
