//! Questions that are asked by the mouse in the picture.

use crate::desk::Desk;
use eframe::egui::{CursorIcon, Key, Modifiers, accesskit::Role, vec2};
use egui_kittest::kittest::Queryable;
use octoscope::document::AnyDocument;
use octoscope::widgets::PageInWindow;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::scenario::built_in;
use octoscope_core::traverse::Algorithm;
use octoscope_core::tree::Node;
use octoscope_figure::Page;

/// A leaf whose sides are far enough apart to be told apart by the mouse, away
/// from the ray.
fn large_leaf(desk: &Desk) -> Node {
    let tree = &desk.plane().tree;
    let upper_left = |leaf: &Node| {
        let middle = tree.node_box(leaf.id).centre();
        middle[0] < 0.5 && middle[1] > 0.7
    };
    tree.leaves().filter(upper_left).max_by_key(|leaf| tree.level(leaf.id)).unwrap()
}

#[test]
fn a_double_click_locates_the_point() {
    let mut desk = Desk::new();
    let leaf = large_leaf(&desk);
    let bounds = desk.plane().tree.node_box(leaf.id);
    let point = [0, 1].map(|e| 0.4 * bounds.min[e] + 0.6 * bounds.max[e]);
    desk.click_at(desk.place(point), 2);
    let Query::Point { at, .. } = desk.plane().scenario.query else { panic!("no point query") };
    assert!(bounds.owns(at), "{at:?} in {bounds:?}");
    desk.press(Key::End);
    assert_eq!(desk.plane().moment(desk.step_number()).current, Some(leaf.id));
}

#[test]
fn the_point_is_dragged_and_undone_as_a_whole() {
    let mut desk = Desk::new();
    desk.click(Role::Button, "Point");
    let asked = |desk: &Desk| match desk.plane().scenario.query {
        Query::Point { at, .. } => at,
        other => panic!("{other:?}"),
    };
    let (before, to) = (asked(&desk), [0.21, 0.87]);
    let from = desk.place(before);
    desk.point_at(from);
    assert_eq!(desk.output().platform_output.cursor_icon, CursorIcon::Grab);
    let corner = desk.place([1.0, 1.0]);
    desk.drag([from, desk.place(to)], Modifiers::NONE);
    let moved = asked(&desk);
    assert!((0..2).all(|e| (moved[e] - to[e]).abs() < 4e-3), "{moved:?}");
    assert_eq!(desk.place([1.0, 1.0]), corner, "the picture stays where it is");
    desk.press(Key::End);
    let found = desk.plane().moment(desk.step_number()).current.unwrap();
    assert!(desk.plane().tree.node_box(found).owns(moved));
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(asked(&desk), before);
    // A press beside it does not take it along.
    let beside = from + vec2(40.0, 0.0);
    desk.drag([beside, beside + vec2(30.0, 30.0)], Modifiers::NONE);
    assert_eq!(asked(&desk), before);
}

#[test]
fn every_corner_of_the_region_is_dragged_also_past_the_opposite_one() {
    let asked = |desk: &Desk| match desk.plane().scenario.query {
        Query::Region { min, max, .. } => [min, max],
        other => panic!("{other:?}"),
    };
    let mut desk = Desk::new();
    desk.click(Role::Button, "Region");
    let before = asked(&desk);
    for [x, y] in [[0, 0], [0, 1], [1, 0], [1, 1]] {
        let (held, opposite) = ([before[x][0], before[y][1]], [before[1 - x][0], before[1 - y][1]]);
        for to in [[0.05, 0.92], [0.9, 0.9], [0.7, 0.03], [1.2, -0.3]] {
            desk.drag([desk.place(held), desk.place(to)], Modifiers::NONE);
            let [min, max] = asked(&desk);
            for e in 0..2 {
                let ends = [opposite[e], to[e].clamp(0.0, 1.0)];
                let [least, most] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
                assert!((min[e] - least).abs() < 2e-2 && (max[e] - most).abs() < 2e-2, "{min:?}");
                assert!([min[e], max[e]].contains(&opposite[e]), "the other corner stays");
            }
            desk.press_with(Modifiers::COMMAND, Key::Z);
            assert_eq!(asked(&desk), before, "one drag is one step");
        }
    }
}

