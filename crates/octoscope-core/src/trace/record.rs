//! The record of one run.

use super::Moment;
use crate::event::{End, Event, Observer, Outcome};
use crate::geometry::Ray;
use crate::progress::{Cancelled, Progress};
use crate::query::Query;
use crate::traverse::Algorithm;
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
        self.events.iter().filter_map(|event| {
            let Event::Leaf { node, enter, exit, .. } = *event else { return None };
            Some((node, [enter, exit]))
        })
    }

    /// Whether the run was longer than what is kept of it.
    pub fn is_cut(&self) -> bool {
        self.outcome.end == End::Cut
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

/// The same with at most `most_events` events and the end: a run of more is cut
/// off, and its outcome is [`End::Cut`]. What the query needs of the tree is made
/// first.
///
/// # Errors
/// Stops with [`Cancelled`] when `progress` is cancelled.
pub fn record_within<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    query: &Query<D>,
    most_events: usize,
    progress: &Progress,
) -> Result<Trace<D>, Cancelled> {
    if matches!(query, Query::Ray { algorithm: Algorithm::SametNet, .. }) {
        tree.link(progress)?;
    }
    progress.start(most_events as u64);
    let mut beginning =
        Beginning { events: Vec::new(), most_events, progress, state: State::Watching };
    let mut outcome = query.run(tree, ray, &mut beginning);
    let Beginning { mut events, state, .. } = beginning;
    match state {
        State::Watching => {}
        State::Full => {
            outcome = Outcome::without_node(End::Cut);
            events.push(Event::End(End::Cut));
        }
        State::Cancelled => return Err(Cancelled),
    }
    Ok(Trace { query: *query, events, outcome })
}

/// Keeps the first events of a run.
struct Beginning<'a, const D: usize> {
    events: Vec<Event<D>>,
    most_events: usize,
    progress: &'a Progress,
    state: State,
}

/// Whether a run is still watched.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Watching,
    /// There was an event too many.
    Full,
    Cancelled,
}

impl<const D: usize> Observer<D> for Beginning<'_, D> {
    fn observe(&mut self, event: Event<D>) {
        if self.state != State::Watching {
            return;
        }
        if self.progress.advance(1).is_err() {
            self.state = State::Cancelled;
        } else if self.events.len() == self.most_events && !matches!(event, Event::End(_)) {
            self.state = State::Full;
        } else {
            self.events.push(event);
        }
    }

    fn wants_more(&self) -> bool {
        self.state == State::Watching
    }
}
