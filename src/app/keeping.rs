//! Keeping what is open for the next start: now and then, and at the end.

use super::App;
use super::jobs::Task;
use crate::job::{Job, Poll, Title};
use crate::save::{self, Kept, Last};
use crate::with_document;
use eframe::egui::Context;

/// Time between two times.
const PERIOD_SECS: f64 = 30.0;

/// What is being kept.
#[derive(Default)]
pub(super) struct Keeping {
    /// Time of the window when it was last begun.
    begun_secs: f64,
    /// A large scenario takes long to print: another thread does it.
    job: Option<Job<Kept>>,
}

impl App {
    /// Keeps what is open if that was last done long ago, so that little is lost if the
    /// program does not come to its end.
    pub(super) fn keep_now_and_then(&mut self, context: &Context, frame: &mut eframe::Frame) {
        let Some(storage) = frame.storage_mut() else { return };
        if let Some(job) = &self.keeping.job {
            match job.poll() {
                Poll::Running => return,
                Poll::Done(kept) => {
                    self.keep_view(storage);
                    kept.put(storage);
                    storage.flush();
                }
                // The next time may do better.
                Poll::Broken => {}
            }
            self.keeping.job = None;
        }
        let now_secs = context.input(|input| input.time);
        if now_secs - self.keeping.begun_secs >= PERIOD_SECS {
            self.keeping.begun_secs = now_secs;
            self.begin_to_keep(context);
        }
    }

    /// Begins to print what is open.
    pub fn begin_to_keep(&mut self, context: &Context) {
        let last = self.last();
        self.keeping.job = Some(Job::start(Title::Silent, context, |_| Kept::of(&last())));
    }

    /// Waits for what is being printed, and keeps it in `storage`.
    pub fn finish_keeping(&mut self, storage: &mut dyn eframe::Storage) {
        let Some(job) = self.keeping.job.take() else { return };
        if let Poll::Done(kept) = job.wait() {
            self.keep_view(storage);
            kept.put(storage);
        }
    }

    /// Keeps everything at once.
    pub(super) fn keep_at_the_end(&self, storage: &mut dyn eframe::Storage) {
        self.keep_view(storage);
        Kept::of(&self.last()()).put(storage);
    }

    fn keep_view(&self, storage: &mut dyn eframe::Storage) {
        if let Ok(view) = serde_json::to_string(&self.view) {
            storage.set_string(save::VIEW_KEY, view);
        }
    }

    /// What the next start begins with; made on any thread, as it may hold many points.
    /// What was open last stays it as long as it is not there and nothing else is made.
    fn last(&self) -> impl FnOnce() -> Last + Send + use<> {
        let is_coming = self.job.as_ref().is_some_and(|(_, task)| *task == Task::Restore);
        let is_changed = self.is_changed();
        let unrestored = self.unrestored.clone().filter(|_| is_coming || !is_changed);
        let (document, step) = (self.document.clone(), self.view.playback.step);
        let view = self.kept_view();
        let saved = is_changed.then(|| self.saved.clone());
        let present = move || {
            let mut scenario = document.scenario_at(step);
            view.keep_in(&mut scenario);
            let unchanged = saved.map(|saved| document.unchanged(&saved));
            let (folder, path) = with_document!(&document, d => (d.folder.clone(), d.path.clone()));
            Last { scenario, unchanged, folder, path }
        };
        move || unrestored.unwrap_or_else(present)
    }
}
