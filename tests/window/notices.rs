//! Lines that say what has just happened.

use crate::desk::Desk;
use eframe::egui::{Key, accesskit::Role};
use egui_kittest::kittest::Queryable;
use octoscope_core::gallery::Degenerate;
use octoscope_core::text::Language;

#[test]
fn a_notice_goes_away_by_itself() {
    let mut desk = Desk::new();
    desk.press(Key::G);
    let text = Degenerate::ALL[0].watch(Language::English);
    assert!(desk.says(&text));
    for (secs, shown) in [(4.0, true), (60.0, false)] {
        let now = desk.ctx.input(|input| input.time);
        desk.input_mut().time = Some(now + secs);
        desk.run_steps(2);
        assert_eq!(desk.says(&text), shown, "after {secs} s");
    }
}

#[test]
fn a_notice_goes_away_when_it_is_true_no_more() {
    let mut desk = Desk::new();
    desk.press(Key::G);
    desk.press(Key::ArrowRight);
    let text = Degenerate::ALL[0].watch(Language::English);
    assert!(desk.says(&text), "stepping along the ray leaves it true");
    desk.press(Key::R);
    assert!(!desk.says(&text));

    desk.type_into("direction x", "0");
    desk.type_into("direction y", "0");
    let refused = "A ray needs a direction other than zero";
    assert!(desk.says(refused));
    desk.type_into("direction y", "1.5");
    assert!(!desk.says(refused));
}

#[test]
fn a_notice_lies_in_the_lower_part_of_the_space_view() {
    let mut desk = Desk::new();
    desk.press(Key::G);
    let text = Degenerate::ALL[0].watch(Language::English);
    let name = format!("{}: {text}", Degenerate::ALL[0].name(Language::English));
    let notice = desk.get_by_role_and_label(Role::Label, &name).rect();
    let space = desk.state().view.space.unwrap();
    assert!(space.contains_rect(notice), "{notice:?} in {space:?}");
    assert!(notice.top() > space.center().y);
}
