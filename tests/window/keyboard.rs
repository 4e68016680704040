//! A whole lecture by keyboard alone.

use crate::desk::{Desk, spoken};
use crate::files::type_path;
use eframe::egui::{Event, Key, Modifiers, accesskit::Role};
use egui_kittest::kittest::NodeT;
use octoscope::document::AnyDocument;
use octoscope::files::Purpose;
use octoscope::view::{Dialog, Preset};
use octoscope_core::query::Query;
use octoscope_core::text::Language;
use octoscope_core::traverse::Algorithm;
use octoscope_figure::Theme;
use std::fs;
use tempfile::tempdir;

impl Desk {
    /// Takes what is found by these words.
    fn find(&mut self, words: &str) {
        self.press_with(Modifiers::COMMAND, Key::K);
        self.event(Event::Text(words.to_owned()));
        self.run_steps(3);
        self.press(Key::Enter);
        self.state_mut().finish_work();
        self.run();
        assert_eq!(self.state().view.dialog, None, "{words}");
    }

    /// Presses Tab until a control of this role and name is focused.
    fn tab_to(&mut self, role: Role, name: &str) {
        let is_focused = |desk: &Self| {
            let nodes = desk.nodes();
            let found = nodes.iter().find(|node| node.accesskit_node().is_focused());
            found.is_some_and(|node| node.accesskit_node().role() == role && spoken(node) == name)
        };
        for _ in 0..200 {
            self.strike(Key::Tab);
            self.step();
            if is_focused(self) {
                return;
            }
        }
        panic!("{name} is not reached by Tab");
    }

    /// Steps to the end by the presenter's key; the number of sentences told.
    fn step_through(&mut self) -> usize {
        self.press(Key::Home);
        // Takes away what is said of the scene that was open before.
        self.press(Key::Escape);
        let n_steps = self.state().document().n_events();
        let mut sentences = vec![self.sentence()];
        for _ in 0..n_steps {
            self.strike(Key::PageDown);
            sentences.push(self.sentence());
        }
        assert_eq!(self.step_number(), n_steps);
        assert!(sentences.iter().all(|sentence| sentence.ends_with(['.', '!'])), "{sentences:?}");
        sentences.dedup();
        sentences.len()
    }
}

#[test]
fn a_whole_lecture_is_given_by_keyboard_alone() {
    let folder = tempdir().unwrap();
    let mut desk = Desk::new();

    // The hall: projector, German, the lecture's panels, larger type.
    for _ in Theme::ALL {
        if desk.state().view.theme != Theme::Projector {
            desk.press(Key::T);
        }
    }
    assert_eq!(desk.state().view.theme, Theme::Projector);
    desk.press(Key::L);
    assert_eq!(desk.state().view.language, Language::German);
    desk.press(Key::Num6);
    assert_eq!(desk.state().view.preset, Preset::Lecture);
    desk.press(Key::Plus);

    // A quadtree, stepped through; back and on; a blank screen for a question.
    desk.find("checker-cells");
    assert!(desk.step_through() > 100);
    desk.press(Key::PageUp);
    desk.press(Key::B);
    assert!(desk.state().view.blank);
    desk.press(Key::B);
    assert!(!desk.state().view.blank);
    desk.press(Key::ArrowUp);
    desk.press(Key::E);
    assert!(!desk.state().view.formulas);
    desk.press(Key::E);

    // Another algorithm, another ray: numbers are typed into the ray's fields.
    desk.find("samet");
    assert!(matches!(desk.plane().scenario.query, Query::Ray { algorithm: Algorithm::Samet, .. }));
    desk.press(Key::Q);
    desk.tab_to(Role::SpinButton, "Startpunkt x");
    desk.event(Event::Text("-1/4".to_owned()));
    desk.press(Key::Enter);
    assert_eq!(desk.plane().scenario.ray.origin()[0], -0.25);
    desk.press(Key::Escape);
    desk.press(Key::R);
    desk.press_with(Modifiers::COMMAND, Key::Z);
    desk.press(Key::Q);

    // A neighbour is asked for, and left again.
    desk.press(Key::Num1);
    desk.tab_to(Role::Button, "Nachbar");
    desk.press(Key::Space);
    assert!(matches!(desk.plane().scenario.query, Query::Neighbour { .. }));
    desk.press(Key::Escape);
    desk.press(Key::Escape);
    assert!(matches!(desk.plane().scenario.query, Query::Ray { .. }));

    // An octree from the front, a slice, the tree, a misprint and its first wrong step.
    desk.press(Key::Num6);
    desk.find("points-3d");
    assert!(matches!(desk.state().document(), AnyDocument::Space(_)));
    desk.press(Key::Y);
    desk.press(Key::K);
    assert!(desk.state().view.space_show.slice.is_some());
    assert!(desk.step_through() > 20);
    desk.press(Key::Num7);
    desk.find("b-2");
    desk.press(Key::W);
    let wrong = desk.step_number();
    assert!(wrong > 0);

    // The scene is kept, and the figure exported.
    type_path(&mut desk, Purpose::Save, &format!("{}/", folder.path().display()), "hall");
    assert!(fs::exists(folder.path().join("hall.octo")).unwrap());
    desk.press_with(Modifiers::COMMAND, Key::E);
    assert_eq!(desk.state().view.dialog, Some(Dialog::Export));
    desk.tap(Key::Escape);
    desk.run();
    assert_eq!(desk.state().view.dialog, None);
}

#[test]
fn letters_are_commands_also_while_a_control_has_the_focus() {
    let mut desk = Desk::new();
    desk.press(Key::Tab);
    assert!(desk.ctx.memory(|memory| memory.focused().is_some()));
    desk.press(Key::B);
    assert!(desk.state().view.blank);
}
