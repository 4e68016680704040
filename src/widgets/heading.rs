//! Title of a section.

use crate::look::Look;
use eframe::egui::{Align, Layout, RichText, Ui};

/// Title of a section, with a quiet note at its right end.
pub fn heading(ui: &mut Ui, look: &Look, title: &str, note: &str) {
    ui.horizontal(|ui| {
        let family = look.strong_family();
        ui.label(RichText::new(title).size(14.0).family(family).color(look.palette.ink));
        if !note.is_empty() {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let text = RichText::new(note).size(13.0).color(look.palette.quiet);
                ui.add(eframe::egui::Label::new(text).truncate());
            });
        }
    });
}