#[test]
fn in_space_points_and_corners_are_dragged_across_the_line_of_sight() {
    let mut desk = Desk::new();
    desk.open_scenario(&built_in("points-3d").unwrap());
    for button in ["Point", "Region"] {
        desk.click(Role::Button, button);
        let rect = desk.state().view.space.unwrap();
        let page = Page { width: f64::from(rect.width()), height: f64::from(rect.height()) };
        let view = PageInWindow { page, corner: rect.min, scale: 1.0 };
        let camera = desk.state().view.camera::<3>().unwrap_or_else(|| desk.space().framed(page));
        let held = |desk: &Desk| match desk.space().scenario.query {
            Query::Point { at, .. } => at,
            Query::Region { max, .. } => max,
            other => panic!("{other:?}"),
        };
        let before = held(&desk);
        let from = view.place(&camera, before).unwrap();
        let to = from + vec2(24.0, -18.0);
        desk.drag([from, to], Modifiers::NONE);
        let after = held(&desk);
        let place = view.place(&camera, after).unwrap();
        assert!(place.distance(to) < 2.0, "{button}: {place} {to}");
        assert_eq!(desk.state().view.camera::<3>(), Some(camera), "{button}");
        let [right, up, towards] = camera.basis();
        let along = |way: [f64; 3]| (0..3).map(|e| way[e] * (after[e] - before[e])).sum::<f64>();
        assert!(along(right) > 0.01 && along(up) > 0.01, "{before:?} {after:?}");
        assert!(along(towards).abs() < 0.02, "{before:?} {after:?}");
        desk.press_with(Modifiers::COMMAND, Key::Z);
        assert_eq!(held(&desk), before);
    }
}

#[test]
fn a_drag_with_shift_locates_the_region() {
    let mut desk = Desk::new();
    let corners = [[0.3, 0.8], [0.45, 0.6]];
    desk.drag(corners.map(|corner| desk.place(corner)), Modifiers::SHIFT);
    let Query::Region { min, max, .. } = desk.plane().scenario.query else { panic!("no region") };
    for (was, wanted) in [(min, [0.3, 0.6]), (max, [0.45, 0.8])] {
        for axis in 0..2 {
            assert!((was[axis] - wanted[axis]).abs() < 4e-3, "{was:?} {wanted:?}");
        }
    }
    desk.press(Key::End);
    let moment = desk.plane().moment(desk.step_number());
    let bounds = desk.plane().tree.node_box(moment.current.unwrap());
    assert!((0..2).all(|e| bounds.min[e] <= min[e] && max[e] < bounds.max[e]), "{bounds:?}");
}

#[test]
fn a_click_on_a_side_asks_for_the_neighbour() {
    let mut desk = Desk::new();
    let leaf = large_leaf(&desk);
    let bounds = desk.plane().tree.node_box(leaf.id);
    let middle = bounds.centre();
    let unit = bounds.size()[0] / f64::from(desk.place(bounds.max).x - desk.place(bounds.min).x);
    let inside = 3.0 * unit;
    for (axis, sign, side) in [
        (0, 1, [bounds.max[0] - inside, middle[1]]),
        (0, -1, [bounds.min[0] + inside, middle[1]]),
        (1, 1, [middle[0], bounds.max[1] - inside]),
        (1, -1, [middle[0], bounds.min[1] + inside]),
    ] {
        desk.click_at(desk.place(side), 1);
        let Query::Neighbour { level, code, direction, .. } = desk.plane().scenario.query else {
            panic!("no neighbour query")
        };
        let tree = &desk.plane().tree;
        assert_eq!((level, code), (tree.level(leaf.id), tree.code(leaf.id)));
        let mut expected = [0; 2];
        expected[axis] = sign;
        assert_eq!(direction.components(), expected);
        // Two clicks that follow at once are a double click.
        desk.run_steps(40);
    }
}

#[test]
fn the_kind_of_query_is_chosen_by_a_button_and_undone() {
    let mut desk = Desk::new();
    let before = desk.plane().scenario.query;
    desk.click(Role::Button, "Region");
    assert!(matches!(desk.plane().scenario.query, Query::Region { .. }));
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(desk.plane().scenario.query, before);
}

/// A point of a leaf, three points of the window inside its right side.
fn inside_the_right_side(desk: &Desk, leaf: Node) -> [f64; 2] {
    let bounds = desk.plane().tree.node_box(leaf.id);
    let unit = bounds.size()[0] / f64::from(desk.place(bounds.max).x - desk.place(bounds.min).x);
    [bounds.max[0] - 3.0 * unit, bounds.centre()[1]]
}

