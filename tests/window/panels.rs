//! Panels are folded, moved, closed, added and restored.

use crate::desk::{Desk, spoken};
use eframe::egui::{Key, Modifiers, accesskit::Role, pos2};
use egui_kittest::kittest::{NodeT, Queryable};
use octoscope::document::{AnyDocument, Found};
use octoscope::view::View;
use octoscope_core::explain::algorithm_name;
use octoscope_core::text::Language;
use octoscope_core::traverse::Algorithm;

impl Desk {
    /// Titles of the panels beside the space view, in their order.
    fn panels(&self) -> Vec<String> {
        let nodes = self.nodes();
        let buttons = nodes.iter().filter(|node| node.accesskit_node().role() == Role::Button);
        let title = |name: String| name.strip_prefix("Panel ").map(str::to_owned);
        buttons.filter_map(|node| title(spoken(node))).collect()
    }

    /// Chooses an entry from the menu of a panel.
    fn choose(&mut self, panel: &str, entry: &str) {
        self.click(Role::Button, &format!("Panel {panel}"));
        self.click(Role::Button, entry);
    }

    /// Ticks a panel in the menu of all panels.
    fn tick(&mut self, panel: &str) {
        self.click(Role::Button, "View");
        self.click(Role::Button, "Panels");
        self.click(Role::CheckBox, panel);
    }

    /// Whether the button of this name is focused after some press of Tab.
    fn reach(&mut self, name: &str) -> bool {
        (0..self.nodes().len()).any(|_| {
            self.tap(Key::Tab);
            self.query_by_role_and_label(Role::Button, name).is_some_and(|node| node.is_focused())
        })
    }
}

const FIRST: [&str; 4] = ["t-rail", "Automaton", "Codes", "Counters"];

#[test]
fn a_panel_is_closed_and_the_arrangement_restored() {
    let mut desk = Desk::new();
    assert_eq!(desk.panels(), FIRST);
    desk.choose("Automaton", "Close");
    assert_eq!(desk.panels(), ["t-rail", "Codes", "Counters"]);
    assert!(!desk.says("Next state by exit plane"));
    desk.press_with(Modifiers::COMMAND, Key::R);
    assert_eq!(desk.panels(), FIRST);
    assert!(desk.says("Next state by exit plane"));
}

#[test]
fn panels_move_up_and_down() {
    let mut desk = Desk::new();
    desk.choose("Codes", "Move up");
    assert_eq!(desk.panels(), ["t-rail", "Codes", "Automaton", "Counters"]);
    desk.choose("t-rail", "Move down");
    assert_eq!(desk.panels(), ["Codes", "t-rail", "Automaton", "Counters"]);
    desk.click(Role::Button, "Panel Codes");
    let up = desk.get_by_role_and_label(Role::Button, "Move up");
    assert!(up.accesskit_node().is_disabled(), "it is the first one");
}

#[test]
fn a_click_on_the_title_of_a_folded_panel_unfolds_it() {
    let mut desk = Desk::with_file("scene:points-3d");
    assert_eq!(desk.panels(), ["t-rail", "Automaton", "Codes", "Counters"]);
    assert!(!desk.says("Table 3"));
    desk.get_all_by_label("Automaton").next().unwrap().click();
    desk.run();
    assert!(desk.says("Table 3"));
    desk.choose("Automaton", "Fold");
    assert!(!desk.says("Table 3"));
}

#[test]
fn a_folded_panel_leaves_its_heading() {
    let mut desk = Desk::new();
    desk.choose("Automaton", "Fold");
    assert_eq!(desk.panels(), FIRST);
    assert!(!desk.says("Next state by exit plane"));
    desk.choose("Automaton", "Unfold");
    assert!(desk.says("Next state by exit plane"));
}

#[test]
fn any_panel_is_added_from_the_menu_and_taken_away_there() {
    let mut desk = Desk::new();
    for panel in ["Region by XOR", "Neighbour", "Listing", "Variables", "Stack", "Comparison"] {
        desk.tick(panel);
        assert_eq!(desk.panels().last().map(String::as_str), Some(panel));
    }
    assert_eq!(desk.panels().len(), 10);
    desk.tick("Codes");
    assert_eq!(desk.panels().len(), 9);
    assert!(!desk.panels().contains(&"Codes".to_owned()));
}

