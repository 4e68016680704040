//! The diagram of the tree, linked with the picture, and why children are left out.

use crate::desk::{Desk, spoken};
use eframe::egui::{Key, Modifiers, Pos2, accesskit::Role, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use octoscope_core::scenario::built_in;
use octoscope_core::text::Language;
use octoscope_core::tree::NodeId;

impl Desk {
    /// The nodes of the diagram, as a screen reader names them.
    fn diagram(&self) -> Vec<(String, Pos2)> {
        let nodes = self.nodes();
        let buttons = nodes.iter().filter(|node| node.accesskit_node().role() == Role::Button);
        let named = buttons.map(|node| (spoken(node), node.rect().center()));
        named.filter(|(name, _)| name.contains(", level ")).collect()
    }

    /// Place of the node of the diagram whose name begins like this.
    #[track_caller]
    fn node(&self, name: &str) -> Pos2 {
        let found = self.diagram().into_iter().find(|(other, _)| other.starts_with(name));
        found.unwrap_or_else(|| panic!("{name}: {:?}", self.diagram())).1
    }

    /// Moves the pointer to a place in the picture, over which it is already.
    fn move_to(&mut self, place: Pos2) {
        self.hover_at(place + vec2(3.0, 3.0));
        self.step();
        self.hover_at(place);
        self.run();
    }

    fn lit(&self) -> Option<NodeId> {
        self.state().view.hover.lit(&self.plane().tree)
    }
}

/// The window on the first scene at step 37, with the preset of the tree.
fn desk() -> Desk {
    let mut desk = Desk::new();
    desk.press(Key::Num7);
    desk.state_mut().view.playback.go_to(37, 1000);
    desk.run();
    desk
}

#[test]
fn the_path_its_siblings_and_visited_leaves_are_named() {
    let desk = desk();
    let moment = desk.plane().moment(37);
    let current = moment.current.unwrap();
    let tree = &desk.plane().tree;
    let names: Vec<String> = desk.diagram().into_iter().map(|(name, _)| name).collect();
    assert!(names.contains(&"Root, level 5, codes 0, 0".to_owned()), "{names:?}");
    for node in tree.ancestors(current).chain([current]).filter(|&node| node != NodeId::ROOT) {
        let child = tree.child_index(node).unwrap().0;
        let [x, y] = tree.code(node);
        let name = format!("Child {child}, level {}, codes {x}, {y}", tree.level(node));
        assert!(names.contains(&name), "{name} in {names:?}");
    }
    for n in 1..=4 {
        assert!(names.iter().any(|name| name.ends_with(&format!("number {n} on the ray"))));
    }
    assert!(names.iter().any(|name| name.ends_with("28 leaves folded")), "{names:?}");
}

#[test]
fn a_node_pointed_at_in_the_diagram_is_lit_in_the_picture_and_the_other_way_round() {
    let mut desk = desk();
    let place = desk.node("Child 0, level 2, codes 0, 8");
    desk.hover_at(place);
    desk.run();
    let lit = desk.lit().unwrap();
    assert_eq!((desk.plane().tree.level(lit), desk.plane().tree.code(lit)), (2, [0, 8]));
    assert!(desk.says("level 2, codes 0, 8"), "the corner of the picture names it");

    let in_picture = desk.place([0.1, 0.2]);
    desk.move_to(in_picture);
    let lit = desk.lit().unwrap();
    assert_eq!(desk.plane().tree.node_box(lit).max, [0.125, 0.25]);
}

#[test]
fn a_click_on_a_node_of_the_run_goes_to_its_first_step() {
    let mut desk = desk();
    let place = desk.node("Child 1, level 2, codes 0, 4");
    desk.click_at(place, 1);
    let (step, tree) = (desk.step_number(), &desk.plane().tree);
    assert!(step < 37, "{step}");
    let current = desk.plane().moment(step).current.unwrap();
    assert_eq!(tree.code(current), [0, 4]);
    let before = desk.plane().moment(step - 1).current.unwrap();
    assert_ne!(before, current);
}

#[test]
fn a_click_beside_the_run_unfolds_and_folds() {
    let mut desk = desk();
    let folded = "Child 2, level 4, codes 16, 0";
    let n_nodes = desk.diagram().len();
    let place = desk.node(folded);
    desk.click_at(place, 1);
    assert_eq!(desk.step_number(), 37);
    assert_eq!(desk.diagram().len(), n_nodes + 4);
    let place = desk.node(folded);
    desk.click_at(place, 1);
    assert_eq!(desk.diagram().len(), n_nodes);
}

#[test]
fn the_hover_text_says_what_a_click_does_and_why_a_node_is_left_out() {
    let mut desk = desk();
    let hover = |desk: &mut Desk, name: &str| {
        let place = desk.node(name);
        desk.hover_at(place);
        for _ in 0..60 {
            desk.step();
        }
    };
    hover(&mut desk, "Child 2, level 4, codes 16, 0");
    assert!(desk.says("Click: unfold 7 leaves"), "{:?}", desk.texts());
    assert!(desk.says("Child 2 is not met"), "{:?}", desk.texts());
    hover(&mut desk, "Child 1, level 2, codes 0, 4");
    assert!(desk.says("Click: to step "), "{:?}", desk.texts());
    assert!(desk.says("number 1 on the ray"));
}

#[test]
fn the_pointer_goes_from_the_hint_of_a_node_to_that_of_the_diagram() {
    let mut desk = desk();
    let canvas = desk.get_by_role_and_label(Role::Canvas, "Tree view").rect();
    let places = [desk.node("Root"), canvas.left_bottom() + vec2(60.0, -30.0)];
    for (place, said) in places.into_iter().zip(["Click: to step ", "Ctrl and the wheel to zoom"]) {
        desk.hover_at(place);
        for _ in 0..60 {
            desk.step();
        }
        assert!(desk.says(said), "{said}: {:?}", desk.texts());
    }
}

#[test]
fn the_keyboard_alone_reaches_a_node_and_goes_to_its_step() {
    let mut desk = desk();
    let wanted = "Child 1, level 2, codes 0, 4";
    let n_stops = desk.nodes().len();
    let reached = (0..n_stops).any(|_| {
        desk.tap(Key::Tab);
        let focused = desk.nodes().into_iter().find(|node| node.is_focused());
        focused.is_some_and(|node| spoken(&node).starts_with(wanted))
    });
    assert!(reached);
    desk.run();
    assert_eq!(desk.lit().map(|lit| desk.plane().tree.code(lit)), Some([0, 4]));
    desk.press(Key::Enter);
    let current = desk.plane().moment(desk.step_number()).current.unwrap();
    assert_eq!(desk.plane().tree.code(current), [0, 4]);
}

#[test]
fn the_diagram_is_dragged_until_the_next_step() {
    let mut desk = desk();
    let name = "Child 0, level 4, codes 0, 0";
    let before = desk.node(name);
    let canvas = desk.get_by_role_and_label(Role::Canvas, "Tree view").rect();
    let empty = canvas.left_bottom() + vec2(60.0, -30.0);
    let by = vec2(40.0, -20.0);
    desk.drag([empty, empty + by], Modifiers::NONE);
    let after = desk.node(name);
    assert!((after - before - by).length() < 4.0, "{before} {after}");
    desk.click_at(empty, 2);
    assert_eq!(desk.node(name), before);
}

#[test]
fn every_child_has_its_reason_in_both_languages() {
    let mut desk = desk();
    assert!(desk.says("not met"));
    assert!(desk.says("Child 1 is not met: t_ym = 0.3448 > t_xm = 0.3163"), "{:?}", desk.texts());
    desk.state_mut().view.language = Language::German;
    desk.run();
    assert!(desk.says("verfehlt"));
    assert!(desk.says("der Austritt durch x käme also vor dem Eintritt durch y"));
}

#[test]
fn the_picture_tells_why_a_child_under_the_pointer_is_left_out() {
    let mut desk = Desk::new();
    desk.state_mut().view.playback.go_to(37, 1000);
    desk.run();
    // Child 1 of the node at work, and a leaf far away.
    let place = desk.place([0.14, 0.36]);
    desk.move_to(place);
    assert!(desk.says("Child 1 is not met"), "{:?}", desk.texts());
    let place = desk.place([0.7, 0.1]);
    desk.move_to(place);
    assert!(desk.says("Node (16, 0) of level 4 is not met"), "{:?}", desk.texts());
}

#[test]
fn an_octree_has_its_diagram_too() {
    let mut desk = Desk::new();
    desk.open_scenario(&built_in("points-3d").unwrap());
    desk.press(Key::Num7);
    desk.state_mut().view.playback.go_to(46, 1000);
    desk.run();
    let children = |desk: &Desk| {
        let of_root = |name: &String| name.contains(", level 4, ");
        desk.diagram().into_iter().filter(|(name, _)| of_root(name)).count()
    };
    assert_eq!(children(&desk), 8);
    for child in 0..8 {
        assert!(desk.says(&format!("Child {child}, level 4, codes")), "{child}");
    }
}
