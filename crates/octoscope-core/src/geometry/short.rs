//! Short numbers without rounding.

use std::cmp::Ordering;

/// What [`Scaled`](super::Scaled) is, as long as 127 digits suffice: most
/// comparisons that doubles leave open need no more.
#[derive(Clone, Copy, Debug)]
pub(super) struct Short {
    digits: i128,
    exponent: i32,
}

impl Short {
    /// `x` itself; `x` is finite.
    pub fn of(x: f64) -> Self {
        let bits = x.to_bits();
        let field = (bits >> 52 & 0x7ff) as i32;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        let (mantissa, exponent) =
            if field == 0 { (fraction, -1074) } else { (fraction | 1 << 52, field - 1075) };
        let digits = i128::from(if x < 0.0 { -mantissa } else { mantissa });
        Self { digits, exponent }.shortened()
    }

    /// `x − y`, both finite, if it is short.
    pub fn difference(x: f64, y: f64) -> Option<Self> {
        let ([x, y], exponent) = Self::aligned(Self::of(x), Self::of(y))?;
        Some(Self { digits: x.checked_sub(y)?, exponent }.shortened())
    }

    /// With the other sign.
    pub fn negated(self) -> Self {
        Self { digits: -self.digits, ..self }
    }

    /// Product, if it is short.
    pub fn times(self, other: Self) -> Option<Self> {
        let digits = self.digits.checked_mul(other.digits)?;
        Some(Self { digits, exponent: self.exponent + other.exponent })
    }

    /// Which one is larger, if both are short in the same unit.
    pub fn compare(self, other: Self) -> Option<Ordering> {
        let ([x, y], _) = Self::aligned(self, other)?;
        Some(x.cmp(&y))
    }

    /// Without zeros at the end.
    fn shortened(self) -> Self {
        if self.digits == 0 {
            return Self { digits: 0, exponent: 0 };
        }
        let zeros = self.digits.trailing_zeros();
        Self { digits: self.digits >> zeros, exponent: self.exponent + zeros as i32 }
    }

    /// Digits of both in the smaller of the two units, and its exponent.
    fn aligned(x: Self, y: Self) -> Option<([i128; 2], i32)> {
        match (x.digits, y.digits) {
            (0, digits) => return Some(([0, digits], y.exponent)),
            (digits, 0) => return Some(([digits, 0], x.exponent)),
            _ => {}
        }
        let exponent = x.exponent.min(y.exponent);
        let in_unit = |number: Self| {
            let shift = (number.exponent - exponent) as u32;
            let room = number.digits.unsigned_abs().leading_zeros() - 1;
            (shift <= room).then(|| number.digits << shift)
        };
        Some(([in_unit(x)?, in_unit(y)?], exponent))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Scaled;
    use super::*;
    use crate::random::Random;

    /// Doubles of few and of many digits, of any size.
    fn number(random: &mut Random) -> f64 {
        let size = 2f64.powi(random.below(61) as i32 - 30);
        match random.below(8) {
            0 => 0.0,
            1 => -0.0,
            2 => (random.below(9) as f64 - 4.0) * size,
            3 => f64::from_bits(random.bits() & !(0x7ff << 52) | random.below(0x7ff) << 52),
            4 => 5e-324 * random.below(9) as f64,
            _ => random.between(-1.0, 1.0) * size,
        }
    }

    #[test]
    fn short_numbers_compare_as_those_of_any_length() {
        let mut random = Random::new(1);
        let mut n_short = 0;
        for _ in 0..20_000 {
            let [a, b, c, x, y, z] = std::array::from_fn(|_| number(&mut random));
            let long = Scaled::difference(a, b).times(&Scaled::of(c));
            let long = long.compare(&Scaled::difference(x, y).negated().times(&Scaled::of(z)));
            let short = || {
                let left = Short::difference(a, b)?.times(Short::of(c))?;
                left.compare(Short::difference(x, y)?.negated().times(Short::of(z))?)
            };
            if let Some(short) = short() {
                assert_eq!(short, long, "({a:e} − {b:e})·{c:e} and −({x:e} − {y:e})·{z:e}");
                n_short += 1;
            }
        }
        assert!((5_000..19_000).contains(&n_short), "{n_short}");
    }
}
