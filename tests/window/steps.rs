//! Stepping, playing and the presenter's keys.

use crate::desk::{Desk, spoken};
use eframe::egui::{Color32, Event as Input, Key, Modifiers, Shape, accesskit::Role, vec2};
use egui_kittest::Node;
use egui_kittest::kittest::{NodeT, Queryable};
use octoscope_core::event::Event;
use octoscope_core::explain::number;
use octoscope_figure::Theme;

#[test]
fn the_rail_and_the_sentence_tell_all_digits_when_pointed_at() {
    let mut desk = Desk::new();
    desk.type_into("origin x", "-1/3");
    desk.press(Key::Home);
    desk.press(Key::ArrowRight);
    let name = desk.texts().into_iter().find(|text| text.starts_with("t-rail:")).unwrap();
    let rail = desk.get_by_role_and_label(Role::Slider, &name).rect();
    desk.point_at(rail.center());
    (0..40).for_each(|_| desk.step());
    let clip = match &desk.plane().trace.events[0] {
        Event::Clip { near, .. } => near[0],
        other => panic!("{other:?}"),
    };
    let digits = number(clip);
    assert!(digits.len() > 10, "{digits}");
    assert!(desk.texts().iter().any(|text| text == &format!("t_x0 = {digits}")), "{digits}");
    let is_sentence = |node: &Node<'_>| node.accesskit_node().author_id() == Some("sentence");
    let sentence = desk.nodes().into_iter().find(is_sentence).unwrap().rect();
    let mut tells_at = |share: f32, height: f32| {
        let at = sentence.left_top() + sentence.size() * vec2(share, height);
        desk.point_at(at);
        (0..40).for_each(|_| desk.step());
        desk.texts().iter().any(|text| text.contains(" ≈ "))
    };
    let first_line = 12.0 / sentence.height();
    let numbers: Vec<f32> = (1..60).map(|n| n as f32 / 60.0).collect();
    let at_number = numbers.into_iter().find(|&share| tells_at(share, first_line));
    let at_number = at_number.expect("a number is told in short");
    assert!(!tells_at(0.999, 0.99), "where nothing is");
    assert!(tells_at(at_number, first_line));
    // Whoever goes on by keyboard is not pointing.
    for _ in 0..2 {
        desk.press(Key::ArrowRight);
        (0..40).for_each(|_| desk.step());
        assert!(!desk.texts().iter().any(|text| text.contains(" ≈ ")), "{}", desk.sentence());
    }
}

#[test]
fn before_the_first_step_no_code_is_shown() {
    let mut desk = Desk::new();
    desk.press(Key::Home);
    assert!(!desk.says("Morton code") && !desk.says("0 = 0"));
    desk.press(Key::ArrowDown);
    assert!(desk.says("Morton code"));
}

#[test]
fn a_focused_slider_is_moved_by_keys_and_by_screen_readers() {
    let mut desk = Desk::new();
    desk.press(Key::Num2);
    desk.press(Key::Home);
    desk.press(Key::ArrowDown);
    let (start, length) = (desk.step_number(), desk.plane().trace.events.len());
    for begins in ["Step of the trace", "t-rail:"] {
        let slider = |desk: &Desk| -> usize {
            let mut all = desk.get_all_by_role(Role::Slider);
            all.position(|node| spoken(&node).starts_with(begins)).unwrap()
        };
        let nth = slider(&desk);
        desk.get_all_by_role(Role::Slider).nth(nth).unwrap().focus();
        desk.run();
        for (key, step) in [
            (Key::ArrowRight, start + 1),
            (Key::ArrowRight, start + 2),
            (Key::ArrowLeft, start + 1),
            (Key::ArrowLeft, start),
        ] {
            desk.press(key);
            assert_eq!(desk.step_number(), step, "{begins}");
        }
        desk.get_all_by_role(Role::Slider).nth(nth).unwrap().increment_accesskit();
        desk.run();
        assert_eq!(desk.step_number(), start + 1, "{begins}");
        desk.get_all_by_role(Role::Slider).nth(nth).unwrap().set_value_accesskit(start as f64);
        desk.run();
        let node = desk.get_all_by_role(Role::Slider).nth(nth).unwrap();
        let node = node.accesskit_node();
        let values = [node.numeric_value(), node.min_numeric_value(), node.max_numeric_value()];
        assert_eq!(values, [start, 0, length].map(|step| Some(step as f64)), "{begins}");
    }
    desk.press(Key::Home);
    assert_eq!(desk.step_number(), 0);
}

