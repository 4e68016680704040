//! The formula of the step under the picture.

use crate::desk::{Desk, spoken};
use eframe::egui::{Key, Modifiers, Rect, accesskit::Role};
use egui_kittest::kittest::{NodeT, Queryable};
use octoscope_core::event::Event;
use octoscope_core::explain::Notation;

/// What a screen reader says of the formula, and where it is.
fn formula(desk: &Desk) -> Option<(String, Rect)> {
    let nodes = desk.nodes();
    let node = nodes.iter().find(|n| n.accesskit_node().author_id() == Some("formula"))?;
    Some((spoken(node), node.rect()))
}

/// Steps to the first halving of a node.
fn at_a_halving(desk: &mut Desk) {
    let events = &desk.plane().trace.events;
    let step = events.iter().position(|event| matches!(event, Event::Halve { .. })).unwrap();
    desk.press(Key::Home);
    (0..=step).for_each(|_| desk.tap(Key::ArrowRight));
    desk.run();
}

#[test]
fn keys_change_the_notation_and_hide_the_formula() {
    let mut desk = Desk::new();
    at_a_halving(&mut desk);
    let said = |desk: &Desk| formula(desk).unwrap().0;
    assert!(said(&desk).starts_with("t xm equals (x m minus p x) over d x; "), "{}", said(&desk));
    desk.press(Key::M);
    assert_eq!(desk.state().view.notation, Notation::Revelles);
    let expected = "t xm (o) equals (x m (o) minus p x) over d x; ";
    assert!(said(&desk).starts_with(expected), "{}", said(&desk));
    assert!(desk.says("As Revelles, Ureña and Lastra write"));
    desk.press(Key::M);
    desk.press(Key::M);
    assert_eq!(desk.state().view.notation, Notation::Seed);
    desk.press(Key::E);
    assert_eq!(formula(&desk), None);
    desk.press(Key::M);
    assert!(formula(&desk).is_some(), "another notation is to be seen");
}

#[test]
fn the_search_finds_the_notation() {
    let mut desk = Desk::new();
    at_a_halving(&mut desk);
    desk.press_with(Modifiers::COMMAND, Key::K);
    desk.event(eframe::egui::Event::Text("notation".to_owned()));
    desk.run();
    desk.press(Key::Enter);
    assert_eq!(desk.state().view.notation, Notation::Revelles);
}

#[test]
fn the_formula_speaks_the_language_of_the_window() {
    let mut desk = Desk::new();
    at_a_halving(&mut desk);
    desk.press(Key::L);
    let said = formula(&desk).unwrap().0;
    assert!(said.starts_with("t xm gleich (x m minus p x) durch d x; "), "{said}");
}

/// What stands beside the picture but formulas, with its place.
fn beside(desk: &Desk) -> Vec<(String, Rect)> {
    let view = desk.get_by_role_and_label(Role::Canvas, "Space view").rect();
    let nodes = desk.nodes();
    let placed = nodes.iter().filter(|n| {
        let node = n.accesskit_node();
        node.bounding_box().is_some() && node.author_id() != Some("formula")
    });
    let said = placed.map(|n| (spoken(n), n.rect()));
    said.filter(|(_, rect)| rect.right() <= view.left() || rect.left() >= view.right()).collect()
}

#[test]
fn formulas_take_their_room_from_the_picture_alone() {
    for preset in [Key::Num1, Key::Num2, Key::Num4, Key::Num6] {
        let mut desk = Desk::new();
        desk.press(preset);
        let with = beside(&desk);
        desk.press(Key::E);
        assert!(with.len() > 6, "{with:?}");
        assert_eq!(beside(&desk), with);
    }
}

#[test]
fn nothing_moves_while_stepping() {
    for preset in [Key::Num2, Key::Num6] {
        let mut desk = Desk::new();
        desk.press(preset);
        desk.press(Key::Home);
        let view = |desk: &Desk| desk.get_by_role_and_label(Role::Canvas, "Space view").rect();
        let (first, mut n_formulas) = (view(&desk), 0);
        for _ in 0..30 {
            desk.tap(Key::ArrowRight);
            assert_eq!(view(&desk), first);
            if let Some((_, rect)) = formula(&desk) {
                // In a lecture it is beside the picture.
                let is_off = rect.top() >= first.bottom() || rect.left() >= first.right();
                assert!(is_off && rect.height() > 60.0, "{rect:?}");
                n_formulas += 1;
            }
        }
        assert!(n_formulas > 10, "{n_formulas}");
    }
}
