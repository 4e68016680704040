//! Laws and expectations of what is said.

mod forms;
mod formulas;
mod listed;
mod told;
mod unbroken;

use super::*;
use crate::event::Event;
use crate::geometry::Ray;
use crate::locate::{Direction, NeighbourMethod, Reach};
use crate::paper::counterexample;
use crate::progress::Progress;
use crate::query::{Arithmetic, PointMethod, Query};
use crate::random::Random;
use crate::scenario::{AnyScenario, Scenario};
use crate::text::Language;
use crate::trace::{Moment, record};
use crate::traverse::{Algorithm, Options, StopAt, Variant, Variants};
use crate::tree::{Cell, Domain, Split, Tree, grow};
use std::collections::{BTreeMap, BTreeSet};

/// Divides the cells along one diagonal; the last of them is full.
fn tree<const D: usize>(levels: u8) -> Tree<D> {
    let split = |cell: Cell<D>, ()| match cell.level {
        0 if cell.code == [2; D] => Split::Full(vec![0]),
        0 => Split::Empty,
        level if cell.code.iter().all(|c| c >> level == 2 >> level) => {
            Split::Inner(vec![(); 1 << D])
        }
        _ => Split::Empty,
    };
    grow(Domain::unit(levels), (), &Progress::default(), split).unwrap()
}

/// Rays that meet the corners of the tree's cells, miss it, or do neither.
fn rays<const D: usize>() -> Vec<Ray<D>> {
    let mut rays = vec![
        ([-0.25; D], [1.0; D]),
        ([1.25; D], [-1.0; D]),
        ([0.3; D], [1.0; D]),
        ([2.0; D], [1.0; D]),
        (std::array::from_fn(|e| 0.3 * e as f64 + 0.1), std::array::from_fn(|e| (e == 0).into())),
        ([-1.0; D], std::array::from_fn(|e| (e == 0).into())),
        (std::array::from_fn(|e| e as f64 - 0.5), std::array::from_fn(|e| 1.0 - e as f64 * 0.9)),
        // Meets the centre, from where an exit point pushed along one axis returns.
        (
            std::array::from_fn(|e| [1.875, 1.627, 0.55][e]),
            std::array::from_fn(|e| [-1.375, -1.127, 0.0][e]),
        ),
        // Touches a corner of the tree's cells, from outside their diagonal.
        (
            std::array::from_fn(|e| if e == 0 { 0.0 } else { 0.5 }),
            std::array::from_fn(|e| if e == 0 { 1.0 } else { -1.0 }),
        ),
    ];
    let mut random = Random::new(5);
    for _ in 0..24 {
        let origin = std::array::from_fn(|_| random.between(-0.5, 1.5));
        let direction = std::array::from_fn(|_| random.between(-1.0, 1.0));
        rays.push((origin, direction));
    }
    rays.into_iter().map(|(origin, direction)| Ray::new(origin, direction).unwrap()).collect()
}

/// Queries of every kind, by the name of their listing.
fn queries<const D: usize>() -> Vec<(&'static str, Query<D>)> {
    let mut queries = Vec::new();
    for algorithm in Algorithm::ALL {
        let own = |variant: &Variant| variant.belongs_to(algorithm);
        let variants = Variant::ALL.into_iter().filter(own).collect();
        for (stop_at, segment_end, variants) in [
            (StopAt::End, None, Variants::NONE),
            (StopAt::End, None, variants),
            (StopAt::End, Some(0.6), Variants::NONE),
            (StopAt::FirstFull, None, Variants::NONE),
        ] {
            let arithmetic = Arithmetic::Exact;
            let options = Options { stop_at, segment_end, variants };
            queries.push((algorithm.id(), Query::Ray { algorithm, options, arithmetic }));
        }
        for variant in Variant::ALL.into_iter().filter(own) {
            let options =
                Options { variants: [variant].into_iter().collect(), ..Options::default() };
            let arithmetic = Arithmetic::Doubles;
            queries.push((algorithm.id(), Query::Ray { algorithm, options, arithmetic }));
        }
    }
    for at in [[0.3; D], [0.5; D], [1.0; D]] {
        let point = |method, variants| Query::Point { at, method, variants };
        queries.push(("point-comparison", point(PointMethod::Comparison, Variants::NONE)));
        for variants in sets(&point(PointMethod::Codes, Variants::NONE)) {
            queries.push(("point-codes", point(PointMethod::Codes, variants)));
        }
    }
    for max in [0.3, 0.55, 0.9, 1.0] {
        let region = |variants| Query::Region { min: [0.26; D], max: [max; D], variants };
        for variants in sets(&region(Variants::NONE)) {
            queries.push(("region", region(variants)));
        }
    }
    for direction in Direction::all() {
        for reach in [Reach::EqualOrLarger, Reach::Leaf, Reach::EveryLeaf] {
            for (name, method) in [
                ("neighbour", NeighbourMethod::Codes),
                ("neighbour-tables", NeighbourMethod::Tables),
            ] {
                for (level, code) in [(0, [2; D]), (1, [2; D]), (2, [4; D])] {
                    let neighbour = |variants| Query::Neighbour {
                        level,
                        code,
                        direction,
                        reach,
                        method,
                        variants,
                    };
                    for variants in sets(&neighbour(Variants::NONE)) {
                        queries.push((name, neighbour(variants)));
                    }
                }
            }
        }
    }
    queries
}

/// No variant, every single one that the query takes, and all of them.
fn sets<const D: usize>(query: &Query<D>) -> Vec<Variants> {
    let own: Vec<Variant> = Variant::ALL.into_iter().filter(|&v| query.takes(v)).collect();
    let mut sets = vec![Variants::NONE, own.iter().copied().collect()];
    sets.extend(own.into_iter().map(|variant| Variants::NONE.with(variant)));
    sets
}

