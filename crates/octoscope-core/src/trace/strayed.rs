//! What a rule in another form has reported although it is not right.

use super::reason::{elsewhere, met};
use super::{Moment, corrected, on_the_ray, results, slivers};
use crate::geometry::Ray;
use crate::query::Query;
use crate::traverse::{Options, Slivers, is_sliver};
use crate::tree::{NodeId, Tree};
use std::collections::HashSet;

/// The nodes reported until `moment` that are not right, whether or not others are: leaves
/// beside the ray that the right rules do not report either, or another node than the
/// query is about. None where every rule is in its right form. O(visited leaves); where
/// one of these is beside the ray, and of a neighbour or region, as long as the query takes.
pub fn strayed<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    query: &Query<D>,
    moment: &Moment<D>,
) -> HashSet<NodeId> {
    if query.variants_at_work().is_empty() {
        return HashSet::new();
    }
    match query {
        Query::Ray { options, .. } => {
            let leaves = moment.leaves.iter().map(|leaf| leaf.node);
            let beside: Vec<NodeId> =
                leaves.filter(|&leaf| met(tree, ray, options.end(), leaf).is_err()).collect();
            without_rounded(tree, ray, query, *options, beside)
        }
        Query::Point { at, .. } => {
            moment.found.into_iter().filter(|&node| elsewhere(tree, at, node).is_some()).collect()
        }
        Query::Region { .. } | Query::Neighbour { .. } => {
            let right = results(&corrected(tree, ray, query));
            moment.found.into_iter().filter(|node| !right.contains(node)).collect()
        }
    }
}

/// Those of the leaves `beside` the ray that are not due to rounding: the right rules do
/// not report them, nor are they slivers where these rules err by slivers, too.
fn without_rounded<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    query: &Query<D>,
    options: Options,
    beside: Vec<NodeId>,
) -> HashSet<NodeId> {
    let mut wrong: HashSet<NodeId> = beside.into_iter().collect();
    if wrong.is_empty() {
        return wrong;
    }
    let corrected = results(&corrected(tree, ray, query));
    for leaf in &corrected {
        wrong.remove(leaf);
    }
    let end = options.end().unwrap_or(f64::INFINITY);
    let is_fine = |&leaf: &NodeId| is_sliver(tree, ray, end, leaf);
    if wrong.iter().any(is_fine) {
        let expected = on_the_ray(tree, ray, options);
        if slivers(tree, ray, options, &expected, &corrected) == Slivers::Ignore {
            wrong.retain(|leaf| !is_fine(leaf));
        }
    }
    wrong
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paper::counterexample;
    use crate::progress::Progress;
    use crate::scenario::{AnyScenario, Scenario};
    use crate::trace::record;
    use crate::traverse::Variant;
    use crate::tree::build;

    /// Level and code of what has strayed at the end of the counterexample of `variant`.
    fn at_the_end(variant: Variant) -> Vec<Vec<u32>> {
        fn of<const D: usize>(scenario: &Scenario<D>) -> Vec<Vec<u32>> {
            let content = scenario.source.content().unwrap();
            let domain = scenario.grid().unwrap();
            let tree = build(&content, domain, &scenario.recipe, &Progress::default()).unwrap();
            let (ray, query) = (&scenario.ray, &scenario.query);
            let moment = Moment::after(&tree, &record(&tree, ray, query), usize::MAX);
            let strayed = strayed(&tree, ray, query, &moment);
            let place = |node| [&[u32::from(tree.level(node))][..], &tree.code(node)].concat();
            let mut places: Vec<_> = strayed.into_iter().map(place).collect();
            places.sort();
            places
        }
        match counterexample(variant) {
            AnyScenario::Quadtree(scenario) => of(&scenario),
            AnyScenario::Octree(scenario) => of(&scenario),
        }
    }

    #[test]
    fn leaves_are_wrong_even_where_none_would_be_right() {
        // The ray passes by the root, or lies behind it, or in its open side.
        assert_eq!(at_the_end(Variant::B1), [[0, 0, 1]]);
        assert_eq!(at_the_end(Variant::B10), [[0, 0, 0, 0], [0, 1, 1, 1]]);
        assert_eq!(at_the_end(Variant::B5), [[0, 1, 0, 0], [0, 1, 0, 1]]);
        assert_eq!(at_the_end(Variant::B11), [[0, 0, 1]]);
        assert_eq!(at_the_end(Variant::B21), [[0, 0, 0]]);
    }

    #[test]
    fn of_several_leaves_only_the_wrong_ones_stray() {
        assert_eq!(at_the_end(Variant::B3), [[0, 0, 1], [0, 1, 1]]);
        assert_eq!(at_the_end(Variant::B2), [[0; 0]; 0], "it loses one, but reports no other");
        assert_eq!(at_the_end(Variant::B9), [[0; 0]; 0]);
    }

    #[test]
    fn another_node_than_the_one_that_is_asked_for_strays() {
        assert_eq!(at_the_end(Variant::B19).len(), 1);
        assert_eq!(at_the_end(Variant::B24c).len(), 1);
        assert_eq!(at_the_end(Variant::B28).len(), 1);
    }
}
