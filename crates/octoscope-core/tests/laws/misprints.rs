//! Rules as printed on random trees and awkward rays: whatever they make of
//! them, they come to an end, and where they are wrong, random input shows it.

use crate::rays::{Class, random_ray};
use crate::trees::{domain, random_tree};
use octoscope_core::event::Event;
use octoscope_core::geometry::Ray;
use octoscope_core::locate::{Direction, NeighbourMethod, Reach};
use octoscope_core::paper::verdict;
use octoscope_core::query::{Arithmetic, PointMethod, Query};
use octoscope_core::random::Random;
use octoscope_core::trace::record;
use octoscope_core::traverse::{Algorithm, Options, StopAt, Variant, Variants, doubles_suffice};
use octoscope_core::tree::{NodeId, Tree};
use std::collections::BTreeMap;

/// Questions with random arguments whose rules may be misprinted.
fn questions<const D: usize>(tree: &Tree<D>, random: &mut Random) -> Vec<Query<D>> {
    let (arithmetic, variants) = (Arithmetic::Doubles, Variants::NONE);
    let mut questions = Vec::new();
    for algorithm in [Algorithm::Parametric, Algorithm::ParametricTable] {
        for (stop_at, segment_end) in [(StopAt::End, None), (StopAt::FirstFull, Some(0.5))] {
            let options = Options { stop_at, segment_end, variants };
            questions.push(Query::Ray { algorithm, options, arithmetic });
        }
    }
    let (min, side) = (tree.domain().min(), tree.domain().side());
    // Quarters of the side lie on planes, the upper face among them.
    let mut point = || std::array::from_fn(|e| min[e] + side * 0.25 * random.below(5) as f64);
    let corners = [point(), point()];
    questions.push(Query::Point { at: corners[0], method: PointMethod::Codes, variants });
    questions.push(Query::Region { min: corners[0], max: corners[1], variants });
    let at = std::array::from_fn(|e| min[e] + side * random.between(0.0, 1.0));
    questions.push(Query::Point { at, method: PointMethod::Codes, variants });
    let beside = at.map(|x| x + side * random.between(0.0, 0.1));
    questions.push(Query::Region { min: at, max: beside, variants });
    let id = NodeId(random.below(tree.n_nodes() as u64) as u32);
    let (level, code, method) = (tree.level(id), tree.code(id), NeighbourMethod::Codes);
    for direction in Direction::all() {
        for reach in [Reach::EqualOrLarger, Reach::Leaf, Reach::EveryLeaf] {
            questions.push(Query::Neighbour { level, code, direction, reach, method, variants });
        }
    }
    questions
}

/// Every misprint of the question alone, and some of them at once.
fn misprinted<const D: usize>(query: Query<D>, random: &mut Random) -> Vec<Query<D>> {
    let own: Vec<Variant> = Variant::ALL.into_iter().filter(|&v| query.takes(v)).collect();
    let some = own.iter().copied().filter(|_| random.below(2) == 0).collect();
    let alone = own.iter().map(|&variant| Variants::NONE.with(variant));
    alone.chain([some]).map(|variants| query.with_variants(variants)).collect()
}

/// Checks one run; returns whether it comes to the right result.
fn check<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, query: &Query<D>) -> bool {
    let trace = record(tree, ray, query);
    let name = || format!("{query:?} {ray:?}");
    assert!(trace.events.len() <= 10 * tree.n_nodes() + 20, "{}", name());
    let ends = trace.events.iter().filter(|event| matches!(event, Event::End(_))).count();
    assert_eq!(ends, 1, "{}", name());
    let leaves: Vec<NodeId> = trace.leaves().map(|(leaf, _)| leaf).collect();
    for (n, leaf) in leaves.iter().enumerate() {
        assert!(!leaves[..n].contains(leaf), "{leaf:?} twice: {}", name());
    }
    let verdict = verdict(tree, ray, &trace);
    let step = verdict.first_wrong_step;
    assert!(step.is_none_or(|step| (1..=trace.events.len()).contains(&step)), "{}", name());
    verdict.agrees()
}

/// How often each variant alone is right and wrong on random input.
fn counts<const D: usize>() -> BTreeMap<Variant, [usize; 2]> {
    let mut random = Random::new(11);
    let mut counts = BTreeMap::new();
    for n in 0..12 {
        let tree: Tree<D> = random_tree(domain(1 + n as u8 % 6, n), 25, &mut random);
        for class in Class::ALL {
            let ray = random_ray(&tree, class, &mut random);
            for question in questions(&tree, &mut random) {
                for query in misprinted(question, &mut random) {
                    let agrees = check(&tree, &ray, &query);
                    let variants: Vec<Variant> = query.variants().iter().collect();
                    // Elsewhere it may be the doubles that are wrong: where planes are
                    // rounded, so is the mirrored origin.
                    let suffice = n % 4 < 2 && doubles_suffice(tree.domain(), &ray);
                    if let (&[variant], true) = (&variants[..], suffice) {
                        counts.entry(variant).or_insert([0; 2])[usize::from(!agrees)] += 1;
                    }
                }
            }
        }
    }
    counts
}

/// Whatever rule is in another form, no node is told to be wrong where the result is right.
fn check_strayed<const D: usize>() {
    let mut random = Random::new(12);
    let mut n_strayed = 0;
    for n in 0..8 {
        let tree: Tree<D> = random_tree(domain(1 + n as u8 % 6, n), 25, &mut random);
        for class in Class::ALL {
            let ray = random_ray(&tree, class, &mut random);
            let ways = Algorithm::ALL.into_iter().flat_map(|algorithm| {
                let ends = [(StopAt::End, None), (StopAt::FirstFull, Some(0.5))];
                ends.map(|(stop_at, segment_end)| {
                    let options = Options { stop_at, segment_end, variants: Variants::NONE };
                    Query::Ray { algorithm, options, arithmetic: Arithmetic::Doubles }
                })
            });
            let questions: Vec<Query<D>> = ways.chain(questions(&tree, &mut random)).collect();
            for query in questions.into_iter().flat_map(|query| misprinted(query, &mut random)) {
                let trace = record(&tree, &ray, &query);
                let verdict = verdict(&tree, &ray, &trace);
                let is_told = !verdict.agrees() || verdict.strayed.is_empty();
                assert!(is_told, "{verdict:?}: {query:?} {ray:?}");
                n_strayed += verdict.strayed.len();
            }
        }
    }
    assert!(n_strayed > 0);
}

#[test]
fn nothing_strays_where_the_result_is_right() {
    check_strayed::<2>();
    check_strayed::<3>();
}

#[test]
fn misprints_come_to_an_end_and_go_wrong_on_random_input() {
    let [plane, space] = [counts::<2>(), counts::<3>()];
    for variant in Variant::ALL.into_iter().filter(|variant| variant.is_misprint()) {
        let wrong = [&plane, &space].map(|counts| counts.get(&variant).map(|[_, wrong]| *wrong));
        // Table 2 is of space, the selection of the plane.
        let of_table_2 = matches!(variant, Variant::B2 | Variant::B2Morton);
        let exists = [!of_table_2, variant != Variant::B3];
        // The walk of B-9 is longer, but what lies behind is not reported.
        let expected = exists.map(|exists| exists.then_some(variant != Variant::B9));
        let goes_wrong = wrong.map(|wrong| wrong.map(|wrong| wrong > 0));
        assert_eq!(goes_wrong, expected, "{variant:?}: {wrong:?}");
    }
}
