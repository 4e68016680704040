//! All algorithms on the same ray.

use crate::counted::{Counted, counted};
use octoscope_core::geometry::Ray;
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::trace::Counters;
use octoscope_core::traverse::{
    Algorithm, Options, Slivers, StopAt, Variants, first_difference_of_run,
};
use octoscope_core::tree::{NodeId, Tree};

/// What one algorithm did on the ray.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// The algorithm.
    pub algorithm: Algorithm,
    /// Number of its steps.
    pub n_steps: usize,
    /// What it cost.
    pub counters: Counters,
    /// Visited leaves, in order.
    leaves: Vec<NodeId>,
    /// Whether they are the leaves of the oracle, or of the reference where
    /// the tree is too large for the oracle; slivers left out.
    pub agrees: bool,
    /// Number of those.
    pub n_expected: usize,
}

/// More leaves than this are not tested one by one for every movement.
pub const MOST_TESTED: usize = 100_000;

/// Trees of more nodes than this are not linked for the comparison alone.
const MOST_LINKS: usize = 50_000;

/// Grids of more cells along an axis are not walked through for every movement.
const MOST_CELLS: u32 = 1 << 12;

/// Whether an algorithm is quick enough in `tree` to be run for every movement.
pub fn is_quick<const D: usize>(algorithm: Algorithm, tree: &Tree<D>) -> bool {
    match algorithm {
        Algorithm::Exhaustive => tree.n_leaves() <= MOST_TESTED,
        Algorithm::SametNet => tree.is_linked() || tree.n_nodes() <= MOST_LINKS,
        Algorithm::Dda | Algorithm::DdaOctree => tree.domain().grid_size() <= MOST_CELLS,
        Algorithm::Parametric
        | Algorithm::ParametricTable
        | Algorithm::Esvo
        | Algorithm::AllChildren
        | Algorithm::Hero
        | Algorithm::Gargantini
        | Algorithm::Codes
        | Algorithm::Glassner
        | Algorithm::Samet
        | Algorithm::SametCorner
        | Algorithm::Bsp => true,
    }
}

/// Runs every algorithm that is quick enough on `ray`, as `query` does: in its arithmetic
/// and up to its end, with every rule in its right form, but the algorithm of the query
/// with the rules of the query.
///
/// # Errors
/// Stops with [`Cancelled`] when `progress` is cancelled.
pub fn compare<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    query: &Query<D>,
    progress: &Progress,
) -> Result<Vec<Run>, Cancelled> {
    let (shown, own, arithmetic) = match *query {
        Query::Ray { algorithm, options, arithmetic } => (Some(algorithm), options, arithmetic),
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => {
            (None, Options::default(), Arithmetic::Doubles)
        }
    };
    let options = Options { variants: Variants::NONE, ..own };
    let wanted = Algorithm::ALL.into_iter().filter(|&algorithm| is_quick(algorithm, tree));
    let run = |algorithm, options| run(tree, ray, algorithm, options, arithmetic, progress);
    let of = |algorithm| run(algorithm, if shown == Some(algorithm) { own } else { options });
    let mut runs = wanted.map(of).collect::<Result<Vec<Run>, Cancelled>>()?;
    let oracle = runs.iter().find(|run| run.algorithm == Algorithm::Exhaustive);
    let Some(reference) = oracle.or(runs.first()) else { return Ok(runs) };
    let is_right = shown != Some(reference.algorithm) || own == options;
    let right = match is_right {
        true => reference.leaves.clone(),
        false => run(reference.algorithm, options)?.leaves,
    };
    let n_expected = right.len();
    let expected = match options.stop_at {
        StopAt::End => right,
        StopAt::FirstFull => {
            let whole = Options { stop_at: StopAt::End, ..options };
            run(reference.algorithm, whole)?.leaves
        }
    };
    for run in &mut runs {
        let slivers = Slivers::Ignore;
        let difference =
            first_difference_of_run(tree, ray, options, &expected, &run.leaves, slivers);
        run.agrees = difference.is_none();
        run.n_expected = n_expected;
    }
    Ok(runs)
}

fn run<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    algorithm: Algorithm,
    options: Options,
    arithmetic: Arithmetic,
    progress: &Progress,
) -> Result<Run, Cancelled> {
    let query = Query::Ray { algorithm, options, arithmetic };
    // A run that is cut has not found all that it should.
    let Counted { n_steps, counters, leaves, .. } = counted(tree, ray, &query, progress)?;
    Ok(Run { algorithm, n_steps, counters, leaves, agrees: false, n_expected: 0 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::traverse::Variant;
    use octoscope_core::tree::{Domain, Split, grow};

    #[test]
    fn all_algorithms_agree_through_the_centre_and_only_the_tables_touch() {
        let tree = grow(Domain::<3>::unit(1), (), &Progress::default(), |cell, ()| {
            if cell.level > 0 { Split::Inner(vec![(); 8]) } else { Split::Empty }
        });
        let tree = tree.unwrap();
        let ray = Ray::new([-1.0; 3], [1.0; 3]).unwrap();
        let query = Query::Ray {
            algorithm: Algorithm::Codes,
            options: Options::default(),
            arithmetic: Arithmetic::Doubles,
        };
        let runs = compare(&tree, &ray, &query, &Progress::default()).unwrap();
        assert!(runs.iter().all(|run| run.agrees && run.leaves.len() == 2));
        assert_eq!(runs.len(), Algorithm::ALL.len());

        // The run that is shown follows its own rules, and no other one.
        let variants = Variants::NONE.with(Variant::B2);
        let options = Options { variants, ..Options::default() };
        let query =
            Query::Ray { algorithm: Algorithm::Parametric, options, arithmetic: Arithmetic::Exact };
        let ray = Ray::new([-1.0, 0.25, 0.5], [1.0, 0.5, 0.25]).unwrap();
        let runs = compare(&tree, &ray, &query, &Progress::default()).unwrap();
        let wrong: Vec<Algorithm> =
            runs.iter().filter(|run| !run.agrees).map(|run| run.algorithm).collect();
        assert_eq!(wrong, [Algorithm::Parametric]);
    }
}
