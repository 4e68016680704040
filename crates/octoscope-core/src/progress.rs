//! How far a long computation is, and whether it is still wanted.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use thiserror::Error;

/// Shared between the thread that computes and the one that waits.
#[derive(Debug, Default)]
pub struct Progress {
    done: AtomicU64,
    total: AtomicU64,
    /// Number of the present stage, and of all stages; none of them is 0 if the
    /// computation is of one piece.
    stage: AtomicU64,
    n_stages: AtomicU64,
    /// The largest part of all stages that was told, as bits.
    told: AtomicU64,
    cancelled: AtomicBool,
}

/// The computation was cancelled through [`Progress::cancel`].
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("cancelled")]
pub struct Cancelled;

impl Progress {
    /// Says that `total` units of work lie ahead, none of them done.
    pub fn start(&self, total: u64) {
        self.done.store(0, Ordering::Relaxed);
        self.total.store(total, Ordering::Relaxed);
    }

    /// Says that stage number `stage`, from 0, of `n_stages` begins, which are taken to
    /// last equally long: what is started from now on is a part of it.
    pub fn enter_stage(&self, stage: u64, n_stages: u64) {
        self.start(0);
        self.stage.store(stage, Ordering::Relaxed);
        self.n_stages.store(n_stages, Ordering::Relaxed);
    }

    /// Says that `units` more are done.
    ///
    /// # Errors
    /// Returns [`Cancelled`] when nobody wants the result any more.
    pub fn advance(&self, units: u64) -> Result<(), Cancelled> {
        self.done.fetch_add(units, Ordering::Relaxed);
        self.check()
    }

    /// Asks whether the result is still wanted.
    ///
    /// # Errors
    /// Returns [`Cancelled`] when nobody wants it any more.
    pub fn check(&self) -> Result<(), Cancelled> {
        if self.cancelled.load(Ordering::Relaxed) { Err(Cancelled) } else { Ok(()) }
    }

    /// Asks the computation to stop soon.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Part that is done, 0 to 1; `None` while its size is unknown.
    pub fn fraction(&self) -> Option<f64> {
        let [done, total, stage, n_stages] = [&self.done, &self.total, &self.stage, &self.n_stages]
            .map(|number| number.load(Ordering::Relaxed) as f64);
        let of_stage = (total > 0.0).then(|| (done / total).min(1.0));
        if n_stages == 0.0 {
            return of_stage;
        }
        // What begins anew within a stage does not go back. Bits of numbers that are not
        // negative are in the order of the numbers.
        let part = ((stage + of_stage.unwrap_or(0.0)) / n_stages).min(1.0);
        let before = f64::from_bits(self.told.fetch_max(part.to_bits(), Ordering::Relaxed));
        Some(part.max(before))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stage_is_a_part_of_the_whole() {
        let progress = Progress::default();
        assert_eq!(progress.fraction(), None);
        progress.start(4);
        assert_eq!(progress.advance(1), Ok(()));
        assert_eq!(progress.fraction(), Some(0.25));
        progress.enter_stage(2, 4);
        assert_eq!(progress.fraction(), Some(0.5));
        progress.start(2);
        assert_eq!(progress.advance(1), Ok(()));
        assert_eq!(progress.fraction(), Some(0.625));
        progress.start(100);
        assert_eq!(progress.fraction(), Some(0.625), "it does not go back");
        progress.cancel();
        assert_eq!(progress.advance(1), Err(Cancelled));
    }
}
