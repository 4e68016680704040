//! Where a ray meets the root, or a node by itself.

use super::Statement;
use super::numbers::{equal, number, operand, told_apart};
use super::term::{Formula, Sign, row};
use super::writer::Writer;
use crate::geometry::Parameter;
use crate::query::Query;
use crate::traverse::{Variant, slabs};
use crate::tree::NodeId;

impl<const D: usize> Writer<'_, D> {
    /// t_min = max(t_x0, t_y0), or the other limit.
    fn limit(
        &self,
        [name, plane]: [&str; 2],
        operator: &'static str,
        values: [f64; D],
        value: f64,
    ) -> Statement {
        let one = Formula::from("t").sub(format!("e{plane}").as_str());
        let all = self.over_axes(operator, |e| self.t(e, plane), one);
        let left = self.of_node(Formula::from("t").sub(name));
        Statement {
            symbols: row![left, Sign::Equal, all],
            numbers: Some(row![
                Formula::call(operator, values.map(number)),
                Sign::Equal,
                number(value)
            ]),
        }
    }

    /// Where the near plane is met that decides: t_x0 = (x_0 − p_x) / d_x.
    fn entry(&self, near: [f64; D], enter: f64) -> Option<Statement> {
        let decides = |&e: &usize| near[e] == enter && self.direction(e) != 0.0;
        let axis = (0..D).find(decides).filter(|_| enter.is_finite())?;
        // Downwards the near plane is the upper one.
        let is_low = self.direction(axis) > 0.0;
        let domain = self.tree.domain();
        let plane = domain.plane(axis, if is_low { 0 } else { domain.grid_size() });
        let [symbols, numbers] = self.quotient(axis, if is_low { "0" } else { "1" }, plane);
        let told = [plane, self.origin(axis), self.direction(axis), enter];
        Some(Statement {
            symbols: row![self.t_of_node(axis, "0"), Sign::Equal, symbols],
            numbers: Some(row![numbers, equal(&told), number(enter)]),
        })
    }

    /// 0 by 0, along an axis without motion, of which B-5 knows no better.
    fn no_number(&self, axis: usize, index: &str) -> Statement {
        let domain = self.tree.domain();
        let plane = domain.plane(axis, if index == "0" { 0 } else { domain.grid_size() });
        let [symbols, numbers] = self.quotient(axis, index, plane);
        Statement {
            symbols: row![self.t_of_node(axis, index), Sign::Equal, symbols],
            numbers: Some(row![numbers, Sign::Equal, number(f64::NAN)]),
        }
    }

    pub(super) fn clip(
        &self,
        near: [f64; D],
        far: [f64; D],
        [enter, exit]: [f64; 2],
        hit: bool,
    ) -> Vec<Statement> {
        let turned = (0..D).filter(|&e| self.is_mirrored() && self.ray.direction()[e] < 0.0);
        let mut all: Vec<Statement> = turned.map(|axis| self.mirrored(axis)).collect();
        let [first, last] = if self.has(Variant::B1) { ["min", "max"] } else { ["max", "min"] };
        for (index, planes) in [("0", near), ("1", far)] {
            all.extend((0..D).filter(|&e| planes[e].is_nan()).map(|e| self.no_number(e, index)));
        }
        all.extend(self.entry(near, enter));
        all.push(self.limit(["min", "0"], first, near, enter));
        all.push(self.limit(["max", "1"], last, far, exit));
        all.push(self.meets([enter, exit], hit));
        all
    }

    /// max(t_min, 0) < t_max, or what holds instead.
    fn meets(&self, [enter, exit]: [f64; 2], hit: bool) -> Statement {
        let [t_min, t_max] = ["min", "max"].map(|name| Formula::from("t").sub(name));
        let is_closed = self.has(Variant::B11);
        // The ray begins at t = 0, which is not asked for in print.
        let begins = |t: Formula| match self.has(Variant::B10) {
            true => t,
            false => Formula::call("max", [t, 0.into()]),
        };
        let from = if self.has(Variant::B10) { enter } else { enter.max(0.0) };
        let precedes = if is_closed { from <= exit } else { from < exit };
        // It meets the root, but ends before.
        let ended = self.end_before(from).filter(|_| precedes && !hit);
        let (name, last) = match ended {
            Some(end) => (t_end(), end),
            None => (t_max, exit),
        };
        let sign = match (hit, is_closed) {
            (true, true) => Sign::LessOrEqual,
            (true, false) => Sign::Less,
            (false, true) if ended.is_none() => Sign::Greater,
            (false, _) => Sign::GreaterOrEqual,
        };
        let [enter, last] = told_apart([enter, last]);
        let follows = self.word(if hit { "formula-hit" } else { "formula-miss" });
        Statement {
            symbols: row![begins(t_min), sign, name, Sign::Implies, follows.clone()],
            numbers: Some(row![begins(enter), sign, last, Sign::Implies, follows]),
        }
    }

    /// Parameter of the end of the ray, if it lies not beyond `enter`.
    fn end_before(&self, enter: f64) -> Option<f64> {
        match self.query {
            Query::Ray { options, .. } => options.end().filter(|&end| enter >= end),
            Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => None,
        }
    }

    /// Origin of the mirrored ray: eq. 16, right or as printed.
    fn mirrored(&self, axis: usize) -> Statement {
        let domain = self.tree.domain();
        let (origin, turned) = (self.ray.origin()[axis], self.origin(axis));
        let (p, left) = (Formula::on(axis, "p", ""), self.ray_symbol(axis, "p"));
        if self.has(Variant::B7) {
            let side = domain.side();
            return Statement {
                symbols: row![left, Sign::Equal, "s", Sign::Minus, p],
                numbers: Some(row![
                    number(side),
                    Sign::Minus,
                    operand(origin),
                    equal(&[side, origin, turned]),
                    number(turned),
                ]),
            };
        }
        let [low, high] = [0, domain.grid_size()].map(|index| domain.plane(axis, index));
        let [x0, x1] = ["0", "1"].map(|index| Formula::coordinate(axis, index));
        Statement {
            symbols: row![left, Sign::Equal, x0, Sign::Plus, x1, Sign::Minus, p],
            numbers: Some(row![
                number(low),
                Sign::Plus,
                operand(high),
                Sign::Minus,
                operand(origin),
                equal(&[low, high, origin, turned]),
                number(turned),
            ]),
        }
    }

    /// A node by itself: whether the latest near plane, or the ray's begin, comes before
    /// the first far one, and before the ray's end.
    pub(super) fn tested(
        &self,
        node: NodeId,
        interval: Option<[f64; 2]>,
        touch: bool,
    ) -> Statement {
        let sign = match (interval, touch) {
            (Some(_), false) => Sign::Less,
            (Some(_), true) => Sign::Equal,
            (None, _) => Sign::GreaterOrEqual,
        };
        let (level, code) = (self.tree.level(node), self.tree.code(node));
        let (near, far) = slabs(self.tree.domain(), self.ray, level, code);
        let (enter, exit) = (f64::latest(near).later(0.0), f64::earliest(far));
        let ended = self.end_before(enter).filter(|_| interval.is_none() && enter.not_after(exit));
        let all: Vec<f64> = near.into_iter().chain(far).chain(ended).collect();
        let shown = crate::explain::number::distinct(&all);
        let value = |n: usize| Formula::Number { value: all[n], shown: shown[n].clone() };
        let follows = self.word(match (interval, touch) {
            (Some(_), false) => "formula-hit",
            (Some(_), true) => "formula-touch",
            (None, _) => "formula-miss",
        });
        let latest = |plane: &dyn Fn(usize) -> Formula| {
            Formula::call("max", (0..D).map(plane).chain([0.into()]))
        };
        // What comes first after it, the earliest far plane or the end.
        let [far, far_value] = match ended {
            Some(_) => [t_end(), value(2 * D)],
            None => [
                Formula::call("min", (0..D).map(|e| self.t(e, "1"))),
                Formula::call("min", (0..D).map(|e| value(D + e))),
            ],
        };
        Statement {
            symbols: row![latest(&|e| self.t(e, "0")), sign, far, Sign::Implies, follows],
            numbers: Some(row![latest(&value), sign, far_value]),
        }
    }
}

fn t_end() -> Formula {
    Formula::from("t").sub("end")
}
