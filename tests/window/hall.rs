//! What a lecture has beside the window.

use crate::desk::Desk;
use eframe::egui::epaint::{ClippedShape, Shape};
use eframe::egui::{Key, Modifiers, accesskit::Role, pos2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, Node};
use octoscope::theme;
use octoscope::view::Preset;

#[test]
fn the_notes_tell_this_step_and_the_next() {
    let mut desk = Desk::new();
    desk.press(Key::ArrowRight);
    let first = desk.sentence();
    desk.press(Key::ArrowRight);
    let second = desk.sentence();
    desk.tap(Key::ArrowLeft);
    assert!(!desk.texts().contains(&second));
    desk.tap(Key::P);
    desk.run_steps(3);
    assert!(desk.texts().iter().filter(|text| **text == first).count() >= 2);
    assert!(desk.texts().contains(&second));
    desk.tap(Key::P);
    desk.run_steps(3);
    assert!(!desk.texts().contains(&second));
}

#[test]
fn the_notes_tell_that_the_window_is_blank() {
    let mut desk = Desk::new();
    desk.tap(Key::P);
    desk.run_steps(3);
    assert!(!desk.says("The window is blank"));
    desk.tap(Key::B);
    desk.run_steps(3);
    assert!(desk.says("The window is blank"), "{:?}", desk.texts());
}

#[test]
fn the_spotlight_dims_no_dialog() {
    let mut desk = Desk::new();
    let view = &desk.state().view;
    let shade = theme::look(view.language, view.theme).palette.shade;
    let is_dimmed = |desk: &Desk| {
        desk.output().shapes.iter().any(|ClippedShape { shape, .. }| match shape {
            Shape::Mesh(mesh) => mesh.vertices.iter().all(|vertex| vertex.color == shade),
            _ => false,
        })
    };
    desk.point_at(pos2(640.0, 300.0));
    assert!(!is_dimmed(&desk));
    desk.press(Key::S);
    assert!(is_dimmed(&desk));
    desk.press_with(Modifiers::COMMAND, Key::K);
    assert!(!is_dimmed(&desk));
    desk.press(Key::Escape);
    assert!(is_dimmed(&desk));
}

#[test]
fn the_spotlight_covers_nothing_with_what_is_said_of_a_cell() {
    let mut desk = Desk::new();
    desk.point_at(desk.place([0.756, 0.4]));
    let n_said = desk.texts().len();
    desk.press(Key::S);
    assert!(desk.texts().len() < n_said, "{:?}", desk.texts());
}

#[test]
fn no_hint_of_the_timeline_covers_the_sentence() {
    for (preset, size) in [(Preset::Rail, [1280.0, 800.0]), (Preset::Lecture, [1024.0, 768.0])] {
        let mut desk = Desk::of(Harness::builder(), size);
        desk.state_mut().view.preset = preset;
        desk.run();
        let sentence = {
            let nodes = desk.nodes();
            let is_it = |node: &&Node<'_>| node.accesskit_node().author_id() == Some("sentence");
            nodes.iter().find(is_it).unwrap().rect()
        };
        let ruler = desk.get_by_role_and_label(Role::Slider, "Step of the trace").rect();
        let forward = desk.get_by_role_and_label(Role::Button, "Step forward").rect();
        for (place, said) in [(ruler, "A tick for every step"), (forward, "Step forward (")] {
            desk.point_at(place.center());
            for _ in 0..60 {
                desk.step();
            }
            let hint = desk.get_by_label_contains(said).rect();
            assert!(hint.bottom() <= sentence.top(), "{preset:?} {said}: {hint} {sentence}");
        }
    }
}
