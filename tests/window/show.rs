//! What the picture shows, by keyboard.

use crate::desk::{Desk, sample};
use eframe::egui::{Key, Modifiers, accesskit::Role};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use octoscope::shown::print_shown;
use octoscope_core::scenario::built_in;
use octoscope_figure::{Levels, Rest, Show, Slice};

const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

fn plane(desk: &Desk) -> Show {
    desk.state().view.plane_show
}

fn space(desk: &Desk) -> Show {
    desk.state().view.space_show
}

#[test]
fn levels_and_the_rest_are_chosen_by_keyboard_and_undone() {
    let mut desk = Desk::new();
    let root = desk.plane().tree.domain().root_level();
    desk.press_with(Modifiers::SHIFT, Key::ArrowUp);
    desk.press_with(CTRL_SHIFT, Key::ArrowDown);
    assert_eq!(plane(&desk).levels, Levels { least: 1, most: root - 1 });
    desk.press(Key::H);
    assert_eq!(plane(&desk).rest, Rest::Faint);
    desk.press(Key::I);
    assert!(plane(&desk).inner_nodes);
    for _ in 0..4 {
        desk.press_with(Modifiers::COMMAND, Key::Z);
    }
    assert_eq!(plane(&desk), Show::at_first::<2>());
    desk.press_with(Modifiers::COMMAND, Key::Y);
    assert_eq!(plane(&desk).levels.least, 1);
}

#[test]
fn an_octree_is_cut_open_by_keyboard() {
    let mut desk = Desk::with_file(sample("knot.octo"));
    desk.press(Key::K);
    assert_eq!(space(&desk).slice, Some(Slice { axis: 0, at: 0.5 }));
    desk.press_with(Modifiers::SHIFT, Key::ArrowRight);
    assert_eq!(space(&desk).slice.unwrap().at, 0.5 + 1.0 / 64.0);
    desk.press(Key::K);
    desk.press(Key::K);
    assert_eq!(space(&desk).slice.unwrap().axis, 2);
    desk.click(Role::DisclosureTriangle, "which cells, cut, how far apart");
    assert!(desk.query_by_role_and_label(Role::Slider, "place of the cut").is_some());
    desk.press(Key::Escape);
    desk.press(Key::K);
    assert_eq!(space(&desk).slice, None);
    // In the plane there is nothing to be cut.
    let mut desk = Desk::new();
    desk.press(Key::K);
    assert_eq!(plane(&desk).slice, None);
}

#[test]
fn children_are_moved_apart_and_back_with_and_without_animation() {
    let mut desk = Desk::new();
    desk.press(Key::A);
    assert_eq!(plane(&desk).explosion, Show::APART);
    desk.press(Key::A);
    assert_eq!(plane(&desk).explosion, 0.0);
    // With reduced motion, one frame is enough.
    desk.state_mut().view.reduced_motion = true;
    desk.tap(Key::A);
    desk.step();
    assert_eq!(plane(&desk).explosion, Show::APART);
    assert!(desk.state().view.flight.is_none());
}

#[test]
fn the_camera_flies_unless_motion_is_reduced() {
    let mut desk = Desk::with_file(sample("knot.octo"));
    desk.press(Key::F);
    desk.tap(Key::X);
    desk.step();
    assert!(desk.state().view.flight.is_some());
    desk.run();
    assert!(desk.state().view.flight.is_none());
    desk.state_mut().view.reduced_motion = true;
    desk.tap(Key::Z);
    desk.step();
    assert!(desk.state().view.flight.is_none());
}

#[test]
fn what_is_shown_is_saved_with_the_scenario() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("shown.octo");
    std::fs::copy(sample("exercise.octo"), &path).unwrap();
    let mut desk = Desk::with_file(&path);
    desk.press(Key::H);
    desk.press(Key::U);
    let shown = plane(&desk);
    desk.press_with(Modifiers::COMMAND, Key::S);
    desk.state_mut().finish_work();
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains(&print_shown(&shown)), "{text}");
    let mut desk = Desk::with_file(&path);
    assert_eq!(plane(&desk), shown);
    desk.press(Key::U);
    assert_ne!(plane(&desk), shown);
}

#[test]
fn a_scene_that_is_opened_is_whole() {
    let mut desk = Desk::new();
    desk.open_scenario(&built_in("points-3d").unwrap());
    desk.press(Key::K);
    desk.press(Key::A);
    desk.press(Key::D);
    let cut = space(&desk);
    assert!(cut.slice.is_some() && cut.explosion > 0.0 && cut.codes);
    desk.open_scenario(&built_in("sphere-grid").unwrap());
    assert_eq!(space(&desk), Show { slice: None, explosion: 0.0, ..cut });
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(space(&desk), cut);
}

#[test]
fn every_choice_has_a_name_in_the_accessibility_tree() {
    let mut desk = Desk::with_file(sample("knot.octo"));
    desk.click(Role::DisclosureTriangle, "which cells, cut, how far apart");
    for name in ["smallest level shown", "largest level shown"] {
        assert!(desk.query_by_role_and_label(Role::SpinButton, name).is_some(), "{name}");
    }
    assert!(desk.query_by_role_and_label(Role::Slider, "apart").is_some());
    for name in ["plain", "faint", "hidden", "off"] {
        assert!(desk.query_by_role_and_label(Role::Button, name).is_some(), "{name}");
    }
    for name in ["inner nodes", "half-open sides", "codes"] {
        assert!(desk.query_by_role_and_label(Role::CheckBox, name).is_some(), "{name}");
    }
}

#[test]
fn a_look_at_where_an_octree_is_cut_does_not_move_the_cut() {
    let mut desk = Desk::with_file(sample("knot.octo"));
    let kept = Some(Slice { axis: 0, at: 0.3 });
    desk.state_mut().view.space_show.slice = kept;
    desk.state_mut().view.space_show.explosion = 0.75;
    desk.run();
    desk.click(Role::DisclosureTriangle, "which cells, cut, how far apart");
    assert!(desk.query_by_role_and_label(Role::Slider, "place of the cut").is_some());
    assert_eq!((space(&desk).slice, space(&desk).explosion), (kept, 0.75));
}

#[test]
fn what_is_wrong_beside_a_slider_stays_and_says_so() {
    // So high that nothing has to be scrolled.
    let mut desk = Desk::of(Harness::builder(), [1280.0, 1600.0]);
    desk.open(sample("knot.octo"));
    desk.state_mut().view.space_show.slice = Some(Slice { axis: 0, at: 0.3 });
    desk.run();
    desk.click(Role::DisclosureTriangle, "which cells, cut, how far apart");
    let kept = (desk.space().scenario.recipe, space(&desk));
    for (name, kind) in
        [("depth", "whole number"), ("apart", "number"), ("place of the cut", "number")]
    {
        for typed in ["abc", "99"] {
            desk.type_into(name, typed);
            let said = format!("“{typed}” is no {kind} from 0 to");
            assert!(desk.says(&said), "{name} {typed}");
            desk.press(Key::Escape);
            assert!(!desk.says(&said), "{name} {typed}");
        }
    }
    assert_eq!((desk.space().scenario.recipe, space(&desk)), kept);
    desk.type_into("apart", "1/4");
    assert_eq!(space(&desk).explosion, 0.25);
}
