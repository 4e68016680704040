//! Opening files and building trees, on another thread.

use super::App;
use super::telling::{file_name, method_told, rules_told};
use crate::document::AnyDocument;
use crate::files::Purpose;
use crate::job::{Job, Poll, Title};
use crate::open::{open, open_built_in, open_scenario};
use crate::save::Last;
use crate::view::PanelKind;
use crate::{complaint, with_document};
use anyhow::anyhow;
use eframe::egui::Context;
use octoscope_core::paper::{counterexample, find_other};
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::traverse::Variant;
use std::path::{Path, PathBuf};

/// What a job is to do.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Task {
    /// Open what the window begins with in place of what was open last.
    Start,
    /// Open what is shown instead of the present document.
    Open,
    /// The same, by a path that was typed.
    OpenTyped,
    /// The same, and it is said which rules it follows.
    Counterexample,
    /// Open what was open last.
    Restore,
    /// Make another tree for the present document.
    Rebuild,
    /// Find another ray and query for the present document.
    Aim,
}

impl App {
    /// Opens a file on another thread.
    pub fn open(&mut self, context: &Context, path: PathBuf) {
        self.begin_to_open(context, path, self.or_start(Task::Open));
    }

    /// The same by a path that was typed.
    pub(super) fn open_typed(&mut self, context: &Context, path: PathBuf) {
        self.begin_to_open(context, path, self.or_start(Task::OpenTyped));
    }

    /// `task`, or a start if that gives up what was open last while it comes: this comes
    /// back if the file cannot be opened.
    fn or_start(&self, task: Task) -> Task {
        match self.job {
            Some((_, Task::Restore)) => Task::Start,
            Some(_) | None => task,
        }
    }

    /// Opens the file that the window is started with; what was open last comes back if
    /// that fails.
    pub(super) fn start_on(&mut self, context: &Context, path: PathBuf, last: Option<Last>) {
        self.unrestored = last;
        self.begin_to_open(context, path, Task::Start);
    }

    fn begin_to_open(&mut self, context: &Context, path: PathBuf, task: Task) {
        let title = Title::Named("job-open", file_name(&path));
        let work = move |progress: &Progress| open(&path, progress);
        self.job = Some((Job::start(title, context, work), task));
    }

    /// Opens what was open last, on another thread as well.
    pub(super) fn restore(&mut self, context: &Context, last: Last) {
        let title = Title::Of("job-restore");
        self.unrestored = Some(last.clone());
        let work = move |progress: &Progress| {
            let Last { scenario, unchanged, folder, path } = last;
            let mut document = open_scenario(scenario, &folder, progress)?;
            with_document!(&mut document, d => (d.folder, d.path) = (folder, path));
            if let Some(unchanged) = unchanged {
                document.opened_as(unchanged);
            }
            Ok(document)
        };
        self.job = Some((Job::start(title, context, work), Task::Restore));
    }

    pub(super) fn open_scene(&mut self, context: &Context, id: &'static str) {
        let title = Title::Named("job-open", id.to_owned());
        let work = move |progress: &Progress| open_built_in(id, progress);
        self.job = Some((Job::start(title, context, work), Task::Open));
    }

    /// Opens the counterexample of a misprint.
    pub(super) fn open_counterexample(&mut self, context: &Context, variant: Variant) {
        let title = Title::Named("job-open", variant.id().to_owned());
        let work = move |progress: &Progress| {
            open_scenario(counterexample(variant), Path::new(""), progress)
        };
        self.job = Some((Job::start(title, context, work), Task::Counterexample));
    }

    /// Looks for another question on which the rules go wrong; each time for another.
    pub(super) fn find_other_question(&mut self, context: &Context) {
        self.n_searches += 1;
        let (seed, mut document) = (self.n_searches, self.document.clone());
        let (title, none) = (Title::Of("job-other"), self.look.text("paper-no-other"));
        let work = move |progress: &Progress| {
            let found = with_document!(&mut document, d => {
                let asked = (d.scenario.ray, d.scenario.query);
                let other = find_other(&d.tree, asked, seed, progress);
                other.map(|other| (d.scenario.ray, d.scenario.query) = other).is_some()
            });
            progress.check()?;
            if found { Ok(document) } else { Err(anyhow!(none)) }
        };
        self.job = Some((Job::start(title, context, work), Task::Aim));
    }

    pub(super) fn open_dropped(&mut self, context: &Context) {
        let dropped = context.input(|input| input.raw.dropped_files.clone());
        let Some(file) = dropped.into_iter().next() else { return };
        let path = file.path().to_owned();
        self.open(context, path);
    }

    pub(super) fn rebuild_if_needed(&mut self, context: &Context) {
        let needs = with_document!(&self.document, document => document.needs_building());
        if !needs || self.job.is_some() {
            return;
        }
        let title = Title::Of("job-build");
        let document = self.document.clone();
        let work = move |progress: &Progress| {
            Ok(match document {
                AnyDocument::Plane(plane) => AnyDocument::Plane(Box::new(plane.rebuilt(progress)?)),
                AnyDocument::Space(space) => AnyDocument::Space(Box::new(space.rebuilt(progress)?)),
            })
        };
        self.job = Some((Job::start(title, context, work), Task::Rebuild));
    }

    /// Cancels what is being opened or built, if there is anything.
    pub fn give_up_opening(&self) {
        if let Some((job, _)) = &self.job {
            job.progress.cancel();
        }
    }

