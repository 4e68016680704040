//! A lecture is read from the back row, and shows everything at once.

use crate::desk::{Desk, spoken};
use crate::drawn::At;
use crate::states::{Question, SCENES};
use eframe::egui::epaint::{ClippedShape, Shape, TextShape};
use eframe::egui::{Key, Rect, accesskit::Role};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, Node};
use octoscope::text::texts;
use octoscope::view::Preset;
use octoscope::with_document;
use octoscope_core::explain::{Formula, Statement, formulas, sentences};
use octoscope_core::paper::{counterexample, erratum_of};
use octoscope_core::scenario::built_in;
use octoscope_core::text::Language;
use octoscope_core::traverse::Variant;
use octoscope_figure::views::formula_figure;
use octoscope_figure::{Form, Page};
use std::cmp::Reverse;
use std::mem::discriminant;

/// What a projector shows, in points.
const PROJECTOR: [f32; 2] = [1024.0, 768.0];
/// Least height of type that is read from the back row, in points of the projector.
const LEAST: f32 = 20.0;

fn lecture(scene: &str, language: Language) -> Desk {
    let mut desk = Desk::of(Harness::builder(), PROJECTOR);
    desk.open_scenario(&built_in(scene).unwrap());
    let view = &mut desk.state_mut().view;
    (view.language, view.preset) = (language, Preset::Lecture);
    desk.run();
    desk
}

/// Pieces of text that are painted, with their height in points of the screen.
fn painted(desk: &Desk) -> Vec<(String, f32)> {
    let zoom = desk.ctx.zoom_factor();
    let mut all = Vec::new();
    for ClippedShape { clip_rect, shape, .. } in &desk.output().shapes {
        each_text(shape, &mut |text| {
            if !clip_rect.intersects(text.visual_bounding_rect()) {
                return;
            }
            let job = &text.galley.job;
            for section in &job.sections {
                let piece = job.text[section.byte_range.start.0..section.byte_range.end.0].trim();
                if !piece.is_empty() {
                    all.push((piece.to_owned(), section.format.font_id.size * zoom));
                }
            }
        });
    }
    all
}

/// Texts beside the picture that are cut off at their right.
fn cut(desk: &Desk) -> Vec<String> {
    let name = texts(desk.state().view.language).get("space-name");
    let space = desk.get_by_role_and_label(Role::Canvas, &name).rect();
    let mut all = Vec::new();
    for ClippedShape { clip_rect, shape, .. } in &desk.output().shapes {
        each_text(shape, &mut |text| {
            let seen = text.visual_bounding_rect();
            let is_beside = seen.is_positive() && seen.left() >= space.right();
            if is_beside && !clip_rect.expand(0.5).x_range().contains(seen.right()) {
                all.push(text.galley.job.text.clone());
            }
        });
    }
    // What lies wholly beyond the window is not painted.
    let window = desk.ctx.content_rect();
    let placed =
        desk.nodes().into_iter().filter(|node| node.accesskit_node().bounding_box().is_some());
    let beyond = placed.filter(|node| node.rect().right() > window.right() + 0.5);
    all.extend(beyond.map(|node| format!("{:?}", node.accesskit_node().value())));
    all
}

pub fn each_text(shape: &Shape, see: &mut impl FnMut(&TextShape)) {
    if let Shape::Text(text) = shape {
        see(text);
    } else if let Shape::Vec(shapes) = shape {
        shapes.iter().for_each(|shape| each_text(shape, see));
    }
}

