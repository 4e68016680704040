//! Whether a run with misprints came to the right result.

use crate::event::{End, Event};
use crate::geometry::Ray;
use crate::query::Query;
use crate::trace::{Trace, corrected, on_the_ray, record, results, slivers};
use crate::traverse::{Options, Slivers, StopAt, Variants, first_difference_of_run, is_sliver};
use crate::tree::{NodeId, Tree};
use std::collections::BTreeSet;

/// What a trace should have come to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// The leaves on the ray in order, or the nodes that the query should find.
    pub expected: Vec<NodeId>,
    /// The nodes that the trace reports and should not, in the order of their numbers,
    /// whether or not others are missing. Of a run that is to stop at the first full leaf,
    /// those on the ray behind it are not among them.
    pub strayed: Vec<NodeId>,
    /// Number of events up to and with the first one that is wrong, if the trace
    /// does not agree: that is another than the same walk makes by the right rules.
    pub first_wrong_step: Option<usize>,
    /// Number of events up to and with the first one that is not made by the right rules,
    /// if the trace agrees all the same, but takes more steps.
    pub detour: Option<usize>,
    /// Number of events of the trace, and of the same walk by the right rules.
    pub n_steps: [usize; 2],
}

impl Verdict {
    /// Whether the trace has found just what it should have.
    pub fn agrees(&self) -> bool {
        self.first_wrong_step.is_none()
    }

    /// Number of events up to and with the first one that leads astray, or round about.
    pub fn first_step_off(&self) -> Option<usize> {
        self.first_wrong_step.or(self.detour)
    }
}

/// Compares a trace with the oracle, or, of a query without a ray, with the
/// right rules. Slivers may be there or not. O(leaves + events) along a ray, else as long
/// as the query takes.
pub fn verdict<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, trace: &Trace<D>) -> Verdict {
    match trace.query {
        Query::Ray { options, .. } => of_ray(tree, ray, trace, options),
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => {
            let right = record(tree, ray, &trace.query.corrected());
            let (expected, found) = (results(&right.events), results(&trace.events));
            let first_wrong_step = (expected != found).then(|| step_apart(trace, &right.events));
            let strayed = without(found, &expected);
            judged(trace, &right.events, [expected, strayed], first_wrong_step)
        }
    }
}

fn of_ray<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    trace: &Trace<D>,
    options: Options,
) -> Verdict {
    let options = Options { variants: Variants::NONE, ..options };
    let (mut expected, found) = (on_the_ray(tree, ray, options), results(&trace.events));
    let corrected = corrected(tree, ray, &trace.query);

    // What the misprint does not change is right, slivers included. The run may stop at a
    // full leaf, but at none that is not on the ray at all.
    let right = results(&corrected);
    let slivers = slivers(tree, ray, options, &expected, &right);
    let stopped_beside = trace.outcome.end == End::FirstFull
        && found.last().is_some_and(|leaf| !expected.contains(leaf));
    let difference = first_difference_of_run(tree, ray, options, &expected, &found, slivers);
    let wrong = difference.map(|difference| difference.found);
    let wrong = wrong.or_else(|| stopped_beside.then(|| found.last().copied()));
    let wrong = wrong.filter(|_| right != found);
    let first_wrong_step =
        wrong.map(|leaf| step_of(trace, leaf).min(step_apart(trace, &corrected)));

    let end = options.end().unwrap_or(f64::INFINITY);
    let mut strayed = without(without(found, &expected), &right);
    strayed.retain(|&leaf| slivers == Slivers::Count || !is_sliver(tree, ray, end, leaf));

    // Expected is what lies before the place where the right run stops.
    let is_full = |&leaf: &NodeId| tree.node(leaf).is_full();
    if options.stop_at == StopAt::FirstFull
        && let Some(first) = expected.iter().position(is_full)
    {
        expected.truncate(first + 1);
    }
    judged(trace, &corrected, [expected, strayed], first_wrong_step)
}

/// Those of `nodes` that are not among `others`, each once, in the order of their numbers.
fn without(nodes: Vec<NodeId>, others: &[NodeId]) -> Vec<NodeId> {
    let others: BTreeSet<NodeId> = others.iter().copied().collect();
    BTreeSet::from_iter(nodes).difference(&others).copied().collect()
}

/// The verdict on a trace beside the run with `corrected` rules.
fn judged<const D: usize>(
    trace: &Trace<D>,
    corrected: &[Event<D>],
    [expected, strayed]: [Vec<NodeId>; 2],
    first_wrong_step: Option<usize>,
) -> Verdict {
    let n_steps = [trace.events.len(), corrected.len()];
    let is_detour = first_wrong_step.is_none() && n_steps[0] > n_steps[1];
    let detour = is_detour.then(|| step_apart(trace, corrected));
    Verdict { expected, strayed, first_wrong_step, detour, n_steps }
}

