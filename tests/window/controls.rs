//! What a screen reader finds, in both languages.

use crate::desk::{Desk, spoken};
use crate::states;
use eframe::egui::{
    Event, Key, Modifiers, PointerButton, Popup, Rect,
    accesskit::{Live, Role},
    epaint::{ClippedShape, Shape},
};
use egui_kittest::kittest::{NodeT, Queryable};
use octoscope::command::Menu;
use octoscope::text::texts;
use octoscope::theme;
use octoscope::view::{Dialog, Preset};
use octoscope_core::query::Query;
use octoscope_core::scenario::{BUILT_IN, built_in};
use octoscope_core::text::Language;
use octoscope_core::traverse::Algorithm;
use std::collections::HashSet;

const PRESETS: [Key; 6] = [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6];
const OPERATED: [Role; 8] = [
    Role::Button,
    Role::CheckBox,
    Role::ComboBox,
    Role::RadioButton,
    Role::Slider,
    Role::SpinButton,
    Role::TextInput,
    Role::Canvas,
];

/// Text of a key, in English.
fn english(key: &str) -> String {
    texts(Language::English).get(key)
}

#[test]
fn every_preset_opens_by_its_key_with_its_panels() {
    let mut desk = Desk::new();
    let titles = [
        &["panel-codes", "panel-counters"][..],
        &["panel-t-rail", "panel-automaton"],
        &["panel-automaton", "panel-t-rail"],
        &["panel-listing", "panel-variables", "panel-stack", "panel-counters"],
        &["panel-compare"],
        &["panel-t-rail"],
    ];
    for ((key, preset), titles) in PRESETS.into_iter().zip(Preset::ALL).zip(titles) {
        desk.press(key);
        assert_eq!(desk.state().view.preset, preset);
        let shown = desk.texts();
        for title in titles {
            assert!(shown.contains(&english(title)), "{title} in {preset:?}");
        }
        let left = shown.contains(&english("panel-scene"));
        assert_eq!(left, preset != Preset::Lecture, "{preset:?}");
    }
}

#[test]
fn a_query_brings_the_panel_that_explains_it() {
    let mut desk = Desk::new();
    desk.press(Key::Num5);
    for (query, title) in
        [("Point", "panel-codes"), ("Region", "panel-region"), ("Neighbour", "panel-neighbour")]
    {
        desk.click(Role::Button, query);
        assert!(desk.texts().contains(&english(title)), "{title}");
    }
}

/// Controls without a name, and a sentence that is not announced.
fn unspoken(desk: &Desk) -> Vec<String> {
    let mut faults = Vec::new();
    let nodes = desk.nodes();
    let operated = nodes.iter().map(NodeT::accesskit_node);
    let operated = operated.filter(|node| OPERATED.contains(&node.role()));
    for node in operated {
        if node.label().unwrap_or_default().trim().is_empty() {
            faults.push(format!("{:?} without a name at {:?}", node.role(), node.bounding_box()));
        }
    }
    let sentence = nodes.iter().map(NodeT::accesskit_node);
    let mut sentence = sentence.filter(|node| node.author_id() == Some("sentence"));
    if !sentence.any(|node| node.live() == Live::Polite) && !desk.state().view.blank {
        faults.push("the sentence is not announced".to_owned());
    }
    faults
}

