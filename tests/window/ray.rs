//! The ray, moved by mouse and numbers.

use crate::desk::Desk;
use eframe::egui::{Key, Modifiers, vec2};
use octoscope_core::tree::NodeId;

fn leaves(desk: &Desk) -> Vec<NodeId> {
    desk.plane().trace.leaves().map(|(leaf, _)| leaf).collect()
}

#[test]
fn dragging_the_tip_turns_the_ray_and_traces_anew() {
    let mut desk = Desk::new();
    let (ray, before) = (desk.plane().scenario.ray, leaves(&desk));
    let tip = desk.place(ray.at(1.0));
    desk.drag([tip, tip + vec2(-120.0, -40.0)], Modifiers::NONE);
    let turned = desk.plane().scenario.ray;
    assert_eq!(turned.origin(), ray.origin());
    assert_ne!(turned.direction(), ray.direction());
    assert_ne!(leaves(&desk), before);
}

#[test]
fn dragging_the_origin_keeps_the_tip() {
    let mut desk = Desk::new();
    let ray = desk.plane().scenario.ray;
    let origin = desk.place(ray.origin());
    desk.drag([origin, origin + vec2(10.0, -80.0)], Modifiers::NONE);
    let moved = desk.plane().scenario.ray;
    assert_ne!(moved.origin(), ray.origin());
    for axis in 0..2 {
        assert!((moved.at(1.0)[axis] - ray.at(1.0)[axis]).abs() < 1e-2);
    }
}

#[test]
fn dragging_the_shaft_keeps_the_direction_to_the_last_bit() {
    let mut desk = Desk::new();
    let ray = desk.plane().scenario.ray;
    let middle = desk.place(ray.at(0.5));
    desk.drag([middle, middle + vec2(0.0, -60.0)], Modifiers::NONE);
    let moved = desk.plane().scenario.ray;
    assert_ne!(moved.origin(), ray.origin());
    assert_eq!(moved.direction().map(f64::to_bits), ray.direction().map(f64::to_bits));
}

#[test]
fn a_drag_is_undone_and_redone_as_a_whole() {
    let mut desk = Desk::new();
    let (ray, before) = (desk.plane().scenario.ray, leaves(&desk));
    let tip = desk.place(ray.at(1.0));
    desk.drag([tip, tip + vec2(-120.0, -40.0)], Modifiers::NONE);
    let (turned, after) = (desk.plane().scenario.ray, leaves(&desk));
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!((desk.plane().scenario.ray, leaves(&desk)), (ray, before));
    desk.press_with(Modifiers::COMMAND, Key::Y);
    assert_eq!((desk.plane().scenario.ray, leaves(&desk)), (turned, after));
}

#[test]
fn a_direction_of_zero_is_refused_and_the_last_one_stays() {
    let mut desk = Desk::new();
    desk.type_into("direction x", "0");
    let upwards = desk.plane().scenario.ray;
    assert_eq!(upwards.direction()[0], 0.0);
    desk.type_into("direction y", "0");
    assert_eq!(desk.plane().scenario.ray, upwards);
    assert!(desk.says("A ray needs a direction other than zero"), "{:?}", desk.texts());
}

#[test]
fn numbers_are_typed_as_decimals_fractions_and_hexadecimal_floats() {
    let mut desk = Desk::new();
    for (text, value) in [("0.25", 0.25), ("3/8", 0.375), ("0x1.8p-1", 0.75)] {
        desk.type_into("origin y", text);
        assert_eq!(desk.plane().scenario.ray.origin()[1], value, "{text}");
    }
    desk.type_into("origin y", "nonsense");
    assert_eq!(desk.plane().scenario.ray.origin()[1], 0.75);
}

#[test]
fn the_ray_is_turned_round_by_a_key() {
    let mut desk = Desk::new();
    let ray = desk.plane().scenario.ray;
    desk.press(Key::R);
    assert_eq!(desk.plane().scenario.ray.origin(), ray.at(1.0));
    assert_eq!(desk.plane().scenario.ray.direction(), ray.direction().map(|d| -d));
}

#[test]
fn undo_and_redo_bring_the_playhead_along() {
    let mut desk = Desk::new();
    desk.press(Key::Home);
    (0..7).for_each(|_| desk.press(Key::ArrowRight));
    let tip = desk.place(desk.plane().scenario.ray.at(1.0));
    desk.drag([tip, tip + vec2(-120.0, -40.0)], Modifiers::NONE);
    assert_eq!(desk.step_number(), 7, "the playhead stays while the ray turns");
    (0..4).for_each(|_| desk.press(Key::ArrowRight));
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(desk.step_number(), 7);
    desk.press(Key::ArrowLeft);
    desk.press_with(Modifiers::COMMAND, Key::Y);
    assert_eq!(desk.step_number(), 11);
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(desk.step_number(), 6, "where it was left");
}
