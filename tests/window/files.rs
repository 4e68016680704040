//! Files, opened as a user opens them.

use crate::desk::{Desk, sample};
use crate::drawn::plane;
use eframe::egui::{self, Key, Modifiers};
use octoscope::files::{Chosen, Purpose};
use octoscope::view::{Dialog, Typed};
use octoscope_core::scenario::Source;
use octoscope_core::scene::Content;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tempfile::tempdir;

#[test]
fn a_picture_opens_as_a_quadtree_and_is_traced() {
    let desk = Desk::with_file(sample("landscape.png"));
    assert_eq!(desk.state().view.dialog, None);
    assert!(matches!(*desk.plane().content, Content::Image(_)));
    assert!(desk.plane().tree.n_leaves() > 100);
    assert!(desk.plane().trace.leaves().count() > 4);
    assert!(desk.says("landscape.png"));
}

#[test]
fn a_mesh_opens_as_an_octree_and_is_traced() {
    let mut desk = Desk::with_file(sample("knot.obj"));
    assert_eq!(desk.state().view.dialog, None);
    assert!(matches!(*desk.space().content, Content::Triangles(_)));
    assert!(desk.space().tree.n_leaves() > 100);
    desk.press(Key::Home);
    let sentence = desk.sentence();
    desk.press(Key::End);
    assert_ne!(desk.sentence(), sentence);
}

#[test]
fn every_sample_opens() {
    let mut desk = Desk::new();
    let folder = sample("");
    let mut opened = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let ending = path.extension().unwrap().to_str().unwrap().to_owned();
        // Cells and rays are for the command line.
        if ["md", "cells", "rays"].contains(&ending.as_str()) {
            continue;
        }
        desk.open(&path);
        assert_eq!(desk.state().view.dialog, None, "{}", path.display());
        opened += 1;
    }
    assert!(opened > 5, "{opened}");
}

#[test]
fn an_opened_file_is_undone_like_any_change() {
    let mut desk = Desk::new();
    let leaves = desk.plane().tree.n_leaves();
    desk.open(sample("knot.obj"));
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(desk.plane().tree.n_leaves(), leaves);
    desk.press_with(Modifiers::COMMAND, Key::Y);
    assert!(desk.space().tree.n_leaves() > 100);
}

#[test]
fn changes_that_no_file_has_are_marked_until_they_are_saved_or_taken_back() {
    let folder = tempdir().unwrap();
    let mut desk = Desk::new();
    let is_marked = |desk: &Desk| {
        assert_eq!(desk.state().is_changed(), desk.says("leaves *"));
        desk.state().is_changed()
    };
    assert!(!is_marked(&desk));
    desk.press(Key::ArrowRight);
    assert!(!is_marked(&desk), "stepping changes nothing");
    desk.press(Key::R);
    assert!(is_marked(&desk));
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert!(!is_marked(&desk));

    desk.press(Key::R);
    type_path(&mut desk, Purpose::Save, &format!("{}/", folder.path().display()), "kept");
    assert!(!is_marked(&desk));
    desk.press(Key::R);
    assert!(is_marked(&desk));
    desk.open(sample("knot.obj"));
    assert!(!is_marked(&desk));
    assert!(desk.says("Ctrl+Z brings it back"), "{:?}", desk.texts());
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert!(is_marked(&desk));
}

#[test]
fn undo_leaves_what_the_scenario_is_saved_to() {
    let folder = tempdir().unwrap();
    let begin = format!("{}/", folder.path().display());
    let [first, second] = ["first.octo", "second.octo"].map(|name| folder.path().join(name));
    let mut desk = Desk::new();
    type_path(&mut desk, Purpose::Save, &begin, "first");
    desk.open(&first);
    desk.press(Key::R);
    type_path(&mut desk, Purpose::Save, &begin, "second");
    let saved = [&first, &second].map(|path| fs::read(path).unwrap());
    assert_ne!(saved[0], saved[1]);
    desk.press(Key::R);
    desk.press(Key::R);
    for _ in 0..3 {
        desk.press_with(Modifiers::COMMAND, Key::Z);
    }
    assert_eq!(desk.plane().path.as_ref(), Some(&second));
    desk.press_with(Modifiers::COMMAND, Key::S);
    desk.state_mut().finish_work();
    assert_eq!(fs::read(&first).unwrap(), saved[0]);
    assert_eq!(fs::read(&second).unwrap(), saved[0], "as the first was");
}

#[test]
fn a_built_in_scene_that_was_saved_keeps_its_file_when_it_is_undone() {
    let folder = tempdir().unwrap();
    let mut desk = Desk::new();
    desk.press(Key::R);
    type_path(&mut desk, Purpose::Save, &format!("{}/", folder.path().display()), "scene");
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(desk.plane().path, Some(folder.path().join("scene.octo")));
}

