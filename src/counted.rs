//! What a search costs, and what it finds, without a record of it.

use octoscope_core::event::{Event, Observer};
use octoscope_core::geometry::Ray;
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

impl<const D: usize> Observer<D> for Counted {
    fn observe(&mut self, event: Event<D>) {
        self.n_steps += 1;
        self.counters.add(&event);
        if let Event::Leaf { node, .. } = event {
            self.leaves.push(node);
        }
    }

    fn wants_more(&self) -> bool {
        self.n_steps < MOST_STEPS
    }
}

/// Runs a search on one ray.
pub fn counted<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, query: &Query<D>) -> Counted {
    let mut counted = Counted::default();
    query.run(tree, ray, &mut counted);
    counted
}