#[test]
fn each_preset_has_its_own_arrangement() {
    let mut desk = Desk::new();
    desk.choose("Codes", "Close");
    desk.press(Key::Num1);
    assert_eq!(desk.panels(), ["Codes", "Tree", "Counters"]);
    desk.press(Key::Num2);
    assert_eq!(desk.panels(), ["t-rail", "Automaton", "Counters"]);
}

#[test]
fn the_arrangement_is_there_again_at_the_next_start() {
    let mut desk = Desk::new();
    desk.choose("Codes", "Move up");
    desk.choose("t-rail", "Close");
    let wanted = desk.panels();
    let json = serde_json::to_string(&desk.state().view).unwrap();
    let view: View = serde_json::from_str(&json).unwrap();
    let mut next = Desk::new();
    next.state_mut().view = view;
    next.run();
    assert_eq!(next.panels(), wanted);
}

#[test]
fn a_query_still_brings_its_panel_after_others_were_moved() {
    let mut desk = Desk::new();
    desk.press(Key::Num1);
    desk.choose("Counters", "Move up");
    desk.click(Role::Button, "Region");
    assert!(desk.panels().contains(&"Region by XOR".to_owned()), "{:?}", desk.panels());
}

#[test]
fn without_panels_the_picture_has_the_room() {
    let mut desk = Desk::new();
    let width = |desk: &Desk| desk.get_by_role_and_label(Role::Canvas, "Space view").rect().width();
    let before = width(&desk);
    for panel in FIRST {
        desk.choose(panel, "Close");
    }
    assert!(width(&desk) > before + 300.0);
    desk.press_with(Modifiers::COMMAND, Key::R);
    assert_eq!(width(&desk), before);
}

#[test]
fn a_panel_is_closed_by_the_keyboard_alone() {
    let mut desk = Desk::new();
    assert!(desk.reach("Panel Automaton"));
    desk.press(Key::Space);
    assert!(desk.reach("Close"));
    desk.press(Key::Enter);
    assert_eq!(desk.panels(), ["t-rail", "Codes", "Counters"]);
}

#[test]
fn the_side_is_resized_by_its_edge_and_restored() {
    let mut desk = Desk::new();
    let edge = |desk: &Desk| desk.get_by_role_and_label(Role::Canvas, "Space view").rect().right();
    let before = edge(&desk);
    let places = [pos2(before + 2.0, 300.0), pos2(before - 98.0, 300.0)];
    desk.drag(places, Modifiers::NONE);
    assert!((edge(&desk) - (before - 100.0)).abs() < 4.0, "{} {before}", edge(&desk));
    desk.press_with(Modifiers::COMMAND, Key::R);
    assert_eq!(edge(&desk), before);
}

#[test]
fn panels_have_their_menus_in_german_too() {
    let mut desk = Desk::new();
    desk.state_mut().view.language = Language::German;
    desk.run();
    desk.click(Role::Button, "Tafel Automat");
    for entry in ["Einklappen", "Nach oben", "Nach unten", "Schließen"] {
        assert!(desk.query_by_role_and_label(Role::Button, entry).is_some(), "{entry}");
    }
}

#[test]
fn a_click_on_a_head_orders_the_comparison() {
    let mut desk = Desk::new();
    desk.press(Key::Num5);
    // The names of the algorithms from top to bottom.
    let order = |desk: &Desk| -> Vec<Algorithm> {
        let nodes = desk.nodes();
        let rows = nodes.iter().filter(|n| n.accesskit_node().role() == Role::RadioButton);
        let mut rows: Vec<_> = rows
            .filter_map(|node| {
                let name = spoken(node);
                let named = |a: &Algorithm| algorithm_name(*a, Language::English) == name;
                let algorithm = Algorithm::ALL.into_iter().find(named)?;
                Some((node.rect().top(), algorithm))
            })
            .collect();
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        rows.into_iter().map(|(_, algorithm)| algorithm).collect()
    };
    assert_eq!(order(&desk), Algorithm::ALL);
    let AnyDocument::Plane(document) = desk.state_mut().document_mut() else { panic!() };
    let Found::Known(runs) = document.comparison() else { panic!() };
    let steps = |algorithm: &Algorithm| {
        runs.iter().find(|run| run.algorithm == *algorithm).unwrap().n_steps
    };
    desk.click(Role::Button, "Sort by steps");
    assert!(order(&desk).iter().is_sorted_by_key(steps));
    desk.click(Role::Button, "Sort by steps");
    assert!(order(&desk).iter().rev().is_sorted_by_key(steps));
    desk.click(Role::Button, "Sort by algorithm");
    assert_eq!(order(&desk), Algorithm::ALL);
}
