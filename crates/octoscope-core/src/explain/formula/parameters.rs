//! Parameters of planes: where they come from, which comes first, which child is next.

use super::Statement;
use super::notation::Notation;
use super::numbers::{equal, number, operand, told_apart};
use super::term::{Formula, Sign, row};
use super::writer::Writer;
use crate::geometry::Axes;
use crate::query::Query;
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
        let (p, d) = (self.ray_symbol(axis, "p"), Formula::on(axis, "d", ""));
        let coordinate = self.of_node(Formula::coordinate(axis, index));
        let symbols = row![coordinate, Sign::Minus, p].over(d);
        let numbers = row![number(plane), Sign::Minus, operand(origin)].over(number(direction));
        [symbols, numbers]
    }

    /// A component of the ray, with a prime where the ray is mirrored.
    fn ray_symbol(&self, axis: usize, name: &str) -> Formula {
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

    /// t_min = max(t_x0, t_y0), or the other limit.
    fn limit(
        &self,
        [name, plane]: [&str; 2],
        operator: &'static str,
        values: [f64; D],
        value: f64,
    ) -> Statement {
        let one = Formula::from("t").sub(row!["e", plane]);
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
        let end = match self.query {
            Query::Ray { options, .. } => options.segment_end,
            Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => None,
        };
        // It meets the root, but ends before.
        let (name, last) = match end.filter(|_| precedes && !hit) {
            Some(end) => (Formula::from("t").sub("end"), end),
            None => (t_max, exit),
        };
        let sign = match (hit, is_closed) {
            (true, true) => Sign::LessOrEqual,
            (true, false) => Sign::Less,
            (false, true) if end.is_none() => Sign::Greater,
            (false, _) => Sign::GreaterOrEqual,
        };
        let [enter, last] = told_apart([enter, last]);
        let follows = self.word(if hit { "formula-hit" } else { "formula-miss" });
        Statement {
            symbols: row![begins(t_min), sign, name, Sign::Implies, follows.clone()],
            numbers: Some(row![begins(enter), sign, last, Sign::Implies, follows]),
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

    /// A node by itself: whether the latest near plane comes before the first far one.
    pub(super) fn tested(&self, interval: Option<[f64; 2]>, touch: bool) -> Statement {
        let sign = match (interval, touch) {
            (Some(_), false) => Sign::Less,
            (Some(_), true) => Sign::Equal,
            (None, _) => Sign::GreaterOrEqual,
        };
        let bound = |operator: &'static str, plane: &str| {
            let one = Formula::from("t").sub(row!["e", plane]);
            row![Formula::Over { operator, limit: Box::new("e".into()) }, one]
        };
        let mut symbols = vec![bound("max", "0"), sign.into(), bound("min", "1")];
        if interval.is_none() {
            let behind = row![bound("min", "1"), Sign::LessOrEqual, 0];
            symbols.extend([Sign::Or.into(), behind]);
        }
        let follows = self.word(match (interval, touch) {
            (Some(_), false) => "formula-hit",
            (Some(_), true) => "formula-touch",
            (None, _) => "formula-miss",
        });
        symbols.extend([Sign::Implies.into(), follows]);
        let numbers = interval.map(|interval| {
            let [enter, exit] = told_apart(interval);
            row![enter, sign, exit]
        });
        Statement { symbols: Formula::Row(symbols), numbers }
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
        let planes = |e: usize| if state.is_upper(e) { ["m", "1"] } else { ["0", "m"] };
        all.extend((0..D).map(|e| {
            let bit = i64::from(state.is_upper(e));
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
                numbers: Some(values.fenced(super::Fence::Round)),
            }
        }));
        all
    }

    pub(super) fn skip(&self, exit: f64, behind: bool) -> Statement {
        let far = self.before.frame().and_then(Frame::planes).map_or([exit; D], |[_, far]| far);
        let sign = if behind { Sign::Less } else { Sign::GreaterOrEqual };
        let one = Formula::from("t").sub(row!["e", "1"]);
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
        let swapped = D == 3 && self.has(Variant::B2);
        // As printed, x sets the bit of z.
        let bit_of = |e: usize| if swapped { D - 1 - e } else { e };
        let strict = self.by_tables() || self.has(Variant::OneByOne);
        let mut all: Vec<Statement> = Vec::new();
        for e in (0..D).filter(|&e| compared.contains(e) && entry_axis != Some(e)) {
            let is_set = state.is_upper(bit_of(e));
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
        all.push(self.index(state));
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
        vec![
            compared([mid[first], mid[other]], [t(first, "m"), t(other, "m")], 1),
            compared([near[other], mid[first]], [t(other, "0"), t(first, "m")], 0),
            compared([mid[other], far[first]], [t(other, "m"), t(first, "1")], 3),
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
        let planes: [&str; D] = std::array::from_fn(|e| if state.is_upper(e) { "1" } else { "m" });
        let letter = self.notation.child();
        let (and, or) = (self.notation.and(), self.notation.or());
        let (from, mask) = (self.index_of(state), self.mask_of(axes));
        let both = Axes(state.0 & axes.0);
        let binary = |n: i64| super::numbers::binary(n as u32, D as u8);
        let sign = if next.is_some() { Sign::Equal } else { Sign::Unequal };
        let (symbol, value) = match next {
            Some(next) => (
                row![letter, Sign::Takes, letter, or, "m"],
                row![from, or, mask, Sign::Equal, self.index_of(next)],
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
        let [t_min, t_max] = ["min", "max"].map(|name| Formula::from("t").sub(name));
        let [enter, exit] = told_apart([enter, exit]);
        Statement { symbols: row![t_min, sign, t_max], numbers: Some(row![enter, sign, exit]) }
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
