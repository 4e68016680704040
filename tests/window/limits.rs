//! The window stays alive while something long is computed.

use crate::desk::Desk;
use eframe::egui::{Key, accesskit::Role};
use egui_kittest::kittest::Queryable;
use octoscope::document::{AnyDocument, Found};
use octoscope::files::{Chosen, Purpose};
use octoscope::traced::MOST_EVENTS;
use octoscope_core::event::End;
use octoscope_core::geometry::Ray;
use octoscope_core::paper::verdict;
use octoscope_core::query::Query;
use octoscope_core::scenario::{AnyScenario, Source, built_in};
use octoscope_core::scene::Content;
use octoscope_core::traverse::{Algorithm, Variant, Variants};
use octoscope_core::tree::Merge;
use std::fs;
use tempfile::tempdir;

/// The window on a quadtree with 2^16 cells along every axis, one of them full.
fn deep() -> Desk {
    let Some(AnyScenario::Quadtree(mut scenario)) = built_in("quadtree-82") else { panic!() };
    scenario.recipe.depth = 16;
    scenario.recipe.capacity = 1;
    let mut desk = Desk::new();
    desk.open_scenario(&AnyScenario::Quadtree(scenario));
    assert_eq!(desk.plane().tree.domain().root_level(), 16);
    desk
}

fn ask(desk: &mut Desk, algorithm: Algorithm) {
    let AnyDocument::Plane(document) = desk.state_mut().document_mut() else { panic!() };
    let Query::Ray { options, arithmetic, .. } = document.scenario.query else { panic!() };
    document.scenario.query = Query::Ray { algorithm, options, arithmetic };
}

#[test]
fn a_long_trace_is_cut_off_and_says_so() {
    let mut desk = deep();
    let before = desk.plane().trace.events.len();
    ask(&mut desk, Algorithm::Dda);
    desk.step();
    // The old trace stays until the new one is there.
    assert_eq!(desk.plane().trace.events.len(), before);
    desk.state_mut().finish_work();
    desk.run();
    let trace = &desk.plane().trace;
    assert_eq!((trace.outcome.end, trace.events.len()), (End::Cut, MOST_EVENTS + 1));
    desk.press(Key::End);
    assert!(desk.sentence().starts_with("The trace ends here, but not the run"));
    assert_eq!(desk.step_number(), MOST_EVENTS + 1);
    assert!(desk.says(&format!("/ {} …", MOST_EVENTS + 1)));
}

#[test]
fn of_all_that_is_asked_meanwhile_the_last_wins() {
    let mut desk = deep();
    ask(&mut desk, Algorithm::Dda);
    desk.step();
    let last = Ray::new([-0.25, 0.3], [1.0, 0.1]).unwrap();
    for ray in [Ray::new([-0.25, 0.1], [1.0, 0.3]).unwrap(), last] {
        let AnyDocument::Plane(document) = desk.state_mut().document_mut() else { panic!() };
        document.scenario.ray = ray;
        desk.step();
    }
    desk.state_mut().finish_work();
    desk.run();
    desk.state_mut().finish_work();
    desk.run();
    assert_eq!(*desk.plane().traced_ray(), last);
    assert!(!desk.plane().needs_tracing());
}

#[test]
fn a_long_trace_that_is_given_up_leaves_everything_as_it_was() {
    let mut desk = deep();
    let before = desk.plane().scenario;
    ask(&mut desk, Algorithm::Dda);
    desk.step();
    desk.state().give_up_tracing();
    desk.state_mut().finish_work();
    desk.run();
    assert_eq!(desk.plane().scenario, before);
    assert!(desk.query_by_role_and_label(Role::Button, "Cancel").is_none());
}

/// The window on a quadtree of so many leaves that not all of them are tested in one
/// frame.
fn wide(misprint: Variants) -> Desk {
    let Some(AnyScenario::Quadtree(mut scenario)) = built_in("quadtree-82") else { panic!() };
    let side = 64u32;
    let cells = (0..side).flat_map(|y| (0..side).map(move |x| [2 * x, 2 * y + 1]));
    scenario.source = Source::Inline(Content::Cells(cells.collect()));
    (scenario.recipe.depth, scenario.recipe.merge) = (7, Merge::Kept);
    scenario.query = scenario.query.with_variants(misprint);
    let mut desk = Desk::new();
    desk.open_scenario(&AnyScenario::Quadtree(scenario));
    assert!(desk.plane().tree.n_leaves() > 4000);
    desk
}

