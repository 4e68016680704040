//! Whether a run with misprints came to the right result.

use crate::event::Event;
use crate::geometry::Ray;
use crate::query::{Arithmetic, Query};
use crate::trace::{Trace, record};
use crate::traverse::{Algorithm, Options, Slivers, Variants, first_difference};
use crate::tree::{NodeId, Tree};

/// What a trace should have come to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// The leaves on the ray in order, or the nodes that the query should find.
    pub expected: Vec<NodeId>,
    /// Whether the trace has found just these.
    pub agrees: bool,
    /// Number of events up to and with the first one that is wrong: the report
    /// of another leaf or node than expected, or the end before all are found.
    pub first_wrong_step: Option<usize>,
}

/// Compares a trace with the oracle, or, of a query without a ray, with the
/// right rules. Slivers may be there or not.
pub fn verdict<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, trace: &Trace<D>) -> Verdict {
    let right = match trace.query {
        Query::Ray { options, .. } => Query::Ray {
            algorithm: Algorithm::Exhaustive,
            options: Options { variants: Variants::NONE, ..options },
            arithmetic: Arithmetic::Exact,
        },
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => {
            trace.query.corrected()
        }
    };
    let results =
        |trace: &Trace<D>| -> Vec<NodeId> { trace.events.iter().filter_map(result).collect() };
    let (expected, found) = (results(&record(tree, ray, &right)), results(trace));
    let difference = match right {
        Query::Ray { .. } => {
            let difference = first_difference(tree, ray, &expected, &found, Slivers::Ignore);
            difference.map(|difference| difference.found)
        }
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => {
            let same = expected.iter().zip(&found).take_while(|(a, b)| a == b).count();
            (expected != found).then(|| found.get(same).copied())
        }
    };
    let step_of = |wrong: Option<NodeId>| {
        let is_wrong = |event: &Event<D>| wrong.is_some() && result(event) == wrong;
        let index = trace.events.iter().position(is_wrong);
        index.map_or(trace.events.len(), |index| index + 1)
    };
    let first_wrong_step = difference.map(step_of);
    Verdict { expected, agrees: first_wrong_step.is_none(), first_wrong_step }
}

/// The leaf that is visited, or the node that is found.
fn result<const D: usize>(event: &Event<D>) -> Option<NodeId> {
    match *event {
        Event::Leaf { node, .. } | Event::Found { node } => Some(node),
        _ => None,
    }
}
