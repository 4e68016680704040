//! Formulas as boxes: what stands where, from the widths of the letters.

mod fences;
mod in_figures;

use crate::{Anchor, Drawn, Form, Part, Role, metrics};
use octoscope_core::explain::{Formula, RichText, Room, Span};

/// A formula that is set: y is 0 on its baseline and points down.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SetFormula {
    /// How wide it is.
    pub width: f64,
    /// How far it reaches above the baseline.
    pub above: f64,
    /// How far it reaches below.
    pub below: f64,
    pieces: Vec<Piece>,
}

/// Part of a set formula.
#[derive(Clone, Debug, PartialEq)]
enum Piece {
    /// Letters whose baseline begins at a point; a number if they are one.
    Letters { at: [f64; 2], step: u8, text: RichText, value: Option<f64> },
    /// A line, of a fraction or of a bracket.
    Line(Vec<[f64; 2]>),
}

/// Where a number is written in a figure, maybe in short.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShownNumber {
    /// Upper left corner of its digits.
    pub min: [f64; 2],
    /// Lower right corner of its digits.
    pub max: [f64; 2],
    /// The number to its last digit.
    pub value: f64,
}

/// Share of the type's height at which bars and minus signs lie above the baseline.
const AXIS: f64 = 0.36;
/// Reach of letters above and below the baseline, against the type's height.
const ABOVE: f64 = 0.74;
const BELOW: f64 = 0.2;
/// Half the height of capitals: texts of figures are placed there.
const CAPITALS: f64 = 0.365;

/// Type of a formula: steps down from the largest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FormulaType {
    /// Steps of the formula's own letters.
    pub step: u8,
    /// Most steps of anything in it, however deep.
    pub most: u8,
}

impl FormulaType {
    /// Steps of the smallest type that there is.
    pub const MOST: u8 = 7;

    /// Type of this many steps, whose subscripts may become as small as they like.
    pub fn new(step: u8) -> Self {
        Self { step, most: Self::MOST }
    }

    /// Steps to the smallest type of at least `least` page units.
    pub fn most_for(least: f64) -> u8 {
        (0..=Self::MOST).rev().find(|&step| size(step) >= least).unwrap_or(0)
    }

    /// The type of a part that is so many steps smaller.
    fn smaller(self, steps: u8) -> Self {
        Self { step: (self.step + steps).min(self.most), ..self }
    }
}

/// Height of the type of formulas that are `step` steps smaller than the largest.
fn size(step: u8) -> f64 {
    metrics::size(Role::Formula(step))
}

impl SetFormula {
    /// `formula` in type of a size.
    pub fn of(formula: &Formula, of: FormulaType) -> Self {
        let step = of.step;
        let em = size(step);
        match formula {
            Formula::Row(parts) => {
                let mut row = Self::default();
                for (index, part) in parts.iter().enumerate() {
                    let [before, after] = match part {
                        Formula::Sign(sign) => match sign.room() {
                            Room::Operation => [0.25, 0.25],
                            Room::Relation => [0.3, 0.3],
                            Room::Consequence => [0.55, 0.55],
                            Room::Behind => [0.0, 0.28],
                            Room::Tight => [0.0, 0.05],
                        },
                        Formula::Over { .. } => [0.0, 0.18],
                        Formula::Row(_)
                        | Formula::Symbol { .. }
                        | Formula::Number { .. }
                        | Formula::Digits(_)
                        | Formula::Words(_)
                        | Formula::Sub { .. }
                        | Formula::Sup { .. }
                        | Formula::Fraction { .. }
                        | Formula::Fenced { .. } => [0.0, 0.06],
                    };
                    row.width += if index == 0 { 0.0 } else { before * em };
                    row.append(Self::of(part, of), 0.0);
                    row.width += if index + 1 == parts.len() { 0.0 } else { after * em };
                }
                row
            }
            Formula::Symbol { name, axis } => {
                Self::letters(Span { text: name.clone(), axis: *axis, ..Span::default() }, step)
            }
            Formula::Number { value, shown } => {
                let mut set = Self::letters(plain(shown), step);
                for piece in &mut set.pieces {
                    if let Piece::Letters { value: of, .. } = piece {
                        *of = Some(*value);
                    }
                }
                set
            }
            Formula::Digits(text) | Formula::Words(text) => Self::letters(plain(text), step),
            Formula::Sign(sign) => Self::letters(plain(sign.text()), step),
            Formula::Sub { body, below } => {
                let mut set = Self::of(body, of);
                set.width += 0.02 * em;
                set.append(Self::of(below, of.smaller(2)), 0.2 * em);
                set
            }
            Formula::Sup { body, above } => {
                let mut set = Self::of(body, of);
                let is_prime = **above == Formula::from("′");
                let (smaller, raise) =
                    if is_prime { (of, 0.0) } else { (of.smaller(2), 0.36 * em) };
                set.width += 0.02 * em;
                set.append(Self::of(above, smaller), -raise);
                set
            }
            Formula::Fraction { over, under } => {
                let [over, under] = [over, under].map(|part| Self::of(part, of.smaller(1)));
                let (axis, gap) = (-AXIS * em, 0.14 * em);
                let width = over.width.max(under.width) + 0.24 * em;
                let bar = vec![[0.06 * em, axis], [width - 0.06 * em, axis]];
                let mut set = Self { width, pieces: vec![Piece::Line(bar)], ..Self::default() };
                for (part, shift) in
                    [(&over, axis - gap - over.below), (&under, axis + gap + under.above)]
                {
                    set.place(part.clone(), [0.5 * (width - part.width), shift]);
                }
                set
            }
            Formula::Over { operator, limit } => {
                let (operator, limit) =
                    (Self::letters(plain(operator), step), Self::of(limit, of.smaller(2)));
                let width = operator.width.max(limit.width);
                let mut set = Self { width, ..Self::default() };
                set.place(operator.clone(), [0.5 * (width - operator.width), 0.0]);
                let shift = 0.15 * em + 1.05 * limit.above;
                set.place(limit.clone(), [0.5 * (width - limit.width), shift]);
                set
            }
            Formula::Fenced { fence, body } => Self::fenced(*fence, Self::of(body, of), em, step),
        }
    }

