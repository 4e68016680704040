//! The bench lab: its dialog, and its work on another thread.

use super::App;
use super::exporting::Made;
use super::telling::file_name;
use crate::bench::run;
use crate::comparison::is_quick;
use crate::job::{Job, Poll, Title};
use crate::lab::{self, SIZE_OF_FILES, Tab, figure};
use crate::lab_dialog::{self, Answer, Shown, State};
use crate::view::Dialog;
use crate::with_document;
use anyhow::anyhow;
use eframe::egui::Context;
use octoscope_core::measure::{Results, Watched, watch};
use octoscope_core::progress::Progress;
use octoscope_core::traverse::Algorithm;
use octoscope_figure::views::lab::{scene_name, way_name};
use std::path::Path;
use std::time::Duration;

/// What the lab has measured, and what it is measuring.
#[derive(Default)]
pub(super) struct Measuring {
    results: Results,
    /// What is to be known about the results.
    remark: Remark,
    job: Option<Job<anyhow::Result<Results>>>,
}

/// What is to be known about results.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Remark {
    /// Nothing.
    #[default]
    None,
    /// They are not all that was wanted.
    Stopped,
    /// Some trees could not be built.
    LeftOut,
    /// The times are those of a program without optimisation.
    Unoptimised,
    /// All algorithms agree.
    Agree,
}

impl App {
    /// Shows the lab, if it is open.
    pub(super) fn show_lab(&mut self, context: &Context) {
        self.poll_measuring(context);
        if self.view.dialog != Some(Dialog::Lab) {
            return;
        }
        let mut choice = self.view.lab.clone();
        let (watched, left_out) = self.watched();
        let note = match choice.tab {
            Tab::Processor => self.left_out(&left_out),
            Tab::Scenes | Tab::Growth | Tab::Published | Tab::Table => self.remark(),
        };
        let state = match &self.measuring.job {
            Some(job) => State::Running(job.progress.fraction()),
            None => State::Idle,
        };
        let shown = Shown {
            choice: &mut choice,
            results: &self.measuring.results,
            watched: &watched,
            state,
            note: note.as_deref(),
        };
        let answer = lab_dialog::ui(context, &self.look, shown);
        self.view.lab = choice;
        match answer {
            None => {}
            Some(Answer::Run) => self.measure(context),
            Some(Answer::Stop) => {
                if let Some(job) = &self.measuring.job {
                    job.progress.cancel();
                }
            }
            Some(Answer::Save(ending)) => self.chosen.ask_lab(context, ending),
            Some(Answer::Close) => self.view.dialog = None,
        }
    }

    /// What the chosen algorithms do on the present ray, where that is shown, and which
    /// of them would take too long.
    fn watched(&self) -> (Vec<Watched>, Vec<Algorithm>) {
        if self.view.lab.tab != Tab::Processor {
            return (Vec::new(), Vec::new());
        }
        let chosen = self.view.lab.chosen_algorithms();
        with_document!(&self.document, d => {
            let is_watched = |algorithm: &Algorithm| {
                *algorithm != Algorithm::Exhaustive && is_quick(*algorithm, &d.tree)
            };
            let (quick, slow): (Vec<_>, Vec<_>) = chosen.into_iter().partition(is_watched);
            (watch(&d.tree, &d.scenario.ray, &quick), slow)
        })
    }

    fn left_out(&self, algorithms: &[Algorithm]) -> Option<String> {
        let names = algorithms.iter().map(|&one| way_name(one.into(), &self.look.texts));
        let names = names.collect::<Vec<_>>().join(", ");
        let told = || self.look.texts.format("lab-left-out", &[("names", names.clone().into())]);
        (!algorithms.is_empty()).then(told)
    }

