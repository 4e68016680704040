//! The formulas of a step in the room that a lecture has for them.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use octoscope_core::explain::{Notation, formulas};
use octoscope_core::paper::{counterexample, erratum_of};
use octoscope_core::progress::Progress;
use octoscope_core::scenario::{AnyScenario, Scenario, built_in};
use octoscope_core::text::Language;
use octoscope_core::trace::record;
use octoscope_core::traverse::{Algorithm, Variant};
use octoscope_core::tree::build;
use octoscope_figure::views::{FormulaRows, formula_figure, formula_height};
use octoscope_figure::{Form, Page};

/// Type that is read from the back row, in the points of a lecture.
const LEAST: f64 = 12.5;

/// Rooms for formulas in a window of 1280 points: below the picture, and below the panel
/// beside it as well.
const BELOW: Room = Room { width: 436.0, rows: FormulaRows::Two };
const ACROSS: Room = Room { width: 736.0, rows: FormulaRows::One };

#[derive(Clone, Copy)]
struct Room {
    width: f64,
    rows: FormulaRows,
}

/// Steps of a run whose formulas are shown without some of their numbers.
fn bare_steps<const D: usize>(scenario: &Scenario<D>, room: Room) -> Vec<usize> {
    let most = Page { width: room.width, height: formula_height(room.rows) };
    let (content, grid) = (scenario.source.content().unwrap(), scenario.grid().unwrap());
    let tree = build(&content, grid, &scenario.recipe, &Progress::default()).unwrap();
    let trace = record(&tree, &scenario.ray, &scenario.query);
    let is_bare = |step: &usize| {
        let (notation, language) = (Notation::default(), Language::English);
        let told = formulas(&tree, &scenario.ray, &trace, *step, notation, language);
        let wanted: usize = told.iter().map(|told| 1 + usize::from(told.numbers.is_some())).sum();
        let figure = formula_figure(&told, most, LEAST);
        let shown = figure.drawn.iter().filter(|drawn| matches!(drawn.form, Form::Formula { .. }));
        shown.count() < wanted
    };
    (1..=trace.events.len()).filter(is_bare).collect()
}

fn check(name: &str, scenario: &AnyScenario, room: Room, expected: &[usize]) {
    let bare = match scenario {
        AnyScenario::Quadtree(scenario) => bare_steps(scenario, room),
        AnyScenario::Octree(scenario) => bare_steps(scenario, room),
    };
    assert_eq!(bare, expected, "{name}");
}

#[test]
fn a_lecture_shows_what_a_misprint_computes_with_its_numbers() {
    for variant in Variant::ALL.into_iter().filter(|&variant| erratum_of(variant).is_some()) {
        // The corners of a region, bit by bit, fill two such rooms.
        let is_long = matches!(variant, Variant::B24a | Variant::B24b | Variant::B24c);
        let expected: &[usize] = if is_long { &[1] } else { &[] };
        check(variant.id(), &counterexample(variant), BELOW, expected);
    }
}

#[test]
fn a_lecture_shows_what_the_first_algorithms_compute_with_its_numbers() {
    for scene in ["quadtree-82", "points-3d"] {
        for algorithm in [Algorithm::Parametric, Algorithm::ParametricTable] {
            let mut scenario = built_in(scene).unwrap();
            match &mut scenario {
                AnyScenario::Quadtree(s) => s.query = s.query.with_algorithm(algorithm),
                AnyScenario::Octree(s) => s.query = s.query.with_algorithm(algorithm),
            }
            check(&format!("{scene} {algorithm:?}"), &scenario, ACROSS, &[]);
        }
    }
}
