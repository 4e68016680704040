//! Saving the scenario, and what paths are chosen or typed for.

use super::App;
use super::telling::file_name;
use crate::document::AnyDocument;
use crate::files::{self, Chosen, Purpose};
use crate::job::{Job, Poll, Title};
use crate::kept_view::KeptView;
use crate::view::{Dialog, Typed};
use crate::{complaint, save, with_document};
use eframe::egui::Context;
use octoscope_core::progress::Progress;
use octoscope_core::scenario::AnyScenario;
use std::collections::VecDeque;
use std::path::PathBuf;

/// What is being saved. A large scenario takes long to print: another thread does it.
#[derive(Default)]
pub(super) struct Saving {
    now: Option<Begun>,
    /// What is to be saved after it, one for each file.
    next: VecDeque<Draft>,
    /// What was typed last as a path, until something has come of it.
    typed: Option<Typed>,
}

/// What is to be saved, as it was when this was asked for.
struct Draft {
    /// The document, with its file.
    document: AnyDocument,
    path: PathBuf,
    step: usize,
    view: KeptView,
}

struct Begun {
    /// Comes to what was saved, with the playhead where it was.
    job: Job<anyhow::Result<AnyScenario>>,
    /// The document as it is being saved, with its file.
    document: AnyDocument,
    path: PathBuf,
    context: Context,
    /// Whether the user knows that it takes a while.
    is_told: bool,
}

/// Whether a file may be replaced.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Replacing {
    /// The user is asked.
    Asks,
    /// The user has agreed.
    Agreed,
}

impl App {
    /// Whether something is being saved.
    pub(super) fn is_saving(&self) -> bool {
        self.saving.now.is_some()
    }

    /// Saves the scenario where it came from, or asks where to.
    pub(super) fn save_or_ask(&mut self, context: &Context) {
        match with_document!(&self.document, document => document.path.clone()) {
            Some(path) => self.save_to(context, path),
            None => self.chosen.ask_save(context),
        }
    }

    /// Begins to save, or, while something is being saved, does so after it.
    fn save_to(&mut self, context: &Context, path: PathBuf) {
        let mut document = self.document.clone();
        with_document!(&mut document, d => d.path = Some(path.clone()));
        let (step, view) = (self.view.playback.step, self.kept_view());
        self.saving.next.retain(|draft| draft.path != path);
        self.saving.next.push_back(Draft { document, path, step, view });
        if !self.is_saving() {
            self.save_next(context);
        }
    }

    fn save_next(&mut self, context: &Context) {
        let Some(draft) = self.saving.next.pop_front() else { return };
        let Draft { document, path, step, view } = draft;
        let (of_job, to) = (document.clone(), path.clone());
        let work = move |_: &Progress| {
            let now = of_job.scenario_at(step);
            let mut kept = now.clone();
            view.keep_in(&mut kept);
            save::scenario(&of_job, kept, &to).map(|()| now)
        };
        let title = Title::Named("status-saving", file_name(&path));
        let job = Job::start(title, context, work);
        let context = context.clone();
        self.saving.now = Some(Begun { job, document, path, context, is_told: false });
        self.poll_saving();
    }

    /// Takes what saving has come to, and begins what is to be saved after it.
    pub(super) fn poll_saving(&mut self) {
        let Some(mut begun) = self.saving.now.take() else { return };
        match begun.job.poll() {
            Poll::Running => {
                if begun.job.is_shown() && !begun.is_told {
                    self.notice.say(begun.job.title.told(&self.look.texts));
                    begun.is_told = true;
                }
                self.saving.now = Some(begun);
            }
            Poll::Done(result) => self.conclude_saving(Some(result), begun),
            Poll::Broken => self.conclude_saving(None, begun),
        }
    }

    /// Waits until all that is to be saved is in its file, or could not be saved.
    pub(super) fn finish_saving(&mut self) {
        while let Some(begun) = self.saving.now.take() {
            match begun.job.wait() {
                Poll::Done(result) => self.conclude_saving(Some(result), begun),
                Poll::Running | Poll::Broken => self.conclude_saving(None, begun),
            }
        }
    }

    /// `result` is what was saved, or why it was not; `None` if nobody knows.
    fn conclude_saving(&mut self, result: Option<anyhow::Result<AnyScenario>>, begun: Begun) {
        let Begun { document, path, context, job, .. } = begun;
        if self.notice.text() == job.title.told(&self.look.texts) {
            self.notice.clear();
        }
        match result {
            Some(Ok(scenario)) => {
                self.saving.typed.take_if(|typed| typed.named() == path);
                let name = file_name(&path);
                self.notice.say(self.look.texts.format("status-saved", &[("name", name.into())]));
                self.exporting.saved = Some((path, scenario));
                // Meanwhile another one may have been opened.
                if self.document.is_of_same_opened(&document) {
                    self.document.keep_file(&document);
                    self.saved = document;
                    self.unrestored = None;
                }
            }
            Some(Err(error)) => {
                let is_it = |typed: &Typed| typed.purpose == Purpose::Save && typed.named() == path;
                self.refuse_path(&error, is_it);
            }
            None => self.tell_error(self.look.text("job-broken")),
        }
        self.save_next(&context);
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
                self.view.dialog = Some(Dialog::Path(Typed::new(purpose, path)));
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
        let (purpose, path) = (typed.purpose, typed.named());
        let asked = if typed.replaces { Replacing::Agreed } else { Replacing::Asks };
        self.saving.typed = Some(typed);
        match purpose {
            Purpose::Open => self.open_typed(context, path),
            Purpose::Save | Purpose::Export(_) | Purpose::Lab(_) => {
                self.use_path(context, purpose, path, asked);
            }
        }
    }

    /// Says why nothing came of the path that was typed last, if `is_it`: where another
    /// one can be typed, unless another dialog is shown. Else as all errors are told.
    pub(super) fn refuse_path(&mut self, error: &anyhow::Error, is_it: impl Fn(&Typed) -> bool) {
        match self.saving.typed.take_if(|typed| is_it(typed)) {
            Some(typed) if self.view.dialog.is_none() => {
                let refused = Some(complaint::told(&self.look.texts, error));
                self.view.dialog = Some(Dialog::Path(Typed { refused, replaces: false, ..typed }));
            }
            Some(_) | None => self.complain(error),
        }
    }

    /// From now on nobody can type another path.
    pub(super) fn forget_typed(&mut self) {
        self.saving.typed = None;
    }

    fn use_path(&mut self, context: &Context, purpose: Purpose, path: PathBuf, asked: Replacing) {
        let is_written = match purpose {
            Purpose::Open => false,
            Purpose::Save | Purpose::Export(_) | Purpose::Lab(_) => true,
        };
        if is_written && asked == Replacing::Asks && files::is_there(&path) {
            let path = path.to_string_lossy().into_owned();
            let typed = Typed { replaces: true, ..Typed::new(purpose, path) };
            self.view.dialog = Some(Dialog::Path(typed));
            return;
        }
        match purpose {
            Purpose::Open => self.open(context, path),
            Purpose::Save => self.save_to(context, path),
            Purpose::Export(_) => self.export_to(context, &path),
            Purpose::Lab(_) => self.save_lab(context, &path),
        }
    }
}
