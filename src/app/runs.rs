//! Traces of long runs, and what is found out about them, on other threads.

use super::App;
use crate::document::AnyDocument;
use crate::job::{Job, Poll, Title};
use crate::with_document;
use eframe::egui::Context;
use octoscope_core::progress::{Cancelled, Progress};

impl App {
    /// Makes the trace of the present question on another thread, if it is too long
    /// to be made at once. One after the other: what has been asked meanwhile is
    /// traced after it, the last question only.
    pub(super) fn trace_if_needed(&mut self, context: &Context) {
        let needs = with_document!(&self.document, document => document.needs_tracing());
        if !needs || self.tracing.is_some() {
            return;
        }
        let mut document = self.document.clone();
        let work = move |progress: &Progress| {
            with_document!(&mut document, d => d.trace_anew(progress))?;
            Ok(document)
        };
        self.tracing = Some(Job::start(Title::Of("job-trace"), context, work));
    }

    /// Cancels the trace that is being made, if there is one.
    pub fn give_up_tracing(&self) {
        if let Some(job) = &self.tracing {
            job.progress.cancel();
        }
    }

    pub(super) fn poll_tracing(&mut self) {
        if let Some(job) = &self.tracing {
            self.conclude_tracing(job.poll());
        }
    }

    pub(super) fn conclude_tracing(&mut self, poll: Poll<Result<AnyDocument, Cancelled>>) {
        match poll {
            Poll::Running => return,
            Poll::Done(Ok(traced)) => {
                let step = self.document.take_trace(&traced, self.view.playback.step);
                self.follow(step);
            }
            // Given up: the question of the trace there is comes back with it.
            Poll::Done(Err(Cancelled)) => {
                with_document!(&mut self.document, document => document.keep_trace());
            }
            Poll::Broken => {
                with_document!(&mut self.document, document => document.keep_trace());
                self.tell_error(self.look.text("job-broken"));
            }
        }
        self.tracing = None;
    }

    /// Moves the playhead to where it belongs in a new trace.
    pub(super) fn follow(&mut self, step: usize) {
        if step != self.view.playback.step {
            self.go_to(step);
        }
    }

    /// Finds out on another thread what the panels have asked for about the run, if
    /// that takes long. One after the other, as traces are made.
    pub(super) fn judge_if_needed(&mut self, context: &Context) {
        let wants = with_document!(&self.document, document => document.wants_judging());
        if !wants || self.judging.is_some() {
            return;
        }
        let mut document = self.document.clone();
        let work = move |progress: &Progress| {
            with_document!(&mut document, d => d.judge(progress))?;
            Ok(document)
        };
        self.judging = Some(Job::start(Title::Silent, context, work));
        // What is not quite as quick is awaited, so that nothing flickers.
        self.poll_judging();
    }

    pub(super) fn poll_judging(&mut self) {
        if let Some(job) = &self.judging {
            self.conclude_judging(job.poll());
        }
    }

    pub(super) fn conclude_judging(&mut self, poll: Poll<Result<AnyDocument, Cancelled>>) {
        match poll {
            Poll::Running => return,
            Poll::Done(Ok(judged)) => self.document.take_judged(&judged),
            // Another document is open.
            Poll::Done(Err(Cancelled)) => {}
            Poll::Broken => {
                with_document!(&mut self.document, document => document.give_up_judging());
                self.tell_error(self.look.text("job-broken"));
            }
        }
        self.judging = None;
    }
}
