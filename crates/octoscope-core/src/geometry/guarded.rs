//! Parameters in doubles that notice where these do not decide.

use super::exact::{bound, leading};
use super::{Axes, Parameter};
use std::cell::Cell;

/// Parameter in doubles. Where their error bound does not tell which of two comes
/// first, the comparison is doubtful: [`doubt`] is told, and all that follows is of no
/// worth. Whoever compares a parameter with itself is in doubt, too.
///
/// Quotients must be finite: those of the root's planes, and hence all.
#[derive(Clone, Copy, Debug)]
pub struct Guarded(f64);

thread_local! {
    static DOUBTFUL: Cell<bool> = const { Cell::new(false) };
}

/// Whether a comparison on this thread was doubtful since [`trust`].
#[inline(always)]
pub fn doubt() -> bool {
    DOUBTFUL.get()
}

/// Begins anew, without doubt.
#[inline]
pub fn trust() {
    DOUBTFUL.set(false);
}

/// Whether the order of two values is that of their parameters; `size` is the size of one
/// of them.
#[inline(always)]
fn is_told(a: f64, b: f64, size: f64) -> bool {
    (a - b).abs() > bound(size)
}

/// Begins to doubt, but not if all values that the error bound does not tell from `value`
/// are infinite: these stand for planes of axes without motion, and are exact.
#[cold]
fn wonder(value: f64, others: &[f64]) {
    let is_exact = |&other: &f64| value.is_infinite() || other.is_infinite();
    let is_sure = |other: &f64| is_exact(other) || is_told(value, *other, value.abs());
    if !others.iter().all(is_sure) {
        DOUBTFUL.set(true);
    }
}

#[cold]
fn wonder_at_others<const D: usize>(parameters: [Guarded; D], leading: usize) {
    for other in (0..D).filter(|&other| other != leading) {
        wonder(parameters[leading].0, &[parameters[other].0]);
    }
}

impl Parameter for Guarded {
    const BEFORE_ALL: Self = Self(f64::NEG_INFINITY);
    const BEYOND_ALL: Self = Self(f64::INFINITY);
    const ORIGIN: Self = Self(0.0);

    #[inline]
    fn at_plane(plane: f64, origin: f64, direction: f64) -> Self {
        Self((plane - origin) / direction)
    }

    #[inline]
    fn given(t: f64) -> Self {
        Self(t)
    }

    #[inline]
    fn mean(_near: Self, _far: Self, mid: impl FnOnce() -> Self) -> Self {
        mid()
    }

    #[inline]
    fn passed_midway(plane: Self, from: Self, to: Self) -> bool {
        // No plane lies between the ends, so the middle tells as well as they do; it is
        // after the origin, and of the error of its ends.
        plane.not_after(Self(0.5 * from.0 + 0.5 * to.0))
    }

    #[inline]
    fn value(self) -> f64 {
        self.0
    }

    #[inline(always)]
    fn before(self, other: Self) -> bool {
        let (a, b) = (self.0, other.0);
        let smaller = if a.abs() < b.abs() { a.abs() } else { b.abs() };
        if !is_told(a, b, smaller) {
            wonder(a, &[b]);
        }
        a < b
    }

    #[inline]
    fn latest<const D: usize>(parameters: [Self; D]) -> Self {
        parameters[Self::index_of_latest(parameters)]
    }

    #[inline]
    fn earliest<const D: usize>(parameters: [Self; D]) -> Self {
        let (earliest, all_told) = leading(parameters.map(Self::value), -1.0, is_told);
        if !all_told {
            wonder_at_others(parameters, earliest);
        }
        parameters[earliest]
    }

    #[inline(always)]
    fn index_of_latest<const D: usize>(parameters: [Self; D]) -> usize {
        let (latest, all_told) = leading(parameters.map(Self::value), 1.0, is_told);
        if !all_told {
            wonder_at_others(parameters, latest);
        }
        latest
    }

    #[inline(always)]
    fn first<const D: usize>(parameters: [Self; D]) -> (Self, Axes<D>) {
        let (first, all_told) = leading(parameters.map(Self::value), -1.0, is_told);
        if !all_told {
            DOUBTFUL.set(true);
        }
        (parameters[first], Axes::one(first))
    }

    #[inline(always)]
    fn passed<const D: usize>(parameters: [Self; D], now: Self) -> Axes<D> {
        let mut all_told = true;
        for axis in 0..D {
            all_told &= is_told(parameters[axis].0, now.0, now.0.abs());
        }
        if !all_told {
            wonder(now.0, &parameters.map(Self::value));
        }
        Axes::of(|axis| parameters[axis].0 <= now.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether comparing is doubtful.
    fn is_doubtful(compare: impl FnOnce()) -> bool {
        trust();
        compare();
        doubt()
    }

    #[test]
    fn only_what_is_close_is_doubtful() {
        let at = |plane: f64| Guarded::at_plane(plane, 0.1, 0.7);
        let before = |a: Guarded, b: Guarded| is_doubtful(|| assert_eq!(a.before(b), a.0 < b.0));
        assert!(!before(at(0.3), at(0.30000001)) && !before(at(0.3), Guarded::ORIGIN));
        assert!(before(at(0.3), at(0.3)) && before(at(0.3), Guarded(at(0.3).0.next_up())));
        assert!(before(at(0.1), Guarded::ORIGIN));
        for end in [Guarded::BEFORE_ALL, Guarded::BEYOND_ALL] {
            assert!(!before(at(0.3), end) && !before(end, end) && !before(end, Guarded::ORIGIN));
        }
    }

    #[test]
    fn axes_without_motion_are_in_no_doubt() {
        let still = [Guarded::BEFORE_ALL, Guarded(0.5), Guarded::BEYOND_ALL];
        assert!(!is_doubtful(|| assert_eq!(Guarded::passed(still, Guarded(0.7)), Axes(0b110))));
        let beside = [Guarded::BEYOND_ALL, Guarded(0.5), Guarded::BEYOND_ALL];
        assert!(!is_doubtful(|| assert_eq!(Guarded::latest(beside).0, f64::INFINITY)));
        let far = [Guarded::BEYOND_ALL, Guarded(0.5), Guarded::BEYOND_ALL];
        assert!(!is_doubtful(|| assert_eq!(Guarded::first(far).1, Axes(0b010))));
        let tie = [Guarded(0.5), Guarded(0.5), Guarded(0.75)];
        assert!(is_doubtful(|| assert_eq!(Guarded::first(tie).0.0, 0.5)));
    }
}
