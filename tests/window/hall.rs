//! What a lecture has beside the window.

use crate::desk::Desk;
use eframe::egui::Key;

#[test]
fn the_notes_tell_this_step_and_the_next() {
    let mut desk = Desk::new();
    desk.press(Key::ArrowRight);
    let first = desk.sentence();
    desk.press(Key::ArrowRight);
    let second = desk.sentence();
    desk.tap(Key::ArrowLeft);
    assert!(!desk.texts().contains(&second));
    desk.tap(Key::P);
    desk.run_steps(3);
    assert!(desk.texts().iter().filter(|text| **text == first).count() >= 2);
    assert!(desk.texts().contains(&second));
    desk.tap(Key::P);
    desk.run_steps(3);
    assert!(!desk.texts().contains(&second));
}
