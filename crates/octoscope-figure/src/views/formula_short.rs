//! Shorter statements, where there is no room for symbols and numbers.

use super::formula_breaks::flat;
use octoscope_core::explain::{Formula, Room, Sign, Statement};

/// How much is told of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Told {
    /// Its symbols, and below its numbers.
    Whole,
    /// What is computed, and from which numbers: t = (1 − 0) / 2 = 0.5.
    InNumbers,
    /// What is computed, and what comes of it: t = 0.5.
    Result,
}

impl Told {
    /// All of them, the most complete first.
    pub const ALL: [Self; 3] = [Self::Whole, Self::InNumbers, Self::Result];
}

/// `statement` with as much of it as is `told`; one without numbers as it is.
pub fn told_in(statement: &Statement, told: Told) -> Statement {
    let Some(numbers) = statement.numbers.as_ref().filter(|_| told != Told::Whole) else {
        return statement.clone();
    };
    let [symbols, numbers] =
        [&statement.symbols, numbers].map(|formula| flat(std::slice::from_ref(formula)));
    let row = |parts: Vec<Formula>| Statement { symbols: Formula::Row(parts), numbers: None };
    let follows = symbols.iter().position(|part| room(part) == Some(Room::Consequence));
    let relation = symbols.iter().position(|part| room(part) == Some(Room::Relation));
    let name = relation.filter(|&at| is_definition(&symbols[at]) && follows.is_none());
    match (name, follows) {
        (Some(name), _) => {
            let last = numbers.iter().rposition(|part| room(part) == Some(Room::Relation));
            let result = last.filter(|_| told == Told::Result);
            match result {
                Some(result) => row([&symbols[..name], &numbers[result..]].concat()),
                None => row([&symbols[..=name], &numbers[..]].concat()),
            }
        }
        // A comparison, and what follows from it.
        (None, Some(follows))
            if !numbers.iter().any(|part| room(part) == Some(Room::Consequence)) =>
        {
            row([&numbers[..], &symbols[follows..]].concat())
        }
        (None, Some(_) | None) => row(numbers),
    }
}

/// The room of a part, if it is a sign.
fn room(part: &Formula) -> Option<Room> {
    if let Formula::Sign(sign) = part { Some(sign.room()) } else { None }
}

/// Whether a sign says what the name before it stands for.
fn is_definition(part: &Formula) -> bool {
    matches!(part, Formula::Sign(Sign::Equal | Sign::Takes))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(parts: &[&str]) -> Formula {
        let sign = |text: &&str| Sign::ALL.into_iter().find(|sign| sign.text() == *text);
        let part = |text: &&str| sign(text).map_or(Formula::from(*text), Formula::Sign);
        Formula::Row(parts.iter().map(part).collect())
    }

    #[track_caller]
    fn check(symbols: &[&str], numbers: &[&str], shorter: [&[&str]; 2]) {
        let statement = Statement { symbols: row(symbols), numbers: Some(row(numbers)) };
        assert_eq!(told_in(&statement, Told::Whole), statement);
        for (told, expected) in [Told::InNumbers, Told::Result].into_iter().zip(shorter) {
            let expected = Statement { symbols: row(expected), numbers: None };
            assert_eq!(told_in(&statement, told), expected, "{told:?}");
        }
    }

    #[test]
    fn what_is_computed_keeps_its_name_and_its_number() {
        check(
            &["t", "=", "a", "+", "b"],
            &["1", "+", "2", "=", "3"],
            [&["t", "=", "1", "+", "2", "=", "3"], &["t", "=", "3"]],
        );
        check(
            &["t", "=", "a"],
            &["1", "+", "2", "≈", "3"],
            [&["t", "=", "1", "+", "2", "≈", "3"], &["t", "≈", "3"]],
        );
    }

    #[test]
    fn a_comparison_keeps_what_follows_from_it() {
        let shorter: &[&str] = &["1", "<", "2", "⇒", "i", "=", "1"];
        check(&["t", "<", "u", "⇒", "i", "=", "1"], &["1", "<", "2"], [shorter; 2]);
        check(
            &["t", "<", "u", "⇒", "hit"],
            &["1", "<", "2", "⇒", "hit"],
            [&["1", "<", "2", "⇒", "hit"]; 2],
        );
    }
}
