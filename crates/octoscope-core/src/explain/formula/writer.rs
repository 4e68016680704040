//! Which formula an event has.

use super::Statement;
use super::notation::Notation;
use super::term::{Fence, Formula, Sign, row};
use crate::event::Event;
use crate::geometry::{Axes, Ray};
use crate::query::Query;
use crate::text::Texts;
use crate::trace::Moment;
use crate::traverse::{Algorithm, Variant};
use crate::tree::{Child, Tree};

/// Writes the formulas of an event, knowing what was before.
pub(super) struct Writer<'a, const D: usize> {
    pub tree: &'a Tree<D>,
    pub ray: &'a Ray<D>,
    pub query: &'a Query<D>,
    pub past: &'a [Event<D>],
    pub before: &'a Moment<D>,
    pub notation: Notation,
    pub texts: &'static Texts,
}

impl<const D: usize> Writer<'_, D> {
    pub(super) fn of(&self, event: &Event<D>) -> Vec<Statement> {
        match *event {
            Event::Clip { near, far, enter, exit, hit, .. } => {
                self.clip(near, far, [enter, exit], hit)
            }
            Event::Test { node, interval, touch, .. } => vec![self.tested(node, interval, touch)],
            Event::Visit { state, near, far, .. } => {
                state.map_or(Vec::new(), |state| self.visit(state, near, far))
            }
            Event::Skip { exit, behind } => vec![self.skip(exit, behind)],
            Event::Halve { mid, .. } => self.halve(mid),
            Event::First { entry, entry_axis, compared, state } => {
                self.first(entry, entry_axis, compared, state)
            }
            Event::Step { state, exits, axes, next } => self.step(state, exits, axes, next),
            Event::Enter { interval, .. } | Event::Pop { interval, .. } => {
                vec![self.interval(interval)]
            }
            Event::Cuts { order, inside, .. } => self.cuts(order, inside),
            Event::Classify { at, piece, child } => self.classify(at, piece, child),
            Event::Flip { at, axes, child } => self.flip(at, axes, child),
            Event::Split { axis, plane, at, interval, halves, .. } => {
                self.split(usize::from(axis), [plane, at], interval, halves)
            }
            Event::Grid { cell, next, .. } => self.grid(cell, next),
            Event::Cross { next, axes, cell, outside, .. } => self.cross(next, axes, cell, outside),
            Event::Parent { child, direction, common, .. } => self.parent(child, direction, common),
            Event::Mirror { child, mirrored, .. } => vec![self.mirror(child, mirrored)],
            Event::Push { from, to, axis } => vec![self.push(from, to, usize::from(axis))],
            Event::Encode { point, code, after, .. } => self.encode(point, code, after),
            Event::Compare { mid, point, child, .. } => self.compare(mid, point, child),
            Event::Follow { level, code, child, .. } => self.follow(level, code, child),
            Event::Exits { planes, exits, axes } => self.exits(planes, exits, axes),
            Event::Target { level, from, to, axes, .. } => self.target(level, from, to, axes),
            Event::Border { tested, outside } => self.border(tested, outside),
            Event::Difference { from, to, xor, level } => self.difference(from, to, xor, level),
            Event::Leave { exits, axes } => {
                vec![self.earliest(&[], exits.map(|t| t), axes, "1")]
            }
            Event::Climb { level, .. } => self.climb(level),
            Event::Corners { min, max, from, to } => self.corners([min, max], [from, to]),
            Event::Leaf { enter, exit, .. } => vec![self.in_leaf([enter, exit])],
            Event::Touch { node, at } => vec![self.touch(node, at)],
            Event::Sort { .. }
            | Event::Up { .. }
            | Event::Facing { .. }
            | Event::Rope { .. }
            | Event::Begin { .. }
            | Event::Resume { .. }
            | Event::Found { .. }
            | Event::End(_) => Vec::new(),
        }
    }

    /// Whether a rule is at work as it is printed, or in another form.
    pub(super) fn has(&self, variant: Variant) -> bool {
        self.query.variants().has(variant) && self.query.takes(variant)
    }

    pub(super) fn by_tables(&self) -> bool {
        matches!(self.query, Query::Ray { algorithm: Algorithm::ParametricTable, .. })
    }

    /// Whether the ray itself is mirrored, as in the paper, and not only the tree.
    pub(super) fn is_mirrored(&self) -> bool {
        let is_parametric = matches!(
            self.query,
            Query::Ray { algorithm: Algorithm::Parametric | Algorithm::ParametricTable, .. }
        );
        is_parametric && self.query.is_misprinted()
    }

    /// Name of the parameter of a plane: t_xm.
    pub(super) fn t(&self, axis: usize, plane: &str) -> Formula {
        Formula::on(axis, "t", plane)
    }

    /// The same where it is computed, as the function of a node that it is for some.
    pub(super) fn t_of_node(&self, axis: usize, plane: &str) -> Formula {
        self.of_node(self.t(axis, plane))
    }

    pub(super) fn of_node(&self, quantity: Formula) -> Formula {
        match self.notation {
            Notation::Revelles => row![quantity, Formula::from("o").fenced(Fence::Round)],
            Notation::Seed | Notation::FriskenPerry => quantity,
        }
    }

    /// Words in the language of the formula.
    pub(super) fn word(&self, key: &str) -> Formula {
        Formula::Words(self.texts.get(key))
    }

    /// Axes in words, as a mask: a bit each.
    pub(super) fn axes(&self, key: &str) -> Formula {
        self.word(key).fenced(Fence::Round)
    }

    /// The bit of a child or state on an axis: i_x.
    pub(super) fn bit(&self, axis: usize) -> Formula {
        Formula::on(axis, self.notation.child(), "")
    }

    /// Whether states are read in Morton order although they are not in it.
    pub(super) fn reads_morton(&self) -> bool {
        D == 3 && self.has(Variant::B2Morton)
    }

    /// The halves in which the child of a state lies.
    pub(super) fn halves(&self, state: Child<D>) -> Child<D> {
        self.query.variants_at_work().child_of_state(state, Axes::NONE)
    }

    /// Index of a child, as this notation counts.
    pub(super) fn index_of(&self, child: Child<D>) -> i64 {
        if self.reads_morton() {
            return i64::from(child.0);
        }
        match self.notation {
            Notation::Seed | Notation::Revelles => i64::from(child.0),
            Notation::FriskenPerry => i64::from(child.morton_index()),
        }
    }

    /// A set of axes as this notation counts children.
    pub(super) fn mask_of(&self, axes: Axes<D>) -> i64 {
        self.index_of(Child(axes.0))
    }

    /// The axes' bits put together: i = 4 i_x + 2 i_y + i_z. `weight` tells each.
    pub(super) fn index_from(
        &self,
        child: Child<D>,
        weight: impl Fn(usize) -> u8,
        index: i64,
    ) -> Statement {
        let letter = self.notation.child();
        let mut axes: Vec<usize> = (0..D).collect();
        axes.sort_by_key(|&e| std::cmp::Reverse(weight(e)));
        let term = |&e: &usize| match weight(e) {
            1 => self.bit(e),
            weight => row![i64::from(weight), self.bit(e)],
        };
        let value =
            |&e: &usize| row![i64::from(weight(e)), Sign::Times, i64::from(child.is_upper(e))];
        let sum = Formula::separated(axes.iter().map(term), Sign::Plus);
        let values = Formula::separated(axes.iter().map(value), Sign::Plus);
        Statement {
            symbols: row![letter, Sign::Equal, sum],
            numbers: Some(row![values, Sign::Equal, index]),
        }
    }

    /// The same in the order of this notation, and which child that is here.
    pub(super) fn index(&self, child: Child<D>) -> Statement {
        let Statement { symbols, numbers } =
            self.index_from(child, |e| self.notation.weight(e, D), self.index_of(child));
        let numbers = numbers.map(|numbers| row![numbers, self.counted_here(child)]);
        Statement { symbols, numbers }
    }

    /// Which number a child has everywhere else, where this notation counts otherwise.
    pub(super) fn counted_here(&self, child: Child<D>) -> Formula {
        if self.index_of(child) == i64::from(child.0) {
            return Formula::Row(Vec::new());
        }
        row![Sign::Comma, self.word("formula-here"), i64::from(child.0)]
    }
}
