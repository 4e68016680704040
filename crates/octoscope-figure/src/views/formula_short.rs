//! Shorter statements, where there is no room for symbols and numbers.

use super::formula_breaks::flat;
use octoscope_core::explain::{Formula, Room, Sign, Statement};
use octoscope_core::geometry::AXIS_NAMES;

/// How much is told of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Told {
    /// Its symbols, and below its numbers.
    Whole,
    /// Its symbols, and what comes of them: t = max(u, v) = 0.5; the symbols once for all
    /// axes that they are the same for.
    Named,
    /// What is computed, and from which numbers: t = (1 − 0) / 2 = 0.5.
    InNumbers,
    /// What is computed, and what comes of it: t = 0.5.
    Result,
}

impl Told {
    /// All of them, the most complete first.
    pub const ALL: [Self; 4] = [Self::Whole, Self::Named, Self::InNumbers, Self::Result];
}

/// `statements` with as much of them as is `told`; those without numbers as they are.
pub fn told_in(statements: &[Statement], told: Told) -> Vec<Statement> {
    match told {
        Told::Whole => statements.to_vec(),
        Told::Named => statements.chunk_by(are_alike).flat_map(named).collect(),
        Told::InNumbers | Told::Result => {
            statements.iter().map(|statement| shorter(statement, told)).collect()
        }
    }
}

/// Statements that differ in their axis alone: what they have in common once, before what
/// comes of each.
fn named(alike: &[Statement]) -> Vec<Statement> {
    let [first, ..] = alike else { return Vec::new() };
    if alike.len() > 1 && first.numbers.is_some() {
        let rule = Statement { symbols: first.symbols.clone(), numbers: None };
        let results = alike.iter().map(|statement| shorter(statement, Told::Result));
        return std::iter::once(rule).chain(results).collect();
    }
    alike.iter().map(with_result).collect()
}

/// What is computed with its symbols and what comes of it; a comparison as it is.
fn with_result(statement: &Statement) -> Statement {
    let parts = |formula: &Formula| flat(std::slice::from_ref(formula));
    let Some(numbers) = statement.numbers.as_ref().map(parts) else { return statement.clone() };
    let symbols = parts(&statement.symbols);
    let last = numbers.iter().rposition(|part| room(part) == Some(Room::Relation));
    match last.filter(|_| definition(&symbols).is_some()) {
        Some(last) => Statement {
            symbols: Formula::Row([&symbols[..], &numbers[last..]].concat()),
            numbers: None,
        },
        None => statement.clone(),
    }
}

/// Whether two statements say the same of two axes.
fn are_alike(a: &Statement, b: &Statement) -> bool {
    of_any_axis(&a.symbols) == of_any_axis(&b.symbols)
}

/// `formula` with every axis named alike.
fn of_any_axis(formula: &Formula) -> Formula {
    let inner = |part: &Formula| Box::new(of_any_axis(part));
    match formula {
        Formula::Symbol { name, axis: Some(axis) } => {
            Formula::Symbol { name: name.replacen(AXIS_NAMES[*axis], "e", 1), axis: None }
        }
        Formula::Row(parts) => Formula::Row(parts.iter().map(of_any_axis).collect()),
        Formula::Sub { body, below } => Formula::Sub { body: inner(body), below: inner(below) },
        Formula::Sup { body, above } => Formula::Sup { body: inner(body), above: inner(above) },
        Formula::Fraction { over, under } => {
            Formula::Fraction { over: inner(over), under: inner(under) }
        }
        Formula::Over { operator, limit } => Formula::Over { operator, limit: inner(limit) },
        Formula::Fenced { fence, body } => Formula::Fenced { fence: *fence, body: inner(body) },
        Formula::Symbol { axis: None, .. }
        | Formula::Number { .. }
        | Formula::Digits(_)
        | Formula::Words(_)
        | Formula::Sign(_) => formula.clone(),
    }
}

/// Where the name ends of what is computed, if something is and nothing follows from it.
fn definition(symbols: &[Formula]) -> Option<usize> {
    let follows = symbols.iter().any(|part| room(part) == Some(Room::Consequence));
    let relation = symbols.iter().position(|part| room(part) == Some(Room::Relation));
    relation.filter(|&at| is_definition(&symbols[at]) && !follows)
}

/// `statement` in numbers, or with what comes of them alone.
fn shorter(statement: &Statement, told: Told) -> Statement {
    let Some(numbers) = statement.numbers.as_ref() else { return statement.clone() };
    let [symbols, numbers] =
        [&statement.symbols, numbers].map(|formula| flat(std::slice::from_ref(formula)));
    let row = |parts: Vec<Formula>| Statement { symbols: Formula::Row(parts), numbers: None };
    let follows = symbols.iter().position(|part| room(part) == Some(Room::Consequence));
    match (definition(&symbols), follows) {
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
        let alone = std::slice::from_ref(&statement);
        assert_eq!(told_in(alone, Told::Whole), alone);
        for (told, expected) in [Told::InNumbers, Told::Result].into_iter().zip(shorter) {
            let expected = Statement { symbols: row(expected), numbers: None };
            assert_eq!(told_in(alone, told), [expected], "{told:?}");
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

    #[test]
    fn what_is_the_same_for_all_axes_is_told_once_before_what_comes_of_each() {
        let on =
            |axis: usize, name: &str| Formula::Symbol { name: name.to_owned(), axis: Some(axis) };
        let of = |parts: &[Formula], numbers: &[&str]| Statement {
            symbols: Formula::Row(parts.to_vec()),
            numbers: Some(row(numbers)),
        };
        let code = |axis: usize, name: &str, result: &str| {
            let parts =
                [on(axis, name), Sign::Equal.into(), on(axis, "c"), Sign::Plus.into(), "1".into()];
            of(&parts, &["0", "+", "1", "=", result])
        };
        let sum = of(&[row(&["s", "=", "x", "+", "y"])], &["1", "+", "2", "=", "3"]);
        let alike = [code(0, "x", "1"), code(1, "y", "2")];
        let told = told_in(&[&alike[..], &[sum]].concat(), Told::Named);
        let result = |axis: usize, name: &str, result: &str| {
            Formula::Row(vec![on(axis, name), Sign::Equal.into(), result.into()])
        };
        let expected = [
            alike[0].symbols.clone(),
            result(0, "x", "1"),
            result(1, "y", "2"),
            row(&["s", "=", "x", "+", "y", "=", "3"]),
        ];
        let expected = expected.map(|symbols| Statement { symbols, numbers: None });
        assert_eq!(told, expected);
    }
}
