//! Work on several threads, results in order.

use std::collections::BTreeMap;
use std::io;
use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::sync_channel;
use std::thread;

/// Items that a thread works on at once, so many that handing their results on is
/// nothing beside it.
pub const BLOCK: usize = 512;

/// Blocks a thread after which all wait for the slowest, so that results that come early
/// need not all be kept.
const BLOCKS_A_ROUND: usize = 64;

/// Does `work` on blocks of the items, by so many threads, and hands the results to
/// `take`, in order and while the next ones are worked on.
///
/// # Errors
/// Stops at the first error of `take`.
pub fn in_order<T: Sync, R: Send>(
    items: &[T],
    threads: NonZeroUsize,
    work: impl Fn(&[T]) -> R + Sync,
    mut take: impl FnMut(R) -> io::Result<()>,
) -> io::Result<()> {
    if threads.get() == 1 {
        return items.chunks(BLOCK).try_for_each(|block| take(work(block)));
    }
    let mut rounds = items.chunks(BLOCK * BLOCKS_A_ROUND * threads.get());
    rounds.try_for_each(|items| one_round(items, threads, &work, &mut take))
}

fn one_round<T: Sync, R: Send>(
    items: &[T],
    threads: NonZeroUsize,
    work: &(impl Fn(&[T]) -> R + Sync),
    take: &mut impl FnMut(R) -> io::Result<()>,
) -> io::Result<()> {
    let next = AtomicUsize::new(0);
    thread::scope(|scope| {
        let (sender, results) = sync_channel(threads.get());
        for _ in 0..threads.get() {
            let (next, sender) = (&next, sender.clone());
            scope.spawn(move || {
                let numbers = std::iter::repeat_with(|| next.fetch_add(1, Ordering::Relaxed));
                let blocks = numbers.map_while(|n| Some((n, items.chunks(BLOCK).nth(n)?)));
                for (number, block) in blocks {
                    // Nobody takes it after an error.
                    if sender.send((number, work(block))).is_err() {
                        return;
                    }
                }
            });
        }
        drop(sender);
        let (mut n_taken, mut early) = (0, BTreeMap::new());
        for (number, result) in results {
            early.insert(number, result);
            while let Some(result) = early.remove(&n_taken) {
                take(result)?;
                n_taken += 1;
            }
        }
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_order_from_any_number_of_threads() {
        for n in [0, 1, BLOCK, 200 * BLOCK + 1] {
            let items: Vec<usize> = (0..n).collect();
            for threads in [1, 2, 3, 7] {
                let mut taken: Vec<usize> = Vec::new();
                let threads = NonZeroUsize::new(threads).unwrap();
                let doubled = |block: &[usize]| block.iter().map(|n| n * 2).collect::<Vec<_>>();
                in_order(&items, threads, doubled, |block| {
                    taken.extend(block);
                    Ok(())
                })
                .unwrap();
                assert!(taken.into_iter().eq((0..n).map(|n| n * 2)));
            }
        }
    }

    #[test]
    fn the_first_error_stops_the_work() {
        for threads in [1, 3] {
            let mut n_taken = 0;
            let threads = NonZeroUsize::new(threads).unwrap();
            let result = in_order(&[0; 20 * BLOCK], threads, <[_]>::len, |_| {
                n_taken += 1;
                if n_taken == 2 { Err(io::ErrorKind::BrokenPipe.into()) } else { Ok(()) }
            });
            assert_eq!((result.unwrap_err().kind(), n_taken), (io::ErrorKind::BrokenPipe, 2));
        }
    }
}
