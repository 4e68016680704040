//! What a run would come to by the right rules.

use super::record;
use crate::event::Event;
use crate::geometry::Ray;
use crate::query::{Arithmetic, Query};
use crate::traverse::{
    Algorithm, Base, Options, Slivers, StopAt, Variants, first_difference_of_run, traverse_mirrored,
};
use crate::tree::{NodeId, Tree};

/// Visited leaves, or the nodes that were found.
pub(crate) fn results<const D: usize>(events: &[Event<D>]) -> Vec<NodeId> {
    events.iter().filter_map(Event::result_node).collect()
}

/// The events of the run with every rule in its right form, by the same walk: a
/// walk with misprints mirrors the ray, so that its numbers are rounded otherwise.
pub(crate) fn corrected<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    query: &Query<D>,
) -> Vec<Event<D>> {
    let mut events = Vec::new();
    match query.corrected() {
        Query::Ray { algorithm, options, .. } if query.is_misprinted() => {
            // Only these two have misprints.
            let by_tables = algorithm == Algorithm::ParametricTable;
            let base = if by_tables { Base::Tables } else { Base::Uniform };
            traverse_mirrored(tree, ray, options, base, &mut events);
        }
        corrected => {
            corrected.run(tree, ray, &mut events);
        }
    }
    events
}

/// All leaves on the ray, wherever the run is to stop.
pub(crate) fn on_the_ray<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
) -> Vec<NodeId> {
    let options = Options { stop_at: StopAt::End, variants: Variants::NONE, ..options };
    let algorithm = Algorithm::Exhaustive;
    let oracle = Query::Ray { algorithm, options, arithmetic: Arithmetic::Exact };
    results(&record(tree, ray, &oracle).events)
}

/// Where the right rules come to exactly what is expected, any other leaf is due to the
/// misprint; elsewhere they may have slivers, too.
pub(crate) fn slivers<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    expected: &[NodeId],
    corrected: &[NodeId],
) -> Slivers {
    let difference =
        first_difference_of_run(tree, ray, options, expected, corrected, Slivers::Count);
    if difference.is_none() { Slivers::Count } else { Slivers::Ignore }
}
