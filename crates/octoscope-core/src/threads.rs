//! Work on several threads: what comes of it is the same for any number of them.

use std::num::NonZeroUsize;
use std::panic::resume_unwind;
use std::sync::{Mutex, PoisonError};
use std::thread::{self, ScopedJoinHandle};

/// As many threads as the machine runs at once; one where that is not known.
pub(crate) fn all_threads() -> NonZeroUsize {
    thread::available_parallelism().unwrap_or(NonZeroUsize::MIN)
}

/// Does `work` on every task, by so many threads at most, each of which takes the next
/// task when it is done with one; the results are in the order of the tasks.
///
/// # Panics
/// Panics if `work` does.
pub(crate) fn in_order<T: Send, R: Send>(
    threads: NonZeroUsize,
    tasks: impl ExactSizeIterator<Item = T> + Send,
    work: impl Fn(T) -> R + Sync,
) -> Vec<R> {
    let n_tasks = tasks.len();
    if threads.get() == 1 || n_tasks <= 1 {
        return tasks.map(work).collect();
    }
    let tasks = Mutex::new(tasks.enumerate());
    let next = || tasks.lock().unwrap_or_else(PoisonError::into_inner).next();
    let work_on = || -> Vec<(usize, R)> {
        std::iter::from_fn(next).map(|(number, task)| (number, work(task))).collect()
    };
    let mut results = thread::scope(|scope| {
        let others: Vec<ScopedJoinHandle<_>> =
            (1..threads.get().min(n_tasks)).map(|_| scope.spawn(work_on)).collect();
        let mut results = work_on();
        for other in others {
            results.extend(other.join().unwrap_or_else(|panic| resume_unwind(panic)));
        }
        results
    });
    results.sort_unstable_by_key(|(number, _)| *number);
    results.into_iter().map(|(_, result)| result).collect()
}

/// Does `work` on parts of the items of about equal length, one for each of so many
/// threads at most; this thread does the first.
///
/// # Panics
/// Panics if `work` does.
pub fn in_parts<T: Sync>(threads: NonZeroUsize, items: &[T], work: impl Fn(&[T]) + Sync) {
    let mut parts = items.chunks(items.len().div_ceil(threads.get()).max(1));
    let Some(own) = parts.next() else { return };
    thread::scope(|scope| {
        let work = &work;
        for part in parts {
            scope.spawn(move || work(part));
        }
        work(own);
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_in_the_order_of_the_tasks() {
        for threads in [1, 2, 3, 16] {
            let threads = NonZeroUsize::new(threads).unwrap();
            for n in [0, 1, 2, 1000] {
                let squares = in_order(threads, 0..n, |task| task * task);
                assert_eq!(squares, (0..n).map(|task| task * task).collect::<Vec<i32>>());
            }
        }
    }

    #[test]
    fn every_item_is_in_one_part() {
        for n in [0, 1, 5, 1000] {
            let items: Vec<usize> = (0..n).collect();
            for threads in [1, 2, 3, 16] {
                let parts = Mutex::new(Vec::new());
                in_parts(NonZeroUsize::new(threads).unwrap(), &items, |part| {
                    parts.lock().unwrap().push(part.to_vec());
                });
                let mut parts = parts.into_inner().unwrap();
                assert!(parts.len() <= threads);
                parts.sort();
                assert_eq!(parts.concat(), items);
            }
        }
    }

    #[test]
    #[should_panic(expected = "task 7")]
    fn what_breaks_a_thread_breaks_the_work() {
        let threads = NonZeroUsize::new(3).unwrap();
        in_order(threads, 0..20, |task| assert!(task != 7, "task {task}"));
    }
}
