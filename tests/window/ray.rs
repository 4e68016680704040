//! The ray, moved by mouse and numbers.

use crate::desk::Desk;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use octoscope::document::AnyDocument;
use octoscope_core::gallery::{Degenerate, snap};
use octoscope_core::geometry::{Aabb, Ray};
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::text::Language;
use octoscope_core::tree::NodeId;
use octoscope_figure::{Camera, Page, far_end};

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
fn dragging_the_head_of_the_arrow_turns_the_ray() {
    for length in [1e-9, 0.05, 1.0] {
        let mut desk = Desk::new();
        set_direction(&mut desk, [length, 0.62 * length]);
        let ray = desk.plane().scenario.ray;
        let head = desk.place(far_end(&desk.plane().tree, &ray));
        let to = head + vec2(-30.0, 90.0);
        desk.drag([head, to], Modifiers::NONE);
        let turned = desk.plane().scenario.ray;
        assert_eq!(turned.origin(), ray.origin());
        let [before, after] = [ray, turned].map(|ray| ray.direction()[0].hypot(ray.direction()[1]));
        assert!((after / before - 1.0).abs() < 0.02, "{before} {after}");
        // It goes where the head was dropped.
        let [from, on] = [0.0, 0.9 / after].map(|t| desk.place(turned.at(t)));
        let (way, wanted) = ((on - from).normalized(), (to - from).normalized());
        assert!(way.dot(wanted) > 0.999, "{way} {wanted}");
        assert!(way.dot((head - from).normalized()) < 0.999, "{length} turns nothing");
    }
}

#[test]
fn the_head_is_grabbed_where_it_is_drawn_though_the_ray_leads_off_the_page() {
    let mut desk = Desk::new();
    let near = Aabb { min: [-0.2, 0.0], max: [0.3, 0.5] };
    let page = Page { width: 600.0, height: 500.0 };
    desk.state_mut().view.plane_camera = Some(Camera::framing(&near, page));
    desk.run();
    let ray = desk.plane().scenario.ray;
    let head = desk.head_of_ray();
    let end = desk.place(far_end(&desk.plane().tree, &ray));
    assert!(head.distance(end) > 100.0, "the end of the ray is off the page: {end} {head}");
    desk.drag([head, head + vec2(-20.0, 60.0)], Modifiers::NONE);
    let turned = desk.plane().scenario.ray;
    assert_eq!(turned.origin(), ray.origin());
    let [before, after] = [ray, turned].map(|ray| ray.direction()[0].hypot(ray.direction()[1]));
    assert!((after / before - 1.0).abs() < 1e-3, "{before} {after}");
    assert_ne!(turned.direction(), ray.direction());
}

