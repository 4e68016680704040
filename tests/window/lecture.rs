//! A lecture is read from the back row, and shows everything at once.

use crate::desk::{Desk, spoken};
use crate::drawn::At;
use crate::states::{Question, SCENES};
use eframe::egui::epaint::{ClippedShape, Shape, TextShape};
use eframe::egui::{Rect, accesskit::Role};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, Node};
use octoscope::text::texts;
use octoscope::view::Preset;
use octoscope_core::scenario::built_in;
use octoscope_core::text::Language;

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

fn each_text(shape: &Shape, see: &mut impl FnMut(&TextShape)) {
    if let Shape::Text(text) = shape {
        see(text);
    } else if let Shape::Vec(shapes) = shape {
        shapes.iter().for_each(|shape| each_text(shape, see));
    }
}

impl Desk {
    /// How far what explains the step goes on below its room, which ends above the
    /// sentence, or above formulas in the same column; 0 if it does not.
    fn overflow(&self) -> f32 {
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
