//! Parameters of planes: where they come from, and which comes first.

use super::Statement;
use super::notation::Notation;
use super::numbers::{equal, number, operand, told_apart};
use super::term::{Formula, Sign, row};
use super::writer::Writer;
use crate::geometry::Axes;
use crate::trace::Frame;
use crate::traverse::Variant;
use crate::tree::{Child, NodeId};

impl<const D: usize> Writer<'_, D> {
    /// Origin of the ray that is followed; of a mirrored one where it is mirrored.
    pub(super) fn origin(&self, axis: usize) -> f64 {
        let (origin, domain) = (self.ray.origin()[axis], self.tree.domain());
        if !self.is_mirrored() || self.ray.direction()[axis] >= 0.0 {
            return origin;
        }
        let [low, high] = [0, domain.grid_size()].map(|index| domain.plane(axis, index));
        if self.has(Variant::B7) { domain.side() - origin } else { low + high - origin }
    }

    pub(super) fn direction(&self, axis: usize) -> f64 {
        let direction = self.ray.direction()[axis];
        if self.is_mirrored() { direction.abs() } else { direction }
    }

    /// (x_m − p_x) / d_x with symbols and with numbers.
    pub(super) fn quotient(&self, axis: usize, index: &str, plane: f64) -> [Formula; 2] {
        let (origin, direction) = (self.origin(axis), self.direction(axis));
        let (p, d) = (self.ray_symbol(axis, "p"), self.ray_symbol(axis, "d"));
        let coordinate = self.of_node(Formula::coordinate(axis, index));
        let symbols = row![coordinate, Sign::Minus, p].over(d);
        let numbers = row![number(plane), Sign::Minus, operand(origin)].over(number(direction));
        [symbols, numbers]
    }

    /// A component of the ray, with a prime where the ray is mirrored.
    pub(super) fn ray_symbol(&self, axis: usize, name: &str) -> Formula {
        let symbol = Formula::on(axis, name, "");
        let is_turned = self.is_mirrored() && self.ray.direction()[axis] < 0.0;
        if is_turned { symbol.sup("′") } else { symbol }
    }

    /// max or min over the axes: as a list, or with the axes below.
    pub(super) fn over_axes(
        &self,
        operator: &'static str,
        part: impl Fn(usize) -> Formula,
        one: Formula,
    ) -> Formula {
        match self.notation {
            Notation::Seed | Notation::Revelles => Formula::call(operator, (0..D).map(part)),
            Notation::FriskenPerry => {
                row![Formula::Over { operator, limit: Box::new("e".into()) }, one]
            }
        }
    }

    /// Between which planes the child of a state lies: (t_x0, t_x1) ← (t_xm, t_x1).
    pub(super) fn visit(&self, state: Child<D>, near: [f64; D], far: [f64; D]) -> Vec<Statement> {
        let mut all = Vec::new();
        let mask = self.before.clip.map_or(Axes::NONE, |clip| clip.mirror);
        if !mask.is_empty() {
            let letter = self.notation.child();
            let [from, to] = [state, state.mirrored(mask)].map(|child| self.index_of(child));
            let f = |argument: Formula| Formula::call("f", [argument]);
            let xor = self.notation.xor();
            all.push(Statement {
                symbols: row![f(letter.into()), Sign::Equal, letter, xor, "a"],
                numbers: Some(row![
                    f(from.into()),
                    Sign::Equal,
                    from,
                    xor,
                    self.mask_of(mask),
                    Sign::Equal,
                    to,
                ]),
            });
        }
        let halves = self.halves(state);
        let planes = |e: usize| if halves.is_upper(e) { ["m", "1"] } else { ["0", "m"] };
        all.extend((0..D).map(|e| {
            let bit = i64::from(halves.is_upper(e));
            let interval = Formula::list(planes(e).map(|plane| self.t(e, plane)));
            let values = Formula::list(told_apart([near[e], far[e]]));
            Statement {
                symbols: row![
                    self.bit(e),
                    Sign::Equal,
                    bit,
                    Sign::Implies,
                    interval.fenced(super::Fence::Round),
                ],
                // The condition again, or the values would stand below it.
                numbers: Some(row![
                    self.bit(e),
                    Sign::Equal,
                    bit,
                    Sign::Implies,
                    values.fenced(super::Fence::Round),
                ]),
            }
        }));
        all
    }

    pub(super) fn skip(&self, exit: f64, behind: bool) -> Statement {
        let far = self.before.frame().and_then(Frame::planes).map_or([exit; D], |[_, far]| far);
        let sign = if behind { Sign::Less } else { Sign::GreaterOrEqual };
        let one = Formula::from("t").sub("e1");
        let follows = if behind { self.word("formula-skip") } else { self.word("formula-go-on") };
        Statement {
            symbols: row![
                self.over_axes("min", |e| self.t(e, "1"), one),
                sign,
                0,
                Sign::Implies,
                follows,
            ],
            numbers: Some(row![
                Formula::call("min", far.map(number)),
                Sign::Equal,
                number(exit),
                sign,
                0,
            ]),
        }
    }

    /// Parameters of the mid planes: from their coordinates, as means, or by the side
    /// on which a ray lies that does not move.
    pub(super) fn halve(&self, mid: [f64; D]) -> Vec<Statement> {
        (0..D).map(|e| self.halved(e, mid[e])).collect()
    }

    fn halved(&self, axis: usize, mid: f64) -> Statement {
        let left = self.t_of_node(axis, "m");
        let moves = self.direction(axis) != 0.0;
        let planes = self.before.frame().and_then(Frame::planes);
        let averages = match moves {
            true => self.has(Variant::Averaged) || self.has(Variant::B4),
            false => self.has(Variant::B6),
        };
        if let Some([near, far]) = planes.filter(|_| averages) {
            // The index is missing in print: read as that of the near plane.
            let is_misprinted = moves && self.has(Variant::B4);
            let last = if is_misprinted { near[axis] } else { far[axis] };
            let second = self.t(axis, if is_misprinted { "" } else { "1" });
            return Statement {
                symbols: row![
                    left,
                    Sign::Equal,
                    row![self.t(axis, "0"), Sign::Plus, second].over(2),
                ],
                numbers: Some(row![
                    row![number(near[axis]), Sign::Plus, operand(last)].over(2),
                    equal(&[near[axis], last, mid]),
                    number(mid),
                ]),
            };
        }
        let plane = self.mid_plane(axis);
        if !moves {
            let is_below = self.origin(axis) < plane;
            let sign = if is_below { Sign::Less } else { Sign::GreaterOrEqual };
            let [origin, plane] = told_apart([self.origin(axis), plane]);
            return Statement {
                symbols: row![
                    Formula::on(axis, "d", ""),
                    Sign::Equal,
                    0,
                    Sign::Comma,
                    Formula::on(axis, "p", ""),
                    sign,
                    Formula::coordinate(axis, "m"),
                ],
                numbers: Some(row![
                    origin,
                    sign,
                    plane,
                    Sign::Implies,
                    self.t(axis, "m"),
                    Sign::Equal,
                    number(mid),
                ]),
            };
        }
        let [symbols, numbers] = self.quotient(axis, "m", plane);
        let told = [plane, self.origin(axis), self.direction(axis), mid];
        Statement {
            symbols: row![left, Sign::Equal, symbols],
            numbers: Some(row![numbers, equal(&told), number(mid)]),
        }
    }

    /// Coordinate of the mid plane of the node at work.
    pub(super) fn mid_plane(&self, axis: usize) -> f64 {
        let at = self.before.frame().map(|frame| frame.node).or(self.before.current);
        let node = at.unwrap_or(NodeId::ROOT);
        let (level, code) = (self.tree.level(node), self.tree.code(node));
        let half = 1u32 << level.saturating_sub(1);
        let index = code[axis] + half;
        self.tree.domain().plane(axis, self.turned(axis, index))
    }

    /// Index of a plane of the true tree in the one that the ray is followed in.
    fn turned(&self, axis: usize, index: u32) -> u32 {
        let is_turned = self.is_mirrored() && self.ray.direction()[axis] < 0.0;
        if is_turned { self.tree.domain().grid_size() - index } else { index }
    }

    /// min(t_x1, t_y1) = t_x1, the planes by `planes` or all by `plane`.
    pub(super) fn earliest(
        &self,
        planes: &[&str],
        values: [f64; D],
        axes: Axes<D>,
        plane: &str,
    ) -> Statement {
        let name = |e: usize| self.t(e, planes.get(e).copied().unwrap_or(plane));
        // Where one is no number, no comparison finds the least.
        let sign = if values.iter().any(|t| t.is_nan()) { Sign::Implies } else { Sign::Equal };
        let mut symbols = vec![Formula::call("min", (0..D).map(name))];
        for axis in axes.iter() {
            symbols.extend([sign.into(), name(axis)]);
        }
        let shown = crate::explain::number::distinct(&values);
        let all = values.iter().zip(&shown);
        let all = all.map(|(&value, shown)| Formula::Number { value, shown: shown.clone() });
        let mut numbers = vec![Formula::call("min", all.clone())];
        if let Some(least) = axes.iter().next().and_then(|axis| all.clone().nth(axis)) {
            numbers.extend([sign.into(), least]);
        }
        Statement { symbols: Formula::Row(symbols), numbers: Some(Formula::Row(numbers)) }
    }

    /// t_min < t_max of a node, a leaf or a part.
    pub(super) fn interval(&self, [enter, exit]: [f64; 2]) -> Statement {
        let sign = match enter.partial_cmp(&exit) {
            Some(std::cmp::Ordering::Less) | None => Sign::Less,
            Some(std::cmp::Ordering::Equal) => Sign::Equal,
            Some(std::cmp::Ordering::Greater) => Sign::Greater,
        };
        limits(enter, sign, exit)
    }

    /// t_min < t_max of a leaf that is reported: exact comparisons know it also where both
    /// are rounded to the same double.
    pub(super) fn in_leaf(&self, [enter, exit]: [f64; 2]) -> Statement {
        if enter == exit && self.query.is_exact(self.tree.domain(), self.ray) {
            return limits(enter, Sign::Less, exit);
        }
        self.interval([enter, exit])
    }

    /// A node that is met in one point.
    pub(super) fn touch(&self, node: NodeId, at: f64) -> Statement {
        let frame = self.before.frame().filter(|frame| frame.node == node);
        let enter = frame.map(|frame| frame.enter().max(0.0)).filter(|enter| *enter > at);
        match enter {
            Some(enter) => self.interval([enter, at]),
            None => self.interval([at, at]),
        }
    }

    /// Parameters of the far planes of a leaf, each, and the first of them.
    pub(super) fn exits(&self, planes: [f64; D], exits: [f64; D], axes: Axes<D>) -> Vec<Statement> {
        let mut all: Vec<Statement> = Vec::new();
        for e in (0..D).filter(|&e| self.ray.direction()[e] != 0.0) {
            let index = if self.ray.direction()[e] > 0.0 { "1" } else { "0" };
            let [symbols, numbers] = self.quotient(e, index, planes[e]);
            let told = [planes[e], self.origin(e), self.direction(e), exits[e]];
            all.push(Statement {
                symbols: row![self.t_of_node(e, "1"), Sign::Equal, symbols],
                numbers: Some(row![numbers, equal(&told), number(exits[e])]),
            });
        }
        all.push(self.earliest(&[], exits, axes, "1"));
        all
    }
}

/// How t_min and t_max compare.
fn limits(enter: f64, sign: Sign, exit: f64) -> Statement {
    let [t_min, t_max] = ["min", "max"].map(|name| Formula::from("t").sub(name));
    let [enter, exit] = told_apart([enter, exit]);
    Statement { symbols: row![t_min, sign, t_max], numbers: Some(row![enter, sign, exit]) }
}
