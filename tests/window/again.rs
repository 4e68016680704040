//! What was open last, when the window is opened again.

use crate::desk::{Desk, Storage, sample};
use eframe::egui::{Context, Key, Modifiers};
use octoscope::app::App;
use octoscope::document::AnyDocument;
use octoscope::files::{Chosen, Purpose};
use octoscope::view::Dialog;
use std::fs;
use std::path::Path;
use tempfile::tempdir;

/// The window on a copy of `name` in `folder`, with the picture that it may need.
fn on_copy(folder: &Path, name: &str) -> Desk {
    for name in ["landscape.png", name] {
        fs::copy(sample(name), folder.join(name)).unwrap();
    }
    let desk = Desk::with_file(folder.join(name));
    assert_eq!(desk.state().view.dialog, None);
    desk
}

#[test]
fn the_window_goes_on_where_it_was_left() {
    let mut desk = Desk::with_file(sample("lecture.octo"));
    desk.press(Key::End);
    desk.press(Key::ArrowLeft);
    let left = desk.left();
    let again = Desk::started(&left);
    assert_eq!(again.plane().scenario, desk.plane().scenario);
    assert_eq!(again.step_number(), desk.step_number());
    assert!(!again.state().is_changed());
    assert_eq!(Desk::started(&left).left(), left);
}

#[test]
fn changes_and_the_file_that_lacks_them_are_known_after_a_start() {
    let folder = tempdir().unwrap();
    let mut desk = on_copy(folder.path(), "lecture.octo");
    let path = folder.path().join("lecture.octo");
    desk.press(Key::R);
    let mut again = Desk::started(&desk.left());
    assert!(again.state().is_changed());
    assert_eq!(again.plane().scenario, desk.plane().scenario);
    assert_eq!(again.plane().path.as_ref(), Some(&path));

    let before = fs::read(&path).unwrap();
    again.press_with(Modifiers::COMMAND, Key::S);
    again.state_mut().finish_work();
    assert_ne!(fs::read(&path).unwrap(), before);
    assert!(!again.state().is_changed());
    assert!(!Desk::started(&again.left()).state().is_changed());
}

#[test]
fn what_has_no_file_yet_is_still_marked_after_a_start() {
    let mut desk = Desk::new();
    let opened = desk.plane().scenario;
    desk.press(Key::R);
    let mut again = Desk::started(&desk.left());
    assert!(again.state().is_changed());
    let AnyDocument::Plane(document) = again.state_mut().document_mut() else { panic!() };
    document.scenario = opened;
    again.run();
    assert!(!again.state().is_changed());
}

#[test]
fn what_cannot_be_opened_now_is_opened_when_it_is_there_again() {
    let folder = tempdir().unwrap();
    let left = on_copy(folder.path(), "knot.obj").left();
    fs::remove_file(folder.path().join("knot.obj")).unwrap();
    let mut without = Desk::started(&left);
    assert!(without.says("knot.obj"), "{:?}", without.texts());
    let left = without.left();
    fs::copy(sample("knot.obj"), folder.path().join("knot.obj")).unwrap();
    assert!(Desk::started(&left).space().tree.n_leaves() > 100);

    // What is made instead is what is open last.
    fs::remove_file(folder.path().join("knot.obj")).unwrap();
    without.press(Key::R);
    assert!(Desk::started(&without.left()).state().is_changed());
}

#[test]
fn a_start_that_ends_at_once_forgets_nothing() {
    let left = Desk::with_file(sample("knot.obj")).left();
    assert_eq!(Desk::left_at_once(&left), left);
}

#[test]
fn what_is_given_up_is_opened_by_the_next_start() {
    // Cancelled or not: it may be there before.
    let left = Desk::with_file(sample("knot.obj")).left();
    let mut desk = Desk::starting(&left);
    desk.state().give_up_opening();
    desk.state_mut().finish_work();
    desk.run();
    assert_eq!(desk.state().view.dialog, None);
    assert_eq!(desk.left(), left);
}

#[test]
fn a_start_on_a_file_that_does_not_open_brings_what_was_open_last() {
    for is_changed in [false, true] {
        let mut before = Desk::started_on(&Storage::default(), "scene:points-3d");
        if is_changed {
            before.press(Key::R);
        }
        let left = before.left();
        let mut desk = Desk::started_on(&left, "typo.octo");
        assert!(matches!(desk.state().view.dialog, Some(Dialog::Error(_))));
        assert!(desk.says("typo.octo"), "{:?}", desk.texts());
        desk.press(Key::Escape);
        assert_eq!(desk.space().scenario, before.space().scenario);
        assert_eq!(desk.state().is_changed(), is_changed);
        let scenario = |left| octoscope::save::remembered(left).map(|last| last.scenario);
        assert_eq!(scenario(&desk.left()), scenario(&left));
    }
}

