//! The camera, by keyboard.

use crate::desk::{Desk, sample};
use eframe::egui::{Key, Modifiers, vec2};
use octoscope::files::{Chosen, Purpose};
use octoscope_figure::{Camera, Lens, Page};

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
fn a_picture_stays_where_it_is_when_the_ray_is_dropped() {
    let mut desk = Desk::new();
    let corner = desk.place([1.0, 1.0]);
    let origin = desk.place(desk.plane().scenario.ray.origin());
    desk.drag([origin, origin + vec2(60.0, -150.0)], Modifiers::NONE);
    assert_eq!(desk.place([1.0, 1.0]), corner);
    let ray = desk.plane().scenario.ray;
    let dropped = desk.place(ray.origin());
    desk.drag([dropped, dropped + vec2(0.0, 40.0)], Modifiers::NONE);
    assert_ne!(desk.plane().scenario.ray, ray, "the handle is where it was dropped");
}

#[test]
fn a_turned_octree_keeps_its_side_and_is_fitted_into_every_room() {
    let mut desk = Desk::with_file(sample("knot.octo"));
    let rect = desk.state().view.space.unwrap();
    let from = rect.right_bottom() - vec2(30.0, 60.0);
    desk.drag([from, from - vec2(90.0, 30.0)], Modifiers::NONE);
    let turned = desk.state().view.camera::<3>().unwrap();
    desk.press(Key::Num6);
    let elsewhere = desk.state().view.camera::<3>().unwrap();
    assert_eq!((elsewhere.yaw, elsewhere.pitch), (turned.yaw, turned.pitch));
    let room = desk.state().view.space.unwrap();
    let page = Page { width: f64::from(room.width()), height: f64::from(room.height()) };
    let mut fitted = elsewhere;
    desk.space().frame(&mut fitted, page);
    assert_eq!(elsewhere, fitted);

    // What was zoomed on purpose stays as it is, until all is asked for.
    let zoomed = Camera { height: 0.5 * elsewhere.height, ..elsewhere };
    let view = &mut desk.state_mut().view;
    view.set_camera(zoomed);
    view.fitted = false;
    desk.press(Key::Num2);
    assert_eq!(desk.state().view.camera::<3>(), Some(zoomed));
    desk.press(Key::F);
    let all = desk.state().view.camera::<3>().unwrap();
    assert_eq!((all.yaw, all.pitch), (turned.yaw, turned.pitch));
    assert_ne!(all.height, zoomed.height);
}

#[test]
fn a_saved_scenario_is_seen_from_where_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("turned.octo");
    let mut desk = Desk::with_file(sample("knot.octo"));
    let rect = desk.state().view.space.unwrap();
    let from = rect.right_bottom() - vec2(30.0, 60.0);
    desk.drag([from, from - vec2(90.0, 30.0)], Modifiers::NONE);
    desk.press(Key::O);
    let turned = desk.state().view.camera::<3>().unwrap();
    let zoomed = Camera { height: 0.5 * turned.height, ..turned };
    desk.state_mut().view.set_camera(zoomed);
    desk.state_mut().view.fitted = false;
    let context = desk.ctx.clone();
    desk.state_mut().take_chosen(&context, Chosen::Path(Purpose::Save, path.clone()));
    desk.state_mut().finish_work();

    let again = Desk::with_file(&path);
    let seen = again.state().view.camera::<3>().unwrap();
    assert_eq!(seen.lens, Lens::Orthographic);
    let is_near = |a: f64, b: f64| (a - b).abs() < 2e-3;
    assert!(is_near(seen.pitch, zoomed.pitch), "{seen:?}");
    assert!(is_near(seen.yaw.sin(), zoomed.yaw.sin()) && is_near(seen.yaw.cos(), zoomed.yaw.cos()));
    assert!(is_near(seen.height / zoomed.height, 1.0), "{seen:?} {zoomed:?}");
    for e in 0..3 {
        let off = (seen.target[e] - zoomed.target[e]) / zoomed.height;
        assert!(is_near(off, 0.0), "{seen:?} {zoomed:?}");
    }
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
