//! Every algorithm is chosen, stepped through and explained.

use crate::desk::{Desk, sample};
use crate::lecture::each_text;
use crate::states::Question;
use eframe::egui::Key;
use eframe::egui::accesskit::{Role, Toggled};
use eframe::egui::epaint::ClippedShape;
use egui_kittest::kittest::{NodeT, Queryable};
use octoscope_core::explain::algorithm_name;
use octoscope_core::query::Query;
use octoscope_core::text::Language;
use octoscope_core::traverse::Algorithm;

impl Desk {
    /// Chooses an algorithm from the menu, by its name in `language`.
    fn choose_algorithm(&mut self, algorithm: Algorithm, language: Language) {
        let combo = self.get_all_by_role(Role::ComboBox).last().unwrap();
        combo.click();
        self.run();
        self.click(Role::Button, &algorithm_name(algorithm, language));
    }
}

/// The title of the panel that is peculiar to an algorithm, and words in it once
/// all steps are done.
fn peculiar(algorithm: Algorithm) -> Option<[&'static str; 2]> {
    match algorithm {
        Algorithm::Parametric
        | Algorithm::ParametricTable
        | Algorithm::Esvo
        | Algorithm::Codes
        | Algorithm::Exhaustive => None,
        Algorithm::AllChildren => Some(["Every child", "missed"]),
        Algorithm::Hero | Algorithm::Gargantini => Some(["Cuts", "piece of t"]),
        Algorithm::Glassner => Some(["Way from the root", "exit point"]),
        Algorithm::Samet | Algorithm::SametCorner => Some(["Neighbour tables", "way up"]),
        Algorithm::SametNet => Some(["Links", "border"]),
        Algorithm::Bsp => Some(["Halving", "half only"]),
        Algorithm::Dda | Algorithm::DdaOctree => Some(["Finest grid", "through plane"]),
    }
}

#[test]
fn every_algorithm_is_chosen_and_stepped_to_the_end_and_back() {
    let mut desk = Desk::new();
    for algorithm in Algorithm::ALL {
        if algorithm != Algorithm::default() {
            desk.choose_algorithm(algorithm, Language::English);
        }
        let chosen = &desk.plane().scenario.query;
        assert!(matches!(chosen, Query::Ray { algorithm: a, .. } if *a == algorithm), "{chosen:?}");
        desk.press(Key::Home);
        let length = desk.plane().trace.events.len();
        let mut sentences = Vec::new();
        for _ in 0..5 {
            sentences.push(desk.sentence());
            desk.press(Key::ArrowRight);
        }
        for sentence in sentences.iter().rev() {
            desk.press(Key::ArrowLeft);
            assert_eq!(&desk.sentence(), sentence, "{algorithm:?}");
        }
        desk.press(Key::End);
        assert_eq!(desk.step_number(), length);
        if let Some([title, words]) = peculiar(algorithm) {
            assert!(desk.says(&format!("Panel {title}")), "{algorithm:?}: {title}");
            // The last step may have left the node that the panel is about.
            let shown = (0..8).any(|_| {
                let shown = desk.says(words);
                desk.press(Key::ArrowLeft);
                shown
            });
            assert!(shown, "{algorithm:?}: {words}");
        }
    }
}

#[test]
fn every_algorithm_is_stepped_through_in_space() {
    let mut desk = Desk::with_file(sample("knot.octo"));
    for algorithm in Algorithm::ALL.into_iter().filter(|a| peculiar(*a).is_some()) {
        desk.choose_algorithm(algorithm, Language::English);
        desk.press(Key::Home);
        (0..8).for_each(|_| desk.press(Key::ArrowRight));
        desk.press(Key::End);
        assert_eq!(desk.step_number(), desk.space().trace.events.len(), "{algorithm:?}");
    }
}

#[test]
fn a_variant_changes_the_trace_and_leaves_with_its_algorithm() {
    let mut desk = Desk::new();
    desk.type_into("origin x", "-0.25");
    desk.type_into("origin y", "-0.25");
    desk.type_into("direction x", "1");
    desk.type_into("direction y", "1");
    let before = desk.plane().trace.clone();
    desk.click(Role::Button, "Rules");
    desk.click(Role::CheckBox, "one plane at a time");
    assert_ne!(desk.plane().trace.events, before.events);
    desk.press(Key::Escape);
    desk.choose_algorithm(Algorithm::Hero, Language::English);
    assert!(desk.plane().scenario.query.variants().is_empty());
    desk.choose_algorithm(Algorithm::Bsp, Language::English);
    desk.click(Role::Button, "Rules");
    assert!(desk.query_by_role_and_label(Role::CheckBox, "one plane at a time").is_none());
    assert!(desk.query_by_role_and_label(Role::CheckBox, "compare as in the gem").is_some());
}

