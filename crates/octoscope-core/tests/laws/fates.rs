//! What becomes of every node, against the oracle.

use crate::rays::{Class, random_ray};
use crate::trees::{domain, random_tree};
use octoscope_core::event::Event;
use octoscope_core::geometry::Ray;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::random::Random;
use octoscope_core::trace::{Fate, Moment, Reason, deciding_fate, fate, record};
use octoscope_core::traverse::{Algorithm, Options, StopAt};
use octoscope_core::tree::{Node, NodeId, Tree};

/// Random trees with rays of every class, to their end and to a part of it.
fn for_random_rays<const D: usize>(check: impl Fn(&Tree<D>, &Ray<D>, Options)) {
    let mut random = Random::new(11);
    for n in 0..12 {
        let tree = random_tree(domain(1 + (n % 6) as u8, n), 25, &mut random);
        for class in Class::ALL {
            let ray = random_ray(&tree, class, &mut random);
            for segment_end in [None, Some(0.5)] {
                check(&tree, &ray, Options { segment_end, ..Options::default() });
            }
        }
    }
}

fn exact<const D: usize>(algorithm: Algorithm, options: Options) -> Query<D> {
    Query::Ray { algorithm, options, arithmetic: Arithmetic::Exact }
}

fn the_oracle_says_the_same<const D: usize>() {
    for_random_rays::<D>(|tree, ray, options| {
        let query = exact(Algorithm::Exhaustive, options);
        let trace = record(tree, ray, &query);
        let moment = Moment::after(tree, &trace, usize::MAX);
        for node in tree.nodes() {
            let is_in = |leaf: NodeId| tree.holds(node.id, leaf);
            let visited = moment.leaves.iter().any(|leaf| is_in(leaf.node));
            let touched = !visited && moment.touches.iter().any(|&(leaf, _)| is_in(leaf));
            let fate = fate(tree, ray, &query, &moment, node.id).expect("a ray is asked for");
            assert_eq!(matches!(fate, Fate::Visited(_)), visited, "{fate:?} {ray:?}");
            let is_touch = matches!(fate, Fate::RuledOut(Reason::Touched { .. }));
            assert_eq!(is_touch, touched, "{fate:?} {ray:?} {:?}", tree.node_box(node.id));
            assert!(visited || matches!(fate, Fate::RuledOut(_)), "{fate:?} {ray:?}");
        }
    });
}

#[test]
fn a_node_is_visited_or_ruled_out_as_the_oracle_says() {
    the_oracle_says_the_same::<2>();
    the_oracle_says_the_same::<3>();
}

#[test]
fn the_numbers_of_a_reason_hold() {
    for_random_rays::<3>(|tree, ray, options| {
        let query = exact(Algorithm::default(), options);
        let moment = Moment::after(tree, &record(tree, ray, &query), usize::MAX);
        for node in tree.nodes() {
            let Some(Fate::RuledOut(reason)) = fate(tree, ray, &query, &moment, node.id) else {
                continue;
            };
            let holds = match reason {
                Reason::Beside { axis, origin, sides } => {
                    ray.direction()[axis] == 0.0 && (origin < sides[0] || origin >= sides[1])
                }
                Reason::Missed { enter, exit } => enter.t >= exit.t && enter.axis != exit.axis,
                Reason::Touched { enter, exit } => enter.map_or(0.0, |enter| enter.t) == exit.t,
                Reason::Behind { exit } => exit.t <= 0.0,
                Reason::BeyondEnd { enter, end } => enter.map_or(0.0, |enter| enter.t) >= end,
                Reason::AfterFull { enter, full } => enter >= full,
                Reason::Elsewhere { .. } => false,
            };
            assert!(holds, "{reason:?} {ray:?}");
        }
    });
}

#[test]
fn exact_runs_of_every_algorithm_neither_stray_nor_pass_anything_by() {
    for_random_rays::<3>(|tree, ray, options| {
        for algorithm in Algorithm::ALL {
            for stop_at in [StopAt::End, StopAt::FirstFull] {
                let query = exact(algorithm, Options { stop_at, ..options });
                let trace = record(tree, ray, &query);
                for step in [0, trace.events.len() / 3, trace.events.len()] {
                    let moment = Moment::after(tree, &trace, step);
                    for node in tree.nodes() {
                        let fate = fate(tree, ray, &query, &moment, node.id).unwrap();
                        let wrong = matches!(fate, Fate::Strayed(_) | Fate::PassedBy(_));
                        assert!(!wrong, "{algorithm:?} {step}: {fate:?} {ray:?}");
                    }
                }
            }
        }
    });
}

#[test]
fn a_ruled_out_node_is_decided_by_the_highest_that_is() {
    for_random_rays::<2>(|tree, ray, options| {
        let query = exact(Algorithm::default(), options);
        let moment = Moment::after(tree, &record(tree, ray, &query), usize::MAX);
        for node in tree.nodes() {
            let (above, decided) = deciding_fate(tree, ray, &query, &moment, node.id).unwrap();
            assert!(tree.holds(above, node.id));
            let is_out =
                |id| matches!(fate(tree, ray, &query, &moment, id), Some(Fate::RuledOut(_)));
            assert_eq!(is_out(node.id), matches!(decided, Fate::RuledOut(_)));
            assert!(tree.ancestors(above).all(|id| !is_out(id)));
        }
    });
}

#[test]
fn the_first_step_in_a_node_is_the_first_of_its_leaves_or_before() {
    for_random_rays::<3>(|tree, ray, options| {
        for algorithm in Algorithm::ALL {
            let trace = record(tree, ray, &exact(algorithm, options));
            for (n, event) in trace.events.iter().enumerate() {
                if let Event::Leaf { node, .. } = event {
                    for above in [*node].into_iter().chain(tree.ancestors(*node)) {
                        let step = trace.first_step_in(tree, above).unwrap();
                        assert!(step <= n + 1, "{algorithm:?}");
                        let current = Moment::after(tree, &trace, step).current.unwrap();
                        assert!(tree.holds(above, current));
                    }
                }
            }
        }
    });
}

fn leaves_are_counted<const D: usize>() {
    let mut random = Random::new(5);
    for n in 0..20 {
        let tree = random_tree::<D>(domain(1 + (n % 7) as u8, n), 40, &mut random);
        for node in tree.nodes() {
            let is_in = |leaf: &Node| {
                leaf.id == node.id || tree.ancestors(leaf.id).any(|above| above == node.id)
            };
            assert_eq!(tree.n_leaves_in(node.id), tree.leaves().filter(is_in).count());
            assert!(tree.leaves().all(|leaf| tree.holds(node.id, leaf.id) == is_in(&leaf)));
        }
    }
}

#[test]
fn the_leaves_in_every_node_are_counted_and_held() {
    leaves_are_counted::<2>();
    leaves_are_counted::<3>();
}
