//! Frames of what moves, drawn on several threads.

use super::Series;
use super::frames::Frames;
use super::made::Made;
use octoscope_core::progress::Progress;
use octoscope_figure::{FileOptions, Pixels, Rasteriser};
use std::num::NonZero;
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread;

/// Steps that one thread draws one after the other: they differ little.
const IN_A_ROW: usize = 16;

/// Calls `then` with the pixels of all steps of `series`, in their order, while
/// the next ones are being drawn.
///
/// # Errors
/// Says what cannot be drawn, or what `then` says; tells if it was cancelled.
pub(super) fn each_frame(
    series: &Series,
    (made, frames): (&Made, &Frames),
    options: &FileOptions,
    progress: &Progress,
    mut then: impl FnMut(Pixels) -> anyhow::Result<()>,
) -> anyhow::Result<()> {
    let steps: Vec<usize> = series.steps.clone().collect();
    let n_rows = steps.len().div_ceil(IN_A_ROW);
    let n_threads = thread::available_parallelism().map_or(1, NonZero::get).min(n_rows);
    thread::scope(|scope| {
        // A thread whose frames nobody waits for any more ends.
        let drawn: Vec<_> = (0..n_threads)
            .map(|thread| {
                let (sender, receiver) = sync_channel(IN_A_ROW);
                let rows = steps.chunks(IN_A_ROW).skip(thread).step_by(n_threads);
                scope.spawn(move || draw(rows.flatten(), (made, frames), options, &sender));
                receiver
            })
            .collect();
        for (row, receiver) in steps.chunks(IN_A_ROW).zip(drawn.iter().cycle()) {
            for _ in row {
                progress.advance(1)?;
                then(receiver.recv()??)?;
            }
        }
        Ok(())
    })
}

fn draw<'a>(
    steps: impl Iterator<Item = &'a usize>,
    (made, frames): (&Made, &Frames),
    options: &FileOptions,
    sender: &SyncSender<anyhow::Result<Pixels>>,
) {
    let mut rasteriser = Rasteriser::new(options);
    for &step in steps {
        let pixels = frames
            .figure(made, step)
            .and_then(|figure| rasteriser.pixels(&figure).map_err(anyhow::Error::from));
        let is_last = pixels.is_err();
        if sender.send(pixels).is_err() || is_last {
            return;
        }
    }
}