impl Desk {
    /// How far what explains the step goes on below its room, which ends above the
    /// sentence, or above formulas in the same column; 0 if it does not.
    pub fn overflow(&self) -> f32 {
        let name = texts(self.state().view.language).get("space-name");
        let space = self.get_by_role_and_label(Role::Canvas, &name).rect();
        let nodes = self.nodes();
        let named = |id: &str| {
            let is_named = |node: &&Node<'_>| node.accesskit_node().author_id() == Some(id);
            nodes.iter().find(is_named).map(|node| node.rect())
        };
        // Margins of both.
        let above_sentence = named("sentence").unwrap().top() - 6.0 - 8.0;
        let formula = named("formula").filter(|rect| rect.left() >= space.right());
        let room = formula.map_or(above_sentence, |rect| rect.top() - 6.0);
        let placed = nodes.iter().filter(|node| node.accesskit_node().bounding_box().is_some());
        let is_beside = |rect: &Rect| rect.left() >= space.right() && rect.top() >= space.top();
        let said = placed.filter(|node| !spoken(node).is_empty()).map(|node| node.rect());
        // The sentence and the timeline begin at the left.
        let beside = said.filter(|rect| is_beside(rect) && Some(*rect) != formula);
        let beside = beside.filter(|rect| rect.top() < above_sentence);
        (beside.map(|rect| rect.bottom()).fold(0.0, f32::max) - room).max(0.0)
    }
}

