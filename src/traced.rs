//! The trace of a question, and what is folded from it: made at once where that is
//! quick, else on another thread.

use octoscope_core::geometry::Ray;
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::query::Query;
use octoscope_core::trace::{Counters, Trace, record_within, rounded_steps};
use octoscope_core::traverse::Algorithm;
use octoscope_core::tree::Tree;
use std::sync::Arc;

/// Traces in the window end after so many events: 8 MB, and a step through them
/// takes no longer than a frame. A ray through ten levels makes some hundred.
pub const MOST_EVENTS: usize = 100_000;

/// Runs of no more events than this take a small part of a frame.
pub const QUICK_EVENTS: usize = 4000;

/// In trees of no more nodes than this all can be linked, or all leaves be tested,
/// in a small part of a frame.
const QUICK_NODES: usize = 20_000;

/// The trace of one question to a tree.
#[derive(Clone, Debug)]
pub struct Traced<const D: usize> {
    /// The ray, which other queries do not use.
    pub ray: Ray<D>,
    /// What was asked.
    pub query: Query<D>,
    /// Record of the query.
    pub trace: Arc<Trace<D>>,
    /// What the events of the trace cost.
    pub total: Counters,
    /// Steps of the trace, from 1, in which doubles would have decided otherwise.
    pub rounded: Arc<[usize]>,
}

impl<const D: usize> Traced<D> {
    /// Runs a query, however long it takes, and keeps at most `most_events` events.
    ///
    /// # Errors
    /// Stops with [`Cancelled`] when `progress` is cancelled.
    pub fn within(
        most_events: usize,
        tree: &Tree<D>,
        ray: Ray<D>,
        query: Query<D>,
        progress: &Progress,
    ) -> Result<Self, Cancelled> {
        let trace = record_within(tree, &ray, &query, most_events, progress)?;
        let mut total = Counters::default();
        trace.events.iter().for_each(|event| total.add(event));
        let rounded = rounded_steps(tree, &ray, &trace).into_iter().map(|(step, _)| step);
        Ok(Self { ray, query, total, rounded: rounded.collect(), trace: Arc::new(trace) })
    }

    /// The same as far as the window keeps it, if that is quick.
    pub fn quickly(tree: &Tree<D>, ray: Ray<D>, query: Query<D>) -> Option<Self> {
        if !is_prepared(tree, &query) {
            return None;
        }
        let traced = Self::within(QUICK_EVENTS, tree, ray, query, &Progress::default());
        traced.ok().filter(|traced| !traced.trace.is_cut())
    }
}

/// Whether a query can begin at once, without a look at all nodes of a large tree.
pub fn is_prepared<const D: usize>(tree: &Tree<D>, query: &Query<D>) -> bool {
    match query {
        Query::Ray { algorithm: Algorithm::Exhaustive, .. } => tree.n_nodes() <= QUICK_NODES,
        Query::Ray { algorithm: Algorithm::SametNet, .. } => {
            tree.is_linked() || tree.n_nodes() <= QUICK_NODES
        }
        Query::Ray { .. }
        | Query::Point { .. }
        | Query::Region { .. }
        | Query::Neighbour { .. } => true,
    }
}