/// What is known of the present run without another look at it.
fn steps_compared(desk: &mut Desk) -> Option<Vec<usize>> {
    let AnyDocument::Plane(document) = desk.state_mut().document_mut() else { panic!() };
    match document.comparison() {
        Found::Known(runs) => Some(runs.iter().map(|run| run.n_steps).collect()),
        Found::Coming(_) => None,
        Found::Never => panic!("the tree is not too large"),
    }
}

#[test]
fn a_long_comparison_is_made_meanwhile_and_the_last_one_stays_in_sight() {
    let mut desk = wide(Variants::NONE);
    assert_eq!(steps_compared(&mut desk), None);
    desk.press(Key::Num5);
    desk.state_mut().finish_work();
    desk.run();
    let before = steps_compared(&mut desk).unwrap();
    let rows = |desk: &Desk| desk.get_all_by_role(Role::RadioButton).count();
    let n_rows = rows(&desk);
    assert!(n_rows >= before.len());

    let AnyDocument::Plane(document) = desk.state_mut().document_mut() else { panic!() };
    document.scenario.ray = Ray::new([-0.25, 0.1], [1.0, 0.3]).unwrap();
    desk.step();
    assert_eq!(*desk.plane().traced_ray(), desk.plane().scenario.ray);
    desk.step();
    assert_eq!(rows(&desk), n_rows);
    desk.state_mut().finish_work();
    desk.run();
    assert_ne!(steps_compared(&mut desk).unwrap(), before);
}

#[test]
fn a_long_verdict_comes_later_and_is_of_the_present_run() {
    let misprint = Variants::NONE.with(Variant::B7);
    let mut desk = wide(misprint);
    for ray in [[0.9, 0.1], [0.7, 0.3]] {
        let AnyDocument::Plane(document) = desk.state_mut().document_mut() else { panic!() };
        document.scenario.ray = Ray::new([-0.25, 0.1], ray).unwrap();
        desk.step();
        desk.step();
        desk.state_mut().finish_work();
        desk.run();
        let document = desk.plane();
        let expected = verdict(&document.tree, document.traced_ray(), &document.trace);
        assert_eq!(document.known_verdict(), Some(&expected));
    }
}

#[test]
fn an_export_goes_on_when_another_one_is_asked_for() {
    let folder = tempdir().unwrap();
    let export = |name: &str| Chosen::Path(Purpose::Export("svg"), folder.path().join(name));
    let mut desk = deep();
    ask(&mut desk, Algorithm::Dda);
    let context = desk.ctx.clone();
    desk.state_mut().take_chosen(&context, export("first.svg"));
    desk.state_mut().take_chosen(&context, export("second.svg"));
    desk.state_mut().finish_export(&context);
    let written = || fs::read_dir(folder.path()).unwrap().map(|file| file.unwrap().file_name());
    assert_eq!(written().collect::<Vec<_>>(), ["first.svg"]);

    desk.state_mut().take_chosen(&context, export("third.svg"));
    eframe::App::on_exit(desk.state_mut());
    assert_eq!(written().collect::<Vec<_>>(), ["first.svg"]);
}

#[test]
fn a_way_back_to_the_ray_that_is_given_up_is_found_again() {
    let mut desk = deep();
    ask(&mut desk, Algorithm::Dda);
    desk.step();
    desk.state_mut().finish_work();
    desk.run();
    let asked = desk.plane().scenario.query;
    desk.click(Role::Button, "Point");
    desk.tap(Key::Escape);
    assert!(desk.plane().needs_tracing());
    desk.state().give_up_tracing();
    desk.state_mut().finish_work();
    desk.run();
    assert!(matches!(desk.plane().scenario.query, Query::Point { .. }));
    desk.tap(Key::Escape);
    assert_eq!(desk.plane().scenario.query, asked);
}
