//! What is pointed at in one view is lit in the others.

use crate::desk::Desk;
use eframe::egui::{Key, Rect, accesskit::Role};
use egui_kittest::kittest::Queryable;
use octoscope::view::Preset;
use octoscope_core::event::Event;
use octoscope_core::tree::NodeId;

/// The window at the end of the first scene, with the panels of a preset.
fn desk(preset: Preset) -> Desk {
    let mut desk = Desk::of(egui_kittest::Harness::builder(), [1280.0, 800.0]);
    desk.open("scene:quadtree-82");
    desk.state_mut().view.preset = preset;
    let first = desk.plane().trace.next_leaf(0);
    let length = desk.plane().trace.events.len();
    desk.state_mut().view.playback.go_to(first, length);
    desk.run();
    desk
}

fn lit(desk: &Desk) -> Option<NodeId> {
    desk.state().view.hover.lit(&desk.plane().tree)
}

fn first_leaf(desk: &Desk) -> NodeId {
    desk.plane().trace.leaves().next().unwrap().0
}

fn rail(desk: &Desk) -> Rect {
    let is_rail = |text: &str| text.starts_with("t-rail:");
    let name = desk.texts().into_iter().find(|text| is_rail(text)).unwrap();
    desk.get_by_role_and_label(Role::Slider, &name).rect()
}

#[test]
fn pointing_at_an_event_on_the_timeline_lights_its_node() {
    let mut desk = desk(Preset::Rail);
    let events = &desk.plane().trace.events;
    let index = events.iter().position(|event| matches!(event, Event::Leaf { .. })).unwrap();
    let share = (index + 1) as f32 / events.len() as f32;
    let ruler = desk.get_by_role_and_label(Role::Slider, "Step of the trace").rect();
    let track = ruler.shrink2(eframe::egui::vec2(8.0, 4.0));
    let place = eframe::egui::pos2(track.left() + share * track.width(), track.center().y);
    desk.point_at(place);
    assert_eq!(lit(&desk), Some(first_leaf(&desk)));
}

#[test]
fn pointing_at_the_rail_lights_the_leaf_at_that_parameter() {
    let mut desk = desk(Preset::Rail);
    let rail = rail(&desk);
    // From the left to the right of the rail the ray comes through leaves.
    let mut nodes = Vec::new();
    for share in 1..16 {
        desk.point_at(rail.lerp_inside(eframe::egui::vec2(share as f32 / 16.0, 0.3)));
        nodes.extend(lit(&desk));
    }
    nodes.dedup();
    let leaves: Vec<NodeId> = desk.plane().trace.leaves().map(|(leaf, _)| leaf).collect();
    let first = leaves.iter().position(|leaf| nodes.first() == Some(leaf)).unwrap();
    assert_eq!(leaves[first..first + nodes.len()], nodes);
}

#[test]
fn pointing_at_a_variable_lights_the_node_that_it_is() {
    let mut desk = desk(Preset::Debug);
    let leaf = first_leaf(&desk);
    // It is not broken after its comma.
    let codes = desk.plane().tree.code(leaf).map(|code| code.to_string()).join(",\u{a0}");
    let value = desk.get_by_label(&format!("({codes})")).rect();
    desk.point_at(value.center());
    assert_eq!(lit(&desk), Some(leaf));
    // And nothing any more once the pointer is elsewhere.
    desk.point_at(eframe::egui::pos2(4.0, 4.0));
    assert_eq!(lit(&desk), None);
}

#[test]
fn the_window_that_opens_beneath_the_pointer_shows_no_hint() {
    let mut desk = Desk::new();
    desk.press(Key::End);
    let place = desk.place([0.756, 0.4]);
    desk.hover_at(place);
    desk.run();
    let hint = "Click: the neighbour beyond";
    assert!(!desk.says(hint) && lit(&desk).is_none());
    desk.point_at(place);
    assert!(desk.says(hint) && lit(&desk).is_some());
}
