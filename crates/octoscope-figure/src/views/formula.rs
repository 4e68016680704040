//! The formulas of a step: with symbols, and below with its numbers.

use super::formula_breaks::{Widths, formula_lines, without_bars};
use super::formula_short::{Told, told_in};
use super::sheet::Sheet;
use super::subject::Subject;
use crate::formula::{FormulaType, SetFormula};
use crate::{Anchor, Figure, Form, Page, Part, Role};
use octoscope_core::explain::{Formula, Statement, formulas};

/// Steps by which the type may become smaller to fit.
const SMALLEST: u8 = 5;
/// Steps after which type is no longer large.
const LARGE: u8 = 1;
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
/// fits, symbols above numbers; closer together before the type becomes smaller, and
/// broken over lines, then with fractions in a line, where no type is small enough. The
/// page is as high as what is on it. No type is smaller than `least` page units: rather
/// what is the same for all axes stands once, then what is computed with its numbers alone,
/// then with what comes of it, then the last statements are left out.
pub fn formula_figure(statements: &[Statement], most: Page, least: f64) -> Figure {
    figure_from(statements, most, least, 0)
}

/// The same in type that is at least `first` steps smaller than the largest.
fn figure_from(statements: &[Statement], most: Page, least: f64, first: u8) -> Figure {
    let smallest = FormulaType::most_for(least);
    let is_fitting = |figure: &Figure| {
        figure.page.height <= most.height + 1e-9 && figure.page.width <= most.width + 1e-9
    };
    let set_in = |statements: &[Statement], lines: Lines, steps: u8| {
        let types = (first..=steps.min(smallest)).map(|step| FormulaType { step, most: smallest });
        let mut pages = types.flat_map(|of| [WIDE, TIGHT].map(|spacing| (of, spacing)));
        pages.find_map(|(of, spacing)| {
            Some(set(statements, most.width, of, (spacing, lines))).filter(is_fitting)
        })
    };
    // Where a hall reads it, it is rather broken than much smaller.
    let large = [Lines::Whole, Lines::Broken].map(|lines| (lines, LARGE));
    let any = [Lines::Whole, Lines::Broken, Lines::Low].map(|lines| (lines, SMALLEST));
    let large = large.into_iter().filter(|_| least > 0.0);
    let ways: Vec<_> = large.chain(any).collect();
    let either = |statements: &[Statement]| {
        ways.iter().find_map(|&(lines, steps)| set_in(statements, lines, steps))
    };
    let fewer = || {
        let results = told_in(statements, Told::Result);
        (1..results.len()).rev().find_map(|n| either(&results[..n]))
    };
    let smaller = FormulaType { step: SMALLEST.min(smallest), most: smallest };
    let found = Told::ALL.into_iter().find_map(|told| either(&told_in(statements, told)));
    let found = found.or_else(|| if least > 0.0 { fewer() } else { None });
    found.unwrap_or_else(|| set(statements, most.width, smaller, (TIGHT, Lines::Broken)))
}

/// How formulas are set, the most beautiful first.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Lines {
    /// Each in a line.
    Whole,
    /// Broken where they are wider than the page.
    Broken,
    /// Broken, and fractions in a line.
    Low,
}

/// Formulas in lines of at most this width, all in the largest type in which each fits, of
/// at least `least` page units.
pub fn formulas_alike<const N: usize>(
    formulas: [&Formula; N],
    most: f64,
    least: f64,
) -> [Figure; N] {
    let most = Page { width: most, height: f64::INFINITY };
    let set = |formula: &Formula, first: u8| {
        let statement = Statement { symbols: formula.clone(), numbers: None };
        figure_from(&[statement], most, least, first)
    };
    let alone = formulas.map(|formula| set(formula, 0));
    let smallest = alone.iter().map(steps_of).max().unwrap_or(0);
    formulas.map(|formula| set(formula, smallest))
}

/// By how many steps the type of what is set is smaller than the largest.
fn steps_of(figure: &Figure) -> u8 {
    let steps = figure
        .drawn
        .iter()
        .filter_map(|drawn| if let Role::Formula(step) = drawn.role { Some(step) } else { None });
    steps.max().unwrap_or(0)
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
    // No two of them are side by side; a little more, for two rows without fractions.
    set(&all[..n_rows], 0.0, of, (TIGHT, Lines::Whole)).page.height + 11.0
}

