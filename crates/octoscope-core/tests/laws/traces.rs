//! Traces and what is folded from them.

use crate::rays::{Class, random_ray};
use crate::trees::{domain, random_tree};
use octoscope_core::event::{End, Event, Observer};
use octoscope_core::geometry::Ray;
use octoscope_core::locate::{Direction, NeighbourMethod, Reach};
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::query::{Arithmetic, PointMethod, Query};
use octoscope_core::random::Random;
use octoscope_core::trace::{Counter, Moment, Trace, record, record_within};
use octoscope_core::traverse::{Algorithm, Options, StopAt, Variant, Variants};
use octoscope_core::tree::{Domain, NodeId, Split, Tree, grow};

/// Every kind of query, with random arguments.
fn queries<const D: usize>(tree: &Tree<D>, random: &mut Random) -> Vec<Query<D>> {
    let mut queries = Vec::new();
    for algorithm in Algorithm::ALL {
        let own = |variant: &Variant| variant.belongs_to(algorithm);
        let variants = Variant::ALL.into_iter().filter(own).collect();
        for arithmetic in [Arithmetic::Doubles, Arithmetic::Exact] {
            for (stop_at, segment_end, variants) in [
                (StopAt::End, None, Variants::NONE),
                (StopAt::End, Some(0.5), variants),
                (StopAt::FirstFull, None, variants),
            ] {
                let options = Options { stop_at, segment_end, variants };
                queries.push(Query::Ray { algorithm, options, arithmetic });
            }
        }
    }
    let (min, side) = (tree.domain().min(), tree.domain().side());
    let mut point = || std::array::from_fn(|e| min[e] + side * random.between(-0.1, 1.1));
    let (a, b) = (point(), point());
    let variants = Variants::NONE;
    queries.push(Query::Point { at: a, method: PointMethod::Codes, variants });
    queries.push(Query::Point { at: a, method: PointMethod::Comparison, variants });
    queries.push(Query::Region { min: a, max: b, variants });
    let id = NodeId(random.below(tree.n_nodes() as u64) as u32);
    let (level, code) = (tree.level(id), tree.code(id));
    for direction in Direction::all() {
        for reach in [Reach::EqualOrLarger, Reach::Leaf, Reach::EveryLeaf] {
            for method in [NeighbourMethod::Codes, NeighbourMethod::Tables] {
                queries.push(Query::Neighbour { level, code, direction, reach, method, variants });
            }
        }
    }
    let with_all = |query: Query<D>| {
        let own = Variant::ALL.into_iter().filter(|&v| query.takes(v)).collect();
        match query {
            Query::Ray { .. } => None,
            Query::Point { at, method, .. } => Some(Query::Point { at, method, variants: own }),
            Query::Region { min, max, .. } => Some(Query::Region { min, max, variants: own }),
            Query::Neighbour { level, code, direction, reach, method, .. } => {
                Some(Query::Neighbour { level, code, direction, reach, method, variants: own })
            }
        }
    };
    let misprinted: Vec<_> = queries.iter().copied().filter_map(with_all).collect();
    queries.extend(misprinted);
    queries
}

fn for_random_traces(mut check: impl FnMut(&Tree<3>, &Ray<3>, &Query<3>, &Trace<3>)) {
    let mut random = Random::new(4);
    for n in 0..10 {
        let tree = random_tree(domain(1 + n as u8, n), 15, &mut random);
        for class in Class::ALL {
            let ray = random_ray(&tree, class, &mut random);
            for query in queries(&tree, &mut random) {
                check(&tree, &ray, &query, &record(&tree, &ray, &query));
            }
        }
    }
}

#[test]
fn watching_does_not_change_what_happens() {
    for_random_traces(|tree, ray, query, trace| {
        assert_eq!(query.run(tree, ray, &mut ()), trace.outcome);
        assert!(matches!(trace.events.last(), Some(Event::End(end)) if *end == trace.outcome.end));
        let ends = trace.events.iter().filter(|event| matches!(event, Event::End(_))).count();
        assert_eq!(ends, 1);
    });
}

#[test]
fn a_trace_within_a_limit_is_the_beginning_of_the_whole_one() {
    let within = |tree: &Tree<3>, ray: &Ray<3>, query: &Query<3>, most| {
        record_within(tree, ray, query, most, &Progress::default()).unwrap()
    };
    for_random_traces(|tree, ray, query, trace| {
        // What is no number is not equal to itself, but as it is printed.
        let printed = |events: &[Event<3>]| format!("{events:?}");
        let n = trace.events.len();
        // The end is not counted.
        let whole = within(tree, ray, query, n - 1);
        assert_eq!(printed(&whole.events), printed(&trace.events));
        assert_eq!(whole.outcome, trace.outcome);
        for most in [0, 1, n / 2, n.saturating_sub(2)].into_iter().filter(|most| *most < n - 1) {
            let cut = within(tree, ray, query, most);
            assert_eq!(cut.outcome.end, End::Cut);
            assert_eq!(printed(&cut.events[..most]), printed(&trace.events[..most]));
            assert_eq!(cut.events[most..], [Event::End(End::Cut)]);
        }
    });
}

