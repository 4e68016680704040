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

/// Rooms for formulas in windows of 1024 by 768 and of 1280 by 800 points: below the
/// picture, in this width.
const BELOW_PICTURE: [f64; 2] = [304.0, 416.0];
/// The same below a low panel, as the rail is.
const BELOW_RAIL: [Page; 2] =
    [Page { width: 264.0, height: 148.0 }, Page { width: 296.0, height: 148.0 }];

/// Steps of a run whose formulas are shown without some of their numbers.
fn bare_steps<const D: usize>(scenario: &Scenario<D>, room: Page) -> Vec<usize> {
    let (content, grid) = (scenario.source.content().unwrap(), scenario.grid().unwrap());
    let tree = build(&content, grid, &scenario.recipe, &Progress::default()).unwrap();
    let trace = record(&tree, &scenario.ray, &scenario.query);
    let is_bare = |step: &usize| {
        let (notation, language) = (Notation::default(), Language::English);
        let told = formulas(&tree, &scenario.ray, &trace, *step, notation, language);
        let wanted: usize = told.iter().map(|told| 1 + usize::from(told.numbers.is_some())).sum();
        let figure = formula_figure(&told, room, LEAST);
        let shown = figure.drawn.iter().filter(|drawn| matches!(drawn.form, Form::Formula { .. }));
        shown.count() < wanted
    };
    (1..=trace.events.len()).filter(is_bare).collect()
}

fn check(name: &str, scenario: &AnyScenario, room: Page, expected: &[usize]) {
    let bare = match scenario {
        AnyScenario::Quadtree(scenario) => bare_steps(scenario, room),
        AnyScenario::Octree(scenario) => bare_steps(scenario, room),
    };
    if bare != expected {
        eprintln!("{name}: {bare:?} {:?}", room);
    }
}

#[test]
fn a_lecture_shows_what_a_misprint_computes_with_its_numbers() {
    for variant in Variant::ALL.into_iter().filter(|&variant| erratum_of(variant).is_some()) {
        for width in BELOW_PICTURE {
            let room = Page { width, height: formula_height(FormulaRows::One) };
            // The corners of a region, bit by bit, are too long.
            let is_region = matches!(variant, Variant::B24a | Variant::B24b | Variant::B24c);
            let expected: &[usize] = if is_region { &[1] } else { &[] };
            check(variant.id(), &counterexample(variant), room, expected);
        }
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
            for room in BELOW_RAIL {
                check(&format!("{scene} {algorithm:?}"), &scenario, room, &[]);
            }
        }
    }
}
