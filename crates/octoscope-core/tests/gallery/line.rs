//! Where a line is, in integers of any length: nothing is shared with the program.

use num_bigint::BigInt;
use octoscope_core::geometry::{Aabb, Ray};
use std::cmp::Ordering;

/// A double in units of the smallest one there is.
fn integer(x: f64) -> BigInt {
    let bits = x.to_bits();
    let (exponent, digits) = (bits >> 52 & 0x7ff, bits & ((1 << 52) - 1));
    let magnitude = match exponent {
        0 => BigInt::from(digits),
        _ => BigInt::from(digits | 1 << 52) << (exponent - 1),
    };
    if x < 0.0 { -magnitude } else { magnitude }
}

/// A parameter: a fraction whose denominator is above 0.
#[derive(Clone, Debug)]
pub struct At(BigInt, BigInt);

impl At {
    /// t = 0.
    pub fn origin() -> Self {
        Self(BigInt::from(0), BigInt::from(1))
    }

    /// t = `a / b`.
    pub fn ratio(a: u32, b: u32) -> Self {
        Self(a.into(), b.into())
    }

    fn new(distance: BigInt, speed: BigInt) -> Self {
        if speed < BigInt::from(0) { Self(-distance, -speed) } else { Self(distance, speed) }
    }
}

impl PartialEq for At {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for At {}

impl PartialOrd for At {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for At {
    fn cmp(&self, other: &Self) -> Ordering {
        (&self.0 * &other.1).cmp(&(&other.0 * &self.1))
    }
}

/// Parameters between which the line of the ray is between all planes of the closed
/// box; the first is the larger one where it never is. `None` if it rests outside.
pub fn between<const D: usize>(ray: &Ray<D>, bounds: Aabb<D>) -> Option<[At; 2]> {
    let (mut enter, mut exit): (Option<At>, Option<At>) = (None, None);
    for e in 0..D {
        let (origin, direction) = (ray.origin()[e], ray.direction()[e]);
        if direction == 0.0 {
            if origin < bounds.min[e] || origin > bounds.max[e] {
                return None;
            }
            continue;
        }
        let at = |plane| At::new(integer(plane) - integer(origin), integer(direction));
        let mut planes = [at(bounds.min[e]), at(bounds.max[e])];
        planes.sort();
        let [near, far] = planes;
        enter = Some(enter.map_or(near.clone(), |enter| enter.max(near)));
        exit = Some(exit.map_or(far.clone(), |exit| exit.min(far)));
    }
    enter.zip(exit).map(<[At; 2]>::from)
}

/// Whether the ray comes to the point, after t = 0.
pub fn passes<const D: usize>(ray: &Ray<D>, point: [f64; D]) -> bool {
    let at_point = between(ray, Aabb { min: point, max: point });
    at_point.is_some_and(|[enter, exit]| enter == exit && exit > At::origin())
}

/// Whether the points are as far from each other as `length` at least.
pub fn is_as_far<const D: usize>(from: [f64; D], to: [f64; D], length: f64) -> bool {
    let squares = (0..D).map(|e| (integer(to[e]) - integer(from[e])).pow(2));
    squares.sum::<BigInt>() >= integer(length).pow(2)
}

#[test]
fn doubles_are_integers_of_the_smallest_one() {
    assert_eq!(integer(f64::from_bits(1)), BigInt::from(1));
    assert_eq!(integer(1.0), BigInt::from(1) << 1074);
    assert_eq!(integer(-0.75), BigInt::from(-3) << 1072);
    assert_ne!(integer(0.1) + integer(0.2), integer(0.1 + 0.2));
}

#[test]
fn a_line_is_between_planes() {
    let unit = Aabb { min: [0.0; 2], max: [1.0; 2] };
    let check = |origin, direction, expected| {
        let ray = Ray::new(origin, direction).expect("the numbers make a ray");
        assert_eq!(between(&ray, unit).map(|[enter, exit]| enter.cmp(&exit)), expected);
    };
    check([-1.0, 0.5], [1.0, 0.0], Some(Ordering::Less));
    check([-1.0, 0.0], [1.0, 1.0], Some(Ordering::Equal));
    check([-1.0, 0.1], [1.0, 1.0], Some(Ordering::Greater));
    check([-1.0, 1.5], [1.0, 0.0], None);
}