/// A tree of one empty leaf over a grid of 2^20 cells along every axis.
fn finest_grid() -> Tree<3> {
    let tree = grow(Domain::unit(20), (), &Progress::default(), |_, ()| Split::Empty);
    tree.expect("nobody cancels it")
}

#[test]
fn a_long_run_ends_soon_after_its_limit_or_a_cancel() {
    let (tree, ray) = (finest_grid(), Ray::new([-1.0, 0.1, 0.2], [2.0, 0.5, 0.25]).unwrap());
    for algorithm in [Algorithm::Dda, Algorithm::DdaOctree] {
        let options = Options::default();
        let query = Query::Ray { algorithm, options, arithmetic: Arithmetic::Doubles };
        let mut asked = Asked { left: 1000, more: 0 };
        assert_eq!(query.run(&tree, &ray, &mut asked).end, End::Cut);
        assert!(asked.more < 10, "{algorithm:?}: {} events too many", asked.more);

        let cancelled = Progress::default();
        cancelled.cancel();
        let trace = record_within(&tree, &ray, &query, usize::MAX, &cancelled);
        assert_eq!(trace, Err(Cancelled));
    }
}

/// Wants so many events, and counts those that come all the same.
struct Asked {
    left: usize,
    more: usize,
}

impl Observer<3> for Asked {
    fn observe(&mut self, _: Event<3>) {
        self.more += usize::from(self.left == 0);
        self.left = self.left.saturating_sub(1);
    }

    fn wants_more(&self) -> bool {
        self.left > 0
    }
}

#[test]
fn every_moment_is_consistent() {
    for_random_traces(|tree, _, query, trace| {
        let mut before = Moment::after(tree, trace, 0);
        assert_eq!(before, Moment::default());
        for step in 1..=trace.events.len() {
            let moment = Moment::after(tree, trace, step);
            assert_eq!(moment.step, step);
            check_stack(tree, query, &moment);
            check_halving(tree, &trace.events[step - 1], &moment);
            for counter in Counter::ALL {
                assert!(moment.counters.get(counter) >= before.counters.get(counter));
            }
            assert!(moment.leaves.starts_with(&before.leaves));
            // A touch may be at no number, which does not equal itself.
            let touched = |moment: &Moment<3>| -> Vec<NodeId> {
                moment.touches.iter().map(|&(node, _)| node).collect()
            };
            assert!(touched(&moment).starts_with(&touched(&before)));
            before = moment;
        }
        assert_eq!(before.end, Some(trace.outcome.end));
        let leaves: Vec<_> = before.leaves.iter().map(|leaf| leaf.node).collect();
        assert_eq!(leaves, trace.leaves().map(|(node, _)| node).collect::<Vec<_>>());
        let whole = Moment::after(tree, trace, usize::MAX);
        assert_eq!(format!("{before:?}"), format!("{whole:?}"));
    });
}

/// Of a top-down traversal the stack is the way from the root to the current
/// node; nothing else has one.
fn check_stack(tree: &Tree<3>, query: &Query<3>, moment: &Moment<3>) {
    let stack: Vec<_> = moment.stack.iter().map(|frame| frame.node).collect();
    use Algorithm::{AllChildren, Esvo, Gargantini, Hero, Parametric, ParametricTable};
    match query {
        // A tested child is the current node, but not on the stack until it is visited.
        Query::Ray { algorithm: AllChildren, .. } => {
            let top = moment.stack.last().map(|frame| frame.node);
            let way_up = |node| [node].into_iter().chain(tree.ancestors(node));
            let mut chain: Vec<_> = top.into_iter().flat_map(way_up).collect();
            chain.reverse();
            assert_eq!(stack, chain);
        }
        Query::Ray {
            algorithm: Parametric | ParametricTable | Esvo | Hero | Gargantini, ..
        } => {
            let mut chain: Vec<_> = moment.current.into_iter().collect();
            chain.extend(moment.ancestors(tree));
            chain.reverse();
            assert_eq!(stack, chain);
        }
        _ => assert!(stack.is_empty()),
    }
    for frame in &moment.stack {
        if frame.planes().is_some() {
            let variants = query.variants_at_work();
            let real = frame.state.zip(moment.clip);
            let real = real.map(|(state, clip)| variants.child_of_state(state, clip.mirror));
            assert_eq!(real, tree.child_index(frame.node));
        }
    }
}