#[test]
fn a_broken_file_is_one_message_and_the_old_scene_stays() {
    let folder = tempdir().unwrap();
    let picture = fs::read(sample("landscape.png")).unwrap();
    let files: [(&str, &[u8]); 6] = [
        ("empty.png", b""),
        ("cut.png", &picture[..picture.len() / 2]),
        ("other.png", b"v 0 0 0\nv 1 0 0\nf 1 2 3\n"),
        ("empty.obj", b""),
        ("hole.obj", b"v 0 0 0\nf 1 2 3\n"),
        ("unknown.ending", b"?"),
    ];
    let mut desk = Desk::new();
    let (scene, texts) = (desk.plane().scenario, desk.texts());
    for (name, bytes) in files {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        desk.open(&path);
        let Some(Dialog::Error(message)) = desk.state().view.dialog.clone() else {
            panic!("{name} was not refused");
        };
        assert!(message.contains(name), "{message}");
        assert!(desk.says(&message));
        assert_eq!(desk.plane().scenario, scene, "{name}");
        desk.press(Key::Escape);
        assert_eq!(desk.state().view.dialog, None);
        assert_eq!(desk.texts(), texts, "{name}");
    }
    desk.open(folder.path().join("missing.png"));
    assert!(matches!(desk.state().view.dialog, Some(Dialog::Error(_))));
}

/// Asks for a path as where the system has no dialog, types `end` behind `path`
/// and confirms.
pub fn type_path(desk: &mut Desk, purpose: Purpose, path: &str, end: &str) {
    let typed = Typed::new(purpose, path.to_owned());
    desk.state_mut().view.dialog = Some(Dialog::Path(typed));
    desk.run();
    desk.event(egui::Event::Text(end.to_owned()));
    desk.press(Key::Enter);
    desk.state_mut().finish_work();
    desk.run();
}

#[test]
fn a_typed_path_is_saved_to_and_a_file_replaced_only_when_confirmed() {
    let folder = tempdir().unwrap();
    let begin = format!("{}/", folder.path().display());
    let path = folder.path().join("new.octo");
    let mut desk = Desk::new();
    type_path(&mut desk, Purpose::Save, &begin, "new");
    assert_eq!(desk.state().view.dialog, None, "{:?}", desk.texts());
    assert!(desk.says("Saved as new.octo"));
    let before = fs::read(&path).unwrap();

    desk.press(Key::R);
    type_path(&mut desk, Purpose::Save, &begin, "new.octo");
    assert!(desk.says("Replace it?"));
    assert_eq!(fs::read(&path).unwrap(), before);
    desk.press(Key::Enter);
    desk.state_mut().finish_work();
    assert_eq!(desk.state().view.dialog, None);
    assert_ne!(fs::read(&path).unwrap(), before);
}

#[test]
fn a_path_of_which_nothing_comes_stays_to_be_corrected() {
    let folder = tempdir().unwrap();
    let begin = format!("{}/", folder.path().display());
    for (purpose, end, wrong) in [
        (Purpose::Save, "none/a.octo", "no such folder"),
        (Purpose::Open, "none.octo", "no such file"),
    ] {
        let mut desk = Desk::new();
        let before = desk.plane().scenario;
        type_path(&mut desk, purpose, &begin, end);
        let Some(Dialog::Path(typed)) = desk.state().view.dialog.clone() else {
            panic!("{:?}", desk.state().view.dialog);
        };
        assert_eq!((typed.purpose, typed.path), (purpose, format!("{begin}{end}")));
        assert!(desk.says(wrong), "{:?}", desk.texts());
        assert_eq!(desk.plane().scenario, before);
        // What is typed now replaces the name, and with it goes what was wrong.
        desk.event(egui::Event::Text("other".to_owned()));
        desk.run();
        assert!(!desk.says(wrong));
        let Some(Dialog::Path(typed)) = &desk.state().view.dialog else { panic!() };
        assert!(typed.path.ends_with("/other.octo"), "{}", typed.path);
    }
}

/// The window on so many points that printing them takes many frames.
fn with_many_points(folder: &Path) -> Desk {
    let many = plane("quadtree-82", |scenario| {
        let points = (0..60_000u32).map(|n| [f64::from(n % 250), f64::from(n / 250)]);
        let points = points.map(|point| point.map(|x| (x + 0.25) / 256.0)).collect();
        scenario.source = Source::Inline(Content::Points(points));
        scenario.recipe.depth = 4;
    });
    let path = folder.join("many.octo");
    fs::write(&path, many.print()).unwrap();
    Desk::with_file(path)
}

#[test]
fn what_is_changed_while_much_is_saved_is_saved_the_next_time() {
    let folder = tempdir().unwrap();
    let mut desk = with_many_points(folder.path());
    let saved = || Desk::with_file(folder.path().join("many.octo")).plane().scenario.ray;
    desk.press(Key::R);
    let asked = desk.plane().scenario.ray;
    desk.key_press_modifiers(Modifiers::COMMAND, Key::S);
    desk.step();
    desk.key_press(Key::R);
    desk.step();
    desk.state_mut().finish_work();
    desk.step();
    assert_eq!(saved(), asked);
    assert!(desk.state().is_changed());

    // Twice at once: one after the other, and the last one stays.
    for _ in 0..2 {
        desk.key_press_modifiers(Modifiers::COMMAND, Key::S);
        desk.step();
    }
    desk.state_mut().finish_work();
    assert!(!desk.state().is_changed());
    assert_eq!(saved(), desk.plane().scenario.ray);
}

