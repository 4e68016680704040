//! The search over everything that has a name, by keyboard alone.

use crate::desk::Desk;
use crate::states::Question;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, TouchPhase, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use octoscope::query_kind::QueryKind;
use octoscope::text::texts;
use octoscope::view::Dialog;
use octoscope_core::query::Query;
use octoscope_core::text::Language;
use octoscope_core::traverse::{Algorithm, Variant};
use octoscope_figure::Theme;

fn search(desk: &mut Desk, words: &str) {
    desk.press_with(Modifiers::COMMAND, Key::K);
    desk.event(Event::Text(words.to_owned()));
    desk.run_steps(3);
}

#[test]
fn a_command_is_found_and_given() {
    let mut desk = Desk::new();
    search(&mut desk, "to the end");
    desk.press(Key::Enter);
    assert_eq!(desk.step_number(), desk.plane().trace.events.len());
    assert_eq!(desk.state().view.dialog, None);
}

/// A key with what it types, as a keyboard gives them.
fn typed(letter: char) -> [Event; 2] {
    let key = Key::from_name(&letter.to_uppercase().to_string()).unwrap();
    [pressed(key, Modifiers::NONE), Event::Text(letter.to_string())]
}

fn pressed(key: Key, modifiers: Modifiers) -> Event {
    Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers }
}

#[test]
fn what_is_typed_faster_than_frames_are_drawn_is_searched_for() {
    for n_in_a_frame in [99, 12, 5] {
        let mut desk = Desk::new();
        let letters = "cylinders".chars().flat_map(typed);
        let mut events = vec![pressed(Key::K, Modifiers::COMMAND)];
        events.extend(letters.chain([pressed(Key::Enter, Modifiers::NONE)]));
        for frame in events.chunks(n_in_a_frame) {
            desk.frame_with(frame);
        }
        desk.run();
        desk.state_mut().finish_work();
        desk.run();
        assert_eq!(desk.state().view.dialog, None);
        assert!(desk.says("4320 cylinders"), "{:?}", desk.texts());
        assert_eq!(desk.step_number(), 0);
    }
}

#[test]
fn the_key_that_opens_it_from_the_menu_is_no_word_and_no_choice() {
    for key in [Key::Enter, Key::Space] {
        let mut desk = Desk::new();
        let help = texts(Language::English).get("menu-help");
        desk.get_all_by_role_and_label(Role::Button, &help).next().unwrap().click();
        desk.run();
        desk.get_all_by_role_and_label(Role::Button, "Find a command… Ctrl+K")
            .next()
            .unwrap()
            .focus();
        desk.run();
        let text = (key == Key::Space).then(|| Event::Text(" ".to_owned()));
        let events: Vec<Event> = [pressed(key, Modifiers::NONE)].into_iter().chain(text).collect();
        desk.frame_with(&events);
        desk.run();
        let Some(Dialog::Find(search)) = &desk.state().view.dialog else { panic!("not open") };
        assert_eq!(search.wanted, "");
    }
}

#[test]
fn the_arrow_keys_choose_among_the_hits() {
    let mut desk = Desk::new();
    search(&mut desk, "samet");
    desk.press(Key::ArrowDown);
    desk.press(Key::Enter);
    let Query::Ray { algorithm, .. } = desk.plane().scenario.query else { panic!("not a ray") };
    assert_eq!(algorithm, Algorithm::SametCorner);
    assert_eq!(desk.step_number(), 0, "the arrows do not step");
}

/// Opens what is found first, and waits until it is there.
fn open(desk: &mut Desk, wanted: &str) {
    search(desk, wanted);
    desk.press(Key::Enter);
    desk.state_mut().finish_work();
    desk.run();
}

#[test]
fn an_erratum_opens_its_counterexample() {
    let mut desk = Desk::new();
    open(&mut desk, "b-2");
    assert!(desk.space().scenario.query.variants().has(Variant::B2));
}

#[test]
fn a_reading_of_an_erratum_opens_its_own_counterexample() {
    let mut desk = Desk::new();
    open(&mut desk, "24b");
    assert!(desk.plane().scenario.query.variants().has(Variant::B24b));
}

#[test]
fn a_panel_that_is_found_is_shown_whether_it_was_open_or_not() {
    let mut desk = Desk::new();
    desk.press(Key::Num1);
    for _ in 0..2 {
        search(&mut desk, "paper lab");
        desk.press(Key::Enter);
        desk.run();
        let heading = desk.get_by_label("Paper lab").rect();
        assert!(heading.top() < 80.0, "{heading:?}");
    }
}