#[test]
fn everything_that_can_be_operated_has_a_name_in_every_state() {
    let mut faults = Vec::new();
    // Other presets show the same panels of a question, and so does space.
    let is_other = |name: &str| name.starts_with("question-") && !name.ends_with("-rail-2d");
    let states: Vec<_> = states::all().into_iter().filter(|s| !is_other(&s.name)).collect();
    assert!(states.len() > 60, "{}", states.len());
    for state in states {
        let mut desk = Desk::new();
        state.reach(&mut desk);
        faults.extend(unspoken(&desk).into_iter().map(|fault| format!("{}: {fault}", state.name)));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn menus_list_their_commands_and_obey() {
    let mut desk = Desk::new();
    for menu in Menu::ALL {
        let name = english(menu.id());
        let bar = desk.get_all_by_role_and_label(Role::Button, &name).next().unwrap();
        bar.click();
        desk.run();
        for row in octoscope::command::COMMANDS.iter().filter(|row| row.menu == menu) {
            assert!(desk.says(&english(row.id)), "{}", row.id);
        }
        desk.press(Key::Escape);
    }
}

#[test]
fn the_dialog_of_keys_tells_every_command_that_has_one() {
    let mut desk = Desk::new();
    desk.state_mut().view.dialog = Some(Dialog::Keys);
    desk.run();
    for row in octoscope::command::COMMANDS.iter().filter(|row| !row.keys.is_empty()) {
        assert!(desk.says(&english(row.id)), "{}", row.id);
    }
}

#[test]
fn in_german_no_english_is_left() {
    let mut desk = Desk::new();
    desk.press(Key::Home);
    desk.press(Key::ArrowRight);
    let sentence = desk.sentence();
    desk.click(Role::Button, "DE");
    assert_ne!(desk.sentence(), sentence);
    assert!(desk.sentence().contains("Strahl"), "{}", desk.sentence());
    let foreign = only_english();
    assert!(foreign.len() > 60, "{}", foreign.len());
    for key in PRESETS {
        desk.press(key);
        for text in desk.nodes().iter().map(spoken) {
            assert!(!foreign.contains(&text), "{text} with {key:?}");
        }
    }
    desk.press(Key::Num1);
    desk.click(Role::Button, "EN");
    assert_eq!(desk.sentence(), sentence);
}

/// Texts that are said in another way in German.
fn only_english() -> HashSet<String> {
    let source = include_str!("../../assets/texts/en/window.ftl");
    let figures = octoscope_figure::views::figure_texts(Language::English);
    let lines = source.lines().chain(figures.lines());
    let keys = lines.filter_map(|line| line.split_once(" = ")).map(|(key, _)| key);
    // Listings say “end” in every language.
    let keys = keys.filter(|key| !key.starts_with([' ', '#']) && *key != "automaton-end");
    let both = keys.map(|key| Language::ALL.map(|language| texts(language).get(key)));
    both.filter(|[one, other]| one != other).map(|[english, _]| english).collect()
}

#[test]
fn larger_type_is_larger_and_goes_back() {
    let mut desk = Desk::new();
    let width = |desk: &Desk| desk.ctx.content_rect().width();
    let usual = width(&desk);
    desk.press(Key::Plus);
    assert!(width(&desk) < usual);
    desk.press(Key::Num0);
    assert_eq!(width(&desk), usual);
}

#[test]
fn another_depth_builds_another_tree_and_is_undone() {
    let mut desk = Desk::new();
    let (depth, leaves) = (desk.plane().scenario.recipe.depth, desk.plane().tree.n_leaves());
    desk.get_by_role_and_label(Role::Slider, "depth").set_value_accesskit(f64::from(depth - 2));
    desk.step();
    desk.state_mut().finish_work();
    desk.run();
    assert_eq!(desk.plane().scenario.recipe.depth, depth - 2);
    assert!(desk.plane().tree.n_leaves() < leaves);
    desk.press_with(Modifiers::COMMAND, Key::Z);
    desk.state_mut().finish_work();
    desk.run();
    assert_eq!(desk.plane().tree.n_leaves(), leaves);
}

#[test]
fn a_tree_that_is_given_up_leaves_all_as_it_was_and_a_quiet_word() {
    let mut desk = Desk::new();
    desk.open_scenario(&built_in("sphere-grid").unwrap());
    let before = desk.space().scenario;
    // Billions of nodes: it has no end before it is given up.
    desk.get_by_role_and_label(Role::Slider, "depth").set_value_accesskit(18.0);
    desk.step();
    assert_ne!(desk.space().scenario, before);
    desk.state().give_up_opening();
    desk.state_mut().finish_work();
    desk.run();
    assert_eq!(desk.space().scenario, before);
    assert_eq!(desk.state().view.dialog, None);
    assert!(desk.says("Cancelled"), "{:?}", desk.texts());
}

#[test]
fn a_list_is_chosen_from_by_keyboard_alone() {
    let mut desk = Desk::new();
    desk.get_all_by_role(Role::ComboBox).next().unwrap().focus();
    desk.run();
    desk.press(Key::Enter);
    assert!(BUILT_IN.iter().all(|scene| desk.says(&english(&format!("scene-{}", scene.id)))));
    // From the present entry on.
    desk.press(Key::ArrowDown);
    desk.press(Key::ArrowDown);
    desk.press(Key::Enter);
    assert!(!Popup::is_any_open(&desk.ctx));
    desk.state_mut().finish_work();
    desk.run();
    assert!(desk.says(&english(&format!("scene-{}", BUILT_IN[2].id))));
    assert_eq!(desk.step_number(), 0);
    assert!(desk.get_all_by_role(Role::ComboBox).next().unwrap().is_focused());
}

#[test]
fn arrows_in_a_list_do_not_step() {
    let mut desk = Desk::new();
    let place = desk.get_all_by_role(Role::ComboBox).last().unwrap().rect().center();
    desk.point_at(place);
    desk.click_at(place, 1);
    assert!(Popup::is_any_open(&desk.ctx));
    for _ in 0..3 {
        desk.press(Key::ArrowDown);
    }
    assert_eq!(desk.step_number(), 0);
    desk.press(Key::Enter);
    assert!(!Popup::is_any_open(&desk.ctx));
    let Query::Ray { algorithm, .. } = desk.plane().scenario.query else { panic!("no ray") };
    assert_ne!(algorithm, Algorithm::default());
}

/// Whether something is framed in the colour of what is chosen.
fn has_ring(desk: &Desk, rect: Rect) -> bool {
    let view = &desk.state().view;
    let accent = theme::look(view.language, view.theme).palette.accent;
    desk.output().shapes.iter().any(|ClippedShape { shape, .. }| match shape {
        Shape::Rect(drawn) => {
            let is_near = drawn.rect.expand(2.0).contains_rect(rect)
                && rect.expand(4.0).contains_rect(drawn.rect);
            is_near && drawn.stroke.color == accent && drawn.stroke.width >= 1.5
        }
        _ => false,
    })
}

#[test]
fn what_the_keys_go_to_has_a_ring() {
    let mut desk = Desk::new();
    for (role, name) in
        [(Role::Button, "File"), (Role::Button, "exact"), (Role::SpinButton, "capacity")]
    {
        let rect = desk.get_by_role_and_label(role, name).rect();
        assert!(!has_ring(&desk, rect), "{name}");
        desk.get_by_role_and_label(role, name).focus();
        desk.run();
        assert!(has_ring(&desk, rect), "{name}");
    }
}

#[test]
fn a_key_in_the_frame_of_a_click_belongs_to_the_field_that_is_clicked() {
    let mut desk = Desk::new();
    let (ray, preset) = (desk.plane().scenario.ray, desk.state().view.preset);
    for (key, text) in [(Key::R, "r"), (Key::Num2, "2")] {
        let pos = desk.get_by_role_and_label(Role::SpinButton, "direction x").rect().center();
        desk.point_at(pos);
        let (modifiers, button) = (Modifiers::NONE, PointerButton::Primary);
        let button = |pressed| Event::PointerButton { pos, button, pressed, modifiers };
        let key =
            |pressed| Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
        let text = Event::Text(text.to_owned());
        let events = [button(true), button(false), key(true), text, key(false)];
        desk.input_mut().events.extend(events);
        desk.step();
        desk.press(Key::Escape);
        assert_eq!((desk.plane().scenario.ray, desk.state().view.preset), (ray, preset));
        desk.press(Key::Escape);
    }
}

#[test]
fn a_click_is_one_however_long_its_frames_take() {
    let mut desk = Desk::new();
    let pos = desk.get_all_by_role(Role::ComboBox).last().unwrap().rect().center();
    desk.point_at(pos);
    assert!(!desk.says("HERO: sorted planes"));
    for pressed in [true, false] {
        let (modifiers, button) = (Modifiers::NONE, PointerButton::Primary);
        desk.event(Event::PointerButton { pos, button, pressed, modifiers });
        let late = desk.ctx.input(|input| input.time) + 2.0;
        desk.input_mut().time = Some(late);
        desk.step();
    }
    desk.step();
    assert!(desk.says("HERO: sorted planes"), "{:?}", desk.texts());
}
