//! The window stays alive while something long is computed.

use crate::desk::Desk;
use eframe::egui::{Key, accesskit::Role};
use egui_kittest::kittest::Queryable;
use octoscope::document::AnyDocument;
use octoscope::traced::MOST_EVENTS;
use octoscope_core::event::End;
use octoscope_core::geometry::Ray;
use octoscope_core::query::Query;
use octoscope_core::scenario::{AnyScenario, built_in};
use octoscope_core::traverse::Algorithm;

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
    assert!(desk.says(&format!("{0} / {0} …", MOST_EVENTS + 1)));
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
