//! Undo and redo.

use std::collections::HashMap;
use std::sync::Arc;

/// States before and after the present one.
#[derive(Clone, Debug)]
pub struct History<T> {
    past: Vec<T>,
    future: Vec<T>,
}

/// A part of a state that other states may share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shared {
    /// Where it lies: two parts of one address are the same.
    pub address: usize,
    /// Memory that it takes.
    pub bytes: usize,
}

impl Shared {
    /// A part that takes so many bytes.
    pub fn of<T>(part: &Arc<T>, bytes: usize) -> Self {
        Self { address: Arc::as_ptr(part) as usize, bytes }
    }
}

/// What tells how much memory it takes.
pub trait Weighed {
    /// All large parts.
    fn shared(&self) -> Vec<Shared>;
}

impl<T> Default for History<T> {
    fn default() -> Self {
        Self { past: Vec::new(), future: Vec::new() }
    }
}

impl<T: Weighed> History<T> {
    /// Number of states that are kept.
    const LIMIT: usize = 50;
    /// Memory that they may take together, in bytes.
    const MOST_BYTES: usize = 512 << 20;

    /// Remembers `before`, which has just been replaced by something new. The
    /// oldest states are forgotten if all together take too much memory; the
    /// last one never is.
    pub fn record(&mut self, before: T) {
        self.past.push(before);
        self.future.clear();
        let kept = n_kept(&self.past).max(1);
        self.past.drain(..self.past.len() - kept);
    }
}

/// Number of states, counted from the last, that are few and small enough.
fn n_kept<T: Weighed>(states: &[T]) -> usize {
    let mut parts = HashMap::new();
    let mut bytes = 0;
    let small = states.iter().rev().take(History::<T>::LIMIT).take_while(|state| {
        for part in state.shared() {
            if parts.insert(part.address, part.bytes).is_none() {
                bytes += part.bytes;
            }
        }
        bytes <= History::<T>::MOST_BYTES
    });
    small.count()
}

impl<T> History<T> {
    /// Exchanges `present` for the state before it; `None` if there is none.
    pub fn undo(&mut self, present: T) -> Option<T> {
        let before = self.past.pop()?;
        self.future.push(present);
        Some(before)
    }

    /// Exchanges `present` for the state that was undone last.
    pub fn redo(&mut self, present: T) -> Option<T> {
        let after = self.future.pop()?;
        self.past.push(present);
        Some(after)
    }

    /// Whether there is something to undo.
    pub fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// Whether there is something to redo.
    pub fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Weighed for char {
        fn shared(&self) -> Vec<Shared> {
            Vec::new()
        }
    }

    /// A state with one large part, at this address and of so many mebibytes.
    #[derive(Clone)]
    struct Large(usize, usize);

    impl Weighed for Large {
        fn shared(&self) -> Vec<Shared> {
            vec![Shared { address: self.0, bytes: self.1 << 20 }]
        }
    }

    fn n_undone<T: Clone + Weighed>(mut history: History<T>, present: T) -> usize {
        std::iter::from_fn(|| history.undo(present.clone()).map(drop)).count()
    }

    #[test]
    fn undo_and_redo_walk_the_same_states() {
        let mut history = History::default();
        history.record('a');
        history.record('b');
        assert_eq!(history.undo('c'), Some('b'));
        assert_eq!(history.undo('b'), Some('a'));
        assert_eq!(history.undo('a'), None);
        assert_eq!(history.redo('a'), Some('b'));
        assert_eq!(history.redo('b'), Some('c'));
        assert_eq!(history.redo('c'), None);
    }

    #[test]
    fn a_new_state_forgets_what_was_undone() {
        let mut history = History::default();
        history.record('a');
        history.undo('b');
        history.record('a');
        assert!(!history.can_redo());
    }

    #[test]
    fn at_most_fifty_states_are_kept() {
        let mut history = History::default();
        (0..70).for_each(|_| history.record('a'));
        assert_eq!(n_undone(history, 'a'), 50);
    }

    #[test]
    fn large_states_are_forgotten_unless_they_are_shared() {
        let mut shared = History::default();
        let mut apart = History::default();
        for n in 0..20 {
            shared.record(Large(1, 200));
            apart.record(Large(n, 200));
        }
        assert_eq!(n_undone(shared, Large(1, 200)), 20);
        assert_eq!(n_undone(apart, Large(1, 200)), 2);
    }

    #[test]
    fn the_last_state_is_kept_however_large_it_is() {
        let mut history = History::default();
        history.record(Large(1, 600));
        history.record(Large(2, 600));
        assert_eq!(n_undone(history, Large(3, 600)), 1);
    }
}
