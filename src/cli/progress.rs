//! How far a long command is, on standard error.

use octoscope_core::progress::Progress;
use std::io::{self, IsTerminal, Write};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// Runs `work`. Where standard error is a terminal, a line there tells how far it
/// is once it has lasted a while; nothing stays of it.
pub(super) fn run_with_progress<T>(work: impl FnOnce(&Progress) -> T) -> T {
    const PATIENCE: Duration = Duration::from_millis(300);
    let progress = Progress::default();
    if !io::stderr().is_terminal() {
        return work(&progress);
    }
    thread::scope(|scope| {
        let (done, is_done) = channel::<()>();
        let watched = &progress;
        let shown = scope.spawn(move || {
            let mut has_written = false;
            while is_done.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                if let Some(fraction) = watched.fraction() {
                    has_written |= write!(io::stderr(), "\r{}", bar(fraction)).is_ok();
                }
            }
            if has_written {
                // If nobody reads it, that is no fault.
                let _ = write!(io::stderr(), "\r{:width$}\r", "", width = bar(1.0).len());
            }
        });
        let result = work(&progress);
        drop(done);
        // It ends at once, and cannot fail.
        let _ = shown.join();
        result
    })
}

fn bar(fraction: f64) -> String {
    const WIDTH: usize = 40;
    let n = (fraction * WIDTH as f64) as usize;
    format!("[{}{}] {:3.0} %", "#".repeat(n), " ".repeat(WIDTH - n), 100.0 * fraction)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_are_of_one_length() {
        assert_eq!(bar(0.5).matches('#').count(), 20);
        assert_eq!(bar(0.0).len(), bar(1.0).len());
    }

    #[test]
    fn the_result_of_the_work_comes_back() {
        assert_eq!(run_with_progress(|_| 7), 7);
    }
}