#[test]
fn the_number_of_a_step_is_typed_to_go_there() {
    for preset in [Key::Num2, Key::Num6] {
        let mut desk = Desk::new();
        desk.press(preset);
        let length = desk.plane().trace.events.len();
        desk.press_with(Modifiers::COMMAND, Key::G);
        desk.event(Input::Text("80".to_owned()));
        desk.press(Key::Enter);
        assert_eq!(desk.step_number(), 80);
        // The keys are commands again.
        desk.press(Key::ArrowRight);
        assert_eq!(desk.step_number(), 81);

        // What is no step is said, and what was there holds.
        let name = "Number of the step";
        for wrong in [(length + 1).to_string(), "-1".to_owned(), "two".to_owned()] {
            desk.type_into(name, &wrong);
            let said = format!("“{wrong}” is no whole number from 0 to {length}");
            assert!(desk.says(&said), "{said}: {:?}", desk.texts());
            assert_eq!(desk.step_number(), 81);
            desk.press(Key::Escape);
            assert_eq!(desk.step_number(), 81);
        }
        let node = desk.get_by_role_and_label(Role::SpinButton, name);
        assert_eq!(node.accesskit_node().numeric_value(), Some(81.0));
    }
}

#[test]
fn a_number_typed_at_once_with_its_key_is_no_command() {
    let mut desk = Desk::new();
    let (preset, ray) = (desk.state().view.preset, desk.plane().scenario.ray);
    desk.press(Key::Space);
    desk.key_press_modifiers(Modifiers::COMMAND, Key::G);
    for (key, digit) in [(Key::Num1, "1"), (Key::Num2, "2")] {
        desk.key_press(key);
        desk.event(Input::Text(digit.to_owned()));
    }
    desk.run();
    desk.press(Key::Enter);
    assert_eq!(desk.step_number(), 12);
    assert_eq!((desk.state().view.preset, desk.plane().scenario.ray), (preset, ray));
    assert!(!desk.state().view.playback.playing);
}

#[test]
fn a_hint_beside_the_pointer_is_for_pointing_not_for_stepping() {
    let mut desk = Desk::new();
    desk.press(Key::Home);
    let inside = desk.place([0.5, 0.75]) + vec2(3.0, 0.0);
    desk.point_at(inside);
    let hint = "Click: the neighbour beyond";
    assert!(desk.says(hint), "{:?}", desk.texts());
    desk.press(Key::ArrowRight);
    assert!(!desk.says(hint));
    desk.point_at(inside + vec2(1.0, 0.0));
    assert!(desk.says(hint));
}

#[test]
fn stepping_to_the_end_and_back_shows_the_same_sentences() {
    let mut desk = Desk::new();
    desk.press(Key::Num6);
    desk.press(Key::Home);
    let length = desk.plane().trace.events.len();
    assert!(length > 20, "{length}");
    let mut forward = vec![desk.sentence()];
    assert!(forward[0].ends_with(". Press → to begin."), "{}", forward[0]);
    while desk.step_number() < length {
        desk.tap(Key::ArrowRight);
        forward.push(desk.sentence());
        assert_eq!(desk.step_number() + 1, forward.len());
    }
    desk.tap(Key::ArrowRight);
    assert_eq!(desk.step_number(), length, "there is nothing after the end");
    for expected in forward.iter().rev().skip(1) {
        desk.tap(Key::ArrowLeft);
        assert_eq!(desk.sentence(), *expected);
    }
    assert_eq!(desk.step_number(), 0);
    desk.tap(Key::ArrowLeft);
    assert_eq!(desk.step_number(), 0, "there is nothing before the start");
}

#[test]
fn home_and_end_reach_both_ends_and_the_presenters_keys_step() {
    let mut desk = Desk::new();
    desk.press(Key::End);
    assert_eq!(desk.step_number(), desk.plane().trace.events.len());
    desk.press(Key::Home);
    assert_eq!(desk.step_number(), 0);
    desk.press(Key::PageDown);
    desk.press(Key::PageDown);
    assert_eq!(desk.step_number(), 2);
    desk.press(Key::PageUp);
    assert_eq!(desk.step_number(), 1);
}

