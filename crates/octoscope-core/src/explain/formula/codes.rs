//! Location codes: how places become codes, how codes are followed and compared.

use super::Statement;
use super::numbers::{binary, number, operand, told_apart};
use super::term::{Fence, Formula, Sign, row};
use super::writer::Writer;
use crate::event::Event;
use crate::query::Query;
use crate::traverse::Variant;
use crate::tree::{Child, Code};

impl<const D: usize> Writer<'_, D> {
    pub(super) fn width(&self) -> u8 {
        self.tree.domain().root_level()
    }

    /// A code on an axis: c_x.
    pub(super) fn code(&self, axis: usize, more: &str) -> Formula {
        Formula::on(axis, self.notation.code(), more)
    }

    /// ⌊(x − O_x) / S · 2^R⌋ with symbols and with numbers.
    fn cell_of(&self, axis: usize, name: Formula, x: f64) -> [Formula; 2] {
        let domain = self.tree.domain();
        let (low, side) = (domain.min()[axis], domain.side());
        let levels = i64::from(domain.root_level());
        let power = |exponent: Formula| Formula::from(2).sup(exponent);
        let symbols = row![name, Sign::Minus, Formula::on(axis, "O", "")].over("S");
        let numbers = row![number(x), Sign::Minus, operand(low)].over(number(side));
        [
            row![symbols, Sign::Times, power("R".into())].fenced(Fence::Floor),
            row![numbers, Sign::Times, power(levels.into())].fenced(Fence::Floor),
        ]
    }

    pub(super) fn encode(
        &self,
        point: [f64; D],
        code: Code<D>,
        after: Option<f64>,
    ) -> Vec<Statement> {
        (0..D)
            .map(|e| match after {
                Some(t) if self.ray.direction()[e] != 0.0 => self.passed(e, code[e], t),
                Some(_) | None => {
                    let [symbols, numbers] = self.cell_of(e, Formula::coordinate(e, ""), point[e]);
                    Statement {
                        symbols: row![self.code(e, ""), Sign::Equal, symbols],
                        numbers: Some(row![
                            numbers,
                            Sign::Equal,
                            i64::from(code[e]),
                            Sign::Equal,
                            binary(code[e], self.width()).sub(2),
                        ]),
                    }
                }
            })
            .collect()
    }

    /// The planes of the smallest cell between which the ray is just after `t`.
    fn passed(&self, axis: usize, code: u32, t: f64) -> Statement {
        let domain = self.tree.domain();
        let (origin, direction) = (self.ray.origin()[axis], self.ray.direction()[axis]);
        let at = |index: u32| (domain.plane(axis, index) - origin) / direction;
        let (c, one) = (self.code(axis, ""), row![self.code(axis, ""), Sign::Plus, 1]);
        let (near, far, names) = match direction > 0.0 {
            true => (at(code), at(code + 1), [row![c], one]),
            false => (at(code + 1), at(code), [one, row![c]]),
        };
        let [near_name, far_name] = names.map(|name| {
            let t = Formula::Symbol { name: "t".to_owned(), axis: Some(axis) };
            row![t, name.fenced(Fence::Round)]
        });
        let [near, now, far] = told_apart([near, t, far]);
        Statement {
            symbols: row![near_name, Sign::LessOrEqual, "t", Sign::Less, far_name],
            numbers: Some(row![
                near,
                Sign::LessOrEqual,
                now,
                Sign::Less,
                far,
                Sign::Implies,
                self.code(axis, ""),
                Sign::Equal,
                i64::from(code),
            ]),
        }
    }

    pub(super) fn corners(
        &self,
        [min, max]: [[f64; D]; 2],
        [from, to]: [Code<D>; 2],
    ) -> Vec<Statement> {
        let corner = |e: usize, index: &str, x: f64, code: u32| {
            let [symbols, numbers] = self.cell_of(e, Formula::coordinate(e, index), x);
            Statement {
                symbols: row![self.code(e, index), Sign::Equal, symbols],
                numbers: Some(row![numbers, Sign::Equal, binary(code, self.width()).sub(2)]),
            }
        };
        let both = |e: usize| [corner(e, "0", min[e], from[e]), corner(e, "1", max[e], to[e])];
        (0..D).flat_map(both).collect()
    }

    pub(super) fn compare(
        &self,
        mid: [f64; D],
        point: [f64; D],
        child: Child<D>,
    ) -> Vec<Statement> {
        let mut all: Vec<Statement> = (0..D)
            .map(|e| {
                let bit = child.is_upper(e);
                let sign = if bit { Sign::GreaterOrEqual } else { Sign::Less };
                let [x, m] = told_apart([point[e], mid[e]]);
                Statement {
                    symbols: row![
                        Formula::coordinate(e, ""),
                        sign,
                        Formula::coordinate(e, "m"),
                        Sign::Implies,
                        self.bit(e),
                        Sign::Equal,
                        i64::from(bit),
                    ],
                    numbers: Some(row![x, sign, m]),
                }
            })
            .collect();
        all.push(self.index(child));
        all
    }

    /// One bit of every code: i_x = (c_x >> (l − 1)) and 1, and how it is read in print.
    pub(super) fn follow(&self, level: u8, code: Code<D>, child: Child<D>) -> Vec<Statement> {
        let k = self.notation.level();
        let and = self.notation.and();
        let by_level = self.has(Variant::B19);
        let backwards = self.has(Variant::B18);
        let by_difference = self.has(Variant::B24c);
        // What is followed is what the codes are taken for; in print, more is shifted.
        let printed = self.encoded().filter(|_| by_level);
        let shown = |e: usize| match printed {
            Some(code) if backwards => {
                code[e].reverse_bits() >> (u32::BITS - 1 - u32::from(self.width()))
            }
            Some(code) => code[e],
            None => code[e],
        };
        // Of a region, that of its lower corner.
        let which = if matches!(self.query, Query::Region { .. }) { "0" } else { "" };
        let amount = match printed {
            Some(_) => Formula::from(k),
            None => row![k, Sign::Minus, 1].fenced(Fence::Round),
        };
        let shift = i64::from(if printed.is_some() { level } else { level - 1 });
        let mut all: Vec<Statement> = (0..D)
            .map(|e| {
                let name = match (by_difference, backwards) {
                    (true, _) => Formula::on(e, self.notation.difference(), ""),
                    (false, true) => {
                        row![
                            self.word("formula-reversed"),
                            self.code(e, which).fenced(Fence::Round)
                        ]
                    }
                    (false, false) => self.code(e, which),
                };
                let bits = binary(shown(e), self.width() + u8::from(backwards || by_level));
                let (name, bits) =
                    (row![name, Sign::Shift, amount.clone()], row![bits, Sign::Shift, shift]);
                Statement {
                    symbols: row![self.bit(e), Sign::Equal, name.fenced(Fence::Round), and, 1],
                    numbers: Some(row![
                        bits.fenced(Fence::Round),
                        and,
                        1,
                        Sign::Equal,
                        i64::from(child.is_upper(e)),
                    ]),
                }
            })
            .collect();
        all.push(self.index(child));
        all
    }

    /// The codes that a place was turned into last.
    fn encoded(&self) -> Option<Code<D>> {
        self.past.iter().rev().find_map(|event| {
            if let &Event::Encode { code, .. } = event { Some(code) } else { None }
        })
    }
}
