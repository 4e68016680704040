//! How an algorithm is watched.

use super::Event;

/// Watches an algorithm. An observer that does nothing costs nothing: the
/// compiler removes the events with it.
pub trait Observer<const D: usize> {
    /// Called once for every step, in order.
    fn observe(&mut self, event: Event<D>);
}

/// Watches nothing.
impl<const D: usize> Observer<D> for () {
    #[inline(always)]
    fn observe(&mut self, _: Event<D>) {}
}

/// Keeps every event.
impl<const D: usize> Observer<D> for Vec<Event<D>> {
    #[inline]
    fn observe(&mut self, event: Event<D>) {
        self.push(event);
    }
}
