//! Pseudocode in step with the algorithm, and its variables.

use super::sheet::{Sheet, line_height};
use super::subject::Subject;
use crate::{Anchor, Figure, Role, metrics};
use octoscope_core::explain::{Line, RichText, Variable, listing, variables};
use octoscope_core::trace::{Moment, Trace};
use octoscope_core::tree::Tree;

/// A variable and whether the last step has changed it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Changed {
    /// The variable now.
    pub variable: Variable,
    /// Whether it is new or has another value.
    pub is_changed: bool,
}

/// The variables at `moment`, with what differs from the moment before in `trace`.
pub fn changed_variables<const D: usize>(
    tree: &Tree<D>,
    trace: &Trace<D>,
    moment: &Moment<D>,
) -> Vec<Changed> {
    let now = variables(tree, &trace.query, moment);
    let before = match moment.step.checked_sub(1) {
        Some(step) => variables(tree, &trace.query, &Moment::after(tree, trace, step)),
        None => now.clone(),
    };
    let is_changed = |variable: &Variable| {
        let was = before.iter().find(|v| v.name == variable.name);
        was.is_none_or(|was| was.value != variable.value)
    };
    let marked = |variable: Variable| Changed { is_changed: is_changed(&variable), variable };
    now.into_iter().map(marked).collect()
}

/// The listing with the lines of the step lit and, beside or below it, the
/// variables, as a figure of this width.
pub(super) fn view<const D: usize>(subject: &Subject<D>, width: f64) -> Figure {
    const GAP: f64 = 20.0;
    let listing = listing(subject.query(), subject.language());
    let lit = listing.lit(subject.past());
    let variables = changed_variables(subject.tree, subject.trace, subject.moment);
    let code_width = listing.lines.iter().map(wide).fold(0.0, f64::max) + INSET + INDENT;
    let columns = Columns::of(&variables);
    let is_beside = !variables.is_empty() && code_width + GAP + columns.width() <= width;
    let own_width = if is_beside { width - GAP - columns.width() } else { width };
    let own_width = own_width.min(code_width.max(0.6 * width));
    let mut sheet = Sheet::default();
    let mut bottom = 0.0;
    for (line, is_lit) in listing.lines.iter().zip(lit) {
        bottom += code_line(&mut sheet, line, is_lit, bottom, own_width);
    }
    if is_beside {
        let left = own_width + 0.5 * GAP;
        let end = columns.draw(&mut sheet, &variables, [left + 0.5 * GAP, 0.0], 1);
        bottom = bottom.max(end);
        sheet.line(Role::Rule, [[left, 0.0], [left, bottom]]);
    } else if !variables.is_empty() {
        sheet.line(Role::Rule, [[0.0, bottom + 7.0], [width, bottom + 7.0]]);
        let n_columns = ((width / columns.width()).floor() as usize).clamp(1, 3);
        bottom = columns.draw(&mut sheet, &variables, [0.0, bottom + 14.0], n_columns);
    }
    sheet.figure([width, bottom])
}

/// Where a line of code ends.
fn wide(line: &Line) -> f64 {
    let code = metrics::width(Role::Code, &line.code.into());
    INSET + INDENT * f64::from(line.indent) + code
}

const INSET: f64 = 6.0;
const INDENT: f64 = 13.0;

/// A line of code, broken where it is too long; the comment of a lit one below it.
/// Returns its height.
fn code_line(sheet: &mut Sheet, line: &Line, is_lit: bool, top: f64, width: f64) -> f64 {
    let x = INSET + INDENT * f64::from(line.indent);
    let room = width - INSET - x;
    let row = 16.0;
    let code = metrics::wrapped(Role::Code, &line.code.into(), room - INDENT);
    let shown = is_lit && !line.comment.is_empty();
    let comment = if shown {
        metrics::wrapped(Role::Note, &line.comment.as_str().into(), room)
    } else {
        Vec::new()
    };
    let comment_row = line_height(Role::Note);
    let height = row * code.len() as f64 + comment_row * comment.len() as f64;
    if is_lit {
        let extra = if comment.is_empty() { 0.0 } else { 3.0 };
        sheet.rect(Role::LitLine, [0.0, top], [width, height + extra]);
        sheet.line(Role::TransitionTogether, [[1.5, top + 1.0], [1.5, top + height + extra - 1.0]]);
    }
    for (n, piece) in code.iter().enumerate() {
        let x = x + if n > 0 { INDENT } else { 0.0 };
        let at = [x, top + row * (n as f64 + 0.5)];
        sheet.text(Role::Code, at, Anchor::Start, piece.clone());
    }
    let below = top + row * code.len() as f64;
    for (n, piece) in comment.iter().enumerate() {
        let at = [x, below + comment_row * (n as f64 + 0.5)];
        sheet.text(Role::Note, at, Anchor::Start, piece.clone());
    }
    height + if comment.is_empty() { 0.0 } else { 3.0 }
}

/// Widths of the names and the values of variables.
struct Columns {
    names: f64,
    values: f64,
}

impl Columns {
    fn of(variables: &[Changed]) -> Self {
        let names = widest(variables.iter().map(|v| &v.variable.name)) + 12.0;
        let values = widest(variables.iter().map(|v| &v.variable.value)) + 14.0;
        Self { names, values }
    }

    fn width(&self) -> f64 {
        self.names + self.values
    }

    /// Draws the variables in columns, with what has changed lit; returns where
    /// they end.
    fn draw(
        &self,
        sheet: &mut Sheet,
        variables: &[Changed],
        [left, top]: [f64; 2],
        n_columns: usize,
    ) -> f64 {
        const ROW: f64 = 18.0;
        let n_rows = variables.len().div_ceil(n_columns);
        for (n, Changed { variable, is_changed }) in variables.iter().enumerate() {
            let left = left + self.width() * (n / n_rows) as f64;
            let y = top + ROW * (n % n_rows) as f64 + 0.5 * ROW;
            sheet.text(Role::Words, [left, y], Anchor::Start, variable.name.clone());
            let x = left + self.names;
            let wide = metrics::width(Role::Words, &variable.value);
            if *is_changed {
                sheet.rect(Role::LitLine, [x - 4.0, y - 8.0], [wide + 8.0, 16.0]);
            }
            sheet.text(Role::Words, [x, y], Anchor::Start, variable.value.clone());
        }
        top + ROW * n_rows as f64
    }
}

fn widest<'a>(texts: impl Iterator<Item = &'a RichText>) -> f64 {
    texts.map(|text| metrics::width(Role::Words, text)).fold(0.0, f64::max)
}
