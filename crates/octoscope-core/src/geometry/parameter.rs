//! Ray parameters t of axis-parallel planes, and how two of them compare.
//!
//! All that a traversal decides, it decides by comparing such parameters.
//! Written over [`Parameter`], one algorithm runs in doubles and exactly.

use super::Axes;

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
    /// plane; where comparisons are exact, `mid`, that of the plane itself.
    fn mean(near: Self, far: Self, mid: impl FnOnce() -> Self) -> Self;

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

    /// The latest of some parameters.
    #[inline]
    fn latest<const D: usize>(parameters: [Self; D]) -> Self {
        parameters.into_iter().fold(Self::BEFORE_ALL, Self::later)
    }

    /// The earliest of some parameters.
    #[inline]
    fn earliest<const D: usize>(parameters: [Self; D]) -> Self {
        parameters.into_iter().fold(Self::BEYOND_ALL, Self::earlier)
    }

    /// Index of the latest of some parameters, of the first one if several come
    /// together.
    #[inline(always)]
    fn index_of_latest<const D: usize>(parameters: [Self; D]) -> usize {
        let mut latest = 0;
        for index in 1..D {
            latest = if parameters[latest].before(parameters[index]) { index } else { latest };
        }
        latest
    }

    /// The earliest of some parameters, one an axis, and the axes of all that come
    /// with it.
    #[inline(always)]
    fn first<const D: usize>(parameters: [Self; D]) -> (Self, Axes<D>) {
        let first = Self::earliest(parameters);
        (first, Self::passed(parameters, first))
    }

    /// The axes whose parameters come before or with `now`.
    #[inline(always)]
    fn passed<const D: usize>(parameters: [Self; D], now: Self) -> Axes<D> {
        Axes::of(|axis| parameters[axis].not_after(now))
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
    fn mean(near: Self, far: Self, _mid: impl FnOnce() -> Self) -> Self {
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
