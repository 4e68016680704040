//! Cuts of the ray's interval: sorted, classified, flipped, halved.

use super::Statement;
use super::numbers::{equal, number, told_apart};
use super::term::{Fence, Formula, Sign, row};
use super::writer::Writer;
use crate::event::Halves;
use crate::geometry::Axes;
use crate::trace::Frame;
use crate::traverse::Variant;
use crate::tree::Child;

impl<const D: usize> Writer<'_, D> {
    fn mid(&self) -> [f64; D] {
        self.before.frame().and_then(|frame| frame.mid).unwrap_or([f64::NAN; D])
    }

    fn ends(&self) -> [f64; 2] {
        self.before.frame().map_or([f64::NAN; 2], |frame| [Frame::enter(frame), frame.exit()])
    }

    /// The mid planes inside the interval in their order, and those that are not.
    pub(super) fn cuts(&self, order: [u8; D], inside: Axes<D>) -> Vec<Statement> {
        let (mid, ends) = (self.mid(), self.ends());
        let numbers: Vec<f64> = ends.into_iter().chain(mid).collect();
        let shown = crate::explain::number::distinct(&numbers);
        let value = |n: usize| Formula::Number { value: numbers[n], shown: shown[n].clone() };
        let [t_min, t_max] = ["min", "max"].map(|name| Formula::from("t").sub(name));
        let chain: Vec<usize> =
            order.into_iter().map(usize::from).filter(|&e| inside.contains(e)).collect();
        let (mut symbols, mut values) = (vec![t_min.clone()], vec![value(0)]);
        let mut last = None;
        for &e in &chain {
            let is_same = last.is_some_and(|last: usize| mid[last] == mid[e]);
            let sign = if is_same { Sign::Equal } else { Sign::Less };
            symbols.extend([sign.into(), self.t(e, "m")]);
            values.extend([sign.into(), value(2 + e)]);
            last = Some(e);
        }
        symbols.extend([Sign::Less.into(), t_max.clone()]);
        values.extend([Sign::Less.into(), value(1)]);
        let mut all =
            vec![Statement { symbols: Formula::Row(symbols), numbers: Some(Formula::Row(values)) }];
        let outside = (0..D).filter(|&e| !inside.contains(e));
        all.extend(outside.map(|e| Statement {
            symbols: row![
                self.t(e, "m"),
                Sign::NotIn,
                Formula::list([t_min.clone(), t_max.clone()]).fenced(Fence::Round),
            ],
            numbers: Some(row![
                value(2 + e),
                Sign::NotIn,
                Formula::list([value(0), value(1)]).fenced(Fence::Round),
            ]),
        }));
        all
    }

    /// On which side of every mid plane the ray is: one bit each.
    pub(super) fn classify(
        &self,
        at: f64,
        piece: Option<[f64; 2]>,
        child: Child<D>,
    ) -> Vec<Statement> {
        let mid = self.mid();
        let mask = self.before.clip.map_or(Axes::NONE, |clip| clip.mirror);
        let passed = Axes::<D>(child.0 ^ mask.0);
        let mut all = Vec::new();
        let name = match piece {
            None => Formula::from("t").sub("min"),
            Some([from, to]) => {
                let ends = [from, to].map(number);
                let [first, last] = ["0", "1"].map(|n| Formula::from("t").sub(n));
                all.push(Statement {
                    symbols: row!["t", Sign::Equal, row![first, Sign::Plus, last].over(2)],
                    numbers: Some(row![
                        Formula::separated(ends, Sign::Plus).over(2),
                        equal(&[from, to, at]),
                        number(at),
                    ]),
                });
                "t".into()
            }
        };
        let numbers: Vec<f64> = mid.into_iter().chain([at]).collect();
        let shown = crate::explain::number::distinct(&numbers);
        let value = |n: usize| Formula::Number { value: numbers[n], shown: shown[n].clone() };
        all.extend((0..D).map(|e| {
            let sign = if passed.contains(e) { Sign::LessOrEqual } else { Sign::Greater };
            let bit = i64::from(child.is_upper(e));
            let mut symbols = vec![
                self.t(e, "m"),
                sign.into(),
                name.clone(),
                Sign::Implies.into(),
                self.bit(e),
                Sign::Equal.into(),
            ];
            let mut numbers = vec![value(e), sign.into(), value(D)];
            if mask.contains(e) {
                // Downwards the upper half comes first.
                let (passed, xor) = (i64::from(passed.contains(e)), self.notation.xor());
                symbols.extend([passed.into(), xor.into(), Formula::on(e, "a", "")]);
                numbers.push(row![
                    Sign::Implies,
                    self.bit(e),
                    Sign::Equal,
                    passed,
                    xor,
                    1,
                    Sign::Equal,
                    bit
                ]);
            } else {
                symbols.push(bit.into());
            }
            Statement { symbols: Formula::Row(symbols), numbers: Some(Formula::Row(numbers)) }
        }));
        all.push(self.index(child));
        all
    }

    /// The next plane and the bits that it flips.
    pub(super) fn flip(&self, at: f64, axes: Axes<D>, child: Child<D>) -> Vec<Statement> {
        let letter = self.notation.child();
        let before = self.index_of(Child(child.0 ^ axes.0));
        let xor = self.notation.xor();
        let names = Formula::separated(axes.iter().map(|e| self.t(e, "m")), Sign::Equal);
        vec![
            Statement {
                symbols: row!["t", Sign::Equal, names],
                numbers: Some(row!["t", Sign::Equal, number(at)]),
            },
            Statement {
                symbols: row![letter, Sign::Takes, letter, xor, self.axes("formula-axes-crossed")],
                numbers: Some(row![
                    before,
                    xor,
                    self.mask_of(axes),
                    Sign::Equal,
                    self.index_of(child),
                ]),
            },
        ]
    }

    /// The parameter of one plane, and where it lies in the interval.
    pub(super) fn split(
        &self,
        axis: usize,
        [plane, at]: [f64; 2],
        interval: [f64; 2],
        halves: Halves,
    ) -> Vec<Statement> {
        let mut all = Vec::new();
        let (origin, direction) = (self.origin(axis), self.direction(axis));
        let [t_min, t_max] = ["min", "max"].map(|name| Formula::from("t").sub(name));
        if direction != 0.0 || self.has(Variant::Gem) {
            let [symbols, numbers] = self.quotient(axis, "m", plane);
            let told = [plane, origin, direction, at];
            all.push(Statement {
                symbols: row![self.t_of_node(axis, "m"), Sign::Equal, symbols],
                numbers: Some(row![numbers, equal(&told), number(at)]),
            });
        } else {
            let sign = if plane <= origin { Sign::LessOrEqual } else { Sign::Greater };
            let [x, p] = told_apart([plane, origin]);
            all.push(Statement {
                symbols: row![Formula::coordinate(axis, "m"), sign, Formula::on(axis, "p", "")],
                numbers: Some(row![x, sign, p]),
            });
            return all;
        }
        let [enter, exit] = interval;
        let [at_shown, enter_shown, exit_shown] = told_apart([at, enter, exit]);
        let t = self.t(axis, "m");
        let is_gem = self.has(Variant::Gem);
        let (later, earlier, not_after) = match is_gem {
            true => (Sign::Greater, Sign::Less, Sign::Less),
            false => (Sign::GreaterOrEqual, Sign::LessOrEqual, Sign::LessOrEqual),
        };
        let is_after = if is_gem { at > exit } else { at >= exit };
        let near = self.word("formula-near-half");
        let (symbols, numbers) = match halves {
            Halves::Near if is_after => {
                (row![t, later, t_max, Sign::Implies, near], row![at_shown, later, exit_shown])
            }
            Halves::Near => (row![t, earlier, 0, Sign::Implies, near], row![at_shown, earlier, 0]),
            Halves::Far => (
                row![t, not_after, t_min, Sign::Implies, self.word("formula-far-half")],
                row![at_shown, not_after, enter_shown],
            ),
            Halves::Both if at.is_nan() => {
                let none =
                    row![t, Sign::Greater, t_max, Sign::Or, self.t(axis, "m"), Sign::Less, t_min];
                let values = row![
                    at_shown.clone(),
                    Sign::Greater,
                    exit_shown,
                    Sign::Or,
                    at_shown,
                    Sign::Less,
                    enter_shown
                ];
                (
                    row![
                        Sign::Not,
                        none.fenced(Fence::Round),
                        Sign::Implies,
                        self.word("formula-both-halves")
                    ],
                    row![Sign::Not, values.fenced(Fence::Round)],
                )
            }
            Halves::Both => {
                let sign = if is_gem { Sign::LessOrEqual } else { Sign::Less };
                (
                    row![
                        t_min,
                        sign,
                        t,
                        sign,
                        t_max,
                        Sign::Implies,
                        self.word("formula-both-halves")
                    ],
                    row![enter_shown, sign, at_shown, sign, exit_shown],
                )
            }
        };
        all.push(Statement { symbols, numbers: Some(numbers) });
        all
    }
}
