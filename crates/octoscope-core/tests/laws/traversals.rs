//! Every algorithm finds the leaves of the oracle.

use crate::rays::{Class, random_ray};
use crate::trees::{domain, random_tree};
use octoscope_core::event::{End, Event, Observer, Outcome};
use octoscope_core::geometry::Ray;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::random::Random;
use octoscope_core::traverse::{
    Algorithm, Options, Slivers, StopAt, doubles_suffice, first_difference,
};
use octoscope_core::tree::{NodeId, Tree};

/// What a run has found.
#[derive(Debug, Default)]
struct Found {
    leaves: Vec<NodeId>,
    intervals: Vec<[f64; 2]>,
    touches: Vec<NodeId>,
    /// Number of children visited so far of every node on the stack.
    visited: Vec<usize>,
    /// Most children visited of one node.
    most_visited: usize,
    clip: Option<[f64; 2]>,
}

impl<const D: usize> Observer<D> for Found {
    fn observe(&mut self, event: Event<D>) {
        match event {
            Event::Leaf { node, enter, exit, .. } => {
                self.leaves.push(node);
                self.intervals.push([enter, exit]);
            }
            Event::Touch { node, .. } => self.touches.push(node),
            Event::Visit { .. } | Event::Enter { .. } => {
                if let Some(visited) = self.visited.last_mut() {
                    *visited += 1;
                    self.most_visited = self.most_visited.max(*visited);
                }
                self.visited.push(0);
            }
            Event::Up { .. } => {
                self.visited.pop();
            }
            Event::Clip { enter, exit, .. } => self.clip = Some([enter.max(0.0), exit]),
            _ => {}
        }
    }
}

fn run<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    algorithm: Algorithm,
    arithmetic: Arithmetic,
    stop_at: StopAt,
) -> (Found, Outcome) {
    let options = Options { stop_at, ..Options::default() };
    run_with(tree, ray, Query::Ray { algorithm, options, arithmetic })
}

fn run_with<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, query: Query<D>) -> (Found, Outcome) {
    let mut found = Found::default();
    let outcome = query.run(tree, ray, &mut found);
    (found, outcome)
}

/// Compares all algorithms on one ray; returns the number of visited leaves.
fn check<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, context: &str) -> usize {
    let (oracle, end) = run(tree, ray, Algorithm::Exhaustive, Arithmetic::Exact, StopAt::End);
    for algorithm in Algorithm::ALL.into_iter().filter(|&a| a != Algorithm::Exhaustive) {
        for arithmetic in [Arithmetic::Exact, Arithmetic::Doubles] {
            let say = || format!("{algorithm:?} {arithmetic:?} {context} {ray:?}");
            let slivers = match arithmetic {
                Arithmetic::Exact => Slivers::Count,
                Arithmetic::Doubles => Slivers::Ignore,
            };
            let (found, outcome) = run(tree, ray, algorithm, arithmetic, StopAt::End);
            let difference = first_difference(tree, ray, &oracle.leaves, &found.leaves, slivers);
            assert_eq!(difference, None, "{}", say());
            let rounding = match arithmetic {
                Arithmetic::Doubles if doubles_suffice(tree.domain(), ray) => 0.0,
                Arithmetic::Doubles | Arithmetic::Exact => 4.0 * f64::EPSILON,
            };
            check_intervals(&found, rounding, say);
            match (algorithm, arithmetic) {
                (Algorithm::ParametricTable, Arithmetic::Exact) => {
                    let known = |touch| oracle.touches.contains(touch);
                    assert!(found.touches.iter().all(known), "{}", say());
                }
                (Algorithm::ParametricTable, Arithmetic::Doubles) => {}
                _ => {
                    assert!(found.most_visited <= D + 1, "{}", say());
                    assert!(found.touches.is_empty(), "{}", say());
                }
            }
            if arithmetic == Arithmetic::Exact {
                assert_eq!(outcome, end, "{}", say());
                let (_, outcome) = run(tree, ray, algorithm, arithmetic, StopAt::FirstFull);
                assert_eq!(outcome, first_full(tree, &oracle.leaves, end), "{}", say());
            }
        }
    }
    oracle.leaves.len()
}