    fn letters(span: Span, step: u8) -> Self {
        let em = size(step);
        let text = RichText(vec![span]);
        let width = metrics::width(Role::Formula(step), &text);
        let piece = Piece::Letters { at: [0.0; 2], step, text, value: None };
        Self { width, above: ABOVE * em, below: BELOW * em, pieces: vec![piece] }
    }

    /// Sets another one to the right, its baseline lower by `drop`.
    fn append(&mut self, other: Self, drop: f64) {
        let width = other.width;
        self.place(other, [self.width, drop]);
        self.width += width;
    }

    fn place(&mut self, other: Self, [x, y]: [f64; 2]) {
        self.above = self.above.max(other.above - y);
        self.below = self.below.max(other.below + y);
        self.pieces.extend(other.pieces.into_iter().map(|piece| match piece {
            Piece::Letters { at, step, text, value } => {
                Piece::Letters { at: [at[0] + x, at[1] + y], step, text, value }
            }
            Piece::Line(points) => {
                Piece::Line(points.into_iter().map(|[px, py]| [px + x, py + y]).collect())
            }
        }));
    }

    /// Its letters and lines, with its baseline beginning at a point.
    pub fn drawn(&self, [x, y]: [f64; 2]) -> Vec<Drawn> {
        let drawn = |(role, part, form)| Drawn { form, role, part, node: None };
        let pieces = self.pieces.iter().map(|piece| match piece {
            Piece::Letters { at, step, text, .. } => {
                let at = [x + at[0], y + at[1] - CAPITALS * size(*step)];
                let form = Form::Text { at, anchor: Anchor::Start, text: text.clone() };
                (Role::Formula(*step), Part::Whole, form)
            }
            Piece::Line(points) => {
                let points = points.iter().map(|[px, py]| [x + px, y + py]).collect();
                (Role::FormulaLine, Part::Edge, Form::Polyline(points))
            }
        });
        pieces.map(drawn).collect()
    }

    /// Its numbers, with its baseline beginning at a point.
    fn numbers(&self, [x, y]: [f64; 2]) -> Vec<ShownNumber> {
        let numbers = self.pieces.iter().filter_map(|piece| match piece {
            Piece::Letters { at, step, text, value } => {
                let (left, base, em) = (x + at[0], y + at[1], size(*step));
                let width = metrics::width(Role::Formula(*step), text);
                Some(ShownNumber {
                    min: [left, base - ABOVE * em],
                    max: [left + width, base + BELOW * em],
                    value: (*value)?,
                })
            }
            Piece::Line(_) => None,
        });
        numbers.collect()
    }
}

