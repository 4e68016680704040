//! Numbers in words.

use std::fmt::Display;

/// Shortest decimal that reads back as `x`; ∞, -∞ and NaN are written out, very large
/// and very small numbers have an exponent. The sign of a zero is left out: where it is
/// what one looks for, [`signed_number`] tells it.
pub fn number(x: f64) -> String {
    // −0 + 0 = 0.
    signed_number(x + 0.0)
}

/// [`number`] as it is shown, with a typographic minus.
pub fn shown_number(x: f64) -> String {
    with_minus(number(x))
}

/// A number as it is written, with a typographic minus for the one of the keyboard.
pub fn with_minus(number: impl Display) -> String {
    number.to_string().replace('-', "−")
}

/// [`number`], but -0 for a zero with a sign.
pub fn signed_number(x: f64) -> String {
    if x.is_nan() {
        return "NaN".to_owned();
    }
    if x.is_infinite() {
        return if x > 0.0 { "∞" } else { "-∞" }.to_owned();
    }
    if x != 0.0 && !(1e-4..1e15).contains(&x.abs()) { format!("{x:e}") } else { format!("{x}") }
}

/// `x` to four significant digits, with a typographic minus.
pub fn approx(x: f64) -> String {
    to_digits(x, 4)
}

/// Numbers to as few digits, four at least, as tell different ones apart.
pub fn distinct(numbers: &[f64]) -> Vec<String> {
    for digits in 4..17 {
        let texts: Vec<String> = numbers.iter().map(|&x| to_digits(x, digits)).collect();
        let told_apart = |i: usize, j: usize| numbers[i] == numbers[j] || texts[i] != texts[j];
        if (0..numbers.len()).all(|i| (0..i).all(|j| told_apart(i, j))) {
            return texts;
        }
    }
    numbers.iter().map(|&x| shown_number(x)).collect()
}

/// `x` to this many significant digits, without zeros at the end.
fn to_digits(x: f64, digits: usize) -> String {
    let rounded =
        if x.is_finite() { format!("{x:.*e}", digits - 1).parse().unwrap_or(x) } else { x };
    shown_number(rounded)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_read_back() {
        assert_eq!(number(0.1), "0.1");
        assert_eq!(number(-0.0), "0");
        assert_eq!(signed_number(-0.0), "-0");
        assert_eq!((approx(-0.0), distinct(&[-0.0, 1.0])[0].as_str()), ("0".to_owned(), "0"));
        assert_eq!(number(f64::NEG_INFINITY), "-∞");
        assert_eq!(number(1e-7), "1e-7");
        for x in [0.1 + 0.2, 1e300, -5e-324, 123456.75] {
            assert_eq!(number(x).parse::<f64>(), Ok(x));
        }
    }

    #[test]
    fn different_numbers_never_look_the_same() {
        assert_eq!(approx(1.0 / 3.0), "0.3333");
        assert_eq!(approx(-2.0), "−2");
        assert_eq!(distinct(&[0.5, 0.50000001]), ["0.5", "0.50000001"]);
        let next = 1.0_f64.next_up();
        assert_ne!(distinct(&[1.0, next])[0], distinct(&[1.0, next])[1]);
    }
}
