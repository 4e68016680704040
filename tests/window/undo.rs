//! What one step of undo takes back.

use crate::desk::Desk;
use eframe::egui::{Event, Key, Modifiers, accesskit::Role, vec2};

/// Types letter by letter into the field of this name, which keeps the keys.
fn begin(desk: &mut Desk, name: &str, typed: &str) {
    desk.click(Role::SpinButton, name);
    for letter in typed.chars() {
        desk.event(Event::Text(letter.to_string()));
        desk.run();
    }
}

/// Leaves the field by a key, and the one that has the keys then.
fn leave(desk: &mut Desk, key: Key) {
    desk.press(key);
    desk.state_mut().finish_work();
    desk.run();
    if desk.ctx.text_edit_focused() {
        desk.press(Key::Escape);
    }
}

/// Number of times that something can be undone.
fn n_undone(desk: &mut Desk) -> usize {
    let mut n = 0;
    loop {
        let before = (desk.plane().scenario, *desk.state().view.show::<2>());
        desk.press_with(Modifiers::COMMAND, Key::Z);
        desk.state_mut().finish_work();
        desk.run();
        if before == (desk.plane().scenario, *desk.state().view.show::<2>()) {
            return n;
        }
        n += 1;
    }
}

#[test]
fn what_is_typed_into_a_field_is_undone_at_once() {
    for (name, typed) in
        [("origin x", "0.375"), ("direction y", "-3/4"), ("depth", "12"), ("capacity", "11")]
    {
        for end in [Key::Enter, Key::Tab] {
            let mut desk = Desk::new();
            let before = desk.plane().scenario;
            begin(&mut desk, name, typed);
            leave(&mut desk, end);
            assert_ne!(desk.plane().scenario, before, "{name}");
            assert_eq!(n_undone(&mut desk), 1, "{name} {end:?}");
            assert_eq!(desk.plane().scenario, before, "{name}");
        }
    }
}

#[test]
fn what_is_given_up_or_refused_is_nothing_to_undo() {
    for end in [Key::Escape, Key::Tab] {
        let mut desk = Desk::new();
        begin(&mut desk, "origin x", "0.5x");
        leave(&mut desk, end);
        assert_eq!(n_undone(&mut desk), 0, "{end:?}");
    }
}

#[test]
fn fields_that_are_gone_through_are_undone_one_after_the_other() {
    let mut desk = Desk::new();
    begin(&mut desk, "origin x", "0.375");
    desk.key_press(Key::Tab);
    desk.event(Event::Text("2".to_owned()));
    desk.run();
    leave(&mut desk, Key::Enter);
    let ray = desk.plane().scenario.ray;
    assert_eq!((ray.origin()[0], ray.direction()[0]), (0.375, 2.0));
    assert_eq!(n_undone(&mut desk), 2);
}

#[test]
fn a_drag_after_an_edit_is_another_step() {
    let mut desk = Desk::new();
    begin(&mut desk, "origin y", "0.25");
    let tip = desk.tip_handle();
    desk.drag([tip, tip + vec2(-60.0, 20.0)], Modifiers::NONE);
    assert_eq!(n_undone(&mut desk), 2);
}
