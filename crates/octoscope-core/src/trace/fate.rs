//! What becomes of a node.

use super::Moment;
use super::reason::{Reason, elsewhere, met, planes};
use crate::event::End;
use crate::geometry::{Parameter, Ray};
use crate::query::Query;
use crate::tree::{NodeId, Tree};

/// What has become of a node at a moment. Intervals are the parameters between
/// which the ray is in the node; there are none without a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fate {
    /// Leaves in it have been visited, or it has been found.
    Visited(Option<[f64; 2]>),
    /// The algorithm is in it.
    Entered(Option<[f64; 2]>),
    /// Its turn has not come.
    Ahead(Option<[f64; 2]>),
    /// It is not visited, and rightly so.
    RuledOut(Reason),
    /// It has been visited although it is ruled out.
    Strayed(Reason),
    /// The algorithm is beyond it and has not visited it, although the ray is in it.
    PassedBy([f64; 2]),
}

/// What has become of `node`; `None` where nothing is searched along a ray or to
/// a point. O(visited leaves).
pub fn fate<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    query: &Query<D>,
    moment: &Moment<D>,
    node: NodeId,
) -> Option<Fate> {
    let (level, code) = (tree.level(node), tree.code(node));
    let is_in = |inner: NodeId| {
        let other = tree.code(inner);
        tree.level(inner) <= level && (0..D).all(|e| other[e] >> level == code[e] >> level)
    };
    let entered = !is_over(moment) && moment.current.is_some_and(is_in);
    match query {
        Query::Ray { options, .. } => {
            // The last ones most often.
            let visited = moment.leaves.iter().rev().any(|leaf| is_in(leaf.node));
            let interval = match met(tree, ray, options.end(), node) {
                Ok(interval) => interval,
                Err(reason) if visited => return Some(Fate::Strayed(reason)),
                Err(reason) => return Some(Fate::RuledOut(reason)),
            };
            Some(if entered {
                Fate::Entered(Some(interval))
            } else if visited {
                Fate::Visited(Some(interval))
            } else {
                unvisited(tree, ray, moment, node, interval)
            })
        }
        Query::Point { at, .. } => {
            let found = moment.found.is_some_and(is_in);
            Some(match elsewhere(tree, at, node) {
                Some(reason) if found => Fate::Strayed(reason),
                Some(reason) => Fate::RuledOut(reason),
                None if entered => Fate::Entered(None),
                None if found => Fate::Visited(None),
                None => Fate::Ahead(None),
            })
        }
        Query::Region { .. } | Query::Neighbour { .. } => None,
    }
}

/// The node above `node`, or `node` itself, that decides what becomes of it, with
/// its fate: the highest that is not simply visited.
pub fn deciding_fate<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    query: &Query<D>,
    moment: &Moment<D>,
    node: NodeId,
) -> Option<(NodeId, Fate)> {
    let mut path: Vec<NodeId> = tree.ancestors(node).collect();
    path.reverse();
    for above in path {
        match fate(tree, ray, query, moment, above)? {
            Fate::Visited(_) | Fate::Entered(_) | Fate::Ahead(_) => {}
            other @ (Fate::RuledOut(_) | Fate::Strayed(_) | Fate::PassedBy(_)) => {
                return Some((above, other));
            }
        }
    }
    Some((node, fate(tree, ray, query, moment, node)?))
}

/// What has become of a node that the ray is in and no visited leaf.
fn unvisited<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    moment: &Moment<D>,
    node: NodeId,
    interval: [f64; 2],
) -> Fate {
    let last = moment.leaves.last();
    let beyond = last.is_some_and(|leaf| {
        let ([_, (_, exit)], [(_, enter), _]) =
            (planes(tree, ray, node), planes(tree, ray, leaf.node));
        exit.not_after(enter)
    });
    let full = last.filter(|_| moment.end == Some(End::FirstFull) && !beyond);
    if let Some(full) = full {
        return Fate::RuledOut(Reason::AfterFull { enter: interval[0], full: full.enter });
    }
    if beyond || is_over(moment) {
        return Fate::PassedBy(interval);
    }
    Fate::Ahead(Some(interval))
}

