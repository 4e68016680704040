//! Ray parameters t of axis-parallel planes, and how two of them compare.
//!
//! All that a traversal decides, it decides by comparing such parameters.
//! Written over [`Parameter`], one algorithm runs in doubles and exactly.

use super::Scaled;
use std::cmp::Ordering;

/// Parameter t at which a ray meets a plane, or ±∞, or a given number. NaN only
/// where an algorithm runs with a misprint.
pub trait Parameter: Copy {
    /// Before every plane.
    const BEFORE_ALL: Self;
    /// Beyond every plane.
    const BEYOND_ALL: Self;
    /// The origin of the ray.
    const ORIGIN: Self;

    /// Parameter `(plane − origin) / direction` on one axis; `direction` is
    /// not zero.
    fn at_plane(plane: f64, origin: f64, direction: f64) -> Self;

    /// A given parameter, finite.
    fn given(t: f64) -> Self;

    /// Parameter of the mid plane as the mean of those of the near and the far
    /// plane; where comparisons are exact, that of `mid`, the plane itself.
    fn mean(near: Self, far: Self, mid: Self) -> Self;

    /// Whether `plane` is passed midway between `from` and `to`, two parameters
    /// between which no plane is met. Where comparisons are exact, that is
    /// whether it is passed at `from`.
    fn passed_midway(plane: Self, from: Self, to: Self) -> bool;

    /// The nearest double, for showing.
    fn value(self) -> f64;

    /// Whether `self` comes before `other`.
    fn before(self, other: Self) -> bool;

    /// Whether `self` comes before or with `other`.
    #[inline]
    fn not_after(self, other: Self) -> bool {
        !other.before(self)
    }

    /// The later of the two.
    #[inline]
    fn later(self, other: Self) -> Self {
        if self.before(other) { other } else { self }
    }

    /// The earlier of the two.
    #[inline]
    fn earlier(self, other: Self) -> Self {
        if other.before(self) { other } else { self }
    }
}

/// Doubles. A correctly rounded quotient keeps exact ties equal whenever the
/// difference `plane − origin` is exact.
impl Parameter for f64 {
    const BEFORE_ALL: Self = f64::NEG_INFINITY;
    const BEYOND_ALL: Self = f64::INFINITY;
    const ORIGIN: Self = 0.0;

    #[inline]
    fn at_plane(plane: f64, origin: f64, direction: f64) -> Self {
        (plane - origin) / direction
    }

    #[inline]
    fn given(t: f64) -> Self {
        t
    }

    #[inline]
    fn mean(near: Self, far: Self, _mid: Self) -> Self {
        0.5 * (near + far)
    }

    #[inline]
    fn passed_midway(plane: Self, from: Self, to: Self) -> bool {
        // The middle of neighbouring doubles is rounded to one of them, at which
        // the plane at the end of the piece would seem passed already.
        plane <= 0.5 * from + 0.5 * to && plane < to
    }

    #[inline]
    fn value(self) -> f64 {
        self
    }

    #[inline]
    fn before(self, other: Self) -> bool {
        self < other
    }
}

/// Parameter that keeps its operands, so that comparisons are exact for any
/// finite input: doubles decide where their error bound allows it, integers of
/// any length where not.
#[derive(Clone, Copy, Debug)]
pub struct Exact {
    value: f64,
    plane: f64,
    origin: f64,
    /// Zero marks constants, whose `value` is exact.
    direction: f64,
}

impl Exact {
    const fn constant(value: f64) -> Self {
        Self { value, plane: 0.0, origin: 0.0, direction: 0.0 }
    }

    /// Numerator and positive denominator.
    fn fraction(self) -> [Scaled; 2] {
        if self.direction == 0.0 {
            return [Scaled::of(self.value), Scaled::of(1.0)];
        }
        let numerator = Scaled::difference(self.plane, self.origin);
        if self.direction > 0.0 {
            [numerator, Scaled::of(self.direction)]
        } else {
            [numerator.negated(), Scaled::of(-self.direction)]
        }
    }

    /// Sign of the quotient; of a constant, its own.
    #[inline]
    fn sign(self) -> i8 {
        let sign_of = |x: f64| i8::from(x > 0.0) - i8::from(x < 0.0);
        if self.direction == 0.0 {
            return sign_of(self.value);
        }
        let ahead = i8::from(self.plane > self.origin) - i8::from(self.plane < self.origin);
        ahead * sign_of(self.direction)
    }

