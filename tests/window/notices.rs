//! Lines that say what has just happened.

use crate::desk::{Desk, spoken};
use eframe::egui::{Key, Rect, accesskit::Role};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, Node};
use octoscope::text::texts;
use octoscope::view::Preset;
use octoscope_core::gallery::Degenerate;
use octoscope_core::scenario::{AnyScenario, built_in};
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

/// The rectangle of the control of this id.
fn named(desk: &Desk, id: &str) -> Option<Rect> {
    let nodes = desk.nodes();
    let is_it = |node: &&Node<'_>| node.accesskit_node().author_id() == Some(id);
    nodes.iter().find(is_it).map(|node| node.rect())
}

/// What a notice covers or moves while so many rays of the gallery are gone through.
fn faults(desk: &mut Desk, n_rays: usize, place: &str) -> Vec<String> {
    let language = desk.state().view.language;
    let lines =
        Degenerate::ALL.map(|one| format!("{}. {}", one.name(language), one.watch(language)));
    let space = desk.state().view.space.unwrap();
    let mut faults = Vec::new();
    for _ in 0..n_rays {
        desk.press(Key::G);
        let notice = {
            let nodes = desk.nodes();
            let found = nodes.iter().find(|node| lines.contains(&spoken(node)));
            found.map(|node| node.rect())
        };
        let Some(notice) = notice else {
            faults.push(format!("{place}: nothing is said"));
            continue;
        };
        if !desk.ctx.content_rect().contains_rect(notice) {
            faults.push(format!("{place}: {notice:?} is cut"));
        }
        let close = texts(language).get("dialog-close");
        let close = desk.get_by_role_and_label(Role::Button, &close).rect();
        if !desk.ctx.content_rect().contains_rect(close) || close.intersects(notice) {
            faults.push(format!("{place}: {close:?} closes {notice:?}"));
        }
        let timeline = texts(language).get("timeline-name");
        let timeline = desk.get_by_role_and_label(Role::Slider, &timeline).rect();
        let mut read = vec![("timeline", timeline), ("picture", desk.state().view.space.unwrap())];
        read.extend(
            ["sentence", "formula"].map(|id| Some((id, named(desk, id)?))).into_iter().flatten(),
        );
        for (name, rect) in read {
            if rect.intersects(notice) {
                faults.push(format!("{place}: {notice:?} on {name} {rect:?}"));
            }
        }
        if desk.state().view.space != Some(space) {
            faults.push(format!(
                "{place}: the picture is {:?} and no more {space:?}",
                desk.state().view.space
            ));
        }
    }
    faults
}

#[test]
fn a_notice_covers_nothing_and_moves_nothing() {
    let mut all = Vec::new();
    for size in [[1024.0, 768.0], [1280.0, 800.0]] {
        for language in Language::ALL {
            let mut desk = Desk::of(Harness::builder(), size);
            desk.state_mut().view.language = language;
            for preset in Preset::ALL {
                desk.state_mut().view.preset = preset;
                desk.run();
                // Every line in both of its places, and a few in all presets.
                let is_whole = matches!(preset, Preset::Rail | Preset::Lecture);
                let n_rays = if is_whole { Degenerate::ALL.len() } else { 2 };
                let place = format!("{size:?} {language:?} {preset:?}");
                all.extend(faults(&mut desk, n_rays, &place));
            }
        }
    }
    assert!(all.is_empty(), "{} faults\n{}", all.len(), all.join("\n"));
}

#[test]
fn in_a_lecture_a_notice_gives_way_to_the_sentence_of_the_next_step() {
    let mut desk = Desk::of(Harness::builder(), [1024.0, 768.0]);
    desk.press(Key::Num6);
    desk.press(Key::ArrowRight);
    desk.press(Key::G);
    let text = Degenerate::ALL[0].watch(Language::English);
    assert!(desk.says(&text) && named(&desk, "sentence").is_none());
    desk.press(Key::ArrowRight);
    assert!(!desk.says(&text) && named(&desk, "sentence").is_some());
    // Who goes back has it again, until its time is over.
    desk.press(Key::ArrowLeft);
    assert!(desk.says(&text));
    desk.press(Key::Escape);
    assert!(!desk.says(&text) && named(&desk, "sentence").is_some());
}

#[test]
fn in_a_lecture_the_sentence_is_there_as_soon_as_the_notice_is_gone() {
    let mut desk = Desk::of(Harness::builder(), [1024.0, 768.0]);
    desk.press(Key::Num6);
    desk.press(Key::ArrowRight);
    desk.press(Key::G);
    assert!(named(&desk, "sentence").is_none());
    let now = desk.ctx.input(|input| input.time);
    desk.input_mut().time = Some(now + 60.0);
    desk.step();
    assert!(named(&desk, "sentence").is_some());
}

#[test]
fn however_long_a_notice_is_the_sentence_stays() {
    let mut desk = Desk::new();
    let before = named(&desk, "sentence").unwrap();
    let space = desk.state().view.space;
    let Some(AnyScenario::Quadtree(mut scenario)) = built_in("quadtree-82") else { panic!() };
    scenario.view.insert("show".to_owned(), "no-such-part".repeat(120).into());
    desk.open_scenario(&AnyScenario::Quadtree(scenario));
    let sentence = named(&desk, "sentence").unwrap();
    assert_eq!(sentence.top(), before.top());
    let notice = {
        let nodes = desk.nodes();
        let is_it = |node: &&Node<'_>| spoken(node).contains("no-such-part");
        nodes.iter().find(is_it).map(|node| node.rect()).unwrap()
    };
    assert!(notice.height() > 24.0, "more than a line: {notice:?}");
    assert!(notice.top() >= sentence.bottom(), "{notice:?} on {sentence:?}");
    assert_eq!(desk.state().view.space, space);
}
