//! The oracle: every leaf is tested by itself, in exact arithmetic.
//!
//! All coordinates are turned into integers of one common unit, those of the
//! direction likewise. A leaf's interval of t is then a pair of fractions, and
//! fractions are compared by multiplying crosswise: in 128 bits where the
//! numbers are short enough, in integers of any length where not. O(leaves).
//!
//! This file shares no arithmetic with the algorithms that are checked against
//! it: not the clipping, not the parameters, not their comparison.

use super::algorithm::{Options, StopAt};
use crate::event::{End, Event, Observer, Outcome};
use crate::geometry::{Aabb, Axes, Ray};
use crate::tree::{Node, Tree};
use num_bigint::BigInt;
use std::cmp::Ordering;
use std::ops::{Mul, Neg, Sub};

/// Leaves of `tree` along `ray`, in order, and the touches among them.
pub fn traverse<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Outcome {
    // The longest numbers decide over the arithmetic.
    let boxes = || tree.leaves().map(|leaf| (leaf, tree.node_box(leaf.id)));
    let corners = boxes().flat_map(|(_, bounds)| bounds.min.into_iter().chain(bounds.max));
    let position = Unit::common(corners.chain(ray.origin()));
    let direction = Unit::common(ray.direction());
    let short = position.bits + direction.bits + 2 < i128::BITS;
    let met = if short && options.end().is_none() {
        let integer = |x: f64, unit: Unit| unit.count(x);
        test_all::<D, i128>(boxes(), ray, [position, direction], integer, None, observe)
    } else {
        let integer = |x: f64, unit: Unit| unit.count_at_any_length(x);
        let end = options.end().map(|t| parameter(t, position, direction));
        test_all::<D, BigInt>(boxes(), ray, [position, direction], integer, end, observe)
    };

    if !observe.wants_more() {
        observe.observe(Event::End(End::Cut));
        return Outcome::without_node(End::Cut);
    }
    observe.observe(Event::Sort { n_leaves: met.len() as u32 });
    let mut outcome = Outcome::without_node(End::Missed);
    for Met { leaf, interval: [enter, exit], kind } in met {
        if kind == Kind::Touch {
            observe.observe(Event::Touch { node: leaf.id, at: enter });
            continue;
        }
        let full = leaf.is_full();
        observe.observe(Event::Leaf { node: leaf.id, enter, exit, full });
        outcome = match kind {
            Kind::Cut => Outcome::without_node(End::SegmentEnd),
            Kind::Whole | Kind::Touch => Outcome::without_node(End::LeftRoot),
        };
        if full && options.stop_at == StopAt::FirstFull {
            outcome = Outcome::at(End::FirstFull, leaf.id);
            break;
        }
    }
    observe.observe(Event::End(outcome.end));
    outcome
}

/// A leaf that the ray meets.
struct Met {
    leaf: Node,
    /// The nearest doubles to the parameters of entry and exit.
    interval: [f64; 2],
    kind: Kind,
}

/// How a leaf is met.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// In one point.
    Touch,
    /// From its near to its far planes.
    Whole,
    /// To the end of the segment.
    Cut,
}

/// Tests all leaves; those that the ray meets, in the order of their entry,
/// touches before the leaf that begins at the same point.
fn test_all<const D: usize, I: Integer>(
    boxes: impl Iterator<Item = (Node, Aabb<D>)>,
    ray: &Ray<D>,
    [position, direction]: [Unit; 2],
    integer: impl Fn(f64, Unit) -> I,
    end: Option<Fraction<I>>,
    observe: &mut impl Observer<D>,
) -> Vec<Met> {
    let origin = ray.origin().map(|x| integer(x, position));
    let steps = ray.direction().map(|x| integer(x, direction));
    let (nothing, one) = (I::from(0), I::from(1));

    let mut met = Vec::new();
    'leaves: for (leaf, bounds) in boxes {
        if !observe.wants_more() {
            break;
        }
        let mut enter =
            Fraction { numerator: nothing.clone(), denominator: one.clone(), value: 0.0 };
        let mut exit: Option<Fraction<I>> = None;
        for e in 0..D {
            let [low, high] = [bounds.min[e], bounds.max[e]].map(|x| integer(x, position));
            if steps[e] == nothing {
                // Without motion the cell owns its lower plane, not its upper one.
                if origin[e] < low || origin[e] >= high {
                    let (node, divided) = (leaf.id, Axes::NONE);
                    let missed = Event::Test { node, interval: None, touch: false, divided };
                    observe.observe(missed);
                    continue 'leaves;
                }
                continue;
            }
            let forward = steps[e] > nothing;
            let [near, far] = if forward { [low, high] } else { [high, low] };
            let at = |plane: I, coordinate: f64| Fraction {
                numerator: signed(plane - origin[e].clone(), forward),
                denominator: signed(steps[e].clone(), forward),
                value: (coordinate - ray.origin()[e]) / ray.direction()[e],
            };
            let [near_x, far_x] = if forward {
                [bounds.min[e], bounds.max[e]]
            } else {
                [bounds.max[e], bounds.min[e]]
            };
            let near = at(near, near_x);
            if near.compare(&enter) == Ordering::Greater {
                enter = near;
            }
            let far = at(far, far_x);
            if exit.as_ref().is_none_or(|exit| far.compare(exit) == Ordering::Less) {
                exit = Some(far);
            }
        }
        let exit = exit.expect("a ray moves along some axis");
        let order = enter.compare(&exit);
        let begins_in_time = end.as_ref().is_none_or(|end| enter.compare(end) == Ordering::Less);
        let meets = order != Ordering::Greater && begins_in_time;
        let cut = end.as_ref().filter(|end| exit.compare(end) != Ordering::Less);
        let interval = [enter.value, cut.unwrap_or(&exit).value];
        let touch = meets && order == Ordering::Equal;
        observe.observe(Event::Test {
            node: leaf.id,
            interval: meets.then_some(interval),
            touch,
            divided: Axes::NONE,
        });
        if meets {
            let kind = match (order, cut) {
                (Ordering::Equal, _) => Kind::Touch,
                (_, Some(_)) => Kind::Cut,
                (_, None) => Kind::Whole,
            };
            met.push((enter, Met { leaf, interval, kind }));
        }
    }
    let last_touch = |met: &Met| met.kind != Kind::Touch;
    met.sort_by(|(a, first), (b, second)| {
        a.compare(b).then(last_touch(first).cmp(&last_touch(second)))
    });
    met.into_iter().map(|(_, met)| met).collect()
}

