//! Lines that say what has just happened.

use crate::desk::{Desk, spoken};
use eframe::egui::{Key, accesskit::Role};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, Node};
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

#[test]
fn a_notice_in_a_lecture_covers_nothing_that_the_hall_reads() {
    for language in Language::ALL {
        let mut desk = Desk::of(Harness::builder(), [1024.0, 768.0]);
        desk.state_mut().view.language = language;
        desk.press(Key::Num6);
        let lines =
            Degenerate::ALL.map(|one| format!("{}: {}", one.name(language), one.watch(language)));
        for _ in lines.iter() {
            desk.press(Key::G);
            let nodes = desk.nodes();
            let is_notice = |node: &&Node<'_>| lines.contains(&spoken(node));
            let notice = nodes.iter().find(is_notice).unwrap().rect();
            for id in ["sentence", "formula"] {
                let is_it = |node: &&Node<'_>| node.accesskit_node().author_id() == Some(id);
                let read = nodes.iter().find(is_it).unwrap().rect();
                assert!(!read.intersects(notice), "{notice:?} on {id} {read:?}");
            }
            assert!(!desk.state().view.space.unwrap().intersects(notice), "{notice:?}");
        }
    }
}
