//! Parameters whose comparison is exact.

use super::{Axes, Parameter, Scaled, Short};
use std::cmp::Ordering;

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

    /// Whether `self` comes before `other`, whatever their values. Signs and
    /// planes of one axis tell most of what is close; fractions in integers the
    /// rest.
    #[cold]
    fn comes_before(self, other: Self) -> bool {
        // −∞ and +∞ lie outside all planes, even those whose quotient overflows;
        // other constants are their own values.
        match (self.direction == 0.0, other.direction == 0.0) {
            (true, true) => return self.value < other.value,
            (true, false) if self.value.is_infinite() => return self.value < 0.0,
            (false, true) if other.value.is_infinite() => return other.value > 0.0,
            (true, false) | (false, true) | (false, false) => {}
        }
        if self.origin == other.origin && self.direction == other.direction {
            let forward = self.direction > 0.0;
            return if forward { self.plane < other.plane } else { other.plane < self.plane };
        }
        // Signs are exact whatever the rounding; the origin is told apart by them.
        let (i, j) = (self.sign(), other.sign());
        if i != j || i == 0 {
            return i < j;
        }
        let order = self.compare_short(other).unwrap_or_else(|| self.compare_long(other));
        order == Ordering::Less
    }

    fn compare_short(self, other: Self) -> Option<Ordering> {
        let fraction = |p: Self| {
            if p.direction == 0.0 {
                return Some([Short::of(p.value), Short::of(1.0)]);
            }
            let numerator = Short::difference(p.plane, p.origin)?;
            let numerator = if p.direction > 0.0 { numerator } else { numerator.negated() };
            Some([numerator, Short::of(p.direction.abs())])
        };
        let ([a, b], [c, d]) = (fraction(self)?, fraction(other)?);
        a.times(d)?.compare(c.times(b)?)
    }

    fn compare_long(self, other: Self) -> Ordering {
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
    fn mean(_near: Self, _far: Self, mid: impl FnOnce() -> Self) -> Self {
        mid()
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
    fn latest<const D: usize>(parameters: [Self; D]) -> Self {
        match told(&parameters, 1.0) {
            Some(index) => parameters[index],
            None => parameters.into_iter().fold(Self::BEFORE_ALL, Self::later),
        }
    }

    #[inline]
    fn earliest<const D: usize>(parameters: [Self; D]) -> Self {
        match told(&parameters, -1.0) {
            Some(index) => parameters[index],
            None => parameters.into_iter().fold(Self::BEYOND_ALL, Self::earlier),
        }
    }

    #[inline]
    fn before(self, other: Self) -> bool {
        let (a, b) = (self.value, other.value);
        let smaller = if a.abs() < b.abs() { a.abs() } else { b.abs() };
        if is_told(a, b, smaller) { a < b } else { self.comes_before(other) }
    }

    #[inline(always)]
    fn index_of_latest<const D: usize>(parameters: [Self; D]) -> usize {
        told(&parameters, 1.0).unwrap_or_else(|| first_of_latest(&parameters))
    }

    #[inline(always)]
    fn first<const D: usize>(parameters: [Self; D]) -> (Self, Axes<D>) {
        match told(&parameters, -1.0) {
            Some(axis) => (parameters[axis], Axes::one(axis)),
            None => all_first(parameters),
        }
    }

    #[inline(always)]
    fn passed<const D: usize>(parameters: [Self; D], now: Self) -> Axes<D> {
        let mut all_told = true;
        for axis in 0..D {
            all_told &= is_told(parameters[axis].value, now.value, now.value.abs());
        }
        if all_told {
            Axes::of(|axis| parameters[axis].value <= now.value)
        } else {
            all_passed(parameters, now)
        }
    }
}

// What is left where doubles do not tell.

#[cold]
fn first_of_latest<const D: usize>(parameters: &[Exact; D]) -> usize {
    let later = |a: usize, b: usize| if parameters[a].before(parameters[b]) { b } else { a };
    (1..D).fold(0, later)
}

#[cold]
fn all_first<const D: usize>(parameters: [Exact; D]) -> (Exact, Axes<D>) {
    let first = parameters.into_iter().fold(Exact::BEYOND_ALL, Exact::earlier);
    (first, all_passed(parameters, first))
}

#[cold]
fn all_passed<const D: usize>(parameters: [Exact; D], now: Exact) -> Axes<D> {
    Axes::of(|axis| parameters[axis].not_after(now))
}

/// Bound of the error of two parameters of about the same size, relative to one of
/// them: difference and quotient are rounded once each, so that a value is off by
/// 2^-52 of itself at most, and by less than the smallest normal number where the
/// quotient is too small for that.
const ERROR: f64 = 6.0 * f64::EPSILON;

/// The gap between two values above which their order is that of their parameters;
/// `size` is the size of one of them. If the other is of more than twice that size, they
/// are far enough from each other anyway.
#[inline(always)]
pub(super) fn bound(size: f64) -> f64 {
    ERROR * size + f64::MIN_POSITIVE
}

/// Whether the order of two values tells that of their parameters. Infinite values tell
/// nothing: a difference that overflows may have a small quotient.
#[inline(always)]
fn is_told(a: f64, b: f64, size: f64) -> bool {
    let gap = (a - b).abs();
    (gap > bound(size)) & (gap < f64::INFINITY)
}

/// Index of the largest of some values, or of the smallest if `sign` is −1, of the first
/// of equal ones; and whether it is told from all others.
#[inline(always)]
pub(super) fn leading<const D: usize>(
    mut values: [f64; D],
    sign: f64,
    is_told: impl Fn(f64, f64, f64) -> bool,
) -> (usize, bool) {
    for index in 0..D {
        values[index] *= sign;
    }
    let mut first = 0;
    for index in 1..D {
        first = if values[index] > values[first] { index } else { first };
    }
    let mut all_told = true;
    for index in 0..D {
        let told = is_told(values[first], values[index], values[first].abs());
        all_told &= (index == first) | told;
    }
    (first, all_told)
}

/// Index of the latest of some parameters, or of the earliest if `sign` is −1; `None`
/// if rounding may have made it so.
#[inline(always)]
fn told<const D: usize>(parameters: &[Exact; D], sign: f64) -> Option<usize> {
    let (first, all_told) = leading(parameters.map(|p| p.value), sign, is_told);
    all_told.then_some(first)
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

    /// Order of two parameters by integers of any length alone.
    fn order(a: Exact, b: Exact) -> Ordering {
        let infinite = |p: Exact| match p.direction == 0.0 && p.value.is_infinite() {
            true => p.value.signum() as i8,
            false => 0,
        };
        match infinite(a).cmp(&infinite(b)) {
            Ordering::Equal if infinite(a) == 0 => a.compare_long(b),
            order => order,
        }
    }

    #[test]
    fn shortcuts_decide_as_integers_do() {
        let mut random = crate::random::Random::new(2);
        let smallest = f64::from_bits(1);
        let special = [
            0.0,
            -0.0,
            1.0,
            -1.0,
            3.0,
            1.0 / 3.0,
            smallest,
            -smallest,
            f64::MIN_POSITIVE,
            f64::MIN_POSITIVE.next_down(),
            f64::MAX,
            f64::MIN,
            f64::MAX / 3.0,
            1.0f64.next_up(),
            1e-300,
            1e300,
        ];
        let mut number = move || {
            let x = special[random.below(special.len() as u64) as usize];
            match random.below(6) {
                0 => x.next_up().clamp(f64::MIN, f64::MAX),
                1 => x.next_down().clamp(f64::MIN, f64::MAX),
                2 => random.between(-2.0, 2.0),
                3 | 4 => random.below(8) as f64 - 4.0,
                _ => x,
            }
        };
        let mut parameter = move || {
            let [plane, origin, direction] = std::array::from_fn(|_| number());
            if direction != 0.0 {
                return at(plane, origin, direction);
            }
            match plane {
                0.0 => Exact::ORIGIN,
                1.0 => Exact::BEYOND_ALL,
                -1.0 => Exact::BEFORE_ALL,
                other => Exact::given(other),
            }
        };
        let mut ties = 0;
        for _ in 0..200_000 {
            let (a, b) = (parameter(), parameter());
            let expected = order(a, b);
            assert_eq!(a.before(b), expected == Ordering::Less, "{a:?} {b:?}");
            assert_eq!(b.before(a), expected == Ordering::Greater, "{a:?} {b:?}");
            assert!(!a.before(a));
            ties += usize::from(expected == Ordering::Equal);
        }
        assert!(ties > 300, "{ties}");
    }

    #[test]
    fn a_zero_of_either_sign_is_the_origin() {
        for origin in [0.0, -0.0] {
            for direction in [1.0, -1.0, f64::from_bits(1), f64::MAX] {
                let now = at(-0.0, origin, direction);
                assert!(!now.before(Exact::ORIGIN) && !Exact::ORIGIN.before(now));
            }
        }
    }
}