/// Compares all algorithms on the piece of a ray that ends at `segment_end`.
fn check_segment<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, segment_end: f64) {
    let options = Options { segment_end: Some(segment_end), ..Options::default() };
    let query = |algorithm| Query::Ray { algorithm, options, arithmetic: Arithmetic::Exact };
    let (oracle, end) = run_with(tree, ray, query(Algorithm::Exhaustive));
    for algorithm in Algorithm::ALL {
        let (found, outcome) = run_with(tree, ray, query(algorithm));
        assert_eq!(found.leaves, oracle.leaves, "{algorithm:?} {segment_end} {ray:?}");
        assert_eq!(outcome, end, "{algorithm:?} {segment_end} {ray:?}");
        // Exits that come before the end may be shown as doubles just after it.
        let latest = segment_end + 4.0 * f64::EPSILON * segment_end.abs();
        assert!(found.intervals.iter().all(|[_, exit]| *exit <= latest));
    }
}

/// How a run ends that stops at the first full one of `leaves`.
fn first_full<const D: usize>(tree: &Tree<D>, leaves: &[NodeId], otherwise: Outcome) -> Outcome {
    let full = leaves.iter().find(|&&leaf| tree.node(leaf).is_full());
    full.map_or(otherwise, |&leaf| Outcome::at(End::FirstFull, leaf))
}

/// The intervals follow each other without gap from the first to the last plane
/// of the root. Exactly equal parameters of two planes may be shown as doubles
/// that differ by `rounding`, relative to them.
fn check_intervals(found: &Found, rounding: f64, say: impl Fn() -> String) {
    let same = |a: f64, b: f64| a == b || (a - b).abs() <= rounding * a.abs();
    let (Some(first), Some(last)) = (found.intervals.first(), found.intervals.last()) else {
        return;
    };
    let clip = found.clip.expect("every fast algorithm begins with a clip");
    assert!(same(clip[0], first[0]) && same(clip[1], last[1]), "{}", say());
    for [enter, exit] in &found.intervals {
        assert!(enter < exit || (rounding > 0.0 && same(*enter, *exit)), "{}", say());
    }
    for pair in found.intervals.windows(2) {
        assert!(same(pair[0][1], pair[1][0]), "{} {pair:?}", say());
    }
}

/// Checks `rays` rays of every class in each of `trees` trees.
fn check_many<const D: usize>(seed: u64, trees: u64, rays: usize) {
    let mut random = Random::new(seed);
    let mut visited = [0; Class::ALL.len()];
    for n in 0..trees {
        let depth = 1 + (n % 10) as u8;
        let tree = random_tree(domain::<D>(depth, n / 10), 30, &mut random);
        for (class, visited) in Class::ALL.into_iter().zip(&mut visited) {
            for _ in 0..rays {
                let ray = random_ray(&tree, class, &mut random);
                *visited += check(&tree, &ray, &format!("{class:?} tree {n}"));
            }
        }
    }
    for (class, visited) in Class::ALL.into_iter().zip(visited) {
        assert!(visited > 100, "rays of class {class:?} hardly meet a leaf: {visited}");
    }
}

fn check_segments<const D: usize>(seed: u64) {
    let mut random = Random::new(seed);
    for n in 0..30 {
        let tree = random_tree(domain::<D>(1 + (n % 6) as u8, n), 20, &mut random);
        for class in Class::ALL {
            let ray = random_ray(&tree, class, &mut random);
            let (whole, _) =
                run(&tree, &ray, Algorithm::Exhaustive, Arithmetic::Exact, StopAt::End);
            let ends = whole.intervals.iter().flat_map(|&[enter, exit]| {
                [enter, exit, 0.5 * enter + 0.5 * exit, exit.next_up(), exit.next_down()]
            });
            for end in ends.chain([-1.0, 0.0, 1e-9, 1e9]).filter(|end| end.is_finite()) {
                check_segment(&tree, &ray, end);
            }
        }
    }
}

#[test]
fn segments_end_where_they_should() {
    check_segments::<2>(3);
    check_segments::<3>(4);
}

#[test]
fn every_algorithm_equals_the_oracle_in_quadtrees() {
    check_many::<2>(1, 160, 20);
}

#[test]
fn every_algorithm_equals_the_oracle_in_octrees() {
    check_many::<3>(2, 160, 20);
}