#[test]
fn a_start_on_a_file_keeps_what_no_file_has() {
    let mut before = Desk::started_on(&Storage::default(), "scene:points-3d");
    before.press(Key::R);
    let mut desk = Desk::started_on(&before.left(), "scene:quadtree-82");
    assert_eq!(desk.plane().tree.n_leaves(), 97);
    assert!(desk.says("Ctrl+Z brings it back"), "{:?}", desk.texts());
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(desk.space().scenario, before.space().scenario);
}

#[test]
fn a_start_on_a_file_keeps_what_no_file_has_until_it_opens_again() {
    let folder = tempdir().unwrap();
    let data = folder.path().join("knot.obj");
    let mut before = on_copy(folder.path(), "knot.obj");
    before.press(Key::R);
    let left = before.left();
    fs::remove_file(&data).unwrap();

    let mut meanwhile = Desk::started_on(&left, "scene:quadtree-82");
    assert_eq!(meanwhile.plane().tree.n_leaves(), 97);
    assert!(meanwhile.says("knot.obj"), "{:?}", meanwhile.texts());
    assert_eq!(meanwhile.left(), left);
    meanwhile.open("typo.octo");
    meanwhile.press(Key::Escape);
    assert_eq!(meanwhile.plane().tree.n_leaves(), 97);

    fs::copy(sample("knot.obj"), &data).unwrap();
    let again = Desk::started(&meanwhile.left());
    assert_eq!(again.space().scenario, before.space().scenario);
    assert!(again.state().is_changed());
}

#[test]
fn what_is_opened_while_the_last_comes_back_does_not_lose_it() {
    let mut before = Desk::with_file(sample("knot.obj"));
    before.press(Key::R);
    let left = before.left();
    let meanwhile = |path: &Path| {
        let open = |app: &mut App| app.open(&Context::default(), path.to_owned());
        let mut desk = Desk::starting_with(&left, open);
        desk.state_mut().finish_work();
        desk.run();
        desk
    };
    assert_eq!(meanwhile(&sample("lecture.octo")).left(), left);
    // What cannot be opened brings it back.
    let failed = meanwhile(Path::new("typo.octo"));
    assert_eq!(failed.space().scenario, before.space().scenario);
}

#[test]
fn a_start_on_a_file_is_not_undone() {
    let mut desk = Desk::started_on(&Storage::default(), "scene:points-3d");
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(desk.space().tree.n_leaves(), 323);
    // What is opened after it is.
    desk.open(sample("lecture.octo"));
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(desk.space().tree.n_leaves(), 323);
}

#[test]
fn what_is_changed_before_it_is_there_can_be_brought_back() {
    let left = Desk::with_file(sample("knot.obj")).left();
    let mut changed = None;
    let mut desk = Desk::starting_with(&left, |app| {
        let AnyDocument::Plane(document) = app.document_mut() else { panic!() };
        document.reverse_ray();
        changed = Some(document.scenario);
    });
    desk.state_mut().finish_work();
    desk.run();
    assert!(desk.space().tree.n_leaves() > 100);
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(Some(desk.plane().scenario), changed);
}

#[test]
fn what_is_kept_meanwhile_is_what_is_kept_at_the_end() {
    let mut desk = Desk::with_file(sample("lecture.octo"));
    desk.press(Key::R);
    desk.press(Key::ArrowRight);
    let context = desk.ctx.clone();
    let mut meanwhile = Storage::default();
    desk.state_mut().begin_to_keep(&context);
    desk.state_mut().finish_keeping(&mut meanwhile);
    assert_eq!(meanwhile, desk.left());
}

#[test]
fn folders_are_remembered_whole() {
    let mut desk = Desk::with_file("assets/scenes/knot.obj");
    let last = octoscope::save::remembered(&desk.left()).unwrap();
    assert!(last.folder.is_absolute(), "{last:?}");
}

#[test]
fn the_next_start_tells_what_could_not_be_saved_while_the_window_closed() {
    let folder = tempdir().unwrap();
    let mut desk = Desk::new();
    let context = desk.ctx.clone();
    let path = folder.path().join("none").join("kept.octo");
    desk.state_mut().take_chosen(&context, Chosen::Path(Purpose::Save, path));
    // Saving may have failed already: then this window shows it.
    let was_told = desk.state().view.dialog.is_some();
    let mut next = Desk::started(&desk.left());
    assert_ne!(next.state().view.dialog.is_some(), was_told);
    // It is told once.
    assert_eq!(Desk::started(&next.left()).state().view.dialog, None);

    let untold = "no space is left";
    desk.state_mut().view.untold = Some(untold.to_owned());
    assert!(Desk::started(&desk.left()).says(untold));
}