/// Integers in which the oracle can count.
trait Integer:
    Clone + Ord + From<i64> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
}

impl Integer for i128 {}
impl Integer for BigInt {}

fn signed<I: Integer>(x: I, positive: bool) -> I {
    if positive { x } else { -x }
}

/// Parameter t, in units of position per units of direction.
struct Fraction<I> {
    numerator: I,
    /// Above zero.
    denominator: I,
    value: f64,
}

impl<I: Integer> Fraction<I> {
    fn compare(&self, other: &Self) -> Ordering {
        let left = self.numerator.clone() * other.denominator.clone();
        let right = other.numerator.clone() * self.denominator.clone();
        left.cmp(&right)
    }
}

/// Parameter `t` in these units.
fn parameter(t: f64, position: Unit, direction: Unit) -> Fraction<BigInt> {
    let (digits, exponent) = digits_and_exponent(t);
    let digits = if t < 0.0 { -BigInt::from(digits) } else { BigInt::from(digits) };
    let shift = exponent - position.exponent + direction.exponent;
    let (numerator, denominator) = if shift >= 0 {
        (digits << shift, BigInt::from(1))
    } else {
        (digits, BigInt::from(1) << -shift)
    };
    Fraction { numerator, denominator, value: t }
}

/// A power of two of which some doubles are multiples.
#[derive(Clone, Copy)]
struct Unit {
    /// The unit is 2^exponent.
    exponent: i32,
    /// The longest multiple has so many binary digits.
    bits: u32,
}

impl Unit {
    /// The largest unit of which all `numbers` are multiples.
    fn common(numbers: impl IntoIterator<Item = f64>) -> Self {
        let mut lowest = i32::MAX;
        let mut highest = i32::MIN;
        for (digits, exponent) in numbers.into_iter().map(digits_and_exponent) {
            if digits != 0 {
                lowest = lowest.min(exponent + digits.trailing_zeros() as i32);
                highest = highest.max(exponent + digits.ilog2() as i32);
            }
        }
        if lowest > highest {
            return Self { exponent: 0, bits: 0 };
        }
        Self { exponent: lowest, bits: (highest - lowest) as u32 + 1 }
    }

    /// How many units `x` is, where this has less than 127 digits.
    fn count(self, x: f64) -> i128 {
        if x == 0.0 {
            return 0;
        }
        let (digits, exponent) = digits_and_exponent(x);
        let shift = exponent - self.exponent;
        let count =
            if shift >= 0 { i128::from(digits) << shift } else { i128::from(digits) >> -shift };
        if x < 0.0 { -count } else { count }
    }

    /// How many units `x` is.
    fn count_at_any_length(self, x: f64) -> BigInt {
        let (digits, exponent) = digits_and_exponent(x);
        let shift = exponent - self.exponent;
        let digits = BigInt::from(digits);
        let count = if shift >= 0 { digits << shift } else { digits >> -shift };
        if x < 0.0 { -count } else { count }
    }
}

/// |x| as an integer times a power of two.
fn digits_and_exponent(x: f64) -> (u64, i32) {
    let bits = x.abs().to_bits();
    let fraction = bits & ((1 << 52) - 1);
    match (bits >> 52) as i32 {
        0 => (fraction, -1074),
        field => (fraction | 1 << 52, field - 1075),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_count_doubles_exactly() {
        let unit = Unit::common([0.75, -6.0, 0.0]);
        assert_eq!((unit.exponent, unit.bits), (-2, 5));
        assert_eq!([0.75, -6.0, 0.0].map(|x| unit.count(x)), [3, -24, 0]);
        assert_eq!(unit.count_at_any_length(-6.0), BigInt::from(-24));
    }

    #[test]
    fn both_lengths_of_integers_agree() {
        let numbers = [0.1, -123.456, 1e-5, 7.0];
        let unit = Unit::common(numbers);
        for x in numbers {
            assert_eq!(BigInt::from(unit.count(x)), unit.count_at_any_length(x));
        }
    }
}
