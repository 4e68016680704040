//! Every algorithm finds the leaves of the oracle.

use crate::agreement::{compare, oracle, run_with};
use crate::rays::{Class, random_ray};
use crate::trees::{domain, random_tree};
use octoscope_core::event::{End, Event, Observer};
use octoscope_core::geometry::{Exact, Ray};
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::random::Random;
use octoscope_core::traverse::{
    Algorithm, Method, Options, Slivers, StopAt, doubles_suffice, first_difference,
};
use octoscope_core::tree::Tree;

/// Compares all algorithms on one ray; returns the number of visited leaves.
fn check<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, context: &str) -> usize {
    let oracle = oracle(tree, ray);
    for algorithm in Algorithm::ALL.into_iter().filter(|&a| a != Algorithm::Exhaustive) {
        for arithmetic in [Arithmetic::Exact, Arithmetic::Doubles] {
            let compared = compare(tree, ray, &oracle, algorithm, arithmetic);
            assert_eq!(compared, Ok(()), "{context}");
        }
    }
    oracle.0.leaves.len()
}

/// The run that begins in doubles and is made exact where these are in doubt has the
/// events of the one that is exact throughout.
fn check_guarded<const D: usize>(seed: u64) {
    let mut random = Random::new(seed);
    for n in 0..30 {
        let tree = random_tree(domain::<D>(1 + (n % 8) as u8, n / 8), 25, &mut random);
        for class in Class::ALL {
            for (stop_at, segment_end) in
                [(StopAt::End, None), (StopAt::FirstFull, None), (StopAt::End, Some(0.75))]
            {
                let ray = random_ray(&tree, class, &mut random);
                for algorithm in Algorithm::ALL {
                    let options = Options { stop_at, segment_end, ..Options::default() };
                    let (mut whole, mut guarded) = (Vec::new(), Vec::new());
                    let outcomes = [
                        algorithm.run::<D, Exact>(&tree, &ray, options, &mut whole),
                        algorithm.run_exactly(&tree, &ray, options, &mut guarded),
                        algorithm.run_exactly(&tree, &ray, options, &mut ()),
                    ];
                    // A point may be at no number, which does not equal itself.
                    let same = guarded == whole || format!("{guarded:?}") == format!("{whole:?}");
                    assert!(same, "{algorithm:?} {class:?} {ray:?}");
                    assert_eq!(outcomes, [outcomes[0]; 3], "{algorithm:?} {class:?} {ray:?}");
                }
            }
        }
    }
}

#[test]
fn doubles_without_doubt_take_exact_steps() {
    check_guarded::<2>(8);
    check_guarded::<3>(9);
}

/// Keeps all events, and wants no more after so many.
struct Limited<const D: usize> {
    events: Vec<Event<D>>,
    most: usize,
}

impl<const D: usize> Observer<D> for Limited<D> {
    fn observe(&mut self, event: Event<D>) {
        self.events.push(event);
    }

    fn wants_more(&self) -> bool {
        self.events.len() < self.most
    }
}

#[test]
fn a_run_that_is_cut_ends_where_the_exact_one_does() {
    let (mut random, mut n_cut) = (Random::new(10), 0);
    for _ in 0..40 {
        let tree = random_tree(domain::<3>(5, 0), 25, &mut random);
        for class in Class::ALL {
            let ray = random_ray(&tree, class, &mut random);
            for algorithm in Algorithm::ALL {
                let options = Options::default();
                let mut whole = Vec::new();
                algorithm.run::<3, Exact>(&tree, &ray, options, &mut whole);
                for most in 1..whole.len().min(40) {
                    let limited = || Limited { events: Vec::new(), most };
                    let (mut exact, mut guarded) = (limited(), limited());
                    let outcomes = [
                        algorithm.run::<3, Exact>(&tree, &ray, options, &mut exact),
                        algorithm.run_exactly(&tree, &ray, options, &mut guarded),
                    ];
                    let context = || format!("{algorithm:?} {class:?} {ray:?} {most}");
                    // As above.
                    let [exact, guarded] =
                        [exact, guarded].map(|limited| format!("{:?}", limited.events));
                    assert_eq!(exact, guarded, "{}", context());
                    assert_eq!(outcomes[0], outcomes[1], "{}", context());
                    n_cut += usize::from(outcomes[0].end == End::Cut);
                }
            }
        }
    }
    assert!(n_cut > 1000, "{n_cut}");
}

/// Planes that are crossed one by one, or mid planes that are means, cost extra
/// touches, but no leaf is missing or out of order.
fn check_forms<const D: usize>(seed: u64) {
    let mut random = Random::new(seed);
    let mut n_touches = 0;
    for n in 0..40 {
        let tree = random_tree(domain::<D>(1 + (n % 8) as u8, n / 8), 25, &mut random);
        for class in Class::ALL {
            for _ in 0..4 {
                let ray = random_ray(&tree, class, &mut random);
                let (expected, _) = oracle(&tree, &ray);
                for (id, arithmetic) in FORMS {
                    let Method { algorithm, variants } = id.parse().expect(id);
                    let options = Options { variants, ..Options::default() };
                    let query = Query::Ray { algorithm, options, arithmetic };
                    let name = || format!("{id} {class:?} {ray:?}");
                    let (found, _) = run_with(&tree, &ray, query);
                    let exact = arithmetic == Arithmetic::Exact;
                    if !exact && !doubles_suffice(tree.domain(), &ray) {
                        continue;
                    }
                    let slivers = if exact { Slivers::Count } else { Slivers::Ignore };
                    let [expected_leaves, leaves] = [&expected.leaves, &found.leaves];
                    let difference =
                        first_difference(&tree, &ray, expected_leaves, leaves, slivers);
                    assert!(difference.is_none(), "{}: {difference:?}", name());
                    let known = |touch| expected.touches.contains(touch);
                    assert!(!exact || found.touches.iter().all(known), "{}", name());
                    n_touches += found.touches.len();
                }
            }
        }
    }
    assert!(n_touches > 100, "{n_touches}");
}

/// Rules in another form that come to the right leaves, in the numbers in which
/// they do.
const FORMS: [(&str, Arithmetic); 6] = [
    ("parametric@one-by-one", Arithmetic::Exact),
    ("parametric@one-by-one", Arithmetic::Doubles),
    ("parametric@averaged", Arithmetic::Doubles),
    ("parametric-table@averaged", Arithmetic::Doubles),
    ("dda@one-by-one", Arithmetic::Exact),
    ("dda-octree@one-by-one", Arithmetic::Exact),
];

#[test]
fn other_forms_of_the_rules_cost_touches_but_no_leaf() {
    check_forms::<2>(5);
    check_forms::<3>(6);
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
            let (whole, _) = oracle(&tree, &ray);
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