    /// Waits until what is being opened, built, traced, found out, saved or drawn is
    /// there; without work, not at all.
    pub fn finish_work(&mut self) {
        self.finish_saving();
        if let Some(job) = &self.judging {
            self.conclude_judging(job.wait());
        }
        // Where it fails, what was open last may come after it.
        while let Some((job, _)) = &self.job {
            self.conclude(job.wait());
        }
        if let Some(job) = &self.tracing {
            self.conclude_tracing(job.wait());
        }
        self.maps.finish_work();
        if let Some(layers) = &mut self.layers {
            layers.finish();
        }
    }

    pub(super) fn poll_job(&mut self) {
        if let Some((job, _)) = &self.job {
            self.conclude(job.poll());
        }
    }

    /// Takes what a job has come to.
    fn conclude(&mut self, poll: Poll<anyhow::Result<AnyDocument>>) {
        let result = match poll {
            Poll::Running => return,
            Poll::Done(result) => result,
            Poll::Broken => Err(anyhow!(self.look.text("job-broken"))),
        };
        let Some((job, task)) = self.job.take() else { return };
        self.take_result(result, task, &job.context);
        // Whatever is opened instead of what was open last, nothing follows that.
        let start = self.started_on.take().filter(|_| task == Task::Restore);
        if let Some(path) = start {
            self.begin_to_open(&job.context, path, Task::Start);
        }
    }

    fn take_result(&mut self, result: anyhow::Result<AnyDocument>, task: Task, context: &Context) {
        match (result, task) {
            (
                Ok(document),
                Task::Start | Task::Open | Task::OpenTyped | Task::Counterexample | Task::Restore,
            ) => self.take_opened(document, task),
            (Ok(rebuilt), Task::Rebuild) => {
                let step = self.document.adopt(&rebuilt, self.view.playback.step);
                self.follow(step);
                (self.tracing, self.judging) = (None, None);
            }
            (Ok(aimed), Task::Aim) => {
                // What was asked meanwhile can be brought back.
                self.settle_now();
                self.document.ask_as(&aimed);
            }
            (Err(error), task) => {
                if task == Task::Rebuild {
                    with_document!(&mut self.document, document => document.keep_tree());
                }
                if error.root_cause().is::<Cancelled>() {
                    self.notice.say(self.look.text("status-cancelled"));
                } else {
                    self.tell_failure(&error, task);
                }
                if task == Task::Start {
                    self.restore_instead(context);
                }
            }
        }
    }

    /// Opens what was open last, if that was given up for what cannot be opened.
    fn restore_instead(&mut self, context: &Context) {
        if !self.is_changed()
            && let Some(last) = self.unrestored.take()
        {
            self.restore(context, last);
        }
    }

    /// Shows another document.
    fn take_opened(&mut self, document: AnyDocument, task: Task) {
        let changed = self.is_changed().then(|| self.titled());
        // A start is not undone, but for what was done meanwhile.
        if !matches!(task, Task::Start | Task::Restore) || changed.is_some() {
            self.settle_now();
            self.history.record(self.shown());
        }
        let method =
            with_document!(&self.document, d => method_told(&d.scenario.query, &self.look));
        self.document = document;
        (self.tracing, self.judging) = (None, None);
        // What no file has is tried again by the next start, as long as nothing else is made.
        let is_safe = |last: &Last| last.unchanged.is_none();
        if task == Task::Restore || self.unrestored.as_ref().is_some_and(is_safe) {
            self.unrestored = None;
        }
        self.saved = self.document.as_opened();
        if task != Task::Start {
            self.notice.clear();
        }
        let kept = changed.map(|title| {
            let title = title.trim_end_matches(" *").to_owned();
            self.look.texts.format("status-kept", &[("title", title.into())])
        });
        let rules = (task == Task::Counterexample).then(
            || with_document!(&self.document, d => rules_told(&d.scenario.query, &method, &self.look)),
        );
        if kept.is_some() || rules.is_some() {
            let all: Vec<String> = rules.into_iter().chain(kept).collect();
            self.notice.say(all.join("\n"));
        }
        self.go_to_start();
        if with_document!(&self.document, d => d.scenario.query.is_misprinted()) {
            self.view.sought = Some(PanelKind::Paper);
        }
        self.show_mirrored_ray();
        self.settled = self.shown();
    }

    /// Shows the mirrored ray as long as a document is open that gets it wrong; afterwards
    /// what was shown before.
    fn show_mirrored_ray(&mut self) {
        let gets_it_wrong = with_document!(&self.document, d => d.scenario.query.variants_at_work().has(Variant::B7));
        let shown =
            [&mut self.view.plane_show.mirrored_ray, &mut self.view.space_show.mirrored_ray];
        let before = self.mirrored_before.take();
        if gets_it_wrong {
            self.mirrored_before = before.or(Some([*shown[0], *shown[1]]));
            shown.into_iter().for_each(|shown| *shown = true);
        } else if let Some(before) = before {
            shown.into_iter().zip(before).for_each(|(shown, before)| *shown = before);
        }
    }

    /// Says why a job came to nothing; at a start, without a dialog.
    fn tell_failure(&mut self, error: &anyhow::Error, task: Task) {
        match task {
            Task::Restore => {
                let why = complaint::told(&self.look.texts, error);
                let arguments = [("why", why.into())];
                self.notice.say(self.look.texts.format("status-not-restored", &arguments));
            }
            Task::OpenTyped => self.refuse_path(error, |typed| typed.purpose == Purpose::Open),
            Task::Start | Task::Open | Task::Counterexample | Task::Rebuild | Task::Aim => {
                self.complain(error);
            }
        }
    }
}