#[test]
fn down_and_up_visit_the_leaves_in_order() {
    let mut desk = Desk::new();
    desk.press(Key::Home);
    let leaves: Vec<_> = desk.plane().trace.leaves().map(|(leaf, _)| leaf).collect();
    for leaf in &leaves {
        desk.press(Key::ArrowDown);
        let moment = desk.plane().moment(desk.step_number());
        assert_eq!(moment.leaves.last().map(|on_ray| on_ray.node), Some(*leaf));
    }
    let last = desk.step_number();
    desk.press(Key::ArrowUp);
    assert!(desk.step_number() < last);
    let moment = desk.plane().moment(desk.step_number());
    assert_eq!(moment.leaves.len(), leaves.len() - 1);
}

#[test]
fn the_keyboard_alone_starts_and_stops_playing() {
    let mut desk = Desk::new();
    desk.press(Key::Home);
    let is_play = |desk: &Desk| {
        desk.query_by_role_and_label(Role::Button, "Play or pause")
            .is_some_and(|button| button.is_focused())
    };
    let n_nodes = desk.nodes().len();
    let tabs = (0..n_nodes).find(|_| {
        desk.tap(Key::Tab);
        is_play(&desk)
    });
    assert!(tabs.is_some(), "Tab reaches the button");
    for key in [Key::Space, Key::Enter] {
        desk.tap(key);
        assert!(desk.state().view.playback.playing, "{key:?}");
        desk.tap(key);
        assert!(!desk.state().view.playback.playing, "{key:?}");
    }
}

#[test]
fn space_plays_to_the_end_by_itself() {
    let mut desk = Desk::new();
    desk.press(Key::Num6);
    desk.press(Key::End);
    for _ in 0..6 {
        desk.tap(Key::CloseBracket);
    }
    desk.tap(Key::Space);
    let length = desk.plane().trace.events.len();
    assert!(desk.state().view.playback.playing);
    assert!(desk.step_number() < length, "it starts over from the end");
    let frames = length * 2;
    let stopped = (0..frames).find(|_| {
        desk.step();
        !desk.state().view.playback.playing
    });
    assert!(stopped.is_some());
    assert_eq!(desk.step_number(), length);
}

#[test]
fn a_blank_screen_shows_nothing_and_comes_back() {
    let mut desk = Desk::new();
    let before = desk.texts();
    for wake in [Key::B, Key::Period, Key::Escape] {
        desk.press(Key::B);
        assert!(desk.texts().is_empty(), "{:?}", desk.texts());
        desk.press(wake);
        assert_eq!(desk.texts(), before, "{wake:?}");
    }
}

#[test]
fn a_blank_screen_is_black_in_every_theme() {
    let mut desk = Desk::new();
    desk.press(Key::B);
    for theme in Theme::ALL {
        desk.state_mut().view.theme = theme;
        desk.run();
        let window = desk.ctx.content_rect();
        let shapes = &desk.output().shapes;
        let mut fills = shapes.iter().filter_map(|clipped| match &clipped.shape {
            Shape::Rect(shape) if shape.rect.contains_rect(window) => Some(shape.fill),
            _ => None,
        });
        assert_eq!(fills.next_back(), Some(Color32::BLACK), "{theme:?}");
    }
}

#[test]
fn dragging_the_timeline_moves_the_playhead() {
    let mut desk = Desk::new();
    let ruler = desk.get_by_role_and_label(Role::Slider, "Step of the trace").rect();
    desk.click_at(ruler.left_center(), 1);
    assert_eq!(desk.step_number(), 0);
    desk.drag([ruler.left_center(), ruler.right_center()], Default::default());
    assert_eq!(desk.step_number(), desk.plane().trace.events.len());
}

#[test]
fn every_press_counts_when_a_frame_brings_several() {
    let mut desk = Desk::new();
    for _ in 0..3 {
        desk.key_press(Key::ArrowRight);
    }
    desk.run();
    assert_eq!(desk.step_number(), 3);
}
