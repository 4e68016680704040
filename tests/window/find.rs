//! The search over everything that has a name, by keyboard alone.

use crate::desk::Desk;
use eframe::egui::{Event, Key, Modifiers};
use octoscope::view::Dialog;
use octoscope_core::query::Query;
use octoscope_core::traverse::{Algorithm, Variant};

fn search(desk: &mut Desk, words: &str) {
    desk.press_with(Modifiers::COMMAND, Key::K);
    desk.event(Event::Text(words.to_owned()));
    desk.run_steps(3);
}

#[test]
fn a_command_is_found_and_given() {
    let mut desk = Desk::new();
    search(&mut desk, "to the end");
    desk.press(Key::Enter);
    assert_eq!(desk.step_number(), desk.plane().trace.events.len());
    assert_eq!(desk.state().view.dialog, None);
}

#[test]
fn the_arrow_keys_choose_among_the_hits() {
    let mut desk = Desk::new();
    search(&mut desk, "samet");
    desk.press(Key::ArrowDown);
    desk.press(Key::Enter);
    let Query::Ray { algorithm, .. } = desk.plane().scenario.query else { panic!("not a ray") };
    assert_eq!(algorithm, Algorithm::SametCorner);
    assert_eq!(desk.step_number(), 0, "the arrows do not step");
}

#[test]
fn an_erratum_opens_its_counterexample() {
    let mut desk = Desk::new();
    search(&mut desk, "b-2");
    desk.press(Key::Enter);
    desk.state_mut().finish_work();
    desk.run();
    assert!(desk.space().scenario.query.variants().has(Variant::B2));
}

#[test]
fn what_is_not_found_is_said_and_escape_leaves() {
    let mut desk = Desk::new();
    search(&mut desk, "xyzzy");
    assert!(desk.says("Nothing has this name"));
    desk.press(Key::Enter);
    assert!(matches!(desk.state().view.dialog, Some(Dialog::Find(_))));
    desk.press(Key::Escape);
    assert_eq!(desk.state().view.dialog, None);
}
