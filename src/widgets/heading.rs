//! Title of a section.

use crate::look::Look;
use eframe::egui::{Align, FontId, Label, Layout, RichText, Ui};

/// Title of a section, with a quiet note at its right end; below it where both have no room
/// side by side.
pub fn heading(ui: &mut Ui, look: &Look, title: &str, note: &str) {
    const NOTE: f32 = 13.0;
    let font = FontId::proportional(NOTE);
    let galley = ui.painter().layout_no_wrap(note.to_owned(), font, look.palette.quiet);
    let text = RichText::new(note).size(NOTE).color(look.palette.quiet);
    let beside = ui.horizontal(|ui| {
        let family = look.strong_family();
        ui.label(RichText::new(title).size(14.0).family(family).color(look.palette.ink));
        let has_room = galley.size().x <= ui.available_width();
        if has_room && !note.is_empty() {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| ui.label(text.clone()));
        }
        has_room
    });
    if !beside.inner && !note.is_empty() {
        ui.add(Label::new(text).wrap());
    }
}
