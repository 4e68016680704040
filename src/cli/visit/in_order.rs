//! Work on several threads, results in order.

use std::io;
use std::num::NonZeroUsize;
use std::panic::resume_unwind;
use std::thread;

/// Items that a thread works on before results are handed on.
const BLOCK: usize = 1024;

/// Does `work` on every item, by so many threads, and hands the results to
/// `take` with the numbers of their items, in order.
///
/// # Errors
/// Stops at the first error of `take`.
pub fn in_order<T: Sync, R: Send>(
    items: &[T],
    threads: NonZeroUsize,
    work: impl Fn(&T) -> R + Sync,
    mut take: impl FnMut(usize, R) -> io::Result<()>,
) -> io::Result<()> {
    if threads.get() == 1 {
        return items.iter().enumerate().try_for_each(|(index, item)| take(index, work(item)));
    }
    let mut results_so_far = 0;
    for block in items.chunks(BLOCK.saturating_mul(threads.get())) {
        let parts = block.chunks(block.len().div_ceil(threads.get()));
        let results: Vec<Vec<R>> = thread::scope(|scope| {
            let workers: Vec<_> =
                parts.map(|part| scope.spawn(|| part.iter().map(&work).collect())).collect();
            let joined = workers.into_iter().map(thread::ScopedJoinHandle::join);
            joined.map(|part| part.unwrap_or_else(|panic| resume_unwind(panic))).collect()
        });
        for result in results.into_iter().flatten() {
            take(results_so_far, result)?;
            results_so_far += 1;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_order_from_any_number_of_threads() {
        let items: Vec<usize> = (0..5000).collect();
        for threads in [1, 2, 3, 7] {
            let mut taken = Vec::new();
            let threads = NonZeroUsize::new(threads).unwrap();
            in_order(
                &items,
                threads,
                |n| n * 2,
                |index, double| {
                    assert_eq!(double, index * 2);
                    taken.push(index);
                    Ok(())
                },
            )
            .unwrap();
            assert_eq!(taken, items);
        }
    }

    #[test]
    fn the_first_error_stops_the_work() {
        let mut taken = 0;
        let result = in_order(
            &[1, 2, 3],
            NonZeroUsize::MIN,
            |n| *n,
            |_, n| {
                taken = n;
                if n == 2 { Err(io::ErrorKind::BrokenPipe.into()) } else { Ok(()) }
            },
        );
        assert_eq!((result.unwrap_err().kind(), taken), (io::ErrorKind::BrokenPipe, 2));
    }
}
