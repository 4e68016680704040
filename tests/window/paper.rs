//! The paper lab.

use crate::desk::Desk;
use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::{NodeT as _, Queryable};
use octoscope::document::AnyDocument;
use octoscope::view::PanelKind;
use octoscope::with_document;
use octoscope_core::geometry::Ray;
use octoscope_core::paper::counterexample;
use octoscope_core::query::Query;
use octoscope_core::scenario::AnyScenario;
use octoscope_core::text::Language;
use octoscope_core::traverse::{Algorithm, Options, Variant, Variants};

/// Follows the rule of a variant, as the menu of the rules does.
fn follow(desk: &mut Desk, algorithm: Algorithm, variant: Variant) {
    let AnyDocument::Plane(document) = desk.state_mut().document_mut() else { panic!() };
    let variants = Variants::NONE.with(variant);
    let options = Options { variants, ..Options::default() };
    let Query::Ray { arithmetic, .. } = document.scenario.query else { panic!() };
    document.scenario.query = Query::Ray { algorithm, options, arithmetic };
    desk.run();
}

#[test]
fn a_misprint_is_explained_and_its_first_wrong_step_is_found() {
    let mut desk = Desk::new();
    desk.open_scenario(&counterexample(Variant::B3));
    assert!(desk.texts().iter().any(|text| text.starts_with("B-3 · ")));
    let wrong = desk.texts().into_iter().find(|text| text.starts_with("Goes wrong at step "));
    let wrong = wrong.expect("the counterexample goes wrong");
    desk.click(Role::Button, "Go to that step");
    assert_eq!(wrong, format!("Goes wrong at step {}.", desk.step_number()));
}

#[test]
fn the_mirrored_ray_is_shown_as_long_as_the_document_gets_it_wrong() {
    let mut desk = Desk::new();
    for before in [false, true] {
        desk.state_mut().view.plane_show.mirrored_ray = before;
        desk.run();
        let shown = |desk: &Desk| desk.state().view.plane_show.mirrored_ray;
        for variant in [Variant::B7, Variant::B7, Variant::B3] {
            desk.open_scenario(&counterexample(variant));
            assert_eq!(shown(&desk), before || variant == Variant::B7, "{variant:?}");
        }
    }
}

#[test]
fn the_lab_stays_where_it_is_when_its_last_switch_is_turned_off() {
    for preset in [Key::Num1, Key::Num2, Key::Num6] {
        let mut desk = Desk::new();
        desk.open_scenario(&counterexample(Variant::B24a));
        desk.press(preset);
        let place = |desk: &Desk| desk.get_by_label("B-24a").rect();
        let before = place(&desk);
        desk.click(Role::Button, "B-24a");
        desk.run();
        assert!(!desk.plane().scenario.query.variants().has(Variant::B24a));
        assert_eq!(place(&desk), before);
    }
}

#[test]
fn another_ray_is_found_and_undone() {
    let mut desk = Desk::new();
    desk.open_scenario(&counterexample(Variant::B3));
    let before = desk.plane().scenario.ray;
    desk.click(Role::Button, "Find another ray where they differ");
    desk.state_mut().finish_work();
    desk.run();
    assert_ne!(desk.plane().scenario.ray, before);
    assert!(desk.texts().iter().any(|text| text.starts_with("Goes wrong at step ")));
    desk.press_with(eframe::egui::Modifiers::COMMAND, Key::Z);
    assert_eq!(desk.plane().scenario.ray, before);
}

#[test]
fn the_counterexample_of_a_misprint_is_loaded_by_a_click() {
    let mut desk = Desk::new();
    follow(&mut desk, Algorithm::Parametric, Variant::B10);
    desk.click(Role::Button, "Load the counterexample");
    desk.state_mut().finish_work();
    desk.run();
    let AnyScenario::Octree(expected) = counterexample(Variant::B10) else { panic!() };
    let shown = &desk.space().scenario;
    assert_eq!((shown.ray, shown.query), (expected.ray, expected.query));
}

#[test]
fn the_first_wrong_step_is_marked_and_reached_by_a_click_or_a_key() {
    let mut desk = Desk::new();
    desk.open_scenario(&counterexample(Variant::B3));
    desk.press(Key::W);
    let wrong = desk.step_number();
    assert!(wrong > 0 && desk.says(&format!("Goes wrong at step {wrong}.")));
    desk.press(Key::Home);
    desk.click(Role::Button, &format!("Step {wrong} is the first one that goes wrong"));
    assert_eq!(desk.step_number(), wrong);

    // With the right rule nothing goes wrong, and nothing is marked.
    let AnyDocument::Plane(document) = desk.state_mut().document_mut() else { panic!() };
    document.scenario.query = document.scenario.query.corrected();
    desk.run();
    assert!(!desk.says("is the first one that goes wrong"));
    desk.press(Key::Home);
    desk.press(Key::W);
    assert_eq!(desk.step_number(), 0);
}

