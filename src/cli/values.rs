//! Values of options that several commands take.

use octoscope_core::text::{Language, UnknownLanguage};
use octoscope_import::hexadecimal;
use std::str::FromStr;

/// Finite numbers between commas or blanks, decimal or hexadecimal.
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

/// A finite number, decimal or hexadecimal.
///
/// # Errors
/// Names the word that is none.
pub fn number(word: &str) -> Result<f64, String> {
    let parsed = hexadecimal(word).or_else(|| word.parse().ok());
    parsed.filter(|number| number.is_finite()).ok_or_else(|| {
        format!("‘{word}’ is no finite number; give numbers such as 0.5, -1e3 or 0x1p-2")
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
    fn what_is_no_number_is_named() {
        for (text, named) in [("1,x", "‘x’"), ("1,,2", "‘’"), ("1,inf", "‘inf’"), ("", "‘’")]
        {
            let message = text.parse::<Numbers>().unwrap_err();
            assert!(message.starts_with(named), "{message}");
        }
    }
}