#[test]
fn the_lab_of_an_erratum_is_seen_from_its_top() {
    let mut desk = Desk::of(Harness::builder(), [1280.0, 600.0]);
    search(&mut desk, "b-3");
    desk.press(Key::Enter);
    desk.state_mut().finish_work();
    desk.run();
    let top = |desk: &Desk| desk.get_by_label("Paper lab").rect().top();
    let first = top(&desk);
    desk.get_by_label_contains("All errata").click();
    desk.run();
    desk.point_at(desk.get_by_label("Paper lab").rect().center());
    desk.event(Event::MouseWheel {
        unit: MouseWheelUnit::Point,
        delta: vec2(0.0, -300.0),
        modifiers: Modifiers::NONE,
        phase: TouchPhase::Move,
        source: MouseWheelSource::Wheel,
    });
    desk.run();
    assert!(top(&desk) < first - 100.0, "{}", top(&desk));
    search(&mut desk, "b-11");
    desk.press(Key::Enter);
    desk.state_mut().finish_work();
    desk.run();
    assert_eq!(top(&desk), first);
}

#[test]
fn a_theme_is_chosen_by_its_name() {
    let mut desk = Desk::new();
    for (wanted, theme) in [("projector", Theme::Projector), ("dunkel", Theme::Dark)] {
        search(&mut desk, wanted);
        desk.press(Key::Enter);
        assert_eq!(desk.state().view.theme, theme);
    }
}

#[test]
fn a_dialog_takes_the_hint_away_that_is_shown_below_it() {
    let mut desk = Desk::new();
    let ruler = desk.get_by_role_and_label(Role::Slider, "Step of the trace").rect();
    desk.point_at(ruler.center());
    for _ in 0..60 {
        desk.step();
    }
    assert!(desk.says("A tick for every step"));
    search(&mut desk, "ray");
    assert!(!desk.says("A tick for every step"));
}

#[test]
fn what_is_not_found_is_said_and_escape_leaves() {
    let mut desk = Desk::new();
    search(&mut desk, "xyzzy");
    assert!(desk.says("Nothing has this name"));
    desk.press(Key::Enter);
    assert!(matches!(desk.state().view.dialog, Some(Dialog::Find(_))));
    desk.press(Key::Escape);
    assert_eq!(desk.state().view.dialog, None);
}

#[test]
fn a_question_that_is_found_begins_at_its_first_step_each_time() {
    for kind in [QueryKind::Point, QueryKind::Region, QueryKind::Neighbour] {
        let wanted = texts(Language::English).get(&format!("find-{}", kind.key()));
        let mut desk = Desk::new();
        desk.press(Key::End);
        for _ in 0..2 {
            search(&mut desk, &wanted);
            desk.press(Key::Enter);
            let asked = desk.plane().scenario.query;
            assert_eq!((QueryKind::of(&asked), desk.step_number()), (kind, 0));
            desk.press(Key::ArrowRight);
            assert_eq!(desk.step_number(), 1);
        }
        // The ray comes back where it was left.
        desk.press(Key::Escape);
        assert_eq!(desk.step_number(), desk.plane().trace.events.len());
    }
}

#[test]
fn an_erratum_of_another_algorithm_says_how_to_go_back_to_the_present_one() {
    for (language, told) in [
        (Language::English, "Ctrl+Z goes back: Samet"),
        (Language::German, "Strg+Z führt zurück: Samet"),
    ] {
        let mut desk = Desk::new();
        Question::Ray(Algorithm::Samet).ask(&mut desk);
        desk.state_mut().view.language = language;
        desk.run();
        let before = desk.plane().scenario.query;
        open(&mut desk, "b-3");
        assert_ne!(desk.plane().scenario.query, before);
        assert!(desk.says(told), "{:?}", desk.texts());
        desk.press_with(Modifiers::COMMAND, Key::Z);
        assert_eq!(desk.plane().scenario.query, before);
        // The same algorithm needs no way back.
        open(&mut desk, "b-3");
        open(&mut desk, "b-1");
        assert!(
            !desk.says("Ctrl+Z goes back") && !desk.says("führt zurück:"),
            "{:?}",
            desk.texts()
        );
    }
}
