//! What a lecture has beside the window: a light at the pointer, and notes on a
//! second screen.

use super::App;
use crate::command::Command;
use crate::panels::notes::{self, Notes};
use crate::panels::spotlight;
use crate::with_document;
use eframe::egui::{CentralPanel, Context, Frame, ViewportBuilder, ViewportCommand, ViewportId};
use octoscope_core::explain::sentence;
use std::time::Duration;

impl App {
    /// Shows the light and the notes, where they are on. Keys that are pressed in
    /// the notes go to `commands`.
    pub(super) fn show_hall(&mut self, context: &Context, commands: &mut Vec<Command>) {
        // A dialog dims the rest itself, and is to be read.
        if self.view.spotlight && self.view.dialog.is_none() {
            spotlight::paint(context, &self.look);
        }
        let Some(since) = self.view.notes_since else { return };
        let secs = context.input(|input| input.time) - since;
        let step = self.view.playback.step;
        let n_steps = self.document.n_events();
        let notes = with_document!(&self.document, d => {
            let told = |step| {
                sentence(&d.tree, d.traced_ray(), &d.trace, step, self.view.language)
            };
            let next = (step < n_steps).then(|| told(step + 1));
            Notes { now: told(step), next, step: [step, n_steps], secs, is_blank: self.view.blank }
        });
        let window = ViewportBuilder::default()
            .with_title(self.look.text("notes-title"))
            .with_inner_size([560.0, 420.0]);
        let (restart, closed) =
            context.show_viewport_immediate(ViewportId::from_hash_of("notes"), window, |ui, _| {
                let frame = Frame::central_panel(&ui.ctx().global_style()).inner_margin(20.0);
                let shown = CentralPanel::default()
                    .frame(frame)
                    .show(ui, |ui| notes::ui(ui, &self.look, &notes));
                let context = ui.ctx();
                commands.extend(self.pressed(context));
                (shown.inner, context.input(|input| input.viewport().close_requested()))
            });
        if restart {
            self.view.notes_since = Some(context.input(|input| input.time));
        }
        if closed {
            self.view.notes_since = None;
            context.send_viewport_cmd(ViewportCommand::Focus);
        }
        context.request_repaint_after(Duration::from_secs(1));
    }
}
