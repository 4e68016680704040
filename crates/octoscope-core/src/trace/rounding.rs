//! Where doubles would have decided otherwise than exact comparisons did.
//!
//! The events of an exact run hold the parameters as doubles and what was decided
//! exactly. So every decision can be made once more, by the doubles.

use super::{Extent, Frame, Moment, Trace};
use crate::event::{Event, Halves};
use crate::geometry::{Axes, Parameter, Ray};
use crate::query::Query;
use crate::traverse::{
    Algorithm, Exit, Options, Variant, clip, code_of_entry, halves, slabs, sorted, target_of,
};
use crate::tree::{Child, Code, Tree};

/// A decision that doubles would have made otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Disagreement<const D: usize> {
    /// Axes of the planes that would have been decided on otherwise; none if it is
    /// about the node as a whole.
    pub axes: Axes<D>,
    /// How many doubles the compared parameters lie apart: 0 if they round to the
    /// same one.
    pub ulps: u64,
}

/// What doubles would have decided otherwise in `event`, the step of `query` after
/// `before`; `None` if nothing. The run is one of exact comparisons.
///
/// Bottom-up walks also compare where they find their codes; of this the first
/// codes and the targets are looked at.
pub fn double_would_differ<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    query: &Query<D>,
    event: &Event<D>,
    before: &Moment<D>,
) -> Option<Disagreement<D>> {
    let Query::Ray { algorithm, options, .. } = *query else { return None };
    let options = Options { variants: query.variants_at_work(), ..options };
    let misprinted = options.variants.iter().any(|variant| variant != Variant::OneByOne);
    if algorithm == Algorithm::Exhaustive || misprinted {
        return None;
    }
    Rounding { tree, ray, algorithm, options, before }.of(event)
}

/// Steps of `trace`, counted from 1, in which doubles would have decided otherwise.
/// O(events); without any look at the events if doubles have decided anyway.
pub fn rounded_steps<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    trace: &Trace<D>,
) -> Vec<(usize, Disagreement<D>)> {
    let mut steps = Vec::new();
    if !trace.query.is_exact(tree.domain(), ray) {
        return steps;
    }
    let mut before = Moment::default();
    for event in &trace.events {
        let disagreement = double_would_differ(tree, ray, &trace.query, event, &before);
        before.apply(tree, event);
        steps.extend(disagreement.map(|disagreement| (before.step, disagreement)));
    }
    steps
}

/// A run and where it is.
struct Rounding<'a, const D: usize> {
    tree: &'a Tree<D>,
    ray: &'a Ray<D>,
    algorithm: Algorithm,
    options: Options,
    before: &'a Moment<D>,
}

