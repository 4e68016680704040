//! Numbers in formulas.

use super::Statement;
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

impl Formula {
    /// All numbers that were computed, with their short forms.
    fn numbers_mut(&mut self) -> Vec<(f64, &mut String)> {
        match self {
            Self::Row(parts) => parts.iter_mut().flat_map(Self::numbers_mut).collect(),
            Self::Number { value, shown } => vec![(*value, shown)],
            Self::Sub { body, below: other }
            | Self::Sup { body, above: other }
            | Self::Fraction { over: body, under: other } => {
                body.numbers_mut().into_iter().chain(other.numbers_mut()).collect()
            }
            Self::Over { limit: body, .. } | Self::Fenced { body, .. } => body.numbers_mut(),
            Self::Symbol { .. } | Self::Digits(_) | Self::Words(_) | Self::Sign(_) => Vec::new(),
        }
    }
}

/// Gives numbers of the same step that differ by more than rounding, but have the same short
/// form, so many digits that they are told apart.
pub(super) fn tell_apart(statements: &mut [Statement]) {
    /// Share of a number by which another one may differ from it by rounding alone.
    const ROUNDING: f64 = 1e-12;
    let formulas = statements.iter_mut().filter_map(|statement| statement.numbers.as_mut());
    let mut numbers: Vec<(f64, &mut String)> = formulas.flat_map(Formula::numbers_mut).collect();
    let all: Vec<(f64, String)> = numbers.iter().map(|(x, shown)| (*x, (*shown).clone())).collect();
    for (value, shown) in &mut numbers {
        let differs = |x: f64| (x - *value).abs() > ROUNDING * x.abs().max(value.abs());
        let others = all.iter().filter(|(x, text)| differs(*x) && *text == **shown);
        let others: Vec<f64> = others.map(|(x, _)| *x).collect();
        if !others.is_empty() {
            let group: Vec<f64> = std::iter::once(*value).chain(others).collect();
            **shown = distinct(&group).swap_remove(0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::term::row;
    use super::*;

    #[test]
    fn numbers_that_differ_are_never_shown_alike() {
        let [low, high] = [0.99999970, 1.000001].map(number);
        let mut statements = vec![
            Statement { symbols: "t".into(), numbers: Some(row![number(1.0), Sign::Equal, low]) },
            Statement { symbols: "t".into(), numbers: Some(high.over(number(2.5))) },
        ];
        tell_apart(&mut statements);
        let numbers = statements.iter_mut().flat_map(|s| s.numbers.as_mut().unwrap().numbers_mut());
        let shown: Vec<String> = numbers.map(|(_, shown)| shown.clone()).collect();
        assert_eq!(shown, ["1", "0.9999997", "1.000001", "2.5"]);
    }

    #[test]
    fn what_rounding_makes_of_a_number_has_no_more_digits() {
        let quotient = (0.25 - 0.2) / 0.25;
        let numbers = row![number(0.2), Sign::About, number(quotient), number(f64::NAN)];
        let mut statements = vec![Statement { symbols: "t".into(), numbers: Some(numbers) }];
        tell_apart(&mut statements);
        let numbers = statements[0].numbers.as_mut().unwrap().numbers_mut();
        assert!(quotient != 0.2 && numbers.iter().take(2).all(|(_, shown)| *shown == "0.2"));
    }
}