#[test]
fn everything_in_a_lecture_is_read_from_the_back_row_at_once() {
    let (mut faults, mut n_texts) = (Vec::new(), 0);
    for (_, scene) in SCENES {
        // Long words in one language, and all kinds of steps in both together.
        for (language, shares) in [(Language::English, [0.35, 0.6]), (Language::German, [0.6, 0.8])]
        {
            let mut desk = lecture(scene, language);
            for question in Question::all() {
                question.ask(&mut desk);
                for share in shares {
                    desk.go_to(&At::Share(share));
                    let place = format!("{scene} {language:?} {} {share}", question.name());
                    for (text, size) in painted(&desk) {
                        n_texts += 1;
                        if size < LEAST - 0.01 {
                            faults.push(format!("{place}: {size:.1} {text}"));
                        }
                    }
                    faults.extend(cut(&desk).iter().map(|text| format!("{place}: cuts {text}")));
                    let overflow = desk.overflow();
                    if overflow > 0.5 {
                        faults.push(format!("{place}: scrolls by {overflow}"));
                    }
                }
                desk.open_scenario(&built_in(scene).unwrap());
            }
        }
    }
    assert!(n_texts > 1000, "{n_texts}");
    assert!(faults.is_empty(), "{} of {n_texts}\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn the_question_of_a_lecture_shows_all_numbers_of_the_ray() {
    for (language, scene) in [(Language::German, "quadtree-82"), (Language::English, "points-3d")] {
        let mut desk = lecture(scene, language);
        desk.press(Key::Q);
        // What fades out at the lower edge of the column is not read.
        let edge = named(&desk, "sentence").unwrap().top() - 50.0;
        for key in ["ray-origin", "ray-direction"] {
            let name = format!("{} y", texts(language).get(key));
            let field = desk.get_by_role_and_label(Role::SpinButton, &name).rect();
            assert!(field.bottom() <= edge, "{scene}: {name} at {field}, the edge at {edge}");
        }
    }
}

/// A lecture on a counterexample, where one goes wrong as printed.
fn lecture_on(variant: Variant, size: [f32; 2], language: Language) -> Desk {
    let mut desk = Desk::of(Harness::builder(), size);
    desk.open_scenario(&counterexample(variant));
    let view = &mut desk.state_mut().view;
    (view.language, view.preset) = (language, Preset::Lecture);
    desk.run();
    desk
}

fn misprints() -> impl Iterator<Item = Variant> {
    Variant::ALL.into_iter().filter(|&variant| erratum_of(variant).is_some())
}

/// The key of the marks in the picture, where no formula is in its place.
fn has_key_of_marks(desk: &Desk) -> bool {
    let texts = texts(desk.state().view.language);
    let keys = ["paper-marks", "paper-marks-mirrored"].map(|key| texts.get(key));
    desk.nodes().iter().any(|node| keys.contains(&spoken(node)))
}

#[test]
fn the_paper_lab_of_a_lecture_is_read_at_once_and_leaves_the_picture_its_height() {
    let mut faults = Vec::new();
    for variant in misprints() {
        for language in Language::ALL {
            let mut desk = lecture_on(variant, PROJECTOR, language);
            for share in [0.0, 0.5, 1.0] {
                desk.go_to(&At::Share(share));
                let place = format!("{} {language:?} {share}", variant.id());
                if share == 0.0 && !has_key_of_marks(&desk) {
                    faults.push(format!("{place}: the marks are not explained"));
                }
                let overflow = desk.overflow();
                if overflow > 0.5 {
                    faults.push(format!("{place}: scrolls by {overflow}"));
                }
                let small = painted(&desk).into_iter().filter(|(_, size)| *size < LEAST - 0.01);
                faults.extend(small.map(|(text, size)| format!("{place}: {size:.1} {text}")));
                let space = desk.state().view.space.unwrap().height();
                let window = desk.ctx.content_rect().height();
                if space < 0.74 * window {
                    faults.push(format!("{place}: the picture has {space} of {window}"));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}

/// Steps whose formulas are shown without what comes of them, in the room that they have
/// in the window.
fn bare_steps(desk: &mut Desk, place: &str) -> Vec<String> {
    // Where a step has none, words may be in their place.
    let room = (1..=desk.state().document().n_events()).find_map(|step| {
        let length = desk.state().document().n_events();
        desk.state_mut().view.playback.go_to(step, length);
        desk.step();
        Some(named(desk, "formula")?.size())
    });
    let Some(room) = room else { return vec![format!("{place}: no room")] };
    let page = Page { width: f64::from(room.x), height: f64::from(room.y) };
    let least = f64::from(Preset::Lecture.least_type());
    let document = desk.state().document();
    let bare = |step: usize, told: &[Statement]| {
        let figure = formula_figure(told, page, least);
        let is_large =
            figure.page.width <= page.width + 0.01 && figure.page.height <= page.height + 0.01;
        let letters: Vec<String> = figure
            .spelled_out()
            .drawn
            .iter()
            .filter_map(|drawn| match &drawn.form {
                Form::Text { text, .. } => Some(text.plain()),
                _ => None,
            })
            .collect();
        // Each line has its own numbers, in the order of the lines.
        let mut rest = letters.iter();
        let mut is_shown = |told: &Statement| {
            let number = told.numbers.as_ref().and_then(last_number);
            number.is_none_or(|number| rest.any(|letter| *letter == number))
        };
        (!is_large || !told.iter().all(&mut is_shown))
            .then(|| format!("{place}: step {step}: {letters:?}"))
    };
    let view = &desk.state().view;
    with_document!(document, d => {
        let told = |step| formulas(&d.tree, d.traced_ray(), &d.trace, step, view.notation, view.language);
        (1..=d.trace.events.len()).filter_map(|step| bare(step, &told(step))).collect()
    })
}

/// The last number of a formula, as it is written.
fn last_number(formula: &Formula) -> Option<String> {
    match formula {
        Formula::Row(parts) => parts.iter().rev().find_map(last_number),
        Formula::Number { shown: text, .. } | Formula::Digits(text) => Some(text.clone()),
        Formula::Sub { body, .. } | Formula::Sup { body, .. } | Formula::Fenced { body, .. } => {
            last_number(body)
        }
        Formula::Fraction { under, .. } => last_number(under),
        Formula::Symbol { .. } | Formula::Words(_) | Formula::Sign(_) | Formula::Over { .. } => {
            None
        }
    }
}

/// The control of this id.
fn named(desk: &Desk, id: &str) -> Option<Rect> {
    let nodes = desk.nodes();
    let is_named = |node: &&Node<'_>| node.accesskit_node().author_id() == Some(id);
    nodes.iter().find(is_named).map(|node| node.rect())
}

#[test]
fn a_lecture_shows_what_a_misprint_computes_with_its_numbers() {
    let mut bare = Vec::new();
    for variant in misprints() {
        for (size, language) in
            [(PROJECTOR, Language::German), ([1280.0, 800.0], Language::English)]
        {
            let mut desk = lecture_on(variant, size, language);
            bare.extend(bare_steps(&mut desk, &format!("{} {size:?}", variant.id())));
        }
    }
    assert!(bare.is_empty(), "{}\n{}", bare.len(), bare.join("\n"));
}

#[test]
fn a_lecture_shows_what_every_algorithm_computes_with_its_numbers() {
    let mut bare = Vec::new();
    for (_, scene) in SCENES {
        for question in Question::all() {
            let mut desk = lecture(scene, Language::German);
            question.ask(&mut desk);
            bare.extend(bare_steps(&mut desk, &format!("{scene} {}", question.name())));
        }
    }
    assert!(bare.is_empty(), "{}\n{}", bare.len(), bare.join("\n"));
}

/// Height of the sentence's type, in points of the screen.
fn size_of_sentence(desk: &Desk) -> f32 {
    let sentence = named(desk, "sentence").unwrap();
    let mut size = 0.0_f32;
    for ClippedShape { shape, .. } in &desk.output().shapes {
        each_text(shape, &mut |text| {
            if sentence.expand(2.0).contains(text.visual_bounding_rect().center()) {
                let sizes = text.galley.job.sections.iter().map(|one| one.format.font_id.size);
                size = sizes.fold(size, f32::max);
            }
        });
    }
    size * desk.ctx.zoom_factor()
}

/// Some steps of a walk: the first and the last, the longest told ones, and of many kinds.
fn telling_steps(desk: &Desk) -> Vec<usize> {
    let language = desk.state().view.language;
    with_document!(desk.state().document(), d => {
        let told = sentences(&d.tree, d.traced_ray(), &d.trace, language);
        let mut steps: Vec<(usize, usize)> =
            told.map(|text| text.plain().chars().count()).enumerate().collect();
        let last = steps.len() - 1;
        steps.sort_by_key(|(_, n_letters)| Reverse(*n_letters));
        let longest = steps.iter().take(2).map(|(step, _)| *step);
        let mut kinds = Vec::new();
        let first_of_kind = d.trace.events.iter().enumerate().filter_map(|(index, event)| {
            let kind = discriminant(event);
            let is_new = !kinds.contains(&kind);
            kinds.push(kind);
            is_new.then_some(index + 1)
        });
        first_of_kind.step_by(3).chain(longest).chain([0, last]).collect()
    })
}

#[test]
fn nothing_in_a_lecture_moves_or_changes_its_size_from_step_to_step() {
    let mut faults = Vec::new();
    let asked = SCENES
        .into_iter()
        .flat_map(|(_, scene)| Question::all().into_iter().map(move |q| (scene, q)));
    let asked: Vec<_> = asked.collect();
    let rooms = [PROJECTOR, [1280.0, 800.0], [1920.0, 1080.0]];
    for (n, room) in rooms.into_iter().enumerate() {
        let mut desk = Desk::of(Harness::builder(), room);
        desk.state_mut().view.preset = Preset::Lecture;
        // All sizes and languages, each with every panel of the plane or of space.
        for (turn, &(scene, question)) in asked.iter().enumerate().skip(n).step_by(rooms.len()) {
            let language = Language::ALL[turn % 2];
            desk.state_mut().view.language = language;
            desk.open_scenario(&built_in(scene).unwrap());
            question.ask(&mut desk);
            let mut first = None;
            for step in telling_steps(&desk) {
                let length = desk.state().document().n_events();
                desk.state_mut().view.playback.go_to(step, length);
                desk.step();
                let place = format!("{scene} {language:?} {room:?} {} {step}", question.name());
                let size = size_of_sentence(&desk);
                let now = (desk.state().view.space.unwrap(), size);
                if *first.get_or_insert(now) != now {
                    faults.push(format!("{place}: {now:?} instead of {first:?}"));
                }
                if size < LEAST - 0.01 {
                    faults.push(format!("{place}: {size}"));
                }
                let overflow = desk.overflow();
                if overflow > 0.5 {
                    faults.push(format!("{place}: scrolls by {overflow}"));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}