impl<const D: usize> Rounding<'_, D> {
    fn of(&self, event: &Event<D>) -> Option<Disagreement<D>> {
        let nobody = Axes::NONE;
        match *event {
            Event::Clip { enter, exit, hit, .. } => self.clip(enter, exit, hit),
            Event::Test { node, interval, touch, .. } => {
                let domain = self.tree.domain();
                let (level, code) = (self.tree.level(node), self.tree.code(node));
                let (near, far) = slabs::<D, f64>(domain, self.ray, level, code);
                let (enter, exit) = (f64::latest(near).later(0.0), f64::earliest(far));
                let crossed = enter.before(exit);
                let touched = !crossed && enter.not_after(exit);
                let agrees = (interval.is_some(), touch) == (crossed || touched, touched);
                disagreement(agrees, nobody, ulps(enter, exit))
            }
            Event::Skip { exit, behind } => {
                disagreement(behind == (exit < 0.0), nobody, ulps(exit, 0.0))
            }
            Event::First { entry, entry_axis, compared, state } => {
                self.first(entry, entry_axis, compared, state)
            }
            Event::Step { exits, axes, .. } => {
                let by_tables = self.algorithm == Algorithm::ParametricTable;
                let in_doubles =
                    if by_tables { last_of_the_first(exits) } else { self.first_of(exits) };
                between(axes, in_doubles, |e| ulps(exits[e], f64::earliest(exits)))
            }
            Event::Cuts { order, inside, .. } => self.cuts(order.map(usize::from), inside),
            Event::Classify { at, piece, child } => self.classify(at, piece, child),
            Event::Flip { at, axes, .. } => self.flip(at, axes),
            Event::Split { axis, plane, at, interval: [enter, exit], halves: exact, .. } => {
                let axis = usize::from(axis);
                let line = [self.ray.origin()[axis], self.ray.direction()[axis]];
                let (in_doubles, _) = halves::<f64>(plane, at, line, [enter, exit]);
                let nearest = match (exact, in_doubles) {
                    (Halves::Near, _) | (_, Halves::Near) => ulps(at, exit).min(ulps(at, 0.0)),
                    (Halves::Far | Halves::Both, Halves::Far | Halves::Both) => ulps(at, enter),
                };
                disagreement(exact == in_doubles, Axes::one(axis), nearest)
            }
            Event::Exits { exits, axes, .. } | Event::Leave { exits, axes } => {
                let in_doubles = first_of(exits);
                between(axes, in_doubles, |e| ulps(exits[e], f64::earliest(exits)))
            }
            Event::Cross { next, axes, .. } => {
                between(axes, self.first_of(next), |e| ulps(next[e], f64::earliest(next)))
            }
            Event::Encode { code, .. } if self.before.leaves.is_empty() => self.first_cell(code),
            Event::Grid { cell, .. } => self.first_cell(cell),
            Event::Target { level, from, to, axes, .. } => self.target(level, from, to, axes),
            Event::Leaf { enter, exit, .. } => {
                disagreement(enter < exit, nobody, ulps(enter, exit))
            }
            Event::Touch { at, .. } => {
                let enter = self.frame_planes().map(|[near, _]| f64::latest(near).later(0.0));
                let agrees = enter.is_none_or(|enter| enter >= at);
                disagreement(agrees, nobody, enter.map_or(0, |enter| ulps(enter, at)))
            }
            Event::Sort { .. }
            | Event::Visit { .. }
            | Event::Halve { .. }
            | Event::Up { .. }
            | Event::Enter { .. }
            | Event::Pop { .. }
            | Event::Parent { .. }
            | Event::Mirror { .. }
            | Event::Facing { .. }
            | Event::Rope { .. }
            | Event::Push { .. }
            | Event::Begin { .. }
            | Event::Encode { .. }
            | Event::Compare { .. }
            | Event::Follow { .. }
            | Event::Border { .. }
            | Event::Difference { .. }
            | Event::Climb { .. }
            | Event::Resume { .. }
            | Event::Corners { .. }
            | Event::Found { .. }
            | Event::End(_) => None,
        }
    }

    fn frame_planes(&self) -> Option<[[f64; D]; 2]> {
        self.before.frame().and_then(Frame::planes)
    }

    fn mid(&self) -> Option<[f64; D]> {
        self.before.frame().and_then(|frame| frame.mid)
    }

    /// The planes that are met first, or one of them where they are crossed one by one.
    fn first_of(&self, parameters: [f64; D]) -> Axes<D> {
        let axes = first_of(parameters);
        let one_by_one = self.options.variants.has(Variant::OneByOne);
        if one_by_one { axes.first() } else { axes }
    }

    fn clip(&self, enter: f64, exit: f64, exact: bool) -> Option<Disagreement<D>> {
        let (in_doubles, _) = clip::<D, f64>(self.tree.domain(), self.ray, self.options);
        let segment = self.options.end().map(|end| ulps(enter.max(0.0), end));
        let nearest = ulps(enter, exit).min(ulps(exit, 0.0)).min(segment.unwrap_or(u64::MAX));
        disagreement(exact == in_doubles.is_some(), Axes::NONE, nearest)
    }

    fn first(
        &self,
        entry: f64,
        entry_axis: Option<usize>,
        compared: Axes<D>,
        state: Child<D>,
    ) -> Option<Disagreement<D>> {
        let mid = self.mid()?;
        let by_table = self.algorithm == Algorithm::ParametricTable;
        let strict = by_table || self.options.variants.has(Variant::OneByOne);
        let passed = |e: usize| if strict { mid[e] < entry } else { mid[e] <= entry };
        let upper = std::array::from_fn(|e| compared.contains(e) && passed(e));
        if let (true, Some([near, _]), Some(axis)) = (by_table, self.frame_planes(), entry_axis)
            && let Some(in_doubles) = (0..D).find(|&e| f64::latest(near) <= near[e])
            && in_doubles != axis
        {
            let axes = Axes(Axes::<D>::one(axis).0 | Axes::<D>::one(in_doubles).0);
            return disagreement(false, axes, ulps(near[axis], near[in_doubles]));
        }
        between(Axes(state.0), Axes::where_true(upper), |e| ulps(mid[e], entry))
    }

    fn cuts(&self, order: [usize; D], inside: Axes<D>) -> Option<Disagreement<D>> {
        let mid = self.mid()?;
        let Extent::Interval([enter, exit]) = self.before.frame()?.extent else { return None };
        let in_doubles = Axes::where_true(mid.map(|t| enter < t && t < exit));
        let to_ends = |e: usize| ulps(mid[e], enter).min(ulps(mid[e], exit));
        if let Some(found) = between(inside, in_doubles, to_ends) {
            return Some(found);
        }
        let (rounded, _) = sorted(mid);
        let elsewhere = (0..D).filter(|&n| order[n] != rounded[n]).map(|n| order[n]);
        let moved = elsewhere.fold(Axes::NONE, |axes, e| Axes(axes.0 | Axes::<D>::one(e).0));
        let nearest = |e: usize| (0..D).filter(|&o| o != e).map(|o| ulps(mid[e], mid[o])).min();
        between(moved, Axes::NONE, |e| nearest(e).unwrap_or(0))
    }

    fn classify(
        &self,
        at: f64,
        piece: Option<[f64; 2]>,
        child: Child<D>,
    ) -> Option<Disagreement<D>> {
        let mid = self.mid()?;
        if let Some([from, to]) = piece.filter(|[from, to]| from >= to) {
            return disagreement(false, Axes::NONE, ulps(from, to));
        }
        let passed = mid.map(|plane| match piece {
            Some([from, to]) => f64::passed_midway(plane, from, to),
            None => plane <= at,
        });
        let mask = self.before.clip.map_or(Axes::NONE, |clip| clip.mirror);
        let exact = Axes::<D>(child.mirrored(mask).0);
        let nearest = |e: usize| {
            let to_ends = piece.map(|[from, to]| ulps(mid[e], from).min(ulps(mid[e], to)));
            to_ends.unwrap_or_else(|| ulps(mid[e], at))
        };
        between(exact, Axes::where_true(passed), nearest)
    }

    fn flip(&self, at: f64, axes: Axes<D>) -> Option<Disagreement<D>> {
        let mid = self.mid()?;
        let cuts = self.before.frame()?.cuts?;
        // Ahead are the planes that follow those flipped, in the exact order.
        let order = cuts.order.map(usize::from);
        let last = (0..D).rfind(|&n| axes.contains(order[n]))?;
        let ahead = |e: usize| cuts.inside.contains(e) && order[last + 1..].contains(&e);
        let flipped = |e: usize| {
            mid[e] == at && (axes.contains(e) || ahead(e)) || { ahead(e) && mid[e] < at }
        };
        let in_doubles = Axes::where_true(std::array::from_fn(flipped));
        between(axes, in_doubles, |e| ulps(mid[e], at))
    }

    fn first_cell(&self, exact: Code<D>) -> Option<Disagreement<D>> {
        let enter = f64::latest(self.before.clip?.near).later(0.0);
        let (in_doubles, _) = code_of_entry::<D, f64>(self.tree.domain(), self.ray, enter);
        self.between_codes(exact.map(i64::from), in_doubles.map(i64::from), enter)
    }

    fn target(
        &self,
        level: u8,
        from: Code<D>,
        to: [i64; D],
        axes: Axes<D>,
    ) -> Option<Disagreement<D>> {
        let exits = self.before.exits?.exits;
        let at = exits[axes.iter().next()?];
        let exit = Exit { planes: from, exits, at, axes };
        let (in_doubles, _) = target_of::<D, f64>(self.tree.domain(), self.ray, level, from, &exit);
        self.between_codes(to, in_doubles, at)
    }

    /// Codes of a place at parameter `t` differ by the plane between them.
    fn between_codes(
        &self,
        exact: [i64; D],
        in_doubles: [i64; D],
        t: f64,
    ) -> Option<Disagreement<D>> {
        let differ = Axes::where_true(std::array::from_fn(|e| exact[e] != in_doubles[e]));
        between(differ, Axes::NONE, |e| {
            let plane = self.tree.domain().plane(e, exact[e].max(in_doubles[e]) as u32);
            ulps((plane - self.ray.origin()[e]) / self.ray.direction()[e], t)
        })
    }
}