    fn compare_exactly(self, other: Self) -> Ordering {
        let [a, b] = self.fraction();
        let [c, d] = other.fraction();
        a.times(&d).compare(&c.times(&b))
    }
}

impl Parameter for Exact {
    const BEFORE_ALL: Self = Self::constant(f64::NEG_INFINITY);
    const BEYOND_ALL: Self = Self::constant(f64::INFINITY);
    const ORIGIN: Self = Self::constant(0.0);

    #[inline]
    fn at_plane(plane: f64, origin: f64, direction: f64) -> Self {
        Self { value: (plane - origin) / direction, plane, origin, direction }
    }

    #[inline]
    fn given(t: f64) -> Self {
        Self::constant(t)
    }

    #[inline]
    fn mean(_near: Self, _far: Self, mid: Self) -> Self {
        mid
    }

    #[inline]
    fn passed_midway(plane: Self, from: Self, _to: Self) -> bool {
        plane.not_after(from)
    }

    #[inline]
    fn value(self) -> f64 {
        self.value
    }

    #[inline]
    fn before(self, other: Self) -> bool {
        // −∞ and +∞ lie outside all planes, even those whose quotient overflows.
        let infinity = |p: Self| match p.direction == 0.0 && p.value.is_infinite() {
            true => p.value.signum(),
            false => 0.0,
        };
        let (i, j) = (infinity(self), infinity(other));
        if i != 0.0 || j != 0.0 {
            return i < j;
        }

        // Difference and quotient are rounded once each: three units in 2^-53
        // bound the relative error, unless a quotient leaves the normal range.
        const ERROR: f64 = 3.0 * f64::EPSILON;
        let (a, b) = (self.value, other.value);
        let gap = (a - b).abs();
        if a.is_normal() && b.is_normal() && gap > ERROR * a.abs().max(b.abs()) {
            return a < b;
        }
        // Signs are exact whatever the rounding; the origin is told apart by them.
        let (i, j) = (self.sign(), other.sign());
        if i != j || i == 0 {
            return i < j;
        }
        self.compare_exactly(other) == Ordering::Less
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(plane: f64, origin: f64, direction: f64) -> Exact {
        Exact::at_plane(plane, origin, direction)
    }

    #[test]
    fn exact_ties_are_no_order() {
        let (a, b) = (at(1.0, 0.0, 3.0), at(2.0, 1.0, 3.0));
        assert!(!a.before(b) && !b.before(a));
    }

    #[test]
    fn differences_below_a_double_are_seen() {
        // 1 − 2^-60 and 1 − 2^-61 both round to 1.
        let tiny = 2f64.powi(-60);
        let (a, b) = (at(1.0, tiny, 1.0), at(1.0, tiny / 2.0, 1.0));
        assert_eq!(a.value(), b.value());
        assert!(a.before(b) && !b.before(a));
    }

    #[test]
    fn quotients_beyond_the_range_of_doubles_are_ordered() {
        let (a, b) = (at(1.0, 0.0, 1e-320), at(2.0, 0.0, 1e-320));
        assert!(a.value().is_infinite() && b.value().is_infinite());
        assert!(a.before(b) && !b.before(a));
        assert!(b.before(Exact::BEYOND_ALL) && !Exact::BEYOND_ALL.before(b));
        assert!(Exact::BEFORE_ALL.before(Exact::BEYOND_ALL));
        let (c, d) = (at(1e-300, 0.0, 1e300), at(2e-300, 0.0, 1e300));
        assert!(c.before(d) && Exact::ORIGIN.before(c) && !c.before(Exact::ORIGIN));
    }

    #[test]
    fn given_parameters_are_exact() {
        let third = at(1.0, 0.0, 3.0);
        let [below, above] = [Exact::given(1.0 / 3.0), Exact::given((1.0f64 / 3.0).next_up())];
        assert_eq!(third.value(), below.value());
        assert!(below.before(third) && third.before(above));
        assert!(!at(1.0, 0.5, 2.0).before(Exact::given(0.25)));
    }

    #[test]
    fn negative_directions_keep_the_order() {
        let (a, b) = (at(0.0, 1.0, -2.0), at(0.0, 1.0, -1.0));
        assert!(a.before(b) && !b.before(a));
    }
}
