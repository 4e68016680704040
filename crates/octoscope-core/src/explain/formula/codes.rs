//! Location codes: how places become codes, how codes are followed and compared.

use super::Statement;
use super::numbers::{binary, equal, number, operand, told_apart};
use super::term::{Fence, Formula, Sign, row};
use super::writer::Writer;
use crate::event::Event;
use crate::geometry::Axes;
use crate::traverse::Variant;
use crate::tree::{Child, Code};

impl<const D: usize> Writer<'_, D> {
    fn width(&self) -> u8 {
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

    /// One bit of every code: i_x = (c_x ≫ (l − 1)) ∧ 1, and how it is read in print.
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
                        row![self.word("formula-reversed"), self.code(e, "").fenced(Fence::Round)]
                    }
                    (false, false) => self.code(e, ""),
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
        self.past.iter().rev().find_map(|event| match event {
            &Event::Encode { code, .. } => Some(code),
            _ => None,
        })
    }

    /// The codes beyond a side.
    pub(super) fn target(
        &self,
        level: u8,
        from: Code<D>,
        to: [i64; D],
        axes: Axes<D>,
    ) -> Vec<Statement> {
        let k = self.notation.level();
        let side = |exponent: Formula| Formula::from(2).sup(exponent);
        (0..D)
            .map(|e| {
                let (old, new) = (self.code(e, ""), self.code(e, "").sup("′"));
                let (was, is) = (i64::from(from[e]), to[e]);
                if !axes.contains(e) {
                    if is == was {
                        return Statement {
                            symbols: row![new, Sign::Equal, old],
                            numbers: Some(row![is]),
                        };
                    }
                    let end = row![old.clone(), Sign::Plus, side(k.into())];
                    return Statement {
                        symbols: row![old, Sign::LessOrEqual, new, Sign::Less, end],
                        numbers: Some(row![
                            was,
                            Sign::LessOrEqual,
                            is,
                            Sign::Less,
                            was + (1 << level),
                        ]),
                    };
                }
                let (sign, by, amount) = if is > was {
                    (Sign::Plus, side(k.into()), side(i64::from(level).into()))
                } else if self.has(Variant::B28) {
                    (Sign::Minus, side(k.into()), side(i64::from(level).into()))
                } else {
                    (Sign::Minus, 1.into(), 1.into())
                };
                Statement {
                    symbols: row![new, Sign::Equal, old, sign, by],
                    numbers: Some(row![was, sign, amount, Sign::Equal, is]),
                }
            })
            .collect()
    }

    pub(super) fn border(&self, tested: Axes<D>, outside: Axes<D>) -> Vec<Statement> {
        let domain = self.tree.domain();
        if let Some([_, point]) = self.before.pushed {
            let inside = |e: usize| {
                let (low, high) = (domain.plane(e, 0), domain.plane(e, domain.grid_size()));
                let name = Formula::coordinate(e, "").sup("′");
                let [x0, x1] = ["0", "1"].map(|index| Formula::coordinate(e, index));
                let [low_shown, x, high_shown] = told_apart([low, point[e], high]);
                self.between(
                    [x0, name, x1],
                    [low_shown, x, high_shown],
                    [point[e] < low, outside.contains(e)],
                )
            };
            return tested.iter().map(inside).collect();
        }
        let Some(target) = self.before.target else { return Vec::new() };
        let size = Formula::from(2).sup("R");
        tested
            .iter()
            .map(|e| {
                let to = target.to[e];
                let name = self.code(e, "").sup("′");
                let numbers = [0, to, i64::from(domain.grid_size())].map(Formula::from);
                self.between([0.into(), name, size.clone()], numbers, [to < 0, outside.contains(e)])
            })
            .collect()
    }

    /// a ≤ b < c, or which of both does not hold.
    fn between(
        &self,
        names: [Formula; 3],
        values: [Formula; 3],
        [is_below, is_outside]: [bool; 2],
    ) -> Statement {
        let line = |[low, x, high]: [Formula; 3]| match (is_outside, is_below) {
            (false, _) => row![low, Sign::LessOrEqual, x, Sign::Less, high],
            (true, true) => row![x, Sign::Less, low],
            (true, false) => row![x, Sign::GreaterOrEqual, high],
        };
        let end = self.word("formula-no-cell");
        let symbols = line(names);
        let symbols = if is_outside { row![symbols, Sign::Implies, end] } else { symbols };
        Statement { symbols, numbers: Some(line(values)) }
    }

    /// XOR of the codes, its highest 1, and the level above.
    pub(super) fn difference(
        &self,
        from: Code<D>,
        to: Code<D>,
        xor: Code<D>,
        level: u8,
    ) -> Vec<Statement> {
        let width = self.width();
        let sign = self.notation.xor();
        let delta = self.notation.difference();
        let is_region = self.before.corners.is_some();
        let mut all: Vec<Statement> = (0..D)
            .map(|e| {
                let [a, b] = match is_region {
                    true => ["0", "1"].map(|index| self.code(e, index)),
                    false => [self.code(e, ""), self.code(e, "").sup("′")],
                };
                Statement {
                    symbols: row![Formula::on(e, delta, ""), Sign::Equal, a, sign, b],
                    numbers: Some(row![
                        binary(from[e], width),
                        sign,
                        binary(to[e], width),
                        Sign::Equal,
                        binary(xor[e], width),
                    ]),
                }
            })
            .collect();
        all.push(self.level_of(xor, level));
        all
    }

    /// l = 1 + ⌊log₂ (Δ_x ∨ Δ_y)⌋, or as it is printed.
    fn level_of(&self, xor: Code<D>, level: u8) -> Statement {
        let k = self.notation.level();
        let delta = self.notation.difference();
        let both = self.has(Variant::B24b);
        let sign = if both { self.notation.and() } else { self.notation.or() };
        let joined = xor.into_iter().reduce(|a, b| if both { a & b } else { a | b }).unwrap_or(0);
        let all = || Formula::separated((0..D).map(|e| Formula::on(e, delta, "")), sign);
        let bits = binary(joined, self.width());
        let climbs = [
            (Variant::B25Leftmost, "formula-leftmost"),
            (Variant::B25Rightmost, "formula-rightmost"),
        ];
        for (variant, key) in climbs {
            if self.has(variant) {
                return Statement {
                    symbols: row![self.word(key), all().fenced(Fence::Round), Sign::Equal, 0],
                    numbers: Some(row![bits, Sign::Implies, k, Sign::Equal, i64::from(level)]),
                };
            }
        }
        if joined == 0 {
            return Statement {
                symbols: row![all(), Sign::Equal, 0, Sign::Implies, k, Sign::Equal, 0],
                numbers: Some(row![bits, Sign::Implies, k, Sign::Equal, i64::from(level)]),
            };
        }
        let logarithm = |of: Formula| {
            row![Formula::Words("log".to_owned()).sub(2), of.fenced(Fence::Round)]
                .fenced(Fence::Floor)
        };
        let number = |of: Formula| match self.has(Variant::B24a) {
            true => logarithm(of),
            false => row![1, Sign::Plus, logarithm(of)],
        };
        Statement {
            symbols: row![k, Sign::Equal, number(all())],
            numbers: Some(row![number(bits.sub(2)), Sign::Equal, i64::from(level)]),
        }
    }

    /// The bit at the level is 1: up to the parent.
    pub(super) fn climb(&self, level: u8) -> Vec<Statement> {
        let Some(difference) = self.before.difference else { return Vec::new() };
        let k = self.notation.level();
        let joined = difference.xor.into_iter().fold(0, |all, c| all | c);
        let (and, delta) = (self.notation.and(), self.notation.difference());
        let bit = joined >> (level - 1) & 1;
        let shifted = |of: Formula, by: Formula| row![of, Sign::Shift, by].fenced(Fence::Round);
        vec![Statement {
            symbols: row![
                shifted(delta.into(), k.into()),
                and,
                1,
                Sign::Equal,
                i64::from(bit),
                Sign::Implies,
                k,
                Sign::Takes,
                k,
                Sign::Plus,
                1,
            ],
            numbers: Some(row![
                shifted(binary(joined, self.width()), i64::from(level - 1).into()),
                and,
                1,
                Sign::Equal,
                i64::from(bit),
                Sign::Implies,
                k,
                Sign::Equal,
                i64::from(level),
            ]),
        }]
    }

    /// The point of exit, pushed by half a smallest cell.
    pub(super) fn push(&self, from: [f64; D], to: [f64; D], axis: usize) -> Statement {
        let cell = self.tree.domain().cell_side(0);
        let sign = if self.ray.direction()[axis] < 0.0 { Sign::Minus } else { Sign::Plus };
        let x = Formula::coordinate(axis, "");
        let half = Formula::from("h").over(2);
        Statement {
            symbols: row![x.clone().sup("′"), Sign::Equal, x, sign, half],
            numbers: Some(row![
                number(from[axis]),
                sign,
                number(cell).over(2),
                equal(&[from[axis], cell, to[axis]]),
                number(to[axis]),
            ]),
        }
    }
}