#[test]
fn the_menu_names_groups_of_algorithms() {
    let mut desk = Desk::new();
    let combo = desk.get_all_by_role(Role::ComboBox).last().unwrap();
    combo.click();
    desk.run();
    for group in ["Top-down", "Bottom-up, from leaf to leaf", "On the finest grid", "Reference"] {
        assert!(desk.says(group), "{group}");
    }
}

#[test]
fn panels_of_algorithms_speak_german() {
    let mut desk = Desk::new();
    desk.state_mut().view.language = Language::German;
    desk.run();
    for (algorithm, title) in [
        (Algorithm::Hero, "Schnitte"),
        (Algorithm::AllChildren, "Jedes Kind"),
        (Algorithm::Glassner, "Weg von der Wurzel"),
        (Algorithm::Samet, "Nachbartabellen"),
        (Algorithm::SametNet, "Verweise"),
        (Algorithm::Bsp, "Halbieren"),
        (Algorithm::Dda, "Feinstes Raster"),
    ] {
        desk.choose_algorithm(algorithm, Language::German);
        assert!(desk.says(&format!("Tafel {title}")), "{title}");
    }
}

#[test]
fn the_tables_are_shown_for_all_directions() {
    let mut desk = Desk::new();
    desk.choose_algorithm(Algorithm::Samet, Language::English);
    desk.press(Key::Home);
    let shown = (0..60).any(|_| {
        desk.press(Key::ArrowRight);
        desk.says("REFLECT")
    });
    assert!(shown);
    desk.get_by_label("All directions").click();
    desk.run();
    desk.click(Role::Button, "REFLECT");
    // Eight directions, each by its axes with their signs.
    for direction in ["−x−y", "−x", "−x+y", "−y", "+y", "+x−y", "+x", "+x+y"] {
        assert!(desk.texts().iter().any(|text| text == direction), "{direction}");
    }
}

#[test]
fn the_gem_is_explained_by_what_it_compares() {
    let mut desk = Desk::new();
    desk.choose_algorithm(Algorithm::Bsp, Language::English);
    desk.click(Role::Button, "Rules");
    desk.click(Role::CheckBox, "compare as in the gem");
    desk.press(Key::Escape);
    for (axis, origin, direction) in [("x", "0.5", "-1"), ("y", "0.3", "0")] {
        desk.type_into(&format!("origin {axis}"), origin);
        desk.type_into(&format!("direction {axis}"), direction);
    }
    let shows = |desk: &mut Desk, words: &str| {
        desk.press(Key::Home);
        (0..20).any(|_| {
            desk.press(Key::ArrowRight);
            desk.says(words)
        })
    };
    // The plane of the origin has t = −0.
    assert!(shows(&mut desk, "The gem: t is neither greater than the end"));
    desk.type_into("direction y", "1");
    desk.type_into("direction x", "0");
    assert!(shows(&mut desk, "The gem: t is no number"));
}

#[test]
fn the_rail_says_that_a_tested_leaf_is_missed() {
    let mut desk = Desk::new();
    desk.choose_algorithm(Algorithm::Exhaustive, Language::English);
    desk.press(Key::Home);
    let missed = (0..20).any(|_| {
        desk.press(Key::ArrowRight);
        desk.sentence().ends_with("is not met by the ray.")
    });
    assert!(missed && desk.says("t-rail: exit ") && desk.says(": missed"));
}

#[test]
fn the_oracle_is_shown_as_exact_and_offers_nothing_else() {
    let mut desk = Desk::new();
    let offers = |desk: &Desk| {
        ["doubles", "exact"].map(|name| {
            let node = desk.query_by_role_and_label(Role::Button, name)?;
            Some(node.accesskit_node().toggled() == Some(Toggled::True))
        })
    };
    assert_eq!(offers(&desk), [Some(true), Some(false)]);
    desk.choose_algorithm(Algorithm::Exhaustive, Language::English);
    assert_eq!(offers(&desk), [None, None]);
    assert!(desk.query_by_role_and_label(Role::Label, "exact").is_some());
    desk.choose_algorithm(Algorithm::Parametric, Language::English);
    assert_eq!(offers(&desk), [Some(true), Some(false)], "what was chosen before");
}

#[test]
fn the_name_of_every_algorithm_is_shown_whole() {
    let mut desk = Desk::new();
    for language in Language::ALL {
        desk.state_mut().view.language = language;
        for algorithm in Algorithm::ALL {
            Question::Ray(algorithm).ask(&mut desk);
            let name = algorithm_name(algorithm, language);
            let mut shown = Vec::new();
            for ClippedShape { shape, .. } in &desk.output().shapes {
                each_text(shape, &mut |text| {
                    if text.galley.job.text == name {
                        shown.push(!text.galley.elided);
                    }
                });
            }
            assert!(
                !shown.is_empty() && shown.iter().all(|is_whole| *is_whole),
                "{name} {shown:?}"
            );
        }
    }
}
