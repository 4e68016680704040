//! What a rule in another form has reported although it is not right.

use super::Moment;
use super::fate::{elsewhere, met};
use crate::event::Event;
use crate::geometry::Ray;
use crate::query::Query;
use crate::tree::{NodeId, Tree};
use std::collections::HashSet;

/// The nodes reported until `moment` that are not right, whether or not others are: leaves
/// beside the ray, or another node than the query is about. None where every rule is in
/// its right form. O(visited leaves); of a neighbour or region, as long as the query takes.
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
            leaves.filter(|&leaf| met(tree, ray, options.end(), leaf).is_err()).collect()
        }
        Query::Point { at, .. } => {
            moment.found.into_iter().filter(|&node| elsewhere(tree, at, node).is_some()).collect()
        }
        Query::Region { .. } | Query::Neighbour { .. } => {
            let mut right = Vec::new();
            query.corrected().run(tree, ray, &mut right);
            let is_right = |node: &NodeId| {
                right.iter().any(|event: &Event<D>| event.result_node() == Some(*node))
            };
            moment.found.into_iter().filter(|node| !is_right(node)).collect()
        }
    }
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
        fn of<const D: usize>(scenario: &Scenario<D>, query: Query<D>) -> Vec<Vec<u32>> {
            let content = scenario.source.content().unwrap();
            let domain = scenario.grid().unwrap();
            let tree = build(&content, domain, &scenario.recipe, &Progress::default()).unwrap();
            let moment = Moment::after(&tree, &record(&tree, &scenario.ray, &query), usize::MAX);
            let strayed = strayed(&tree, &scenario.ray, &query, &moment);
            let place = |node| [&[u32::from(tree.level(node))][..], &tree.code(node)].concat();
            let mut places: Vec<_> = strayed.into_iter().map(place).collect();
            places.sort();
            places
        }
        match counterexample(variant) {
            AnyScenario::Quadtree(scenario) => {
                assert_eq!(of(&scenario, scenario.query.corrected()), [[0; 0]; 0]);
                of(&scenario, scenario.query)
            }
            AnyScenario::Octree(scenario) => {
                assert_eq!(of(&scenario, scenario.query.corrected()), [[0; 0]; 0]);
                of(&scenario, scenario.query)
            }
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
