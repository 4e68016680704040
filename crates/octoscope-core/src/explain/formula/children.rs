//! Which child is the first on a ray, and which is the next.

use super::Statement;
use super::numbers::{number, told_apart};
use super::term::{Formula, Sign, row};
use super::writer::Writer;
use crate::explain::words::far_planes;
use crate::geometry::{AXIS_NAMES, Axes};
use crate::trace::Frame;
use crate::traverse::Variant;
use crate::tree::Child;

impl<const D: usize> Writer<'_, D> {
    pub(super) fn first(
        &self,
        entry: f64,
        entry_axis: Option<usize>,
        compared: Axes<D>,
        state: Child<D>,
    ) -> Vec<Statement> {
        let mid = self.before.frame().and_then(|frame| frame.mid).unwrap_or([entry; D]);
        if D == 2 && self.has(Variant::B3) {
            return self.selected(mid);
        }
        let name = entry_axis.map_or(Formula::from(0), |axis| self.t(axis, "0"));
        // As printed, x sets the bit of z, unless the number is read in Morton order.
        let swapped = D == 3 && self.has(Variant::B2) && !self.reads_morton();
        let halves = self.halves(state);
        let bit_of = |e: usize| if swapped { D - 1 - e } else { e };
        let strict = self.by_tables() || self.has(Variant::OneByOne);
        let mut all: Vec<Statement> = Vec::new();
        for e in (0..D).filter(|&e| compared.contains(e) && entry_axis != Some(e)) {
            let is_set = halves.is_upper(bit_of(e));
            let sign = match (is_set, strict) {
                (true, true) => Sign::Less,
                (true, false) => Sign::LessOrEqual,
                (false, true) => Sign::GreaterOrEqual,
                (false, false) => Sign::Greater,
            };
            let follows = row![self.bit(bit_of(e)), Sign::Equal, i64::from(is_set)];
            let numbers = if mid[e].is_nan() || entry.is_nan() {
                let asked = if strict { Sign::Less } else { Sign::LessOrEqual };
                let compared = row![number(mid[e]), asked, number(entry)];
                row![Sign::Not, compared.fenced(super::Fence::Round)]
            } else {
                let [mid, entry] = told_apart([mid[e], entry]);
                row![mid, sign, entry]
            };
            all.push(Statement {
                symbols: row![self.t(e, "m"), sign, name.clone(), Sign::Implies, follows],
                numbers: Some(numbers),
            });
        }
        all.push(if self.reads_morton() {
            self.index_from(halves, |e| 1 << e, i64::from(state.0))
        } else {
            self.index(state)
        });
        all
    }

    /// The selection of children in the plane, as it is printed.
    fn selected(&self, mid: [f64; D]) -> Vec<Statement> {
        let Some([near, far]) = self.before.frame().and_then(Frame::planes) else {
            return Vec::new();
        };
        let (first, other) = if mid[1] < mid[0] { (1, 0) } else { (0, 1) };
        let q = |n: i64| Formula::from("q").sub(n);
        let compared = |[a, b]: [f64; 2], names: [Formula; 2], child: i64| {
            let holds = a < b;
            let sign = if holds { Sign::Less } else { Sign::GreaterOrEqual };
            let [left, right] = names;
            let [a, b] = told_apart([a, b]);
            let follows = if holds { row![Sign::Implies, q(child)] } else { Formula::Row(vec![]) };
            Statement { symbols: row![left, sign, right, follows], numbers: Some(row![a, sign, b]) }
        };
        let t = |e: usize, plane: &str| self.t(e, plane);
        // The last one asks for the far plane of y in either branch.
        vec![
            compared([mid[first], mid[other]], [t(first, "m"), t(other, "m")], 1),
            compared([near[other], mid[first]], [t(other, "0"), t(first, "m")], 0),
            compared([mid[other], far[1]], [t(other, "m"), t(1, "1")], 3),
        ]
    }

    /// Which of the child's far planes comes first, and which child lies behind it.
    pub(super) fn step(
        &self,
        state: Child<D>,
        exits: [f64; D],
        axes: Axes<D>,
        next: Option<Child<D>>,
    ) -> Vec<Statement> {
        let planes = far_planes(self.halves(state));
        let letter = self.notation.child();
        let (and, or) = (self.notation.and(), self.notation.or());
        let (from, mask) = (self.index_of(state), self.mask_of(axes));
        let both = Axes(state.0 & axes.0);
        // Which axis a digit is of, where x is the last.
        let in_order = self.notation.weight(0, D) > 1;
        let binary = |n: i64| {
            let digits = super::numbers::binary(n as u32, D as u8);
            let axes: String = AXIS_NAMES[..D].iter().rev().copied().collect();
            if in_order { digits } else { digits.sub(axes.as_str()) }
        };
        let sign = if next.is_some() { Sign::Equal } else { Sign::Unequal };
        let (symbol, value) = match next {
            Some(next) => (
                row![letter, Sign::Takes, letter, or, "m"],
                row![from, or, mask, Sign::Equal, self.index_of(next), self.counted_here(next)],
            ),
            None => (self.word("formula-end"), self.word("formula-end")),
        };
        vec![
            self.earliest(&planes, exits, axes, ""),
            Statement {
                symbols: row![letter, and, "m", sign, 0, Sign::Implies, symbol],
                numbers: Some(row![
                    binary(from),
                    and,
                    binary(mask),
                    Sign::Equal,
                    binary(self.mask_of(both)),
                    Sign::Implies,
                    value,
                ]),
            },
        ]
    }
}
