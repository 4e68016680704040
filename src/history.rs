//! Undo and redo.

/// States before and after the present one.
#[derive(Clone, Debug)]
pub struct History<T> {
    past: Vec<T>,
    future: Vec<T>,
}

impl<T> Default for History<T> {
    fn default() -> Self {
        Self { past: Vec::new(), future: Vec::new() }
    }
}

impl<T> History<T> {
    /// Number of states that are kept.
    const LIMIT: usize = 50;

    /// Remembers `before`, which has just been replaced by something new.
    pub fn record(&mut self, before: T) {
        if self.past.len() == Self::LIMIT {
            self.past.remove(0);
        }
        self.past.push(before);
        self.future.clear();
    }

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
}
