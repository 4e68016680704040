//! The sentence of the step, readable from the back row.

use crate::look::Look;
use crate::widgets::{rich_job, rich_label};
use eframe::egui::Ui;
use octoscope_core::explain::{RichText, Span};

/// With less room than this, in points, the type is smaller.
const NARROW: f32 = 640.0;
/// Heights of type; the largest that fits is taken.
const SIZES: [f32; 7] = [22.0, 20.0, 18.0, 17.0, 16.0, 15.0, SMALLEST];
const SMALLEST: f32 = 14.0;

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
    let largest = if look.is_for_hall() || width >= NARROW { SIZES[0] } else { 18.0 };
    let size = fitted(ui, look, &sentence, [width, ui.min_size().y]).min(largest);
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

/// Height of the largest type in which a text fits into a room.
pub fn fitted(ui: &Ui, look: &Look, text: &RichText, [width, most]: [f32; 2]) -> f32 {
    let height = |size| {
        let job = rich_job(text, look, size, width);
        ui.painter().layout_job(job).size().y
    };
    SIZES.into_iter().find(|&size| height(size) <= most).unwrap_or(SMALLEST)
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
