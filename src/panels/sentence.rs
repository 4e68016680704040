//! The sentence of the step, readable from the back row.

use crate::document::Document;
use crate::look::Look;
use crate::widgets::{fitting_size, hint_over, rich_label, span_under};
use eframe::egui::{Id, Ui, Vec2, vec2};
use octoscope_core::explain::{RichText, Span, sentence as sentence_of, sentences};
use octoscope_core::text::Language;
use octoscope_core::trace::Trace;
use std::cmp::Reverse;
use std::sync::Arc;

/// With less room than this, in points, the type is smaller.
const NARROW: f32 = 640.0;
/// Height of type in all other rooms, where the sentence fits.
const LARGEST: f32 = 22.0;

/// Of which step the sentence is, and how it is shown.
#[derive(Clone, Copy, Debug)]
pub struct Shown {
    /// Its language.
    pub language: Language,
    /// The step.
    pub step: usize,
    /// Whether the mouse points, and is not only where it was left.
    pub is_pointing: bool,
    /// Height that the largest sentence of the walk has.
    pub height: f32,
}

/// The sentence of `step`, in large type, before the first step with the key
/// that begins; a screen reader is told when it changes. A number that is told in short
/// shows all its digits where it is pointed at, if somebody `is_pointing` at this step.
/// `height` is that of the sentence's room where nothing else is said in it.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, document: &Document<D>, shown: Shown) {
    let Shown { language, step, is_pointing, height } = shown;
    let (tree, ray, trace) = (&document.tree, document.traced_ray(), &document.trace);
    let sentence = whole(look, step, sentence_of(tree, ray, trace, step, language));
    let width = ui.available_width();
    let room = vec2(width, ui.min_size().y);
    // Nothing moves from step to step, and no type changes.
    let largest = if look.is_for_hall() || width >= NARROW { LARGEST } else { 18.0 };
    let of_all = size_of_walk(ui, look, document, language, vec2(width, height));
    let of_all = of_all.min(largest);
    let size = fitting_size(ui, look, &sentence, room, of_all);
    let response = rich_label(ui, look, &sentence, size, width);
    let under = span_under(ui, look, &sentence, size, width, &response);
    if let Some(digits) = under.filter(|_| is_pointing).and_then(|span| digits(&sentence.0[span])) {
        hint_over(ui, &response, response.rect, &digits);
    }
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_live(eframe::egui::accesskit::Live::Polite);
        node.set_author_id("sentence");
    });
}

/// The sentence of a step with the key that begins, if that is what comes next.
fn whole(look: &Look, step: usize, mut sentence: RichText) -> RichText {
    if step == 0 {
        let text = format!(" {}", look.text("sentence-begin"));
        sentence.0.push(Span { text, ..Span::default() });
    }
    sentence
}

/// Height of type for all sentences of a walk, and what it follows from.
#[derive(Clone)]
struct SizeOfWalk<const D: usize> {
    trace: Arc<Trace<D>>,
    language: Language,
    room: Vec2,
    zoom: f32,
    size: f32,
}

/// Height of the largest type in which every sentence of a walk fits into a room, in
/// points; found once for a walk, and for one that changes while something is dragged, once
/// that is let go.
fn size_of_walk<const D: usize>(
    ui: &Ui,
    look: &Look,
    document: &Document<D>,
    language: Language,
    room: Vec2,
) -> f32 {
    /// Sentences of so many steps at most are looked at: longer walks say the same again.
    const STEPS: usize = 2000;
    /// Of them, so many of the longest are laid out.
    const LONGEST: usize = 24;
    let id = Id::unique("size-of-sentences");
    let zoom = ui.ctx().pixels_per_point();
    let trace = &document.trace;
    let kept = ui.data(|data| data.get_temp::<SizeOfWalk<D>>(id));
    let is_dragged = ui.input(|input| input.pointer.any_down());
    let is_same = |kept: &SizeOfWalk<D>| {
        let is_same_room = kept.room == room && kept.zoom == zoom;
        let is_same_walk = Arc::ptr_eq(&kept.trace, trace) || is_dragged;
        is_same_walk && kept.language == language && is_same_room
    };
    if let Some(kept) = kept.filter(is_same) {
        return kept.size;
    }
    let all = sentences(&document.tree, document.traced_ray(), trace, language);
    let all = all.take(STEPS).enumerate().map(|(step, text)| whole(look, step, text));
    let mut all: Vec<(usize, RichText)> = all.map(|text| (n_letters(&text), text)).collect();
    all.sort_by_key(|(n_letters, _)| Reverse(*n_letters));
    // No type is tried that was too large for a sentence before.
    let longest = all.iter().take(LONGEST);
    let size = longest.fold(LARGEST, |size, (_, text)| fitting_size(ui, look, text, room, size));
    let kept = SizeOfWalk { trace: Arc::clone(trace), language, room, zoom, size };
    ui.data_mut(|data| data.insert_temp(id, kept));
    size
}

fn n_letters(text: &RichText) -> usize {
    text.0.iter().map(|span| span.text.chars().count()).sum()
}

/// A number that is told in short, with all its digits.
fn digits(span: &Span) -> Option<String> {
    span.whole.as_ref().map(|whole| format!("{} ≈ {whole}", span.text))
}
