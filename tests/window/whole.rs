//! Words that are seen whole: no caption of a control is broken, and nothing is cut with
//! an ellipsis.

use crate::desk::{Desk, spoken};
use crate::lecture::each_text;
use crate::states::{Question, SCENES};
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::NodeT as _;
use octoscope::finder::find;
use octoscope::view::{Dialog, Preset, Search};
use octoscope_core::scenario::built_in;
use octoscope_core::text::Language;
use std::collections::BTreeSet;

/// What is painted: the text, in how many lines, and whether its end is left out.
fn painted(desk: &Desk) -> Vec<(String, usize, bool)> {
    let mut all = Vec::new();
    for clipped in &desk.output().shapes {
        each_text(&clipped.shape, &mut |text| {
            let galley = &text.galley;
            all.push((galley.job.text.clone(), galley.rows.len(), galley.elided));
        });
    }
    all
}

/// Captions that are broken or cut.
fn faults(desk: &Desk) -> Vec<String> {
    let is_control = |role| matches!(role, Role::Button | Role::RadioButton | Role::CheckBox);
    let nodes = desk.nodes();
    let controls = nodes.iter().filter(|node| is_control(node.accesskit_node().role()));
    let names: BTreeSet<String> = controls.map(spoken).collect();
    let is_fault = |(text, n_rows, is_cut): &(String, usize, bool)| {
        *is_cut || (*n_rows > 1 && names.contains(text))
    };
    painted(desk).into_iter().filter(is_fault).map(|(text, _, _)| text).collect()
}

#[test]
fn no_caption_of_a_control_is_broken_or_cut() {
    let mut found = Vec::new();
    for (preset, size) in [
        (Preset::Rail, [1280.0, 800.0]),
        (Preset::Compare, [1280.0, 800.0]),
        (Preset::Lecture, [1024.0, 768.0]),
    ] {
        for language in Language::ALL {
            let mut desk = Desk::of(Harness::builder(), size);
            (desk.state_mut().view.preset, desk.state_mut().view.language) = (preset, language);
            for question in Question::all() {
                desk.open_scenario(&built_in(SCENES[0].1).unwrap());
                question.ask(&mut desk);
                assert!(painted(&desk).len() > 8);
                let of = |text| format!("{preset:?} {language:?} {}: {text}", question.name());
                found.extend(faults(&desk).into_iter().map(of));
            }
        }
    }
    assert_eq!(found, [""; 0]);
}

#[test]
fn everything_that_is_found_is_named_whole() {
    for language in Language::ALL {
        let mut desk = Desk::new();
        desk.state_mut().view.language = language;
        // Shorter names than these have room.
        let hits = find("", language);
        let long: Vec<_> = hits.iter().filter(|hit| hit.name.chars().count() > 36).collect();
        assert!(!long.is_empty());
        for hit in long {
            let search = Search { wanted: hit.name.clone(), chosen: 0 };
            desk.state_mut().view.dialog = Some(Dialog::Find(search));
            desk.run_steps(4);
            let texts = painted(&desk);
            assert!(texts.iter().any(|(text, ..)| *text == hit.name), "{}", hit.name);
            assert!(!texts.iter().any(|(.., is_cut)| *is_cut), "{}", hit.name);
        }
    }
}