/// The plane of a halving goes through the middle of the node that it is said to halve.
fn check_halving(tree: &Tree<3>, event: &Event<3>, moment: &Moment<3>) {
    match *event {
        Event::Split { axis, plane, .. } => {
            let halving = moment.halving.expect("a halving is told");
            let axis = usize::from(axis);
            assert_eq!(halving.axis, axis);
            let (level, code) = (tree.level(halving.node), tree.code(halving.node));
            assert_eq!(tree.domain().plane(axis, code[axis] + (1 << level) / 2), plane);
        }
        Event::Leaf { .. } | Event::Pop { .. } => assert_eq!(moment.halving, None),
        _ => {}
    }
}

#[test]
fn counters_count_what_the_trace_shows() {
    for_random_traces(|tree, _, _, trace| {
        let end = Moment::after(tree, trace, usize::MAX);
        let count = |counter| end.counters.get(counter) as usize;
        assert_eq!(count(Counter::Leaves), end.leaves.len());
        assert_eq!(count(Counter::Touches), end.touches.len());
        assert!(count(Counter::StackDepth) <= 3 * usize::from(tree.domain().root_level()) + 1);
    });
}

#[test]
fn stepping_from_leaf_to_leaf_stops_at_each() {
    for_random_traces(|_, _, _, trace| {
        let n = trace.events.len();
        let results: Vec<usize> =
            (1..=n).filter(|&step| trace.events[step - 1].is_result()).collect();
        for step in 0..=n + 1 {
            let next = results.iter().copied().find(|&result| result > step);
            assert_eq!(trace.next_leaf(step), next.unwrap_or(n));
            let previous = results.iter().copied().rfind(|&result| result < step);
            assert_eq!(trace.previous_leaf(step), previous.unwrap_or(0));
        }
    });
}

#[test]
fn a_walk_through_the_grid_reports_a_leaf_in_its_first_cell() {
    let mut n_reported = 0;
    for_random_traces(|tree, _, query, trace| {
        let Query::Ray { algorithm: Algorithm::Dda | Algorithm::DdaOctree, .. } = query else {
            return;
        };
        let mut moment = Moment::default();
        for event in &trace.events {
            moment.apply(tree, event);
            match *event {
                Event::Leaf { node, .. } | Event::Touch { node, .. } => {
                    let cell = moment.grid.and_then(|grid| grid.cell).unwrap();
                    assert_eq!(tree.node_at(0, cell).map(|node| node.id), Some(node));
                    n_reported += 1;
                }
                _ => {}
            }
        }
    });
    assert!(n_reported > 1000, "{n_reported}");
}

#[test]
fn folding_a_long_trace_takes_every_event_once() {
    // One walk after the other, as if along one ray: 10^5 events and more.
    let mut random = Random::new(5);
    let tree = random_tree::<3>(domain(10, 0), 60, &mut random);
    let ray = random_ray(&tree, Class::Diagonal, &mut random);
    let algorithm = Algorithm::Parametric;
    let query =
        Query::Ray { algorithm, options: Options::default(), arithmetic: Arithmetic::Doubles };
    let mut trace = record(&tree, &ray, &query);
    let (once, n_leaves) = (trace.events.clone(), trace.leaves().count());
    assert!(n_leaves > 0);
    let mut repeats = 1;
    while trace.events.len() < 100_000 {
        trace.events.extend_from_slice(&once);
        repeats += 1;
    }
    let moment = Moment::after(&tree, &trace, usize::MAX);
    assert_eq!(moment.step, trace.events.len());
    assert_eq!(moment.leaves.len(), n_leaves * repeats);
    let visits = once.iter().filter(|event| matches!(event, Event::Visit { .. })).count();
    assert_eq!(moment.counters.get(Counter::Calls) as usize, visits * repeats);
}

#[test]
fn on_the_way_to_a_neighbour_through_the_tree_no_old_codes_are_followed() {
    for_random_traces(|tree, _, _, trace| {
        let mut moment = Moment::default();
        for event in &trace.events {
            moment.apply(tree, event);
            let walks = matches!(
                event,
                Event::Parent { .. }
                    | Event::Mirror { .. }
                    | Event::Facing { .. }
                    | Event::Rope { .. }
            );
            assert!(!walks || moment.codes.is_none(), "{event:?}");
        }
    });
}