#[test]
fn the_ray_keeps_its_length_however_long_it_is_turned() {
    // What is beside the picture has no part in it.
    let mut desk = Desk::of(Harness::builder(), [640.0, 480.0]);
    desk.state_mut().view.formulas = false;
    desk.press(Key::Num6);
    let ray = desk.plane().scenario.ray;
    let head = desk.head_of_ray();
    let path = (0..=300).map(|n| {
        let turn = f64::from(n) * 0.2;
        head + vec2((-0.2 * turn) as f32, (3.0 * turn.sin() + turn) as f32)
    });
    desk.drag_along(&path.collect::<Vec<_>>(), Modifiers::NONE);
    let turned = desk.plane().scenario.ray;
    assert_eq!(turned.origin(), ray.origin());
    assert_ne!(turned.direction(), ray.direction());
    let [before, after] = [ray, turned].map(|ray| ray.direction()[0].hypot(ray.direction()[1]));
    assert!((after / before - 1.0).abs() < 1e-3, "{before} {after}");
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
fn a_key_says_why_it_does_nothing() {
    let mut desk = Desk::new();
    desk.press(Key::Num7);
    desk.click(Role::Button, "Point");
    for key in [Key::G, Key::R, Key::N] {
        desk.press(key);
        assert!(desk.says("This query has no ray"), "{key:?}: {:?}", desk.texts());
        desk.press(Key::Escape);
        assert!(!desk.says("This query has no ray"));
    }
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

/// Sets the direction of the ray, as its fields do.
fn set_direction(desk: &mut Desk, direction: [f64; 2]) {
    let AnyDocument::Plane(document) = desk.state_mut().document_mut() else { panic!() };
    let origin = document.scenario.ray.origin();
    document.scenario.ray = Ray::new(origin, direction).unwrap();
    desk.run();
}

#[test]
fn origin_tip_and_shaft_are_grabbed_however_short_or_long_the_direction_is() {
    for length in [1e-9, 0.01, 0.05, 40.0, 1e200] {
        let check = |grab: fn(&Desk) -> Pos2| -> [Ray<2>; 2] {
            let mut desk = Desk::new();
            set_direction(&mut desk, [length, 0.62 * length]);
            let before = desk.plane().scenario.ray;
            let from = grab(&desk);
            desk.drag([from, from + vec2(9.0, -70.0)], Modifiers::NONE);
            [before, desk.plane().scenario.ray]
        };
        let [before, after] = check(|desk| desk.place(desk.plane().scenario.ray.origin()));
        assert_ne!(after.origin(), before.origin(), "the origin, {length}");

        let [before, after] = check(Desk::tip_handle);
        assert_eq!(after.origin(), before.origin(), "the tip, {length}");
        let slope = |ray: Ray<2>| ray.direction()[1] / ray.direction()[0];
        assert!((slope(after) - slope(before)).abs() > 0.05, "the tip, {length}");

        let [before, after] = check(|desk| desk.place([0.4, 0.13 + 0.56 * 0.62]));
        assert_eq!(after.direction(), before.direction(), "the shaft, {length}");
        assert_ne!(after.origin(), before.origin(), "the shaft, {length}");
    }
}

#[test]
fn the_tip_follows_the_pointer_from_wherever_its_handle_was() {
    for length in [1e-9, 40.0] {
        let mut desk = Desk::new();
        set_direction(&mut desk, [length, 0.62 * length]);
        let (from, to) = (desk.tip_handle(), desk.place([0.5, 0.75]));
        desk.drag([from, to], Modifiers::NONE);
        let tip = desk.place(desk.plane().scenario.ray.at(1.0));
        assert!(tip.distance(to) < 1.5, "{tip:?} {to:?}");
    }
}

#[test]
fn one_key_shows_every_degenerate_ray_with_what_is_to_be_watched() {
    let mut desk = Desk::new();
    let tree = desk.plane().tree.clone();
    let in_the_plane = Degenerate::ALL.into_iter().filter(|ray| ray.exists_in(&tree));
    for kind in in_the_plane.chain([Degenerate::ALL[0]]) {
        desk.press(Key::G);
        assert_eq!(Some(desk.plane().scenario.ray), kind.ray(&desk.plane().tree), "{kind:?}");
        assert!(desk.says(&kind.watch(Language::English)), "{kind:?}");
    }
}

#[test]
fn a_degenerate_ray_is_chosen_from_the_gallery_and_undone() {
    let mut desk = Desk::new();
    let before = desk.plane().scenario.ray;
    // The menu; the query has a button of this name as well.
    let menu = desk.get_all_by_role_and_label(Role::Button, "Ray").next();
    menu.expect("the menu bar comes first").click();
    desk.run();
    desk.click(Role::Button, "Gallery of degenerate rays");
    desk.click(Role::Button, &Degenerate::Centre.name(Language::English));
    assert_eq!(Some(desk.plane().scenario.ray), Degenerate::Centre.ray(&desk.plane().tree));
    assert!(desk.says(&Degenerate::Centre.watch(Language::English)));
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(desk.plane().scenario.ray, before);
}

#[test]
fn one_key_makes_the_ray_degenerate_in_the_nearest_way() {
    let mut desk = Desk::new();
    let (tree, ray) = (desk.plane().tree.clone(), desk.plane().scenario.ray);
    let nearest = snap(&tree, &ray).unwrap();
    desk.press(Key::N);
    assert_eq!(desk.plane().scenario.ray, nearest.ray);
    assert!(desk.says(&nearest.snap.told(Language::English)));
}

#[test]
fn steps_that_doubles_would_make_otherwise_are_known_to_the_window() {
    let mut desk = Desk::new();
    let ray = Degenerate::Thirds.ray(&desk.plane().tree).unwrap();
    assert!(desk.plane().rounded.is_empty());
    let AnyDocument::Plane(document) = desk.state_mut().document_mut() else { panic!() };
    document.scenario.ray = ray;
    let Query::Ray { arithmetic, .. } = &mut document.scenario.query else { panic!() };
    *arithmetic = Arithmetic::Exact;
    desk.run();
    let Some(&step) = desk.plane().rounded.first() else { panic!("doubles err on thirds") };
    desk.press(Key::Home);
    for _ in 0..step {
        desk.tap(Key::ArrowRight);
    }
    assert!(desk.sentence().contains("Doubles would err here"));
}
