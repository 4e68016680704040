//! Questions that are asked by the mouse in the picture.

use crate::desk::Desk;
use eframe::egui::{Key, Modifiers, accesskit::Role};
use egui_kittest::kittest::Queryable;
use octoscope::document::AnyDocument;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::traverse::Algorithm;
use octoscope_core::tree::Node;

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
    let field = desk.get_all_by_role(Role::SpinButton).next();
    field.expect("the coordinates of the point").click();
    desk.run();
    desk.press(Key::Escape);
    assert_eq!(desk.plane().scenario.query, asked);
    desk.press(Key::Escape);
    assert_ne!(desk.plane().scenario.query, asked);
}
