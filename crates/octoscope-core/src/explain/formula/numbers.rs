//! Numbers in formulas.

use super::term::{Fence, Formula, Sign};
use crate::explain::number::{approx, distinct};

/// A number in its short form.
pub(super) fn number(value: f64) -> Formula {
    Formula::Number { value, shown: approx(value) }
}

/// Numbers in short forms that tell different ones apart.
pub(super) fn told_apart<const N: usize>(values: [f64; N]) -> [Formula; N] {
    let shown = distinct(&values);
    std::array::from_fn(|n| Formula::Number { value: values[n], shown: shown[n].clone() })
}

/// A number behind a sign: in brackets if it has a sign of its own.
pub(super) fn operand(value: f64) -> Formula {
    match value < 0.0 {
        true => number(value).fenced(Fence::Round),
        false => number(value),
    }
}

/// = if the short forms of all these numbers tell them to the last digit, else ≈.
pub(super) fn equal(values: &[f64]) -> Sign {
    let is_whole = |x: &f64| {
        let shown = approx(*x).replace('−', "-");
        !x.is_finite() || shown.parse() == Ok(*x)
    };
    if values.iter().all(is_whole) { Sign::Equal } else { Sign::About }
}

/// A code or set in binary.
pub(super) fn binary(bits: u32, width: u8) -> Formula {
    Formula::Digits(crate::explain::words::binary(bits, width))
}
