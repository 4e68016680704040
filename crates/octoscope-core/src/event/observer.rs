//! How an algorithm is watched.

#[cfg(doc)]
use super::End;
use super::Event;

/// Watches an algorithm. An observer that does nothing costs nothing: the
/// compiler removes the events with it.
pub trait Observer<const D: usize> {
    /// Whether it looks at any event.
    const LOOKS: bool = true;

    /// Called once for every step, in order.
    fn observe(&mut self, event: Event<D>);

    /// Whether the algorithm is to go on. It asks now and then, at least once a
    /// leaf and once a cell of the grid, and ends with [`End::Cut`] if not.
    #[inline(always)]
    fn wants_more(&self) -> bool {
        true
    }
}

/// Watches nothing.
impl<const D: usize> Observer<D> for () {
    const LOOKS: bool = false;

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