#[test]
fn pointing_at_a_cell_tells_its_level_and_codes_and_what_a_click_does() {
    let mut desk = Desk::new();
    let leaf = large_leaf(&desk);
    let (tree, hint) = (desk.plane().tree.clone(), "Click: the neighbour beyond");
    let [x, y] = tree.code(leaf.id);
    let note = format!("level {}, codes {x}, {y}", tree.level(leaf.id));
    desk.point_at(desk.place(tree.node_box(leaf.id).centre()));
    assert!(desk.says(&note), "{note} in {:?}", desk.texts());
    assert!(!desk.says(hint), "a click in the middle does nothing");

    desk.point_at(desk.place(inside_the_right_side(&desk, leaf)));
    assert!(desk.says(&note) && desk.says(hint), "{:?}", desk.texts());

    desk.point_at(desk.place(desk.plane().scenario.ray.at(0.5)));
    assert!(!desk.says(hint), "the ray is in the way");
    desk.remove_cursor();
    desk.run();
    assert!(!desk.says(&note));
}

#[test]
fn escape_goes_back_to_the_ray_and_to_the_place_in_its_trace() {
    let mut desk = Desk::new();
    let before = desk.plane().scenario.query;
    desk.press(Key::Home);
    (0..5).for_each(|_| desk.press(Key::ArrowRight));
    let leaf = large_leaf(&desk);
    desk.click_at(desk.place(inside_the_right_side(&desk, leaf)), 1);
    assert!(matches!(desk.plane().scenario.query, Query::Neighbour { .. }));
    desk.run_steps(40);
    desk.click(Role::Button, "Point");
    assert!(matches!(desk.plane().scenario.query, Query::Point { .. }));

    desk.press(Key::F1);
    desk.press(Key::Escape);
    assert_eq!(desk.state().view.dialog, None);
    let still = desk.plane().scenario.query;
    assert!(matches!(still, Query::Point { .. }), "Escape closed the keys alone");

    desk.press(Key::Escape);
    assert_eq!((desk.plane().scenario.query, desk.step_number()), (before, 5));
    desk.press(Key::Escape);
    assert_eq!(desk.plane().scenario.query, before);
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(desk.plane().scenario.query, still);
}

#[test]
fn a_ray_that_is_not_shown_is_not_changed() {
    let mut desk = Desk::new();
    let ray = desk.plane().scenario.ray;
    desk.click(Role::Button, "Point");
    for key in [Key::R, Key::N, Key::G] {
        desk.press(key);
        assert_eq!(desk.plane().scenario.ray, ray, "{key:?}");
    }
}

#[test]
fn the_button_of_the_ray_goes_back_to_it_as_its_key_does() {
    let mut desk = Desk::new();
    let AnyDocument::Plane(document) = desk.state_mut().document_mut() else { panic!() };
    let Query::Ray { algorithm, arithmetic, .. } = &mut document.scenario.query else { panic!() };
    (*algorithm, *arithmetic) = (Algorithm::Codes, Arithmetic::Exact);
    let asked = document.scenario.query;
    desk.run();
    desk.press(Key::Home);
    desk.press(Key::ArrowRight);
    desk.click(Role::Button, "Point");
    let button = desk.get_all_by_role_and_label(Role::Button, "Ray").last();
    button.expect("the menu bar has one of this name, too").click();
    desk.run();
    assert_eq!((desk.plane().scenario.query, desk.step_number()), (asked, 1));
}

#[test]
fn escape_in_a_field_leaves_the_field_alone() {
    let mut desk = Desk::new();
    desk.click(Role::Button, "Point");
    let asked = desk.plane().scenario.query;
    desk.click(Role::SpinButton, "Point x0");
    desk.run();
    desk.press(Key::Escape);
    assert_eq!(desk.plane().scenario.query, asked);
    desk.press(Key::Escape);
    assert_ne!(desk.plane().scenario.query, asked);
}

#[test]
fn what_is_asked_in_the_picture_is_answered_at_once_and_what_a_button_asks_begins_at_its_start() {
    let mut desk = Desk::new();
    desk.press(Key::Home);
    desk.click(Role::Button, "Neighbour");
    assert_eq!(desk.step_number(), 0);
    desk.press(Key::ArrowRight);
    // What else is asked of the neighbour leaves the step alone.
    desk.click(Role::RadioButton, "direction y + 1");
    assert_eq!(desk.step_number(), 1);

    desk.press(Key::Escape);
    let leaf = large_leaf(&desk);
    desk.click_at(desk.place(inside_the_right_side(&desk, leaf)), 1);
    assert_eq!(desk.step_number(), desk.plane().trace.events.len());
}
