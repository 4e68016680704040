//! Looking for another question on which a misprint goes wrong.

use super::verdict;
use crate::geometry::Ray;
use crate::locate::Direction;
use crate::progress::Progress;
use crate::query::Query;
use crate::random::Random;
use crate::trace::record;
use crate::traverse::Variants;
use crate::tree::Tree;

/// Questions that are tried at most.
const N_TRIES: u64 = 4000;

/// Most decimal digits behind the point that are asked for.
const MOST_DIGITS: i32 = 6;

/// A ray, and what is asked; queries without a ray leave it alone.
pub type Question<const D: usize> = (Ray<D>, Query<D>);

/// Another ray, point, region or cell than that of `question` on which its query
/// goes wrong in `tree`, or, if it never does, takes a longer way; with numbers as short
/// as still show it; the same for the same `seed`. `None` if none is found, or if
/// `progress` is cancelled.
///
/// Tried are rays from about the root in random directions, some of them along
/// axes, points and regions in and about the root, some of all these on grid points,
/// where ties are, and nodes with every direction to a neighbour.
pub fn find_other<const D: usize>(
    tree: &Tree<D>,
    question: Question<D>,
    seed: u64,
    progress: &Progress,
) -> Option<Question<D>> {
    let judged = |(ray, query): &Question<D>| verdict(tree, ray, &record(tree, ray, query));
    let goes_wrong = |other: &Question<D>| *other != question && !judged(other).agrees();
    let is_detour = |other: &Question<D>| *other != question && judged(other).detour.is_some();
    let mut detour = None;
    let mut random = Random::new(seed);
    progress.start(N_TRIES);
    for _ in 0..N_TRIES {
        progress.advance(1).ok()?;
        let Some(other) = random_question(tree, question, &mut random) else { continue };
        if goes_wrong(&other) {
            return Some(shortened(tree, other, goes_wrong));
        }
        if detour.is_none() && is_detour(&other) {
            detour = Some(other);
        }
    }
    detour.map(|other| shortened(tree, other, is_detour))
}

/// The same question about something else.
fn random_question<const D: usize>(
    tree: &Tree<D>,
    (ray, query): Question<D>,
    random: &mut Random,
) -> Option<Question<D>> {
    Some(match query {
        Query::Ray { .. } => (random_ray(tree, random)?, query),
        Query::Point { method, variants, .. } => {
            let at = random_point(tree, [-0.25, 1.25], random);
            (ray, Query::Point { at, method, variants })
        }
        Query::Region { variants, .. } => {
            let a = random_point(tree, [0.0, 1.0], random);
            let mut b = random_point(tree, [0.0, 1.0], random);
            // Small regions, and such without any extent along an axis, too.
            let size = 0.5f64.powi(random.below(6) as i32);
            let flat = random.below(2 * D as u64) as usize;
            for e in 0..D {
                b[e] = if e == flat { a[e] } else { a[e] + (b[e] - a[e]) * size };
            }
            (ray, region(tree, a, b, variants)?)
        }
        Query::Neighbour { reach, method, variants, .. } => {
            let root_level = tree.domain().root_level();
            let level = random.below(u64::from(root_level) + 1) as u8;
            let grid = tree.domain().grid_size();
            let place = std::array::from_fn(|_| random.below(u64::from(grid)) as u32);
            let node = tree.node_at(level, place)?.id;
            let (level, code) = (tree.level(node), tree.code(node));
            let directions: Vec<Direction<D>> = Direction::all().collect();
            let direction = directions[random.below(directions.len() as u64) as usize];
            (ray, Query::Neighbour { level, code, direction, reach, method, variants })
        }
    })
}

/// Region between two corners, if both lie in the root's box.
fn region<const D: usize>(
    tree: &Tree<D>,
    a: [f64; D],
    b: [f64; D],
    variants: Variants,
) -> Option<Query<D>> {
    let [min, max] = [f64::min, f64::max].map(|end| std::array::from_fn(|e| end(a[e], b[e])));
    let is_inside = [min, max].iter().all(|&corner| tree.domain().encode_point(corner).is_some());
    is_inside.then_some(Query::Region { min, max, variants })
}

