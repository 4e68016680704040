//! Saving the scenario, and what paths are chosen or typed for.

use super::App;
use super::jobs::file_name;
use crate::files::{self, Chosen, Purpose};
use crate::kept_show::keep_show;
use crate::view::{Dialog, Typed};
use crate::{complaint, save, with_document};
use eframe::egui::Context;
use octoscope_core::scenario::AnyScenario;
use std::path::{Path, PathBuf};

/// Whether a file may be replaced.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Replacing {
    /// The user is asked.
    Asks,
    /// The user has agreed.
    Agreed,
}

impl App {
    /// The scenario with the playhead where it is.
    pub(super) fn scenario_now(&self) -> AnyScenario {
        self.document.scenario_at(self.view.playback.step)
    }

    /// The same with what the picture shows.
    pub(super) fn scenario_to_keep(&self) -> AnyScenario {
        let mut scenario = self.scenario_now();
        keep_show(&mut scenario, self.show_of_document());
        scenario
    }

    pub(super) fn save(&mut self, context: &Context, ask: bool) {
        let path = with_document!(&self.document, document => document.path.clone());
        match path {
            Some(path) if !ask => self.save_to(&path),
            Some(_) | None => self.chosen.ask_save(context),
        }
    }

    fn save_to(&mut self, path: &Path) {
        match save::scenario(&self.document, self.scenario_to_keep(), path) {
            Ok(()) => {
                with_document!(&mut self.document, d => d.path = Some(path.to_owned()));
                self.saved = self.document.clone();
                self.unrestored = None;
                self.exporting.saved = Some((path.to_owned(), self.scenario_now()));
                let name = file_name(path);
                self.notice.say(self.look.texts.format("status-saved", &[("name", name.into())]));
            }
            Err(error) => {
                self.view.dialog = Some(Dialog::Error(complaint::told(&self.look.texts, &error)))
            }
        }
    }

    pub(super) fn take_answers(&mut self, context: &Context) {
        if let Some(chosen) = self.chosen.take() {
            self.take_chosen(context, chosen);
        }
    }

    /// Does what a file was chosen for.
    pub fn take_chosen(&mut self, context: &Context, chosen: Chosen) {
        match chosen {
            Chosen::Path(purpose, path) => {
                if matches!(purpose, Purpose::Export(_)) {
                    self.view.dialog = None;
                }
                // The dialog has asked about the name as it was chosen.
                let named = purpose.named(&path);
                let asked = if named == path { Replacing::Agreed } else { Replacing::Asks };
                self.use_path(context, purpose, named, asked);
            }
            Chosen::NoDialog(purpose) => {
                let path = self.suggested(purpose).to_string_lossy().into_owned();
                // What is typed from now on is the path.
                context.memory_mut(|memory| {
                    if let Some(focused) = memory.focused() {
                        memory.surrender_focus(focused);
                    }
                });
                self.view.dialog = Some(Dialog::Path(Typed { purpose, path, replaces: false }));
            }
        }
    }

    /// Path to begin with where one is typed.
    fn suggested(&self, purpose: Purpose) -> PathBuf {
        let (path, folder) =
            with_document!(&self.document, d => (d.path.clone(), d.folder.clone()));
        match purpose {
            // With a separator at its end, behind which the name is typed.
            Purpose::Open if folder.as_os_str().is_empty() => folder,
            Purpose::Open => folder.join(""),
            Purpose::Save => path.unwrap_or_else(|| folder.join("scenario.octo")),
            Purpose::Export(_) => folder.join(self.view.export.file.trim()),
            Purpose::Lab(ending) => folder.join(format!("bench.{ending}")),
        }
    }

    /// Does what a path was typed for; asks once before a file is replaced.
    pub(super) fn take_path(&mut self, context: &Context, typed: Typed) {
        let path = typed.purpose.named(Path::new(typed.path.trim()));
        let asked = if typed.replaces { Replacing::Agreed } else { Replacing::Asks };
        self.use_path(context, typed.purpose, path, asked);
    }

    fn use_path(&mut self, context: &Context, purpose: Purpose, path: PathBuf, asked: Replacing) {
        let is_written = match purpose {
            Purpose::Open => false,
            Purpose::Save | Purpose::Export(_) | Purpose::Lab(_) => true,
        };
        if is_written && asked == Replacing::Asks && files::is_there(&path) {
            let path = path.to_string_lossy().into_owned();
            self.view.dialog = Some(Dialog::Path(Typed { purpose, path, replaces: true }));
            return;
        }
        match purpose {
            Purpose::Open => self.open(context, path),
            Purpose::Save => self.save_to(&path),
            Purpose::Export(_) => self.export_to(context, &path),
            Purpose::Lab(_) => self.save_lab(context, &path),
        }
    }
}
