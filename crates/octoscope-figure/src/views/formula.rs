//! The formulas of a step: with symbols, and below with its numbers.

use super::sheet::Sheet;
use super::subject::Subject;
use crate::formula::{FormulaType, SetFormula};
use crate::{Anchor, Figure, Form, Page, Part, Role};
use octoscope_core::explain::{Formula, Statement, formulas};

/// Steps by which the type may become smaller to fit.
const SMALLEST: u8 = 5;
/// Distances of what stands on a page, in page units.
#[derive(Clone, Copy)]
struct Spacing {
    /// Of the two lines of a statement.
    leading: f64,
    /// Of statements side by side, in the largest type.
    gap: f64,
    /// Of rows of them.
    row_gap: f64,
}

const WIDE: Spacing = Spacing { leading: 10.0, gap: 28.0, row_gap: 14.0 };
/// Where type would have to be smaller otherwise.
const TIGHT: Spacing = Spacing { leading: 4.0, gap: 12.0, row_gap: 8.0 };

/// Statements side by side on a page of at most this size, in the largest type that
/// fits, symbols above numbers; closer together before the type becomes smaller. The
/// page is as high as what is on it. No type is
/// smaller than `least` page units: rather the numbers are left out, then the last
/// statements.
pub fn formula_figure(statements: &[Statement], most: Page, least: f64) -> Figure {
    let smallest = FormulaType::most_for(least);
    let is_fitting = |figure: &Figure| {
        figure.page.height <= most.height + 1e-9 && figure.page.width <= most.width + 1e-9
    };
    let set_in = |statements: &[Statement]| {
        let types = (0..=SMALLEST.min(smallest)).map(|step| FormulaType { step, most: smallest });
        let mut pages = types.flat_map(|of| [WIDE, TIGHT].map(|spacing| (of, spacing)));
        pages.find_map(|(of, spacing)| {
            Some(set(statements, most.width, of, spacing)).filter(is_fitting)
        })
    };
    let bare = |statement: &Statement| Statement { numbers: None, ..statement.clone() };
    let symbols: Vec<Statement> = statements.iter().map(bare).collect();
    let fewer = || (1..=symbols.len()).rev().find_map(|n| set_in(&symbols[..n]));
    let smaller = FormulaType { step: SMALLEST.min(smallest), most: smallest };
    let found = set_in(statements).or_else(|| if least > 0.0 { fewer() } else { None });
    found.unwrap_or_else(|| set(statements, most.width, smaller, TIGHT))
}

/// A formula in a line of at most this width, in type of at least `least` page units.
pub fn formula_line(formula: &Formula, most: f64, least: f64) -> Figure {
    let statement = Statement { symbols: formula.clone(), numbers: None };
    formula_figure(&[statement], Page { width: most, height: f64::INFINITY }, least)
}

/// How many rows of statements a page has room for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FormulaRows {
    /// One, with fractions.
    One,
    /// One with fractions and one without.
    Two,
}

/// Height of a page that has room for `rows` of statements in type one step below the
/// largest, subscripts as large as a hall reads them.
pub fn formula_height(rows: FormulaRows) -> f64 {
    let boxed = |text: &str| Box::new(Formula::from(text));
    let plain = [Formula::Sub { body: boxed("t"), below: boxed("x") }, Formula::from("1")];
    let fractions =
        plain.clone().map(|x| Formula::Fraction { over: Box::new(x), under: boxed("d") });
    let statement =
        |[symbols, numbers]: [Formula; 2]| Statement { symbols, numbers: Some(numbers) };
    let all = [fractions, plain].map(statement);
    let n_rows = match rows {
        FormulaRows::One => 1,
        FormulaRows::Two => 2,
    };
    let of = FormulaType { step: 1, most: 2 };
    // No two of them are side by side; minus signs and primes need a little more.
    set(&all[..n_rows], 0.0, of, TIGHT).page.height + 5.0
}

/// A row of statements with the room that it takes.
#[derive(Default)]
struct Row {
    columns: Vec<[Option<(SetFormula, Formula)>; 2]>,
    width: f64,
}

fn set(statements: &[Statement], most: f64, of: FormulaType, spacing: Spacing) -> Figure {
    let step = of.step;
    let gap = spacing.gap * 0.9_f64.powi(i32::from(step));
    let mut rows = vec![Row::default()];
    for Statement { symbols, numbers } in statements {
        let set = |formula: &Formula| (SetFormula::of(formula, of), formula.clone());
        let column = [Some(set(symbols)), numbers.as_ref().map(set)];
        let width = column.iter().flatten().map(|(set, _)| set.width).fold(0.0, f64::max);
        let last = rows.len() - 1;
        let is_full = !rows[last].columns.is_empty() && rows[last].width + gap + width > most;
        if is_full {
            rows.push(Row::default());
        }
        let last = rows.len() - 1;
        let row = &mut rows[last];
        row.width += if row.columns.is_empty() { width } else { gap + width };
        row.columns.push(column);
    }
    let mut sheet = Sheet::default();
    let mut top = 0.0;
    for (index, row) in rows.iter().enumerate() {
        top += if index == 0 { 0.0 } else { spacing.row_gap };
        for line in 0..2 {
            let parts = || row.columns.iter().filter_map(|column| column[line].as_ref());
            let reach = |reach: fn(&SetFormula) -> f64| {
                parts().map(|(set, _)| reach(set)).fold(0.0, f64::max)
            };
            let (above, below) = (reach(|set| set.above), reach(|set| set.below));
            if above + below == 0.0 {
                continue;
            }
            top += if line == 0 { 0.0 } else { spacing.leading };
            let mut x = 0.0;
            for column in &row.columns {
                if let Some((_, formula)) = &column[line] {
                    let form = Form::Formula {
                        at: [x, top + above],
                        of,
                        formula: Box::new(formula.clone()),
                    };
                    sheet.push(Role::Formula(step), Part::Whole, form);
                }
                let width = column.iter().flatten().map(|(set, _)| set.width).fold(0.0, f64::max);
                x += width + gap;
            }
            top += above + below;
        }
    }
    let width = rows.iter().map(|row| row.width).fold(0.0, f64::max);
    sheet.figure([width, top])
}

/// The formulas of the step, as a figure; what is said of one that has none.
pub(super) fn view<const D: usize>(subject: &Subject<D>, width: f64) -> Figure {
    let Subject { tree, ray, trace, moment, texts, notation } = *subject;
    let statements = formulas(tree, ray, trace, moment.step, notation, texts.language());
    if statements.is_empty() {
        let mut sheet = Sheet::default();
        sheet.text(Role::Note, [0.0, 10.0], Anchor::Start, texts.get("formula-none"));
        return sheet.figure([width, 20.0]);
    }
    formula_figure(&statements, Page { width, height: f64::INFINITY }, 0.0)
}
