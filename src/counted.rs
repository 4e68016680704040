//! What a search costs, and what it finds, without a record of it.

use octoscope_core::event::{Event, Observer};
use octoscope_core::geometry::Ray;
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::query::Query;
use octoscope_core::trace::Counters;
use octoscope_core::tree::{NodeId, Tree};

/// A run of more steps is cut: a printed rule may go round for ever.
const MOST_STEPS: usize = 1_000_000;

/// What a search costs on one ray.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Counted {
    /// Its steps.
    pub n_steps: usize,
    /// What they cost.
    pub counters: Counters,
    /// Visited leaves, in order.
    pub leaves: Vec<NodeId>,
}

/// Runs a search on one ray.
///
/// # Errors
/// Stops with [`Cancelled`] when `progress` is cancelled.
pub fn counted<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    query: &Query<D>,
    progress: &Progress,
) -> Result<Counted, Cancelled> {
    let mut counting = Counting { counted: Counted::default(), progress };
    query.run(tree, ray, &mut counting);
    progress.advance(0)?;
    Ok(counting.counted)
}

/// Counts as long as the result is wanted.
struct Counting<'a> {
    counted: Counted,
    progress: &'a Progress,
}

impl<const D: usize> Observer<D> for Counting<'_> {
    fn observe(&mut self, event: Event<D>) {
        self.counted.n_steps += 1;
        self.counted.counters.add(&event);
        if let Event::Leaf { node, .. } = event {
            self.counted.leaves.push(node);
        }
    }

    fn wants_more(&self) -> bool {
        self.counted.n_steps < MOST_STEPS && self.progress.advance(0).is_ok()
    }
}
