//! Whether two traversals of one ray agree.

use super::algorithm::{Options, StopAt};
use crate::geometry::Ray;
use crate::tree::{Domain, NodeId, Tree};

/// Pieces of a ray shorter than this part of the root's side are slivers: so
/// fine doubles need not be.
pub const SLIVER: f64 = 1e-12;

/// What is made of leaves on which the ray has only a sliver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slivers {
    /// They count as any other leaf, as befits exact arithmetic.
    Count,
    /// They may be there or not, as befits doubles.
    Ignore,
}

/// Where two lists of visited leaves part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Position in the expected list.
    pub index: usize,
    /// The leaf that is expected there; `None` after the last.
    pub expected: Option<NodeId>,
    /// The leaf that was found instead; `None` after the last.
    pub found: Option<NodeId>,
}

/// First place where the leaves `found` along `ray` are others than those
/// `expected`, or `None` if the lists agree. O(length of the lists).
pub fn first_difference<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    expected: &[NodeId],
    found: &[NodeId],
    slivers: Slivers,
) -> Option<Difference> {
    first_difference_until(tree, ray, f64::INFINITY, expected, found, slivers)
}

/// The same for a run with `options`, which may stop at the first full leaf or at the
/// end of a segment; `expected` are all leaves up to that end, also where the run
/// stops earlier. O(length of the lists).
pub fn first_difference_of_run<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    options: Options,
    expected: &[NodeId],
    found: &[NodeId],
    slivers: Slivers,
) -> Option<Difference> {
    // A run that has found a full leaf need not go on; whether it was right to stop
    // there, the leaves up to it tell.
    let stopped = options.stop_at == StopAt::FirstFull
        && found.last().is_some_and(|&leaf| tree.node(leaf).is_full());
    let n_expected = if stopped {
        let is_found = |leaf: &NodeId| found.contains(leaf);
        expected.iter().rposition(is_found).map_or(0, |last| last + 1)
    } else {
        expected.len()
    };
    let end = options.end().unwrap_or(f64::INFINITY);
    first_difference_until(tree, ray, end, &expected[..n_expected], found, slivers)
}

fn first_difference_until<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    end: f64,
    expected: &[NodeId],
    found: &[NodeId],
    slivers: Slivers,
) -> Option<Difference> {
    let may_lack = |id: NodeId| match slivers {
        Slivers::Count => false,
        Slivers::Ignore => is_sliver(tree, ray, end, id),
    };
    let (mut i, mut j) = (0, 0);
    loop {
        match (expected.get(i).copied(), found.get(j).copied()) {
            (None, None) => return None,
            (Some(a), Some(b)) if a == b => (i, j) = (i + 1, j + 1),
            (Some(a), _) if may_lack(a) => i += 1,
            (_, Some(b)) if may_lack(b) => j += 1,
            (expected, found) => return Some(Difference { index: i, expected, found }),
        }
    }
}

/// Whether doubles find every leaf along `ray` but slivers.
///
/// The parameter of a plane is off by 2^-52 of itself at most, and so is the
/// point on the ray by as much of its distance from the origin. Hence the
/// origin must not be thousands of sides away, nor may the time that the ray
/// takes for the root leave the range of doubles.
pub fn doubles_suffice<const D: usize>(domain: &Domain<D>, ray: &Ray<D>) -> bool {
    let bounds = domain.root_box();
    let origin = ray.origin();
    let near = (0..D).all(|e| {
        let reach = (origin[e] - bounds.min[e]).abs().max((bounds.max[e] - origin[e]).abs());
        reach <= 1000.0 * domain.side()
    });
    let duration = domain.side() / largest(ray.direction());
    near && (1e-290..1e290).contains(&duration)
}

/// Whether the ray, up to the parameter `end`, is in the leaf, or misses it, by no more
/// than a sliver.
pub(crate) fn is_sliver<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    end: f64,
    leaf: NodeId,
) -> bool {
    let bounds = tree.node_box(leaf);
    let (origin, direction) = (ray.origin(), ray.direction());
    let (mut enter, mut exit) = (0.0f64, end);
    for e in 0..D {
        let [a, b] = [bounds.min[e], bounds.max[e]].map(|plane| (plane - origin[e]) / direction[e]);
        if direction[e] != 0.0 {
            enter = enter.max(a.min(b));
            exit = exit.min(a.max(b));
        } else if !(bounds.min[e] <= origin[e] && origin[e] < bounds.max[e]) {
            return false;
        }
    }
    // The length is a product that cannot overflow where doubles suffice.
    let fastest = largest(direction);
    let length = direction.iter().map(|d| (d / fastest).powi(2)).sum::<f64>().sqrt();
    ((exit - enter) * fastest).abs() * length < SLIVER * tree.domain().side()
}