/// A row of statements with the room that it takes.
#[derive(Default)]
struct Row {
    columns: Vec<Column>,
    width: f64,
}

/// The lines of a statement: of its symbols, and below of its numbers.
struct Column {
    lines: Vec<Line>,
    width: f64,
}

/// A formula, or what goes on of one.
struct Line {
    set: SetFormula,
    formula: Formula,
    indent: f64,
}

/// How far what goes on of a formula is moved in, in page units, in type of any size.
const INDENT: f64 = 12.0;

impl Column {
    fn of(statement: &Statement, most: f64, of: FormulaType, breaks: Lines) -> Self {
        let mut lines = Vec::new();
        let widths = Widths { first: most, others: most - INDENT };
        for formula in [Some(&statement.symbols), statement.numbers.as_ref()].into_iter().flatten()
        {
            let parts = match breaks {
                Lines::Whole => vec![formula.clone()],
                Lines::Broken => formula_lines(formula, of, widths),
                Lines::Low => formula_lines(&without_bars(formula), of, widths),
            };
            lines.extend(parts.into_iter().enumerate().map(|(n, formula)| Line {
                set: SetFormula::of(&formula, of),
                formula,
                indent: if n == 0 { 0.0 } else { INDENT },
            }));
        }
        let width = lines.iter().map(|line| line.indent + line.set.width).fold(0.0, f64::max);
        Self { lines, width }
    }
}

fn set(
    statements: &[Statement],
    most: f64,
    of: FormulaType,
    (spacing, breaks): (Spacing, Lines),
) -> Figure {
    let step = of.step;
    let gap = spacing.gap * 0.9_f64.powi(i32::from(step));
    let mut rows = vec![Row::default()];
    for statement in statements {
        let column = Column::of(statement, most, of, breaks);
        let last = rows.len() - 1;
        let is_full =
            !rows[last].columns.is_empty() && rows[last].width + gap + column.width > most;
        if is_full {
            rows.push(Row::default());
        }
        let last = rows.len() - 1;
        let row = &mut rows[last];
        row.width += if row.columns.is_empty() { column.width } else { gap + column.width };
        row.columns.push(column);
    }
    let mut sheet = Sheet::default();
    let mut top = 0.0;
    for (index, row) in rows.iter().enumerate() {
        top += if index == 0 { 0.0 } else { spacing.row_gap };
        let n_lines = row.columns.iter().map(|column| column.lines.len()).max().unwrap_or(0);
        for n in 0..n_lines {
            let parts = || row.columns.iter().filter_map(|column| column.lines.get(n));
            let reach = |reach: fn(&SetFormula) -> f64| {
                parts().map(|line| reach(&line.set)).fold(0.0, f64::max)
            };
            let (above, below) = (reach(|set| set.above), reach(|set| set.below));
            top += if n == 0 { 0.0 } else { spacing.leading };
            let mut x = 0.0;
            for column in &row.columns {
                if let Some(Line { formula, indent, .. }) = column.lines.get(n) {
                    let form = Form::Formula {
                        at: [x + indent, top + above],
                        of,
                        formula: Box::new(formula.clone()),
                    };
                    sheet.push(Role::Formula(step), Part::Whole, form);
                }
                x += column.width + gap;
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

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::explain::misprint_formula;
    use octoscope_core::traverse::Variant;

    #[test]
    fn rules_that_are_compared_are_set_in_one_type() {
        let mut n_smaller = 0;
        for misprint in Variant::ALL.into_iter().filter_map(misprint_formula) {
            let both = [&misprint.printed, &misprint.right];
            for (most, least) in [(120.0, 0.0), (170.0, 12.5), (180.0, 0.0), (290.0, 12.5)] {
                let steps = formulas_alike(both, most, least).map(|figure| steps_of(&figure));
                assert_eq!(steps[0], steps[1], "{misprint:?} {most}");
                n_smaller += usize::from(steps[0] > 0);
            }
        }
        assert!(n_smaller > 5, "{n_smaller}");
    }
}