/// The planes that are met first.
fn first_of<const D: usize>(parameters: [f64; D]) -> Axes<D> {
    let first = f64::earliest(parameters);
    Axes::where_true(parameters.map(|t| t <= first))
}

/// The plane that is met first, of equal ones the last.
fn last_of_the_first<const D: usize>(parameters: [f64; D]) -> Axes<D> {
    (0..D).rfind(|&e| first_of(parameters).contains(e)).map_or(Axes::NONE, Axes::one)
}

/// The disagreement of two sets of axes, with the largest distance in it.
fn between<const D: usize>(
    exact: Axes<D>,
    in_doubles: Axes<D>,
    distance: impl Fn(usize) -> u64,
) -> Option<Disagreement<D>> {
    let axes = Axes(exact.0 ^ in_doubles.0);
    disagreement(axes.is_empty(), axes, axes.iter().map(distance).max().unwrap_or(0))
}

fn disagreement<const D: usize>(agrees: bool, axes: Axes<D>, ulps: u64) -> Option<Disagreement<D>> {
    (!agrees).then_some(Disagreement { axes, ulps })
}

/// Number of steps from one double to the next between `a` and `b`; 0 and −0 are
/// the same.
fn ulps(a: f64, b: f64) -> u64 {
    let place = |x: f64| {
        let size = i128::from(x.abs().to_bits());
        if x < 0.0 { -size } else { size }
    };
    (place(a) - place(b)).unsigned_abs().try_into().unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ulps_count_the_doubles_between() {
        assert_eq!(ulps(1.0, 1.0), 0);
        assert_eq!(ulps(0.0, -0.0), 0);
        assert_eq!(ulps(1.0, 1.0f64.next_up().next_up()), 2);
        assert_eq!(ulps(5e-324, -5e-324), 2);
        assert!(ulps(f64::NEG_INFINITY, f64::INFINITY) > 1 << 63);
    }

    #[test]
    fn of_equal_planes_the_table_takes_the_last() {
        assert_eq!(last_of_the_first([1.0, 2.0, 1.0]), Axes::one(2));
        assert_eq!(first_of([1.0, 2.0, 1.0]), Axes(0b101));
    }
}
