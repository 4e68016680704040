//! Values of options that several commands take.

use octoscope_core::text::{Language, UnknownLanguage};
use octoscope_figure::Theme;
use octoscope_import::hexadecimal;
use std::ops::RangeInclusive;
use std::str::FromStr;

/// Finite numbers between commas or blanks: decimals, fractions or hexadecimal floats.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers(pub Vec<f64>);

impl FromStr for Numbers {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        // A comma may have blanks around it.
        let numbers = text.split(',').flat_map(|part| {
            let mut words = part.split_whitespace().peekable();
            let empty = words.peek().is_none().then_some("");
            words.chain(empty)
        });
        numbers.map(number).collect::<Result<_, _>>().map(Self)
    }
}

/// A finite number: decimal, hexadecimal or a fraction of two such, rounded once.
///
/// # Errors
/// Names the word that is none.
pub fn number(word: &str) -> Result<f64, String> {
    const SUCH_AS: &str = "give numbers such as 0.5, -1e3, 1/3 or 0x1p-2";
    if word.is_empty() {
        return Err(format!("a number is missing; {SUCH_AS}"));
    }
    let simple = |text: &str| hexadecimal(text).or_else(|| text.parse().ok());
    let parsed = match word.split_once('/') {
        Some((above, below)) => match (simple(above), simple(below)) {
            (Some(_), Some(0.0)) => {
                return Err(format!("‘{word}’ divides by 0; {SUCH_AS}"));
            }
            (Some(above), Some(below)) if above.is_finite() && below.is_finite() => {
                Some(above / below)
            }
            (Some(_) | None, Some(_) | None) => None,
        },
        None => simple(word),
    };
    let finite = parsed.filter(|number| number.is_finite());
    finite.ok_or_else(|| format!("‘{word}’ is no finite number; {SUCH_AS}"))
}

/// The whole number in `text`, which lies in `range`; `why` says where its
/// bounds come from, and may be empty.
///
/// # Errors
/// Tells the range.
pub fn whole<T: TryFrom<u64>>(
    text: &str,
    range: RangeInclusive<u64>,
    why: &str,
) -> Result<T, String> {
    let parsed = text.parse::<u64>().ok().filter(|number| range.contains(number));
    let (least, most) = range.into_inner();
    parsed.and_then(|number| T::try_from(number).ok()).ok_or_else(|| {
        let why = if why.is_empty() { String::new() } else { format!(": {why}") };
        format!("give a whole number from {least} to {most}{why}")
    })
}

/// The language of this identifier.
///
/// # Errors
/// Lists the languages there are.
pub fn language(id: &str) -> Result<Language, UnknownLanguage> {
    let found = Language::ALL.into_iter().find(|language| language.id() == id);
    found.ok_or_else(|| UnknownLanguage(id.to_owned()))
}

/// The theme of this identifier.
///
/// # Errors
/// Lists the themes there are.
pub fn theme(id: &str) -> Result<Theme, String> {
    Theme::ALL.into_iter().find(|theme| theme.id() == id).ok_or_else(|| {
        let known = Theme::ALL.map(Theme::id).join(", ");
        format!("there is no theme ‘{id}’; there are {known}")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(text: &str, numbers: &[f64]) {
        assert_eq!(text.parse(), Ok(Numbers(numbers.to_vec())), "{text}");
    }

    #[test]
    fn numbers_stand_between_commas_or_blanks() {
        check("-1,0.5,1e3", &[-1.0, 0.5, 1000.0]);
        check("-1, 0x1p-1 ,2", &[-1.0, 0.5, 2.0]);
        check("1 2  3", &[1.0, 2.0, 3.0]);
    }

    #[test]
    fn fractions_are_divided_once() {
        check("1/3,-3/4 0x1p-1/2", &[1.0 / 3.0, -0.75, 0.25]);
        for (text, told) in [
            ("1/0", "‘1/0’ divides by 0; give numbers such as 0.5, -1e3, 1/3 or 0x1p-2"),
            ("0,0/-0", "‘0/-0’ divides by 0; give numbers such as 0.5, -1e3, 1/3 or 0x1p-2"),
            ("1/2/3", "‘1/2/3’ is no finite number; give numbers such as 0.5, -1e3, 1/3 or 0x1p-2"),
            ("1/inf", "‘1/inf’ is no finite number; give numbers such as 0.5, -1e3, 1/3 or 0x1p-2"),
            ("1/", "‘1/’ is no finite number; give numbers such as 0.5, -1e3, 1/3 or 0x1p-2"),
        ] {
            assert_eq!(text.parse::<Numbers>(), Err(told.to_owned()));
        }
    }

    #[test]
    fn whole_numbers_are_refused_with_their_range() {
        assert_eq!(whole("20", 0..=20, ""), Ok(20u8));
        for bad in ["21", "-1", "2.5", "x", "", "99999999999999999999"] {
            let message = whole::<u8>(bad, 0..=20, "codes have 20 bits").unwrap_err();
            assert_eq!(message, "give a whole number from 0 to 20: codes have 20 bits", "{bad}");
        }
    }

    #[test]
    fn what_is_no_number_is_named() {
        for (text, named) in
            [("1,x", "‘x’"), ("1,,2", "a number is missing"), ("1,inf", "‘inf’"), ("", "a number")]
        {
            let message = text.parse::<Numbers>().unwrap_err();
            assert!(message.starts_with(named), "{message}");
        }
    }
}
