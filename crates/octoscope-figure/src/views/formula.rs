//! The formulas of a step: with symbols, and below with its numbers.

use super::sheet::Sheet;
use super::subject::Subject;
use crate::formula::{FormulaType, SetFormula};
use crate::{Anchor, Figure, Form, Page, Part, Role};
use octoscope_core::explain::{Formula, Statement, formulas};

/// Steps by which the type may become smaller to fit.
const SMALLEST: u8 = 5;
/// Distance of the two lines of a statement, against the first's type.
const LEADING: f64 = 10.0;
/// Distance of statements side by side, and of rows of them.
const GAP: f64 = 28.0;
const ROW_GAP: f64 = 14.0;

/// Statements side by side on a page of at most this size, in the largest type that
/// fits, symbols above numbers. The page is as high as what is on it. No type is
/// smaller than `least` page units: rather the numbers are left out, then the last
/// statements.
pub fn formula_figure(statements: &[Statement], most: Page, least: f64) -> Figure {
    let smallest = FormulaType::most_for(least);
    let is_fitting = |figure: &Figure| {
        figure.page.height <= most.height + 1e-9 && figure.page.width <= most.width + 1e-9
    };
    let set_in = |statements: &[Statement]| {
        let types = (0..=SMALLEST.min(smallest)).map(|step| FormulaType { step, most: smallest });
        types.map(|of| set(statements, most.width, of)).find(is_fitting)
    };
    let bare = |statement: &Statement| Statement { numbers: None, ..statement.clone() };
    let symbols: Vec<Statement> = statements.iter().map(bare).collect();
    let fewer = || (1..=symbols.len()).rev().find_map(|n| set_in(&symbols[..n]));
    let smaller = FormulaType { step: SMALLEST.min(smallest), most: smallest };
    let found = set_in(statements).or_else(|| if least > 0.0 { fewer() } else { None });
    found.unwrap_or_else(|| set(statements, most.width, smaller))
}

/// A formula in a line of at most this width, in type of at least `least` page units.
pub fn formula_line(formula: &Formula, most: f64, least: f64) -> Figure {
    let statement = Statement { symbols: formula.clone(), numbers: None };
    formula_figure(&[statement], Page { width: most, height: f64::INFINITY }, least)
}

/// Height of a page that has room for every statement of one row.
pub fn formula_height() -> f64 {
    let letter = || Box::new(Formula::from("x"));
    let fraction = Formula::Fraction { over: letter(), under: letter() };
    let statement = Statement { symbols: fraction.clone(), numbers: Some(fraction) };
    set(&[statement], f64::INFINITY, FormulaType::new(0)).page.height + 2.0
}

/// A row of statements with the room that it takes.
#[derive(Default)]
struct Row {
    columns: Vec<[Option<(SetFormula, Formula)>; 2]>,
    width: f64,
}

fn set(statements: &[Statement], most: f64, of: FormulaType) -> Figure {
    let step = of.step;
    let gap = GAP * 0.9_f64.powi(i32::from(step));
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
        top += if index == 0 { 0.0 } else { ROW_GAP };
        for line in 0..2 {
            let parts = || row.columns.iter().filter_map(|column| column[line].as_ref());
            let reach = |reach: fn(&SetFormula) -> f64| {
                parts().map(|(set, _)| reach(set)).fold(0.0, f64::max)
            };
            let (above, below) = (reach(|set| set.above), reach(|set| set.below));
            if above + below == 0.0 {
                continue;
            }
            top += if line == 0 { 0.0 } else { LEADING };
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