/// Number of events up to and with the report of `wrong`, or of all.
fn step_of<const D: usize>(trace: &Trace<D>, wrong: Option<NodeId>) -> usize {
    let is_wrong = |event: &Event<D>| wrong.is_some() && event.result_node() == wrong;
    let index = trace.events.iter().position(is_wrong);
    index.map_or(trace.events.len(), |index| index + 1)
}

/// Number of events up to and with the first one that comes to something else than that
/// of the run with `corrected` rules.
fn step_apart<const D: usize>(trace: &Trace<D>, corrected: &[Event<D>]) -> usize {
    let pairs = trace.events.iter().zip(corrected);
    // A wrong bit may select the right child.
    let result = |event: &Event<D>| match *event {
        Event::Follow { level, child, node, .. } => {
            Event::Follow { level, code: [0; D], child, node }
        }
        event => event,
    };
    // Numbers that are none differ from themselves, but not as they are printed.
    let same =
        |(a, b): &(&Event<D>, &Event<D>)| format!("{:?}", result(a)) == format!("{:?}", result(b));
    (pairs.take_while(same).count() + 1).min(trace.events.len())
}

#[cfg(test)]
mod tests {
    use super::super::counterexample;
    use super::*;
    use crate::progress::Progress;
    use crate::scenario::{AnyScenario, Scenario};
    use crate::traverse::Variant;
    use crate::tree::{Cell, Domain, Split, grow};

    /// The first wrong event of the counterexample of `variant`.
    fn first_wrong(variant: Variant) -> (usize, Event<2>) {
        let AnyScenario::Quadtree(scenario) = counterexample(variant) else { panic!() };
        let tree = scenario.tree().unwrap();
        let trace = record(&tree, &scenario.ray, &scenario.query);
        let step = verdict(&tree, &scenario.ray, &trace).first_wrong_step.unwrap();
        (step, trace.events[step - 1])
    }

    /// Step and level at which it goes down off the right path.
    fn wrong_way_down(variant: Variant) -> (usize, u8) {
        let (step, event) = first_wrong(variant);
        let Event::Follow { level, .. } = event else { panic!("{variant:?}: {event:?}") };
        (step, level)
    }

    #[test]
    fn queries_go_wrong_where_they_leave_the_right_path() {
        assert_eq!(wrong_way_down(Variant::B19), (4, 1));
        // From the root already, by the differences of the codes.
        assert_eq!(wrong_way_down(Variant::B24c), (4, 4));
        // Where the level is read, and not only where it is passed.
        assert!(matches!(first_wrong(Variant::B24a), (2, Event::Difference { .. })));
        // Where the ancestor is taken for that of the cell itself.
        for variant in [Variant::B25Leftmost, Variant::B25Rightmost] {
            assert!(matches!(first_wrong(variant), (4, Event::Difference { .. })));
        }
        assert!(matches!(first_wrong(Variant::B28), (2, Event::Target { .. })));
    }

    #[test]
    fn a_mirrored_ray_goes_wrong_in_the_step_of_the_rule() {
        let divided = |cell: Cell<3>, ()| match cell.level {
            0 => Split::Empty,
            _ => Split::Inner(vec![(); 8]),
        };
        let tree = grow(Domain::unit(1), (), &Progress::default(), divided).unwrap();
        // 1 − 0.3 is no double, nor are the parameters that begin with it.
        let ray = Ray::new([0.3, 0.25, -1.0], [-0.0625, 0.0625, 1.0]).unwrap();
        for id in ["parametric@B-2", "parametric-table@B-2"] {
            let query = Query::default().along_the_ray_by(id.parse().unwrap());
            let trace = record(&tree, &ray, &query);
            let step = verdict(&tree, &ray, &trace).first_wrong_step.unwrap();
            assert!(matches!(trace.events[step - 1], Event::First { .. }), "{id}: {step}");
        }
    }

