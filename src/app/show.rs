//! The panels of one frame, and the windows over them.

use super::App;
use crate::command::Command;
use crate::panels::menu::Entry;
use crate::panels::{dialogs, menu, sentence, timeline};
use crate::sidebar::{self, Wish};
use crate::with_document;
use eframe::egui::{Frame, Margin, Panel, Ui, vec2};
use octoscope_core::explain::{sentence as sentence_of, short_title};

impl App {
    /// Shows all panels.
    pub(super) fn show(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let step = self.view.playback.step;
        let bar = |fill| Frame::new().fill(fill).inner_margin(Margin::symmetric(12, 6));
        let palette = self.look.palette;
        let title = with_document!(&self.document, d => {
            short_title(d.opened(), d.tree.n_leaves(), self.view.language)
        });
        Panel::top("menu").frame(bar(palette.panel)).show(ui, |ui| {
            let mut language = self.view.language;
            menu::ui(ui, &self.look, &title, &mut language, |c| self.entry(c), commands);
            self.view.language = language;
        });
        let bottom = Frame::new().fill(palette.background).inner_margin(Margin::symmetric(20, 12));
        Panel::bottom("sentence").frame(bottom).show(ui, |ui| {
            let height = if self.view.preset.scale() > 1.0 { 62.0 } else { 60.0 };
            ui.allocate_ui(vec2(ui.available_width(), height), |ui| {
                ui.set_min_height(height);
                let text = with_document!(&self.document, d => {
                    sentence_of(&d.tree, &d.scenario.ray, &d.trace, step, self.view.language)
                });
                sentence::ui(ui, &self.look, text, step);
            });
            with_document!(&self.document, d => {
                timeline::ui(ui, &self.look, &d.trace, &d.rounded, &mut self.view.playback, commands);
            });
        });
        let layers = self.layers.as_mut();
        let wish = with_document!(&mut self.document, d => {
            sidebar::ui(ui, &self.look, d, &mut self.view, layers, &mut self.status)
        });
        let context = ui.ctx().clone();
        match wish {
            None => {}
            Some(Wish::Scene(id)) => self.open_scene(&context, id),
            Some(Wish::Counterexample(variant)) => self.open_counterexample(&context, variant),
            Some(Wish::OtherRay) => self.find_other_ray(&context),
            Some(Wish::Step(step)) => self.go_to(step),
        }
        self.show_dialogs(ui, commands);
    }

    fn entry(&self, command: Command) -> Entry {
        if let Command::Panel(kind) = command {
            return if self.panels().contains(&kind) { Entry::On } else { Entry::Off };
        }
        if self.is_enabled(command) { Entry::Enabled } else { Entry::Disabled }
    }

    fn show_dialogs(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let context = ui.ctx().clone();
        if let Some((job, _)) = &self.job
            && job.is_shown()
            && dialogs::progress(&context, &self.look, &job.title, job.progress.fraction())
        {
            job.progress.cancel();
        }
        self.poll_export(&context);
        self.show_export_dialog(&context);
        let answer = dialogs::ui(&context, &self.look, &mut self.view.dialog, commands);
        match answer {
            None => {}
            Some(dialogs::Answer::Path(path)) => self.open(&context, path),
        }
        dialogs::status(&context, &self.look, &mut self.status);
    }
}