/// A point whose coordinates lie between these shares of the root's side.
fn random_point<const D: usize>(
    tree: &Tree<D>,
    [low, high]: [f64; 2],
    random: &mut Random,
) -> [f64; D] {
    let domain = tree.domain();
    let on_grid = random.below(4) == 0;
    std::array::from_fn(|e| {
        let part = random.between(low, high);
        let part = if on_grid { (part * 4.0).round() / 4.0 } else { part };
        domain.min()[e] + domain.side() * part
    })
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

/// The question with every number rounded to as few digits as `goes_wrong` allows:
/// to whole numbers first. Nodes go towards the lowest corner instead.
fn shortened<const D: usize>(
    tree: &Tree<D>,
    question: Question<D>,
    goes_wrong: impl Fn(&Question<D>) -> bool,
) -> Question<D> {
    let mut best = question;
    for number in 0..2 * D {
        let shorter = (0..=MOST_DIGITS)
            .filter_map(|digits| with_short_number(tree, best, number, digits))
            .find(|question| goes_wrong(question));
        best = shorter.unwrap_or(best);
    }
    best
}

/// The question with one of its numbers rounded: to so many decimal digits, or a code
/// to so many of its binary ones. `None` where it has no such number, or where
/// nothing can be asked with it.
fn with_short_number<const D: usize>(
    tree: &Tree<D>,
    (ray, query): Question<D>,
    number: usize,
    digits: i32,
) -> Option<Question<D>> {
    let scale = 10f64.powi(digits);
    // Zero is what is meant, without a sign.
    let round = |x: &mut f64| *x = (*x * scale).round() / scale + 0.0;
    let axis = number % D;
    match query {
        Query::Ray { .. } => {
            let (mut origin, mut direction) = (ray.origin(), ray.direction());
            round(if number < D { &mut origin[axis] } else { &mut direction[axis] });
            Some((Ray::new(origin, direction).ok()?, query))
        }
        Query::Point { mut at, method, variants } => {
            round(at.get_mut(number)?);
            Some((ray, Query::Point { at, method, variants }))
        }
        Query::Region { mut min, mut max, variants } => {
            round(if number < D { &mut min[axis] } else { &mut max[axis] });
            Some((ray, region(tree, min, max, variants)?))
        }
        Query::Neighbour { level, mut code, direction, reach, method, variants } => {
            let coordinate = code.get_mut(number)?;
            let dropped = tree.domain().root_level().checked_sub(digits as u8)?;
            *coordinate = (*coordinate >> dropped) << dropped;
            let node = tree.node_at(level, code)?.id;
            let (level, code) = (tree.level(node), tree.code(node));
            Some((ray, Query::Neighbour { level, code, direction, reach, method, variants }))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::counterexample;
    use super::*;
    use crate::scenario::{AnyScenario, Scenario};
    use crate::traverse::Variant;

    fn check<const D: usize>(scenario: &Scenario<D>, variant: Variant) {
        let tree = scenario.tree().unwrap();
        let asked = (scenario.ray, scenario.query);
        for seed in [7, 8] {
            let find = |question| find_other(&tree, question, seed, &Progress::default());
            let found = find(asked).unwrap_or_else(|| panic!("nothing else for {variant:?}"));
            assert_eq!(find(asked), Some(found), "another one for the same seed");
            assert_ne!(found, asked);
            let (ray, query) = found;
            let agrees = |query| verdict(&tree, &ray, &record(&tree, &ray, &query)).agrees();
            assert!(!agrees(query), "{variant:?} {found:?}");
            assert!(agrees(query.corrected()), "{variant:?} {found:?}");
            assert_eq!(query.variants(), scenario.query.variants());
            let numbers = numbers(&found);
            let digits: usize = numbers.iter().map(|x| x.to_string().len()).sum();
            assert!(digits <= 7 * numbers.len(), "{variant:?} {found:?}");
            assert_eq!(find((scenario.ray, scenario.query.corrected())), None);
        }

        let cancelled = Progress::default();
        cancelled.cancel();
        assert_eq!(find_other(&tree, asked, 7, &cancelled), None);
    }

    fn numbers<const D: usize>((ray, query): &Question<D>) -> Vec<f64> {
        match query {
            Query::Ray { .. } => [ray.origin(), ray.direction()].concat(),
            Query::Point { at, .. } => at.to_vec(),
            Query::Region { min, max, .. } => [*min, *max].concat(),
            Query::Neighbour { code, .. } => code.map(f64::from).to_vec(),
        }
    }

    fn check_all(variants: &[Variant]) {
        for &variant in variants {
            match counterexample(variant) {
                AnyScenario::Quadtree(scenario) => check(&scenario, variant),
                AnyScenario::Octree(scenario) => check(&scenario, variant),
            }
        }
    }

    #[test]
    fn misprints_go_wrong_on_other_rays_with_few_digits() {
        use Variant::{B1, B2, B2Morton, B3, B6, B7};
        check_all(&[B1, B2, B2Morton, B3, B6, B7]);
    }

    #[test]
    fn misprints_of_points_regions_and_neighbours_go_wrong_elsewhere_too() {
        use Variant::{B18, B19, B21, B24a, B24b, B24c, B25Leftmost, B25Rightmost, B28};
        check_all(&[B18, B19, B21, B24a, B24b, B24c, B25Leftmost, B25Rightmost, B28]);
    }
}
