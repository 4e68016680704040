//! Looking for another ray on which a misprint goes wrong.

use super::verdict;
use crate::geometry::Ray;
use crate::progress::Progress;
use crate::query::Query;
use crate::random::Random;
use crate::trace::record;
use crate::tree::Tree;

/// Rays that are tried at most.
const N_TRIES: u64 = 4000;

/// Most decimal digits behind the point that are asked for.
const MOST_DIGITS: i32 = 6;

/// A ray on which `query` goes wrong in `tree`, with numbers as short as still
/// show it; the same for the same `seed`. `None` if none is found, if the query
/// is none along a ray, or if `progress` is cancelled.
///
/// Tried are rays from about the root in random directions, some of them along
/// axes and some from grid points, where ties are.
pub fn find_other<const D: usize>(
    tree: &Tree<D>,
    query: &Query<D>,
    seed: u64,
    progress: &Progress,
) -> Option<Ray<D>> {
    match query {
        Query::Ray { .. } => {}
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => return None,
    }
    let goes_wrong = |ray: &Ray<D>| !verdict(tree, ray, &record(tree, ray, query)).agrees;
    let mut random = Random::new(seed);
    progress.start(N_TRIES);
    for _ in 0..N_TRIES {
        progress.advance(1).ok()?;
        let Some(ray) = random_ray(tree, &mut random) else { continue };
        if goes_wrong(&ray) {
            return Some(shortened(ray, goes_wrong));
        }
    }
    None
}

/// A ray that begins within half a side of the root.
fn random_ray<const D: usize>(tree: &Tree<D>, random: &mut Random) -> Option<Ray<D>> {
    let domain = tree.domain();
    let on_grid = random.below(4) == 0;
    let along_axes = random.below(4) == 0;
    let origin = std::array::from_fn(|e| {
        let part = random.between(-0.5, 1.5);
        let part = if on_grid { (part * 4.0).round() / 4.0 } else { part };
        domain.min()[e] + domain.side() * part
    });
    let direction = std::array::from_fn(|_| {
        let part = random.between(-1.0, 1.0);
        let part = if on_grid || along_axes { part.round() } else { part };
        domain.side() * part
    });
    Ray::new(origin, direction).ok()
}

/// The ray with every number rounded to as few digits as `goes_wrong` allows:
/// to whole numbers first.
fn shortened<const D: usize>(ray: Ray<D>, goes_wrong: impl Fn(&Ray<D>) -> bool) -> Ray<D> {
    let mut best = ray;
    for number in 0..2 * D {
        let candidates = (0..=MOST_DIGITS).filter_map(|digits| {
            let (mut origin, mut direction) = (best.origin(), best.direction());
            let x = if number < D { &mut origin[number] } else { &mut direction[number - D] };
            let scale = 10f64.powi(digits);
            // Zero is what is meant, without a sign.
            *x = (*x * scale).round() / scale + 0.0;
            Ray::new(origin, direction).ok()
        });
        let shorter = candidates.into_iter().find(|ray| goes_wrong(ray));
        best = shorter.unwrap_or(best);
    }
    best
}

#[cfg(test)]
mod tests {
    use super::super::counterexample;
    use super::*;
    use crate::scenario::{AnyScenario, Scenario};
    use crate::traverse::Variant;
    use crate::tree::build;

    fn check<const D: usize>(scenario: &Scenario<D>, variant: Variant) {
        let content = scenario.source.content().unwrap();
        let domain = scenario.grid().unwrap();
        let tree = build(&content, domain, &scenario.recipe, &Progress::default()).unwrap();
        let find = |query| find_other(&tree, query, 7, &Progress::default());
        let ray = find(&scenario.query).unwrap_or_else(|| panic!("no ray for {variant:?}"));
        assert_eq!(find(&scenario.query), Some(ray), "another one for the same seed");
        let agrees = |query| verdict(&tree, &ray, &record(&tree, &ray, &query)).agrees;
        assert!(!agrees(scenario.query), "{variant:?} {ray:?}");
        assert!(agrees(scenario.query.corrected()), "{variant:?} {ray:?}");
        let numbers = [ray.origin(), ray.direction()].concat();
        let digits: usize = numbers.iter().map(|x| x.to_string().len()).sum();
        assert!(digits <= 7 * numbers.len(), "{variant:?} {ray:?}");
        assert_eq!(find(&scenario.query.corrected()), None);

        let cancelled = Progress::default();
        cancelled.cancel();
        assert_eq!(find_other(&tree, &scenario.query, 7, &cancelled), None);
    }

    #[test]
    fn misprints_go_wrong_on_other_rays_with_few_digits() {
        for variant in [Variant::B1, Variant::B2, Variant::B3, Variant::B6, Variant::B7] {
            match counterexample(variant) {
                AnyScenario::Quadtree(scenario) => check(&scenario, variant),
                AnyScenario::Octree(scenario) => check(&scenario, variant),
            }
        }
    }

    #[test]
    fn queries_without_a_ray_have_no_other_one() {
        let AnyScenario::Quadtree(scenario) = counterexample(Variant::B18) else { unreachable!() };
        let content = scenario.source.content().unwrap();
        let domain = scenario.grid().unwrap();
        let tree = build(&content, domain, &scenario.recipe, &Progress::default()).unwrap();
        assert_eq!(find_other(&tree, &scenario.query, 1, &Progress::default()), None);
    }
}
