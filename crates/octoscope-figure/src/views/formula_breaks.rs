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

/// `formula` in lines of at most `most` page units where it can be broken so: before
/// what is said of its left side, else also before operations.
pub fn formula_lines(formula: &Formula, of: FormulaType, most: f64) -> Vec<Formula> {
    let whole = || vec![formula.clone()];
    let Formula::Row(parts) = formula else { return whole() };
    let is_fitting = |line: &Formula| SetFormula::of(line, of).width <= most;
    if is_fitting(formula) {
        return whole();
    }
    let parts = flat(parts);
    let ways = [Breaks::Relations, Breaks::Signs].map(|at| filled(&parts, at, is_fitting));
    let is_good = |lines: &Vec<Formula>| lines.iter().all(is_fitting);
    let [by_relations, by_signs] = ways;
    if is_good(&by_relations) { by_relations } else { by_signs }
}

/// `formula` with its fractions in a line, which is half as high.
pub fn without_bars(formula: &Formula) -> Formula {
    let inner = |part: &Formula| Box::new(without_bars(part));
    match formula {
        Formula::Row(parts) => Formula::Row(parts.iter().map(without_bars).collect()),
        Formula::Fraction { over, under } => {
            let operand = |part: &Formula| {
                let part = without_bars(part);
                let is_sum = matches!(&part, Formula::Row(parts) if parts.len() > 1);
                let fence = Fence::Round;
                if is_sum { Formula::Fenced { fence, body: Box::new(part) } } else { part }
            };
            let slash = Formula::Words("/".to_owned());
            Formula::Row(vec![operand(over), slash, operand(under)])
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

/// Parts of rows within rows, in their order.
fn flat(parts: &[Formula]) -> Vec<Formula> {
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
fn filled(parts: &[Formula], at: Breaks, is_fitting: impl Fn(&Formula) -> bool) -> Vec<Formula> {
    let mut lines: Vec<Vec<Formula>> = Vec::new();
    for piece in pieces(parts, at) {
        if let Some(last) = lines.last_mut() {
            let longer: Vec<_> = last.iter().chain(&piece).cloned().collect();
            if is_fitting(&Formula::Row(longer.clone())) {
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
        let lines = formula_lines(&row(signs), of, most);
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
}
