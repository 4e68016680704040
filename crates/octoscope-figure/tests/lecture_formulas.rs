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
/// The same below the rail, and in the narrower of them below another low panel.
const BELOW_RAIL: [Page; 2] =
    [Page { width: 264.0, height: 148.0 }, Page { width: 296.0, height: 148.0 }];
const BELOW_LOW_PANEL: Page = Page { width: 280.0, height: 148.0 };

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

fn bare_steps_of(scenario: &AnyScenario, room: Page) -> Vec<usize> {
    match scenario {
        AnyScenario::Quadtree(scenario) => bare_steps(scenario, room),
        AnyScenario::Octree(scenario) => bare_steps(scenario, room),
    }
}

/// Misprints whose counterexamples have steps without their numbers in a room.
fn bare_misprints(room: Page) -> Vec<(&'static str, Vec<usize>)> {
    let variants = Variant::ALL.into_iter().filter(|&variant| erratum_of(variant).is_some());
    let bare = variants.map(|v| (v.id(), bare_steps_of(&counterexample(v), room)));
    bare.filter(|(_, steps)| !steps.is_empty()).collect()
}

#[test]
fn a_lecture_shows_what_a_misprint_computes_with_its_numbers() {
    // The corners of a region, bit by bit, are too long.
    let regions = ["B-24a", "B-24b", "B-24c"].map(|id| (id, vec![1]));
    for room in BELOW_RAIL.into_iter().chain([BELOW_LOW_PANEL]) {
        assert_eq!(bare_misprints(room), regions, "{room:?}");
    }
    let [narrow, wide] = BELOW_PICTURE
        .map(|width| Page { width, height: formula_height(FormulaRows::One) })
        .map(bare_misprints);
    assert_eq!(wide, regions);
    // These are below a low panel, unless others are added: then they are too high.
    let firsts =
        ["B-1", "B-2", "B-2-morton", "B-5", "B-6", "B-7"].map(|id| (id, vec![1])).into_iter();
    let others = [("B-9", vec![1, 3]), ("B-18", vec![1]), ("B-19", vec![1])];
    assert_eq!(narrow, firsts.chain(others).chain(regions).collect::<Vec<_>>());
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
            for room in BELOW_RAIL.into_iter().chain([BELOW_LOW_PANEL]) {
                let bare = bare_steps_of(&scenario, room);
                assert!(bare.is_empty(), "{scene} {algorithm:?} in {room:?}: {bare:?}");
            }
        }
    }
}