#[test]
fn another_point_region_and_cell_are_found_as_well() {
    for (variant, name) in
        [(Variant::B19, "point"), (Variant::B24c, "region"), (Variant::B28, "cell")]
    {
        let mut desk = Desk::new();
        desk.open_scenario(&counterexample(variant));
        let before = desk.plane().scenario.query;
        desk.click(Role::Button, &format!("Find another {name} where they differ"));
        desk.state_mut().finish_work();
        desk.run();
        assert_ne!(desk.plane().scenario.query, before);
        assert!(desk.texts().iter().any(|text| text.starts_with("Goes wrong at step ")));
    }
}

#[test]
fn the_key_leads_to_where_a_detour_begins_or_says_why_nothing_is_wrong() {
    let mut desk = Desk::new();
    desk.press(Key::W);
    assert!(desk.says("Every rule is followed in its right form"));

    desk.open_scenario(&counterexample(Variant::B9));
    desk.press(Key::Home);
    desk.press(Key::W);
    let step = desk.step_number();
    assert!(desk.says(&format!("The detour begins at step {step}.")));
    assert!(desk.says("comes to the right result by a detour, which begins here"));
    assert!(desk.sentence().contains("B-9"), "{}", desk.sentence());

    // Another form that is no misprint, although the paper lab judges it.
    desk.open_scenario(&counterexample(Variant::OneByOne));
    desk.state_mut().view.arrangement().add(PanelKind::Paper);
    desk.press(Key::Home);
    desk.state_mut().finish_work();
    desk.press(Key::W);
    assert!(desk.says("Every rule is followed in its right form"));
    assert_eq!(desk.step_number(), 0);

    // B-3 does no harm to a ray that only meets child 0.
    desk.open_scenario(&counterexample(Variant::B3));
    let AnyDocument::Plane(document) = desk.state_mut().document_mut() else { panic!() };
    document.scenario.ray = Ray::new([-1.0, 0.25], [1.0, -0.125]).unwrap();
    desk.run();
    desk.press(Key::W);
    assert!(desk.says("On this input the printed rule does no harm."));
}

#[test]
fn loading_a_counterexample_says_which_algorithm_and_rules_are_at_work() {
    for (language, told) in [
        (Language::English, "Algorithm: Parametric, by tables; rule B-3 as printed"),
        (Language::German, "Verfahren: Parametrisch, Tabellen; Regel B-3 wie gedruckt"),
    ] {
        let mut desk = Desk::new();
        follow(&mut desk, Algorithm::Parametric, Variant::B3);
        desk.state_mut().view.language = language;
        desk.run();
        let button = match language {
            Language::English => "Load the counterexample",
            Language::German => "Gegenbeispiel laden",
        };
        desk.click(Role::Button, button);
        desk.state_mut().finish_work();
        desk.run();
        assert!(desk.says(told), "{:?}", desk.texts());
    }
}

#[test]
fn readings_of_one_printed_rule_exclude_each_other() {
    let mut desk = Desk::new();
    for (first, second) in
        [(Variant::B2, Variant::B2Morton), (Variant::B25Leftmost, Variant::B25Rightmost)]
    {
        desk.open_scenario(&counterexample(first));
        let followed = |desk: &Desk| -> Vec<Variant> {
            with_document!(desk.state().document(), d => d.scenario.query.variants().iter().collect())
        };
        assert_eq!(followed(&desk), [first]);
        desk.click(Role::RadioButton, second.id());
        assert_eq!(followed(&desk), [second]);
        // The same by the keyboard, and none of them.
        for expected in [vec![first], vec![]] {
            desk.get_by_role_and_label(Role::RadioButton, first.id()).focus();
            desk.run();
            desk.press(Key::Space);
            assert_eq!(followed(&desk), expected);
        }
    }
}

#[test]
fn in_the_menu_of_rules_readings_exclude_each_other_as_well() {
    let mut desk = Desk::new();
    desk.open_scenario(&counterexample(Variant::B2));
    desk.get_by_role_and_label(Role::Button, "Rules (1)").click();
    desk.run();
    let in_menu = |desk: &mut Desk, name: &str, role: Role| {
        let row = desk.get_by_label_contains(name);
        assert_eq!(row.accesskit_node().role(), role);
        row.click();
        desk.run();
    };
    in_menu(&mut desk, "B-2-morton · ", Role::RadioButton);
    let variants = |desk: &Desk| desk.space().scenario.query.variants();
    assert_eq!(variants(&desk), Variants::NONE.with(Variant::B2Morton));
    in_menu(&mut desk, "B-1 · ", Role::CheckBox);
    assert_eq!(variants(&desk), Variants::NONE.with(Variant::B2Morton).with(Variant::B1));
}
