//! Formulas in lines: where one that is too wide is broken.

use crate::formula::{FormulaType, SetFormula};
use octoscope_core::explain::{Fence, Formula, Room};

/// Where a formula may be broken.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Breaks {
    /// Before what is said of the left side.
    Relations,
    /// Before every sign between two parts, and behind commas.
    Signs,
}

/// Widths of the lines of a formula at most, in page units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Widths {
    /// Of the first line.
    pub first: f64,
    /// Of the others.
    pub others: f64,
}

/// `formula` in lines of these widths where it can be broken so: before what is said of its
/// left side, else also before operations.
pub fn formula_lines(
    formula: &Formula,
    of: FormulaType,
    Widths { first, others }: Widths,
) -> Vec<Formula> {
    let whole = || vec![formula.clone()];
    let Formula::Row(parts) = formula else { return whole() };
    let is_fitting = |n: usize, line: &Formula| {
        SetFormula::of(line, of).width <= if n == 0 { first } else { others }
    };
    if is_fitting(0, formula) {
        return whole();
    }
    let parts = flat(parts);
    let ways = [Breaks::Relations, Breaks::Signs].map(|at| filled(&parts, at, is_fitting));
    let is_good =
        |lines: &Vec<Formula>| lines.iter().enumerate().all(|(n, line)| is_fitting(n, line));
    let [by_relations, by_signs] = ways;
    if is_good(&by_relations) { by_relations } else { by_signs }
}

/// `formula` with its fractions in a line, which is half as high.
pub fn without_bars(formula: &Formula) -> Formula {
    let inner = |part: &Formula| Box::new(without_bars(part));
    match formula {
        Formula::Row(parts) => Formula::Row(parts.iter().map(without_bars).collect()),
        Formula::Fraction { over, under } => {
            let [over, under] = [over, under].map(|part| without_bars(part));
            let over = if is_compound(&over) { in_brackets(over) } else { over };
            let is_open = is_compound(&under) || is_negative(&under);
            let under = if is_open { in_brackets(under) } else { under };
            Formula::Row(vec![over, Formula::Words("/".to_owned()), under])
        }
        Formula::Sup { body, above } if matches!(**body, Formula::Fraction { .. }) => {
            let body = Box::new(in_brackets(without_bars(body)));
            Formula::Sup { body, above: inner(above) }
        }
        Formula::Sub { body, below } => Formula::Sub { body: inner(body), below: inner(below) },
        Formula::Sup { body, above } => Formula::Sup { body: inner(body), above: inner(above) },
        Formula::Over { operator, limit } => Formula::Over { operator, limit: inner(limit) },
        Formula::Fenced { fence, body } => Formula::Fenced { fence: *fence, body: inner(body) },
        Formula::Symbol { .. }
        | Formula::Number { .. }
        | Formula::Digits(_)
        | Formula::Words(_)
        | Formula::Sign(_) => formula.clone(),
    }
}

/// Whether it has parts side by side, which a bar holds together and a slash does not.
fn is_compound(formula: &Formula) -> bool {
    matches!(formula, Formula::Row(parts) if parts.len() > 1 || parts.iter().any(is_compound))
}

/// Whether it is a number with a minus.
fn is_negative(formula: &Formula) -> bool {
    match formula {
        Formula::Row(parts) => parts.first().is_some_and(is_negative),
        Formula::Number { shown: text, .. } | Formula::Digits(text) | Formula::Words(text) => {
            text.starts_with(['−', '-'])
        }
        Formula::Symbol { .. }
        | Formula::Sign(_)
        | Formula::Sub { .. }
        | Formula::Sup { .. }
        | Formula::Fraction { .. }
        | Formula::Over { .. }
        | Formula::Fenced { .. } => false,
    }
}

fn in_brackets(formula: Formula) -> Formula {
    Formula::Fenced { fence: Fence::Round, body: Box::new(formula) }
}

/// Parts of rows within rows, in their order.
pub fn flat(parts: &[Formula]) -> Vec<Formula> {
    let parts = parts.iter().flat_map(|part| match part {
        Formula::Row(inner) => flat(inner),
        Formula::Symbol { .. }
        | Formula::Number { .. }
        | Formula::Digits(_)
        | Formula::Words(_)
        | Formula::Sign(_)
        | Formula::Sub { .. }
        | Formula::Sup { .. }
        | Formula::Fraction { .. }
        | Formula::Over { .. }
        | Formula::Fenced { .. } => vec![part.clone()],
    });
    parts.collect()
}

