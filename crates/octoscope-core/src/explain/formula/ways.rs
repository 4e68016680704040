//! Ways from cell to cell: through the grid, and by the path through the tree.

use super::Statement;
use super::numbers::{equal, number};
use super::term::{Formula, Sign, row};
use super::writer::Writer;
use crate::geometry::Axes;
use crate::tree::{Child, Code};

impl<const D: usize> Writer<'_, D> {
    /// Parameters of the planes ahead of a cell.
    pub(super) fn grid(&self, cell: Code<D>, next: [f64; D]) -> Vec<Statement> {
        let moves = (0..D).filter(|&e| self.ray.direction()[e] != 0.0);
        moves
            .map(|e| {
                let is_up = self.ray.direction()[e] > 0.0;
                let plane = self.tree.domain().plane(e, cell[e] + u32::from(is_up));
                let [symbols, numbers] = self.quotient(e, if is_up { "1" } else { "0" }, plane);
                let told = [plane, self.origin(e), self.direction(e), next[e]];
                Statement {
                    symbols: row![self.t(e, "Max"), Sign::Equal, symbols],
                    numbers: Some(row![numbers, equal(&told), number(next[e])]),
                }
            })
            .collect()
    }

    /// The first plane ahead, and the code beyond it.
    pub(super) fn cross(
        &self,
        next: [f64; D],
        axes: Axes<D>,
        cell: [i64; D],
        outside: Axes<D>,
    ) -> Vec<Statement> {
        let mut all = vec![self.earliest(&[], next, axes, "Max")];
        all.extend(axes.iter().map(|e| {
            let is_up = self.ray.direction()[e] > 0.0;
            let sign = if is_up { Sign::Plus } else { Sign::Minus };
            let before = cell[e] - if is_up { 1 } else { -1 };
            let code = self.code(e, "");
            let takes = row![code.clone(), Sign::Takes, code, sign, 1];
            let becomes = row![before, sign, 1, Sign::Equal, cell[e]];
            let end = self.word("formula-no-cell");
            let (symbols, numbers) = match outside.contains(e) {
                true => (takes, row![becomes, Sign::Implies, end]),
                false => (takes, becomes),
            };
            Statement { symbols, numbers: Some(numbers) }
        }));
        all
    }

    /// Which part of a direction a child's side of its parent has in common with it.
    pub(super) fn parent(
        &self,
        child: Child<D>,
        direction: [i8; D],
        common: [i8; D],
    ) -> Vec<Statement> {
        let asked = (0..D).filter(|&e| direction[e] != 0);
        asked
            .map(|e| {
                let (bit, is_up) = (i64::from(child.is_upper(e)), direction[e] > 0);
                let same = common[e] != 0;
                let sign = if same { Sign::Equal } else { Sign::Unequal };
                let side = if is_up { Sign::Greater } else { Sign::Less };
                let s = Formula::on(e, "s", "");
                let left: Formula = if same { s.clone() } else { 0.into() };
                Statement {
                    symbols: row![
                        s.clone(),
                        side,
                        0,
                        Sign::And,
                        self.bit(e),
                        sign,
                        i64::from(is_up),
                        Sign::Implies,
                        s.clone().sup("′"),
                        Sign::Equal,
                        left,
                    ],
                    numbers: Some(row![
                        i64::from(direction[e]),
                        side,
                        0,
                        Sign::And,
                        bit,
                        sign,
                        i64::from(is_up),
                        Sign::Implies,
                        s.sup("′"),
                        Sign::Equal,
                        i64::from(common[e]),
                    ]),
                }
            })
            .collect()
    }

    /// The child that mirrors the one on the way up.
    pub(super) fn mirror(&self, child: Child<D>, mirrored: Child<D>) -> Statement {
        let letter = self.notation.child();
        let xor = self.notation.xor();
        let mask = self.mask_of(Axes(child.0 ^ mirrored.0));
        let axes = self.axes("formula-axes-mirrored");
        Statement {
            symbols: row![Formula::from(letter).sup("′"), Sign::Equal, letter, xor, axes],
            numbers: Some(row![
                self.index_of(child),
                xor,
                mask,
                Sign::Equal,
                self.index_of(mirrored),
            ]),
        }
    }
}