    /// What is to be known about the results, in words.
    fn remark(&self) -> Option<String> {
        let texts = &self.look.texts;
        let sites = self.measuring.results.sites.iter();
        let differs = sites.filter_map(|site| Some((site, site.disagreement?))).next();
        if let Some((site, found)) = differs {
            let arguments = [
                ("scene", scene_name(&site.scene, texts).into()),
                ("depth", site.depth.into()),
                ("method", way_name(found.way, texts).into()),
                ("reference", way_name(found.reference, texts).into()),
                ("ray", (found.ray + 1).into()),
            ];
            return Some(texts.format("lab-disagrees", &arguments));
        }
        match self.measuring.remark {
            Remark::None => None,
            Remark::Stopped => Some(texts.get("lab-stopped")),
            Remark::LeftOut => {
                let left_out = self.measuring.results.left_out.iter();
                let names = left_out
                    .map(|one| format!("{} ({})", scene_name(&one.scene, texts), one.depth));
                let names = names.collect::<Vec<_>>().join(", ");
                Some(texts.format("lab-not-built", &[("names", names.into())]))
            }
            Remark::Unoptimised => Some(texts.get("lab-unoptimised")),
            Remark::Agree => Some(texts.get("lab-agree")),
        }
    }

    /// Begins to measure what is chosen.
    fn measure(&mut self, context: &Context) {
        let Some(plan) = self.view.lab.plan() else { return };
        let work = move |progress: &Progress| run(&plan, progress);
        self.measuring.job = Some(Job::start(Title::Of("lab-running"), context, work));
    }

    fn poll_measuring(&mut self, context: &Context) {
        let Some(job) = self.measuring.job.take() else { return };
        match job.poll() {
            Poll::Running => {
                context.request_repaint_after(Duration::from_millis(100));
                self.measuring.job = Some(job);
            }
            poll => self.measured(&job, poll),
        }
    }

    /// Waits until everything is measured.
    pub fn finish_measuring(&mut self) {
        if let Some(job) = self.measuring.job.take() {
            self.measured(&job, job.wait());
        }
    }

    fn measured(
        &mut self,
        job: &Job<anyhow::Result<Results>>,
        poll: Poll<anyhow::Result<Results>>,
    ) {
        let results = match poll {
            Poll::Running => return,
            Poll::Done(results) => results,
            Poll::Broken => Err(anyhow!(self.look.text("job-broken"))),
        };
        match results {
            Ok(results) => {
                let was_stopped = job.progress.check().is_err();
                // What was there is worth more than nothing.
                if was_stopped && results.sites.is_empty() {
                    return;
                }
                let is_whole = results.left_out.is_empty();
                self.take_results(results);
                self.measuring.remark = match (was_stopped, is_whole) {
                    (true, _) => Remark::Stopped,
                    (false, false) => Remark::LeftOut,
                    (false, true) if cfg!(debug_assertions) => Remark::Unoptimised,
                    (false, true) => Remark::Agree,
                };
            }
            Err(error) => self.complain(&error),
        }
    }

    /// Shows these results in the lab.
    pub fn take_results(&mut self, results: Results) {
        self.measuring.results = results;
        self.measuring.remark = Remark::None;
    }

    /// Writes what the lab shows to `path`, whose ending tells the format.
    pub(super) fn save_lab(&mut self, context: &Context, path: &Path) {
        let choice = &self.view.lab;
        let (watched, _) = self.watched();
        let chart =
            figure(choice, &self.measuring.results, &watched, &self.look.texts, SIZE_OF_FILES);
        let title = format!("{}: {}", self.look.text("lab-title"), self.look.text(choice.tab.id()));
        let (results, theme) = (self.measuring.results.clone(), self.view.theme);
        let (name, path) = (file_name(path), path.to_owned());
        let job = Title::Named("job-export", name);
        // It is shown again after the dialog about the path.
        self.view.dialog = Some(Dialog::Lab);
        self.make(context, job, move |progress| {
            lab::write(&results, &chart, (theme, &title), &path, progress)?;
            Ok(Made::File { path, left_out: None })
        });
    }
}