/// Whether the search has come to its end.
fn is_over<const D: usize>(moment: &Moment<D>) -> bool {
    match moment.end {
        Some(
            End::Missed
            | End::LeftRoot
            | End::FirstFull
            | End::SegmentEnd
            | End::Looped
            | End::Found
            | End::Outside,
        ) => true,
        // A trace that is cut off tells of a search that goes on.
        Some(End::Cut) | None => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Progress;
    use crate::trace::record;
    use crate::trace::{Crossing, ParentPlane};
    use crate::traverse::Options;
    use crate::tree::{Domain, Split, grow};

    /// Four leaves, 1 to 4, the last of which is full.
    fn tree() -> Tree<2> {
        grow(Domain::unit(1), 0, &Progress::default(), |cell, n| match cell.level {
            0 if n == 3 => Split::Full(vec![]),
            0 => Split::Empty,
            _ => Split::Inner((0..4).collect()),
        })
        .unwrap()
    }

    fn query(options: Options) -> Query<2> {
        let Query::Ray { algorithm, arithmetic, .. } = Query::<2>::default() else {
            panic!("a ray")
        };
        Query::Ray { algorithm, options, arithmetic }
    }

    /// Fates of the leaves after `step` events.
    #[track_caller]
    fn fates(origin: [f64; 2], direction: [f64; 2], query: &Query<2>, step: usize) -> [Fate; 4] {
        let (tree, ray) = (tree(), Ray::new(origin, direction).unwrap());
        let moment = Moment::after(&tree, &record(&tree, &ray, query), step);
        [1, 2, 3, 4].map(|id| fate(&tree, &ray, query, &moment, NodeId(id)).unwrap())
    }

    fn at(axis: usize, plane: ParentPlane, t: f64) -> Crossing {
        Crossing { axis, plane, t }
    }

    #[test]
    fn a_child_is_missed_by_the_planes_of_two_axes() {
        let [_, above, right, _] = fates([-0.25, 0.0], [1.0, 0.5], &Query::default(), 99);
        let (enter, exit) = (at(1, ParentPlane::Mid, 1.0), at(0, ParentPlane::Mid, 0.75));
        assert_eq!(above, Fate::RuledOut(Reason::Missed { enter, exit }));
        assert_eq!(right, Fate::Visited(Some([0.75, 1.0])));
    }

    #[test]
    fn planes_are_named_as_the_ray_meets_them() {
        let [first, ..] = fates([1.25, 0.0], [-1.0, 0.75], &Query::default(), 99);
        let (enter, exit) = (at(0, ParentPlane::Mid, 0.75), at(1, ParentPlane::Mid, 0.5 / 0.75));
        assert_eq!(first, Fate::RuledOut(Reason::Missed { enter, exit }));
    }

    #[test]
    fn a_ray_through_the_centre_touches_two_children() {
        let [_, above, right, _] = fates([0.0; 2], [1.0; 2], &Query::default(), 99);
        let [x, y] = [0, 1].map(|axis| at(axis, ParentPlane::Mid, 0.5));
        assert_eq!(above, Fate::RuledOut(Reason::Touched { enter: Some(y), exit: x }));
        assert_eq!(right, Fate::RuledOut(Reason::Touched { enter: Some(x), exit: y }));
    }

    #[test]
    fn what_lies_behind_the_origin_or_ends_there_is_ruled_out() {
        let [behind, _, touched, _] = fates([0.5, 0.25], [-1.0, 0.0], &Query::default(), 99);
        assert_eq!(behind, Fate::Visited(Some([0.0, 0.5])));
        let exit = at(0, ParentPlane::Mid, 0.0);
        assert_eq!(touched, Fate::RuledOut(Reason::Touched { enter: None, exit }));
        let [_, _, behind, _] = fates([0.25, 0.25], [-1.0, 0.0], &Query::default(), 99);
        let exit = at(0, ParentPlane::Mid, -0.25);
        assert_eq!(behind, Fate::RuledOut(Reason::Behind { exit }));
    }

    #[test]
    fn without_motion_along_an_axis_the_origin_decides() {
        let [_, beside, ..] = fates([0.0, 0.25], [1.0, -0.0], &Query::default(), 99);
        let reason = Reason::Beside { axis: 1, origin: 0.25, sides: [0.5, 1.0] };
        assert_eq!(beside, Fate::RuledOut(reason));
    }

    #[test]
    fn the_end_of_the_segment_and_the_first_full_leaf_end_the_search() {
        let options = Options { segment_end: Some(0.5), ..Options::default() };
        let [first, _, beyond, _] = fates([0.0, 0.25], [1.0, 0.0], &query(options), 99);
        assert_eq!(first, Fate::Visited(Some([0.0, 0.5])));
        let enter = Some(at(0, ParentPlane::Mid, 0.5));
        assert_eq!(beyond, Fate::RuledOut(Reason::BeyondEnd { enter, end: 0.5 }));

        let options = Options { stop_at: crate::traverse::StopAt::FirstFull, ..Options::default() };
        let [_, after, _, full] = fates([1.0, 0.75], [-1.0, 0.0], &query(options), 99);
        assert_eq!(full, Fate::Visited(Some([0.0, 0.5])));
        assert_eq!(after, Fate::RuledOut(Reason::AfterFull { enter: 0.5, full: 0.0 }));
    }

    #[test]
    fn children_come_are_entered_and_are_done_in_turn() {
        let of_first = |step| fates([0.0, 0.25], [1.0, 0.0], &Query::default(), step)[0];
        let all: Vec<Fate> = (0..12).map(of_first).collect();
        let interval = Some([0.0, 0.5]);
        let mut turns = all.clone();
        turns.dedup();
        assert_eq!(
            turns,
            [Fate::Ahead(interval), Fate::Entered(interval), Fate::Visited(interval)]
        );
    }

    #[test]
    fn a_run_that_leaves_a_leaf_out_has_passed_it_by() {
        let (tree, ray) = (tree(), Ray::new([0.0, 0.25], [1.0, 0.0]).unwrap());
        let query = Query::default();
        let mut trace = record(&tree, &ray, &query);
        let first = trace.events.iter().position(|event| event.is_result()).unwrap();
        trace.events.remove(first);
        let moment = Moment::after(&tree, &trace, 99);
        let passed = fate(&tree, &ray, &query, &moment, NodeId(1));
        assert_eq!(passed, Some(Fate::PassedBy([0.0, 0.5])));
        let (node, fate) = deciding_fate(&tree, &ray, &query, &moment, NodeId(1)).unwrap();
        assert_eq!((node, Some(fate)), (NodeId(1), passed));
    }

    #[test]
    fn a_point_lies_in_one_half_on_every_axis() {
        let variants = crate::traverse::Variants::NONE;
        let query =
            Query::Point { at: [0.5, 0.25], method: crate::query::PointMethod::Codes, variants };
        let [left, _, owner, above] = fates([0.0; 2], [1.0; 2], &query, 99);
        let elsewhere = |axis, place, side, above| {
            Fate::RuledOut(Reason::Elsewhere { axis, place, side, above })
        };
        assert_eq!(left, elsewhere(0, 0.5, 0.5, true));
        assert_eq!(owner, Fate::Visited(None));
        assert_eq!(above, elsewhere(1, 0.25, 0.5, false));
    }
}