#[test]
fn what_is_saved_is_what_was_there_when_it_was_asked_for() {
    let folder = tempdir().unwrap();
    let mut desk = with_many_points(folder.path());
    let direction = desk.plane().scenario.ray.direction();
    let tap = |desk: &mut Desk, modifiers, key| {
        desk.key_press_modifiers(modifiers, key);
        desk.step();
    };
    // The second one waits for the first, and the last change is not saved.
    for _ in 0..2 {
        tap(&mut desk, Modifiers::NONE, Key::R);
        tap(&mut desk, Modifiers::COMMAND, Key::S);
    }
    tap(&mut desk, Modifiers::NONE, Key::R);
    desk.state_mut().finish_work();
    desk.step();
    assert!(desk.state().is_changed());
    let saved = Desk::with_file(folder.path().join("many.octo"));
    assert_eq!(saved.plane().scenario.ray.direction(), direction);
}

#[test]
fn a_window_that_is_closed_has_saved_what_it_was_to_save() {
    let folder = tempdir().unwrap();
    let mut desk = with_many_points(folder.path());
    desk.press(Key::R);
    let ray = desk.plane().scenario.ray;
    desk.key_press_modifiers(Modifiers::COMMAND, Key::S);
    desk.step();
    eframe::App::on_exit(desk.state_mut());
    let saved = Desk::with_file(folder.path().join("many.octo"));
    assert_eq!(saved.plane().scenario.ray, ray);
}

#[test]
fn a_chosen_name_gets_its_ending_and_replaces_nothing_unasked() {
    let folder = tempdir().unwrap();
    let chosen = |purpose, name: &str| Chosen::Path(purpose, folder.path().join(name));
    let mut desk = Desk::new();
    let context = desk.ctx.clone();
    desk.state_mut().take_chosen(&context, chosen(Purpose::Save, "version 1.2"));
    desk.state_mut().finish_work();
    desk.run();
    let path = folder.path().join("version 1.2.octo");
    let saved = fs::read(&path).unwrap();
    assert_eq!(desk.plane().path.as_ref(), Some(&path));

    desk.press(Key::R);
    desk.state_mut().take_chosen(&context, chosen(Purpose::Save, "version 1.2"));
    desk.run();
    assert!(desk.says("Replace it?"));
    assert_eq!(fs::read(&path).unwrap(), saved);
    desk.press(Key::Escape);
    // The system's dialog has asked about this name.
    desk.state_mut().take_chosen(&context, chosen(Purpose::Save, "version 1.2.octo"));
    desk.state_mut().finish_work();
    assert_ne!(fs::read(&path).unwrap(), saved);

    let figure = folder.path().join("figure.svg");
    fs::write(&figure, "old").unwrap();
    desk.state_mut().take_chosen(&context, chosen(Purpose::Export("svg"), "figure"));
    desk.run();
    assert!(desk.says("Replace it?"));
    assert_eq!(fs::read(&figure).unwrap(), b"old");
}

#[test]
fn a_typed_path_is_exported_to_in_its_format_and_opened() {
    let folder = tempdir().unwrap();
    let begin = format!("{}/", folder.path().display());
    let mut desk = Desk::new();
    type_path(&mut desk, Purpose::Export("svg"), &begin, "figure");
    let context = desk.ctx.clone();
    desk.state_mut().finish_export(&context);
    desk.run();
    let path = folder.path().join("figure.svg");
    assert!(desk.says(&format!("Exported as {}", path.display())), "{:?}", desk.texts());
    assert!(fs::read_to_string(folder.path().join("figure.svg")).unwrap().contains("<svg"));

    type_path(&mut desk, Purpose::Open, &sample("").display().to_string(), "knot.obj");
    desk.state_mut().finish_work();
    desk.run();
    assert!(desk.space().tree.n_leaves() > 100);
}

#[test]
fn keys_do_nothing_behind_a_message() {
    let mut desk = Desk::new();
    desk.press(Key::Home);
    desk.state_mut().view.dialog = Some(Dialog::Keys);
    desk.press(Key::ArrowRight);
    assert_eq!(desk.step_number(), 0);
    desk.press(Key::Escape);
    desk.press(Key::ArrowRight);
    assert_eq!(desk.step_number(), 1);
}

#[test]
fn a_file_dropped_on_the_window_opens() {
    let mut desk = Desk::new();
    desk.input_mut().dropped_files.push(Arc::new(Dropped(sample("knot.obj"))));
    desk.step();
    desk.state_mut().finish_work();
    desk.run();
    assert!(desk.space().tree.n_leaves() > 100);
}

#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        fs::read(&self.0).map_err(|error| error.to_string())
    }
}

#[test]
fn a_recipe_that_the_sliders_do_not_reach_stays_as_the_file_has_it() {
    let mut desk = Desk::new();
    desk.open_scenario(&plane("quadtree-82", |scenario| scenario.recipe.capacity = 200));
    assert_eq!(desk.plane().scenario.recipe.capacity, 200);
    assert!(!desk.state().is_changed());
}