/// As much in every line as it holds.
fn filled(
    parts: &[Formula],
    at: Breaks,
    is_fitting: impl Fn(usize, &Formula) -> bool,
) -> Vec<Formula> {
    let mut lines: Vec<Vec<Formula>> = Vec::new();
    for piece in pieces(parts, at) {
        let index = lines.len().saturating_sub(1);
        if let Some(last) = lines.last_mut() {
            let longer: Vec<_> = last.iter().chain(&piece).cloned().collect();
            if is_fitting(index, &Formula::Row(longer.clone())) {
                *last = longer;
                continue;
            }
        }
        lines.push(piece);
    }
    lines.into_iter().map(Formula::Row).collect()
}

/// What is not broken.
fn pieces(parts: &[Formula], at: Breaks) -> Vec<Vec<Formula>> {
    let mut pieces: Vec<Vec<Formula>> = vec![Vec::new()];
    let mut before = None;
    for part in parts {
        let room = match part {
            Formula::Sign(sign) => Some(sign.room()),
            Formula::Row(_)
            | Formula::Symbol { .. }
            | Formula::Number { .. }
            | Formula::Digits(_)
            | Formula::Words(_)
            | Formula::Sub { .. }
            | Formula::Sup { .. }
            | Formula::Fraction { .. }
            | Formula::Over { .. }
            | Formula::Fenced { .. } => None,
        };
        let is_break = match room {
            Some(Room::Relation | Room::Consequence) => true,
            // One that has nothing before it belongs to what is behind it.
            Some(Room::Operation) => at == Breaks::Signs && before.is_none(),
            Some(Room::Behind | Room::Tight) => false,
            None => at == Breaks::Signs && before == Some(Room::Behind),
        };
        match pieces.last_mut() {
            Some(last) if !is_break || last.is_empty() => last.push(part.clone()),
            Some(_) | None => pieces.push(vec![part.clone()]),
        }
        before = room;
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::explain::Sign;

    fn row(signs: &[Sign]) -> Formula {
        let mut parts = vec![Formula::from("t")];
        for &sign in signs {
            parts.extend([Formula::Sign(sign), Formula::from("0.1234")]);
        }
        Formula::Row(parts)
    }

    fn n_lines(signs: &[Sign], most: f64) -> usize {
        let of = FormulaType::new(0);
        let lines = formula_lines(&row(signs), of, Widths { first: most, others: most });
        let parts = |line: &Formula| match line {
            Formula::Row(parts) => parts.len(),
            _ => 1,
        };
        let n_parts: usize = lines.iter().map(parts).sum();
        assert_eq!(n_parts, 2 * signs.len() + 1, "nothing is lost");
        lines.len()
    }

    #[test]
    fn a_formula_is_broken_where_it_is_too_wide_for_its_room() {
        use Sign::{Equal, Implies, Plus};
        assert_eq!(n_lines(&[Plus, Equal, Implies], 1000.0), 1);
        assert_eq!(n_lines(&[Plus, Equal, Implies], 120.0), 3);
        assert_eq!(n_lines(&[Plus, Plus, Plus], 120.0), 3);
        // What cannot be broken has a line of its own.
        assert_eq!(n_lines(&[Equal], 1.0), 2);
    }

    #[test]
    fn the_first_line_has_all_the_room_and_the_others_less() {
        let (of, formula) = (FormulaType::new(0), row(&[Sign::Equal, Sign::Equal]));
        let whole = SetFormula::of(&formula, of).width;
        let lines = |first| formula_lines(&formula, of, Widths { first, others: first - 12.0 });
        assert_eq!(lines(whole).len(), 1);
        let first = row(&[Sign::Equal]);
        let width = SetFormula::of(&first, of).width;
        assert_eq!(lines(width)[0], first);
    }

    #[test]
    fn a_fraction_in_a_line_keeps_its_meaning() {
        let number = |value: f64, shown: &str| Formula::Number { value, shown: shown.to_owned() };
        let fraction = |over: Formula, under: Formula| {
            let [over, under] = [over, under].map(Box::new);
            Formula::Fraction { over, under }
        };
        let slash = || Formula::Words("/".to_owned());
        let difference =
            Formula::Row(vec![number(0.5, "0.5"), Sign::Minus.into(), number(0.25, "0.25")]);
        let minus = number(-1.0, "−1");
        let fenced = [difference.clone(), minus.clone()].map(in_brackets);
        assert_eq!(
            without_bars(&fraction(difference, minus.clone())),
            Formula::Row(vec![fenced[0].clone(), slash(), fenced[1].clone()])
        );
        // Over the line, a minus says the same of the whole.
        let half = fraction(minus.clone(), "b".into());
        let flat = Formula::Row(vec![minus, slash(), "b".into()]);
        assert_eq!(without_bars(&half), flat);
        let raised = |body: Formula| {
            let [body, above] = [body, "2".into()].map(Box::new);
            Formula::Sup { body, above }
        };
        assert_eq!(without_bars(&raised(half)), raised(in_brackets(flat)));
        assert_eq!(without_bars(&raised("b".into())), raised("b".into()));
    }
}
