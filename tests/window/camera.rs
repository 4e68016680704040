//! The camera, by keyboard.

use crate::desk::{Desk, sample};
use eframe::egui::Key;
use octoscope_figure::Lens;

#[test]
fn octrees_are_seen_from_named_sides() {
    let mut desk = Desk::with_file(sample("knot.octo"));
    for (key, back) in
        [(Key::X, [1.0, 0.0, 0.0]), (Key::Y, [0.0, -1.0, 0.0]), (Key::Z, [0.0, 0.0, 1.0])]
    {
        desk.press(key);
        let [_, _, towards_eye] = desk.state().view.camera::<3>().unwrap().basis();
        let is_near = (0..3).all(|e| (towards_eye[e] - back[e]).abs() < 1e-12);
        assert!(is_near, "{key:?} {towards_eye:?}");
    }
    desk.press(Key::O);
    assert_eq!(desk.state().view.camera::<3>().unwrap().lens, Lens::Orthographic);
}

#[test]
fn the_camera_follows_the_current_node_until_told_otherwise() {
    let mut desk = Desk::with_file(sample("knot.octo"));
    desk.press(Key::Home);
    desk.press(Key::V);
    let centre = |desk: &Desk| {
        let document = desk.space();
        let moment = document.moment(desk.step_number());
        document.tree.node_box(moment.current.unwrap()).centre()
    };
    for _ in 0..3 {
        desk.press(Key::ArrowDown);
        assert_eq!(desk.state().view.camera::<3>().unwrap().target, centre(&desk));
    }
    desk.press(Key::V);
    let before = desk.state().view.camera::<3>();
    desk.press(Key::ArrowDown);
    assert_eq!(desk.state().view.camera::<3>(), before);
}

#[test]
fn named_sides_mean_nothing_in_the_plane() {
    let mut desk = Desk::new();
    let before = desk.state().view.camera::<2>();
    desk.press(Key::Z);
    desk.press(Key::O);
    assert_eq!(desk.state().view.camera::<2>(), before);
    desk.press(Key::ArrowRight);
    desk.press(Key::ArrowRight);
    desk.press(Key::C);
    let moment = desk.plane().moment(desk.step_number());
    let node = desk.plane().tree.node_box(moment.current.unwrap());
    assert_eq!(desk.state().view.camera::<2>().unwrap().target, node.centre());
}
