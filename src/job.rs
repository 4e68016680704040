//! Work on another thread, with progress and cancel.

use eframe::egui::Context;
use octoscope_core::progress::Progress;
use octoscope_core::text::Texts;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// What is done, to be said in the language of the moment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Title {
    /// Nothing is said of it.
    Silent,
    /// The text of a key.
    Of(&'static str),
    /// The same with a name in it.
    Named(&'static str, String),
}

impl Title {
    /// What is done, in the user's words.
    pub fn told(&self, texts: &Texts) -> String {
        match self {
            Self::Silent => String::new(),
            Self::Of(key) => texts.get(key),
            Self::Named(key, name) => texts.format(key, &[("name", name.clone().into())]),
        }
    }
}

/// A computation that has been started.
pub struct Job<T> {
    /// What is done.
    pub title: Title,
    /// The window that waits for it.
    pub context: Context,
    /// How far it is; cancels it.
    pub progress: Arc<Progress>,
    started: Instant,
    receiver: Receiver<T>,
}

/// State of a job.
pub enum Poll<T> {
    /// Not yet done.
    Running,
    /// Done, with this result.
    Done(T),
    /// It stopped without a result.
    Broken,
}

impl<T: Send + 'static> Job<T> {
    /// Work of less than this is awaited, so that the window does not flicker.
    const PATIENCE: Duration = Duration::from_millis(12);
    /// Longer work shows its progress.
    const SHOWN_AFTER: Duration = Duration::from_millis(250);

    /// Starts `work` on another thread and wakes the window when it is done.
    pub fn start(
        title: Title,
        context: &Context,
        work: impl FnOnce(&Progress) -> T + Send + 'static,
    ) -> Self {
        let progress = Arc::new(Progress::default());
        let (sender, receiver) = channel();
        let context = context.clone();
        let job = Self {
            title,
            context: context.clone(),
            progress: Arc::clone(&progress),
            started: Instant::now(),
            receiver,
        };
        std::thread::spawn(move || {
            // Nobody may be waiting any more: then the result is not wanted.
            let _ = sender.send(work(&progress));
            context.request_repaint();
        });
        job
    }

    /// Looks whether the work is done.
    pub fn poll(&self) -> Poll<T> {
        let patience = Self::PATIENCE.saturating_sub(self.started.elapsed());
        match self.receiver.recv_timeout(patience) {
            Ok(result) => Poll::Done(result),
            Err(RecvTimeoutError::Timeout) => Poll::Running,
            Err(RecvTimeoutError::Disconnected) => Poll::Broken,
        }
    }

    /// Waits until the work is done.
    pub fn wait(&self) -> Poll<T> {
        self.receiver.recv().map_or(Poll::Broken, Poll::Done)
    }

    /// Whether it has lasted long enough to be shown.
    pub fn is_shown(&self) -> bool {
        self.started.elapsed() >= Self::SHOWN_AFTER
    }
}

impl<T> Drop for Job<T> {
    fn drop(&mut self) {
        self.progress.cancel();
    }
}
