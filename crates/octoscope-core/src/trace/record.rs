//! The record of one run.

use super::Moment;
use crate::event::{Event, Outcome};
use crate::geometry::Ray;
use crate::query::Query;
use crate::tree::{NodeId, Tree};

/// Immutable record of one run of one algorithm.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace<const D: usize> {
    /// What was asked.
    pub query: Query<D>,
    /// The steps, in order; never empty.
    pub events: Vec<Event<D>>,
    /// What the run came to.
    pub outcome: Outcome,
}

impl<const D: usize> Trace<D> {
    /// Visited leaves in order, with the parameters at which the ray enters
    /// and leaves them.
    pub fn leaves(&self) -> impl Iterator<Item = (NodeId, [f64; 2])> + '_ {
        self.events.iter().filter_map(|event| match *event {
            Event::Leaf { node, enter, exit, .. } => Some((node, [enter, exit])),
            _ => None,
        })
    }

    /// Number of events up to and with the next visited leaf or result after
    /// `step`, or the number of all events.
    pub fn next_leaf(&self, step: usize) -> usize {
        let rest = self.events.iter().skip(step);
        rest.take_while(|event| !event.is_result())
            .count()
            .saturating_add(step + 1)
            .min(self.events.len())
    }

    /// Number of events until the algorithm is first at `node` or in it; `None` if
    /// it never is. A node that is only tested and missed does not count.
    pub fn first_step_in(&self, tree: &Tree<D>, node: NodeId) -> Option<usize> {
        let mut moment = Moment::default();
        self.events.iter().find_map(|event| {
            let n_missed = moment.missed.len();
            moment.apply(tree, event);
            let is_in = moment.current.is_some_and(|current| tree.holds(node, current));
            (is_in && moment.missed.len() == n_missed).then_some(moment.step)
        })
    }

    /// Number of events up to and with the last visited leaf or result before
    /// the one at `step`, or 0.
    pub fn previous_leaf(&self, step: usize) -> usize {
        let earlier = &self.events[..step.saturating_sub(1).min(self.events.len())];
        earlier.iter().rposition(Event::is_result).map_or(0, |index| index + 1)
    }
}

/// Trace of `query` in `tree`; `ray` is used by queries along the ray.
pub fn record<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, query: &Query<D>) -> Trace<D> {
    let mut events = Vec::new();
    let outcome = query.run(tree, ray, &mut events);
    Trace { query: *query, events, outcome }
}
