//! Codes of what lies beyond a side, and the level of what holds both places.

use super::Statement;
use super::numbers::{binary, equal, number, told_apart};
use super::term::{Fence, Formula, Sign, row};
use super::writer::Writer;
use crate::geometry::Axes;
use crate::traverse::Variant;
use crate::tree::{self, Code};

impl<const D: usize> Writer<'_, D> {
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
        let width = self.difference_width();
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

    /// Digits of a difference: as many as levels lie below the root, and for who looks at
    /// the leftmost one, that of the root.
    fn difference_width(&self) -> u8 {
        self.width() + u8::from(self.has(Variant::B25Leftmost))
    }

    /// l = 1 + ⌊log₂ (Δ_x or Δ_y)⌋, or as it is printed.
    fn level_of(&self, xor: Code<D>, level: u8) -> Statement {
        let k = self.notation.level();
        let delta = self.notation.difference();
        let both = self.has(Variant::B24b);
        let sign = if both { self.notation.and() } else { self.notation.or() };
        let joined = xor.into_iter().reduce(|a, b| if both { a & b } else { a | b }).unwrap_or(0);
        let all = || Formula::separated((0..D).map(|e| Formula::on(e, delta, "")), sign);
        let bits = binary(joined, self.difference_width());
        let climbs = [
            (Variant::B25Leftmost, "formula-leftmost"),
            (Variant::B25Rightmost, "formula-rightmost"),
        ];
        for (variant, key) in climbs {
            if self.has(variant) {
                let climbs = variant == Variant::B25Rightmost && joined & 1 == 1;
                let sign = if climbs { Sign::Unequal } else { Sign::Equal };
                return Statement {
                    symbols: row![self.word(key), all().fenced(Fence::Round), sign, 0],
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
        let joined = tree::joined(difference.xor);
        let (and, delta) = (self.notation.and(), self.notation.difference());
        // In print the rightmost digit decides, whatever the level.
        let by = if self.has(Variant::B25Rightmost) { 0 } else { level - 1 };
        let bit = joined >> by & 1;
        let bits = binary(joined, self.width());
        let shifted = |of: Formula, amount: Formula| match self.has(Variant::B25Rightmost) {
            true => of,
            false => row![of, Sign::Shift, amount].fenced(Fence::Round),
        };
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
                shifted(bits, i64::from(by).into()),
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