/// Calls `check` for every run of every query on sample trees.
fn for_all_runs<const D: usize>(mut check: impl FnMut(&Tree<D>, &Ray<D>, &'static str, &Query<D>)) {
    for levels in [0, 1, 3] {
        let tree = tree(levels);
        for (name, query) in queries() {
            let along_ray = matches!(query, Query::Ray { .. });
            for ray in rays().iter().take(if along_ray { usize::MAX } else { 1 }) {
                check(&tree, ray, name, &query);
            }
        }
    }
}

fn check_sentences<const D: usize>() {
    for_all_runs::<D>(|tree, ray, _, query| {
        let trace = record(tree, ray, query);
        for language in Language::ALL {
            for step in 0..=trace.events.len() {
                let text = sentence(tree, ray, &trace, step, language).plain();
                let whole = text.ends_with('.') && text.len() > 10;
                let placed = !text.contains(['{', '}', '$', '\n']) && !text.contains("  ");
                let marks = text.chars().any(|c| ('\u{E000}'..='\u{E0FF}').contains(&c));
                assert!(whole && placed && !marks, "{query:?}, step {step}: {text}");
            }
        }
    });
}

#[test]
fn every_step_has_a_whole_sentence_in_both_languages() {
    check_sentences::<2>();
    check_sentences::<3>();
}

/// A number as it is written in a sentence.
fn read(token: &str) -> Option<f64> {
    let digits = token.trim_end_matches([',', ':', ';', '.']).replace('−', "-");
    digits.replace('∞', "inf").parse().ok().filter(|x: &f64| !x.is_nan())
}

/// The number, or the "a xor b", at the end of `tokens`.
fn read_left(tokens: &[&str]) -> Option<f64> {
    let right = read(tokens.last()?)?;
    let ["xor", _] = tokens[tokens.len().saturating_sub(2)..] else { return Some(right) };
    let left = read(tokens.iter().rev().nth(2)?.rsplit('(').next()?)?;
    Some(f64::from(left as u32 ^ right as u32))
}

/// Checks each "x < y", "x < name = y" and "x xor y = z" of a text; returns how many
/// there are.
#[track_caller]
fn check_relations(text: &str, context: &str) -> usize {
    let tokens: Vec<&str> = text.split_whitespace().collect();
    let mut n = 0;
    for at in 1..tokens.len().saturating_sub(1) {
        let right = read(tokens[at + 1]).or_else(|| {
            let is_named = tokens.get(at + 2).is_some_and(|token| *token == "=");
            read(tokens.get(at + 3)?).filter(|_| is_named)
        });
        let (Some(left), Some(right)) = (read_left(&tokens[..at]), right) else { continue };
        let holds = match tokens[at] {
            "<" => left < right,
            ">" => left > right,
            "≤" => left <= right,
            "≥" => left >= right,
            "=" => left == right,
            _ => continue,
        };
        assert!(holds, "{context}: {text}");
        n += 1;
    }
    n
}

fn count_relations<const D: usize>() -> usize {
    let mut n = 0;
    for_all_runs::<D>(|tree, ray, _, query| {
        let trace = record(tree, ray, query);
        for step in 0..=trace.events.len() {
            let text = sentence(tree, ray, &trace, step, Language::English).plain();
            // Where doubles err they are not what was compared.
            if !text.contains("Doubles would err") {
                n += check_relations(&text, &format!("{query:?} {ray:?}, step {step}"));
            }
        }
    });
    n
}

#[test]
fn what_is_told_of_numbers_holds_for_them() {
    assert!(count_relations::<2>() > 1000);
    assert!(count_relations::<3>() > 1000);
}

fn check_variables<const D: usize>() {
    for_all_runs::<D>(|tree, ray, _, query| {
        let trace = record(tree, ray, query);
        for step in 0..=trace.events.len() {
            let variables = variables(tree, query, &Moment::after(tree, &trace, step));
            let names: BTreeSet<String> = variables.iter().map(|v| v.name.plain()).collect();
            assert_eq!(names.len(), variables.len(), "{query:?}, step {step}: {variables:?}");
            assert!(variables.iter().all(|v| !v.value.plain().is_empty()));
        }
    });
}

#[test]
fn variables_have_a_name_of_their_own_and_a_value() {
    check_variables::<2>();
    check_variables::<3>();
}

/// Checks that a run is told with these words, in English and in German.
fn check_words<const D: usize>(ray: &Ray<D>, query: &Query<D>, expected: [&str; 2]) {
    let tree = tree(3);
    let trace = record(&tree, ray, query);
    for (language, expected) in Language::ALL.into_iter().zip(expected) {
        let told: Vec<String> = (0..=trace.events.len())
            .map(|step| sentence(&tree, ray, &trace, step, language).plain())
            .collect();
        assert!(told.iter().any(|text| text == expected), "{}", told.join("\n"));
    }
}

fn along(algorithm: Algorithm) -> Query<2> {
    let (options, arithmetic) = (Options::default(), Arithmetic::Doubles);
    Query::Ray { algorithm, options, arithmetic }
}

fn with(algorithm: Algorithm, variant: Variant) -> Query<2> {
    let options = Options { variants: Variants::NONE.with(variant), ..Options::default() };
    Query::Ray { algorithm, options, arithmetic: Arithmetic::Doubles }
}

#[test]
fn the_first_sentence_tells_no_key_of_the_window() {
    for_all_runs::<2>(|tree, ray, _, query| {
        let trace = record(tree, ray, query);
        for language in Language::ALL {
            let text = sentence(tree, ray, &trace, 0, language).plain();
            assert!(!text.contains('→'), "{text}");
        }
    });
}