fn largest<const D: usize>(numbers: [f64; D]) -> f64 {
    numbers.into_iter().fold(0.0, |largest, x| x.abs().max(largest))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Progress;
    use crate::tree::{Split, grow};

    fn four_leaves() -> Tree<2> {
        grow(Domain::unit(1), (), &Progress::default(), |cell, ()| match cell.level {
            0 => Split::Empty,
            _ => Split::Inner(vec![(); 4]),
        })
        .unwrap()
    }

    fn check(ray: &Ray<2>, expected: &[u32], found: &[u32], slivers: Slivers) -> Option<usize> {
        let [expected, found] = [expected, found].map(|ids| ids.iter().copied().map(NodeId));
        let (expected, found): (Vec<_>, Vec<_>) = (expected.collect(), found.collect());
        let difference = first_difference(&four_leaves(), ray, &expected, &found, slivers);
        difference.map(|difference| difference.index)
    }

    #[test]
    fn slivers_may_be_there_or_not() {
        // From leaf 1 to leaf 4, and for 10^-13 through leaf 2.
        let ray = Ray::new([0.0, 1e-13], [1.0, 1.0]).unwrap();
        assert_eq!(check(&ray, &[1, 2, 4], &[1, 4], Slivers::Ignore), None);
        assert_eq!(check(&ray, &[1, 4], &[1, 2, 4], Slivers::Ignore), None);
        assert_eq!(check(&ray, &[1, 2, 4], &[1, 3, 4], Slivers::Ignore), None);
        assert_eq!(check(&ray, &[1, 2, 4], &[1, 4], Slivers::Count), Some(1));
    }

    #[test]
    fn true_leaves_may_not_lack_nor_false_ones_be_there() {
        let ray = Ray::new([0.0, 0.25], [1.0, 1.0]).unwrap();
        assert_eq!(check(&ray, &[1, 2, 4], &[1, 2, 4], Slivers::Ignore), None);
        assert_eq!(check(&ray, &[1, 2, 4], &[1, 4], Slivers::Ignore), Some(1));
        assert_eq!(check(&ray, &[1, 2, 4], &[1, 2], Slivers::Ignore), Some(2));
        assert_eq!(check(&ray, &[1, 2, 4], &[1, 3, 2, 4], Slivers::Ignore), Some(1));
        let level = Ray::new([0.0, 0.25], [1.0, 0.0]).unwrap();
        assert_eq!(check(&level, &[1, 3], &[2, 1, 3], Slivers::Ignore), Some(0));
    }

    #[test]
    fn a_run_may_stop_at_a_full_leaf_and_at_the_end_of_a_segment() {
        let full = |leaf: u32| {
            grow(Domain::unit(1), 0, &Progress::default(), |cell, at| match (cell.level, at) {
                (0, at) if at == leaf => Split::Full(vec![]),
                (0, _) => Split::Empty,
                _ => Split::Inner(vec![1, 2, 3, 4]),
            })
            .unwrap()
        };
        let ids = |ids: &[u32]| ids.iter().copied().map(NodeId).collect::<Vec<_>>();
        let differ = |full_leaf: u32, ray: &Ray<2>, options, found: &[u32]| {
            let (tree, expected): (Tree<2>, _) = (full(full_leaf), ids(&[1, 2, 4]));
            let slivers = Slivers::Ignore;
            let found = ids(found);
            first_difference_of_run(&tree, ray, options, &expected, &found, slivers).is_some()
        };
        let first = Options { stop_at: StopAt::FirstFull, ..Options::default() };
        let ray = Ray::new([0.0, 0.25], [1.0, 1.0]).unwrap();
        assert!(!differ(2, &ray, first, &[1, 2]));
        assert!(differ(2, &ray, first, &[1]), "the full leaf is missing");
        assert!(differ(4, &ray, first, &[1, 2]), "leaf 2 is not full");
        // Leaf 2 is a sliver: it may be found, or the run goes on.
        let sliver = Ray::new([0.0, 1e-13], [1.0, 1.0]).unwrap();
        assert!(!differ(2, &sliver, first, &[1, 2]) && !differ(2, &sliver, first, &[1, 4]));
        // The segment ends a sliver into leaf 2.
        let end = Options { segment_end: Some(0.25 + 1e-13), ..Options::default() };
        let tree = four_leaves();
        let found =
            first_difference_of_run(&tree, &ray, end, &ids(&[1, 2]), &ids(&[1]), Slivers::Ignore);
        assert_eq!(found, None);
    }

    #[test]
    fn doubles_do_not_suffice_far_away_nor_at_extreme_speed() {
        let suffice = |origin: f64, direction: f64| {
            doubles_suffice(&Domain::unit(4), &Ray::new([origin], [direction]).unwrap())
        };
        assert!(suffice(0.5, 1.0) && suffice(-900.0, 1e200));
        assert!(!suffice(1e6, -1.0) && !suffice(0.5, 1e-300) && !suffice(0.5, 1e300));
    }
}
