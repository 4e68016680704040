//! Numbers without rounding.

use num_bigint::{BigInt, Sign};
use std::cmp::Ordering;

/// Integer times a power of two: a double, or an exact result of doubles.
#[derive(Clone, Debug)]
pub(crate) struct Scaled {
    digits: BigInt,
    exponent: i32,
}

impl Scaled {
    /// `x` itself; `x` is finite.
    pub fn of(x: f64) -> Self {
        let bits = x.to_bits();
        let field = (bits >> 52 & 0x7ff) as i32;
        let fraction = bits & ((1 << 52) - 1);
        let (mantissa, exponent) =
            if field == 0 { (fraction, -1074) } else { (fraction | 1 << 52, field - 1075) };
        let sign = if x < 0.0 { Sign::Minus } else { Sign::Plus };
        Self { digits: BigInt::from_biguint(sign, mantissa.into()), exponent }
    }

    /// `x − y`; both are finite.
    pub fn difference(x: f64, y: f64) -> Self {
        let [x, y] = Self::aligned(&Self::of(x), &Self::of(y));
        Self { digits: x.digits - y.digits, exponent: x.exponent }
    }

    /// Sum.
    pub fn plus(&self, other: &Self) -> Self {
        let [x, y] = Self::aligned(self, other);
        Self { digits: x.digits + y.digits, exponent: x.exponent }
    }

    /// −1, 0 or 1.
    pub fn sign(&self) -> i8 {
        match self.digits.sign() {
            Sign::Minus => -1,
            Sign::NoSign => 0,
            Sign::Plus => 1,
        }
    }

    /// With the other sign.
    pub fn negated(self) -> Self {
        Self { digits: -self.digits, exponent: self.exponent }
    }

    /// Product.
    pub fn times(&self, other: &Self) -> Self {
        Self { digits: &self.digits * &other.digits, exponent: self.exponent + other.exponent }
    }

    /// Which one is larger.
    pub fn compare(&self, other: &Self) -> Ordering {
        let [x, y] = Self::aligned(self, other);
        x.digits.cmp(&y.digits)
    }

    /// Both with the smaller of the two exponents.
    fn aligned(x: &Self, y: &Self) -> [Self; 2] {
        let exponent = x.exponent.min(y.exponent);
        [x, y].map(|s| Self { digits: &s.digits << (s.exponent - exponent), exponent })
    }
}