    #[test]
    fn a_run_that_stops_at_a_full_leaf_is_judged_up_to_it() {
        // Leaves 0, 1, 3 along the ray; those of the numbers in `full` are full.
        let judged = |full: &'static [u32], id: &str, origin: [f64; 2], direction: [f64; 2]| {
            let divided = |cell: Cell<2>, number: u32| match cell.level {
                0 if full.contains(&number) => Split::Full(vec![]),
                0 => Split::Empty,
                _ => Split::Inner(vec![0, 1, 2, 3]),
            };
            let tree = grow(Domain::unit(1), 0, &Progress::default(), divided).unwrap();
            let ray = Ray::new(origin, direction).unwrap();
            let Query::Ray { algorithm, options, arithmetic } =
                Query::<2>::default().along_the_ray_by(id.parse().unwrap())
            else {
                panic!()
            };
            let options = Options { stop_at: StopAt::FirstFull, ..options };
            let trace = record(&tree, &ray, &Query::Ray { algorithm, options, arithmetic });
            let verdict = verdict(&tree, &ray, &trace);
            let expected: Vec<u32> = verdict.expected.iter().map(|leaf| leaf.0 - 1).collect();
            (expected, verdict.first_wrong_step.map(|step| trace.events[step - 1]))
        };
        let (to_right, up) = ([-1.0, 0.1], [1.0, 0.1]);
        // B-3 reports leaves 0, 1, 3 instead of 0, 2; what comes after a full leaf 0
        // is not walked any more.
        assert_eq!(judged(&[0], "parametric@B-3", to_right, up), (vec![0], None));
        // It stops at leaf 1, which is not on the ray.
        let (expected, wrong) = judged(&[1, 2], "parametric@B-3", to_right, up);
        assert_eq!(expected, [0, 2]);
        assert!(matches!(wrong, Some(Event::Visit { node: NodeId(2), .. })), "{wrong:?}");
        // It walks past leaf 2 and stops nowhere.
        let (expected, wrong) = judged(&[2], "parametric@B-3", to_right, up);
        assert_eq!(expected, [0, 2]);
        assert!(matches!(wrong, Some(Event::Visit { node: NodeId(2), .. })), "{wrong:?}");
        // By the diagonal, B-11 stops at leaf 1, which is only touched.
        let diagonal = ([-1.0; 2], [1.0; 2]);
        let (expected, wrong) = judged(&[1, 2], "parametric-table@B-11", diagonal.0, diagonal.1);
        assert_eq!(expected, [0, 3]);
        assert!(matches!(wrong, Some(Event::Leaf { node: NodeId(2 | 3), .. })), "{wrong:?}");
        // So is a sliver, but the right rules stop at it, too.
        let sliver = ([0.0, 1e-13], [1.0; 2]);
        assert_eq!(judged(&[1], "parametric@B-7", sliver.0, sliver.1), (vec![0, 1], None));
        assert_eq!(judged(&[3], "parametric@B-7", sliver.0, sliver.1), (vec![0, 1, 3], None));
    }

    #[test]
    fn a_point_outside_goes_wrong_where_it_gets_codes() {
        assert!(matches!(first_wrong(Variant::B21), (1, Event::Encode { .. })));
    }

    /// Level and code of what has strayed at the end of the counterexample of `variant`.
    fn at_the_end(variant: Variant) -> Vec<Vec<u32>> {
        fn of<const D: usize>(scenario: &Scenario<D>) -> Vec<Vec<u32>> {
            let tree = scenario.tree().unwrap();
            let (ray, query) = (&scenario.ray, &scenario.query);
            let strayed = verdict(&tree, ray, &record(&tree, ray, query)).strayed;
            let place = |node| [&[u32::from(tree.level(node))][..], &tree.code(node)].concat();
            let mut places: Vec<_> = strayed.into_iter().map(place).collect();
            places.sort();
            places
        }
        match counterexample(variant) {
            AnyScenario::Quadtree(scenario) => of(&scenario),
            AnyScenario::Octree(scenario) => of(&scenario),
        }
    }

    #[test]
    fn leaves_are_wrong_even_where_none_would_be_right() {
        // The ray passes by the root, or lies behind it, or in its open side.
        assert_eq!(at_the_end(Variant::B1), [[0, 0, 1]]);
        assert_eq!(at_the_end(Variant::B10), [[0, 0, 0, 0], [0, 1, 1, 1]]);
        assert_eq!(at_the_end(Variant::B5), [[0, 1, 0, 0], [0, 1, 0, 1]]);
        assert_eq!(at_the_end(Variant::B11), [[0, 0, 1]]);
        assert_eq!(at_the_end(Variant::B21), [[0, 0, 0]]);
    }

    #[test]
    fn of_several_leaves_only_the_wrong_ones_stray() {
        assert_eq!(at_the_end(Variant::B3), [[0, 0, 1], [0, 1, 1]]);
        assert_eq!(at_the_end(Variant::B2), [[0; 0]; 0], "it loses one, but reports no other");
        assert_eq!(at_the_end(Variant::B9), [[0; 0]; 0]);
    }

    #[test]
    fn another_node_than_the_one_that_is_asked_for_strays() {
        assert_eq!(at_the_end(Variant::B19).len(), 1);
        assert_eq!(at_the_end(Variant::B24c).len(), 1);
        assert_eq!(at_the_end(Variant::B28).len(), 1);
    }
}
