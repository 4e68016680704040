//! The sentence of the step, readable from the back row.

use crate::look::Look;
use crate::widgets::{fitting_size, rich_label};
use eframe::egui::Ui;
use octoscope_core::explain::{RichText, Span};

/// With less room than this, in points, the type is smaller.
const NARROW: f32 = 640.0;
/// Height of type in all other rooms, where the sentence fits.
const LARGEST: f32 = 22.0;

/// The sentence of `step`, in large type, before the first step with the key
/// that begins; a screen reader is told when it changes. Pointing at it shows the
/// numbers that it tells in short with all their digits.
pub fn ui(ui: &mut Ui, look: &Look, mut sentence: RichText, step: usize) {
    if step == 0 {
        let text = format!(" {}", look.text("sentence-begin"));
        sentence.0.push(Span { text, ..Span::default() });
    }
    let width = ui.available_width();
    // Nothing moves from step to step: a long sentence has smaller type.
    let largest = if look.is_for_hall() || width >= NARROW { LARGEST } else { 18.0 };
    let size = fitting_size(ui, look, &sentence, [width, ui.min_size().y]).min(largest);
    let mut response = rich_label(ui, look, &sentence, size, width);
    let digits = digits(&sentence);
    if !digits.is_empty() {
        response = response.on_hover_text(digits.join("\n"));
    }
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_live(eframe::egui::accesskit::Live::Polite);
        node.set_author_id("sentence");
    });
}

/// The numbers that are told in short, each once, with all their digits.
fn digits(sentence: &RichText) -> Vec<String> {
    let mut digits = Vec::new();
    for span in &sentence.0 {
        if let Some(whole) = &span.whole {
            let line = format!("{} ≈ {whole}", span.text);
            if !digits.contains(&line) {
                digits.push(line);
            }
        }
    }
    digits
}
