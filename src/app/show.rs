//! The panels of one frame, and the windows over them.

use super::App;
use crate::command::Command;
use crate::panels::menu::Entry;
use crate::panels::{dialogs, menu, notice_line, sentence, timeline};
use crate::sidebar;
use crate::wish::Wish;
use crate::with_document;
use eframe::egui::{Align, Context, Frame, Layout, Margin, Panel, Rangef, Ui, vec2};

/// Height of the sentence in a hall, of three lines that are read from the back row or two
/// of the largest type, and the room below it, before the buttons; of the sentence with what
/// has happened below it.
const SENTENCE_IN_HALL: f32 = 66.0;
const BELOW_SENTENCE: f32 = 5.0;
const SENTENCE_AND_NOTICE: f32 = 74.0;

impl App {
    /// Shows all panels.
    pub(super) fn show(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        self.take_hints_away(ui);
        // Students have nothing to choose: the menus are folded, and the picture is higher.
        if !self.look.is_for_hall() {
            self.show_menus(ui, commands);
        }
        self.show_step(ui, commands);
        let wish = self.show_side_and_space(ui);
        self.maps.give_up_unwanted();
        self.grant(&ui.ctx().clone(), wish);
        self.show_dialogs(ui, commands);
    }

    fn show_menus(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let fill = self.look.palette.panel;
        let frame = Frame::new().fill(fill).inner_margin(Margin::symmetric(12, 6));
        let title = self.titled();
        Panel::top("menu").frame(frame).show(ui, |ui| {
            let language = self.view.language;
            menu::ui(ui, &self.look, &title, language, |c| self.entry(c), commands);
        });
    }

    /// The sentence of the step, what has happened, and the timeline.
    fn show_step(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let hall = self.look.is_for_hall();
        let margin = if hall { Margin::symmetric(16, 6) } else { Margin::symmetric(20, 6) };
        let bottom = Frame::new().fill(self.look.palette.background).inner_margin(margin);
        Panel::bottom(("sentence", hall)).frame(bottom).show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 3.0;
            let bar = ui.max_rect().expand2(margin.left_top()).y_range();
            self.show_sentence(ui);
            self.show_timeline(ui, bar, commands);
        });
    }

    /// The sentence with what has happened below it; in a hall in the place of it.
    fn show_sentence(&mut self, ui: &mut Ui) {
        let hall = self.look.is_for_hall();
        let step = self.view.playback.step;
        // Over a dialog it is said there.
        let is_said_here = self.view.dialog.is_none();
        let said = is_said_here.then_some(&self.notice);
        let slot = notice_line::slot_height(ui, &self.look, said, ui.available_width());
        let height = |slot| if hall { SENTENCE_IN_HALL } else { SENTENCE_AND_NOTICE - slot };
        // What it has where nothing is said below it.
        let room = height(notice_line::slot_height(ui, &self.look, None, ui.available_width()));
        let height = height(slot);
        ui.allocate_ui(vec2(ui.available_width(), height), |ui| {
            ui.set_min_height(height);
            if hall && is_said_here {
                self.notice.seen_at(step);
                if notice_line::for_sentence(ui, &self.look, &mut self.notice, step) {
                    return;
                }
            }
            let is_pointing = self.view.pointed == Some(step);
            with_document!(&self.document, d => {
                let language = self.view.language;
                let shown = sentence::Shown { language, step, is_pointing, height: room };
                sentence::ui(ui, &self.look, d, shown);
            });
        });
        if hall {
            ui.add_space(BELOW_SENTENCE);
        } else {
            let said = is_said_here.then_some(&mut self.notice);
            notice_line::slot(ui, &self.look, said, slot);
        }
    }

    /// The timeline in a bar of this height; in a hall beside the folded menus.
    fn show_timeline(&mut self, ui: &mut Ui, bar: Rangef, commands: &mut Vec<Command>) {
        let row = vec2(ui.available_width(), timeline::HEIGHT);
        ui.allocate_ui_with_layout(row, Layout::left_to_right(Align::Center), |ui| {
            if self.look.is_for_hall() {
                menu::folded(ui, &self.look, bar, |c| self.entry(c), commands);
            }
            with_document!(&mut self.document, d => {
                let marked = timeline::Marked {
                    first_wrong: d.first_wrong_step(),
                    rounded: &d.rounded,
                    lit: self.view.hover.lit(&d.tree),
                };
                let playback = &mut self.view.playback;
                let pointed =
                    timeline::ui(ui, &self.look, &d.trace, marked, playback, bar, commands);
                pointed.into_iter().for_each(|node| self.view.hover.offer(node));
            });
        });
    }

    fn show_side_and_space(&mut self, ui: &mut Ui) -> Option<Wish> {
        let layers = self.layers.as_mut();
        with_document!(&mut self.document, d => {
            sidebar::ui(ui, &self.look, d, &mut self.view, layers, &mut self.maps, &mut self.notice)
        })
    }

    fn grant(&mut self, context: &Context, wish: Option<Wish>) {
        match wish {
            None => {}
            Some(Wish::Scene(id)) => self.open_scene(context, id),
            Some(Wish::Counterexample(variant)) => self.open_counterexample(context, variant),
            Some(Wish::OtherQuestion) => self.find_other_question(context),
            Some(Wish::Step(step)) => self.go_to(step),
        }
    }

    /// Takes away the hint that is shown, once a dialog comes over what it is about: for
    /// one frame there is nothing below it that could have one, and none comes back.
    fn take_hints_away(&mut self, ui: &mut Ui) {
        let shows_progress = self.job.as_ref().is_some_and(|(job, _)| job.is_shown());
        let is_covered = self.view.dialog.is_some() || shows_progress;
        if is_covered && !self.was_covered {
            ui.visuals_mut().disabled_alpha = 1.0;
            ui.disable();
        }
        self.was_covered = is_covered;
    }

    fn entry(&self, command: Command) -> Entry {
        if let Command::Panel(kind) = command {
            return if self.panels().contains(&kind) { Entry::On } else { Entry::Off };
        }
        if command == Command::Follow {
            return if self.view.follow { Entry::On } else { Entry::Off };
        }
        if command == Command::ReducedMotion {
            return if self.view.reduced_motion { Entry::On } else { Entry::Off };
        }
        if let Command::Show(change) = command
            && let Some(is_on) = change.is_on(self.show_of_document())
        {
            return if is_on { Entry::On } else { Entry::Off };
        }
        if command == Command::Formulas {
            return if self.view.formulas { Entry::On } else { Entry::Off };
        }
        if command == Command::Question {
            return if self.view.question_shown { Entry::On } else { Entry::Off };
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
        if let Some(job) = &self.tracing
            && self.job.is_none()
            && job.is_shown()
            && dialogs::progress(&context, &self.look, &job.title, job.progress.fraction())
        {
            self.give_up_tracing();
        }
        self.poll_export(&context);
        self.show_export_dialog(&context);
        self.show_lab(&context);
        let answer = dialogs::ui(&context, &self.look, &mut self.view.dialog, commands);
        match answer {
            None => {}
            Some(dialogs::Answer::Path(typed)) => self.take_path(&context, typed),
            Some(dialogs::Answer::Take(target)) => self.take(&context, target),
        }
        if self.view.dialog.is_some() {
            notice_line::over_dialog(&context, &self.look, &mut self.notice);
        }
    }
}