fn plain(text: &str) -> Span {
    Span { text: text.to_owned(), ..Span::default() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Figure;
    use octoscope_core::explain::{Fence, Sign, misprint_formula};
    use octoscope_core::traverse::Variant;

    /// Corners of what a drawn letter or line covers.
    fn box_of(drawn: &Drawn) -> [f64; 4] {
        match &drawn.form {
            Form::Text { at: [x, y], text, .. } => {
                let (width, em) = (metrics::width(drawn.role, text), metrics::size(drawn.role));
                let base = y + CAPITALS * em;
                [*x, base - 0.74 * em, x + width, base + 0.02 * em]
            }
            Form::Polyline(points) => {
                let fold = |e: usize, f: fn(f64, f64) -> f64| {
                    points.iter().map(|p| p[e]).reduce(f).unwrap()
                };
                [fold(0, f64::min), fold(1, f64::min), fold(0, f64::max), fold(1, f64::max)]
            }
            Form::Polygon(_) | Form::Circle { .. } | Form::Formula { .. } => panic!("{drawn:?}"),
        }
    }

    fn check(formula: &Formula, step: u8) {
        let set = SetFormula::of(formula, FormulaType::new(step));
        let drawn = set.drawn([0.0, 0.0]);
        let boxes: Vec<[f64; 4]> = drawn.iter().map(box_of).collect();
        for (index, a) in boxes.iter().enumerate() {
            assert!(a[0] >= -1e-9 && a[2] <= set.width + 1e-9, "{formula:?}: {a:?}");
            assert!(a[1] >= -set.above - 1e-9 && a[3] <= set.below + 1e-9, "{formula:?}: {a:?}");
            for b in &boxes[..index] {
                let is_apart = a[2] <= b[0] + 0.2
                    || b[2] <= a[0] + 0.2
                    || a[3] <= b[1] + 0.2
                    || b[3] <= a[1] + 0.2;
                // A bracket bends around what is in it.
                assert!(is_apart, "{formula:?}: {a:?} {b:?}");
            }
        }
    }

    #[test]
    fn nothing_in_a_formula_covers_another_part_or_leaves_its_box() {
        for variant in Variant::ALL {
            let Some(misprint) = misprint_formula(variant) else { continue };
            for step in 0..6 {
                check(&misprint.printed, step);
                check(&misprint.right, step);
            }
        }
    }

    fn fraction() -> Formula {
        let [over, under] = ["a", "b"].map(|name| Box::new(Formula::from(name)));
        Formula::Fraction { over, under }
    }

    #[test]
    fn a_bar_lies_between_what_is_over_and_under_it_at_the_height_of_a_minus() {
        let row = Formula::Row(vec!["x".into(), Sign::Minus.into(), fraction()]);
        let drawn = SetFormula::of(&row, FormulaType::new(0)).drawn([0.0, 0.0]);
        let boxes: Vec<[f64; 4]> = drawn.iter().map(box_of).collect();
        let [_, _, bar, over, under] = boxes[..] else { panic!("{boxes:?}") };
        assert!(over[3] < bar[1] && bar[1] < under[1]);
        assert!((bar[1] + AXIS * size(0)).abs() < 1e-9);
        assert!(bar[0] < over[0] && over[2] < bar[2]);
    }

    #[test]
    fn parts_of_a_row_share_their_baseline() {
        let row = Formula::Row(vec!["t".into(), Sign::Less.into(), Formula::Digits("12".into())]);
        let drawn = SetFormula::of(&row, FormulaType::new(1)).drawn([3.0, 40.0]);
        let heights = drawn.iter().map(|drawn| match drawn.form {
            Form::Text { at: [_, y], .. } => y,
            _ => panic!("{drawn:?}"),
        });
        assert!(heights.into_iter().all(|y| (y - 40.0 + CAPITALS * size(1)).abs() < 1e-9));
    }

    #[test]
    fn brackets_are_as_high_as_what_is_between_them() {
        for fence in [Fence::Round, Fence::Floor, Fence::Ceiling, Fence::Absolute] {
            let fenced = Formula::Fenced { fence, body: Box::new(fraction()) };
            let [inner, outer] =
                [&fraction(), &fenced].map(|one| SetFormula::of(one, FormulaType::new(0)));
            assert!(outer.above >= inner.above && outer.below >= inner.below);
            assert!(outer.width > inner.width + 0.4 * size(0));
            check(&fenced, 0);
        }
    }

    #[test]
    fn numbers_keep_all_their_digits() {
        let value = 1.0 / 3.0;
        let formula = Formula::Number { value, shown: "0.3333".to_owned() };
        let form =
            Form::Formula { at: [0.0, 20.0], of: FormulaType::new(0), formula: Box::new(formula) };
        let drawn = vec![Drawn { form, role: Role::Formula(0), part: Part::Whole, node: None }];
        let figure = Figure { page: crate::Page { width: 100.0, height: 30.0 }, drawn };
        let numbers = figure.numbers();
        assert_eq!(numbers.len(), 1);
        assert_eq!(numbers[0].value, value);
        assert!(numbers[0].min[1] < 20.0 && numbers[0].max[0] > 30.0);
        assert_eq!(figure.spelled_out().drawn.len(), 1);
    }
}
