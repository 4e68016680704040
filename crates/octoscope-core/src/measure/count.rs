//! What a query costs on many rays.

use super::{Branches, Cache, FNV_BASIS, Memory, fnv_1a};
use crate::event::{Event, Observer};
use crate::geometry::Ray;
use crate::progress::{Cancelled, Progress};
use crate::query::Query;
use crate::trace::Counters;
use crate::traverse::{Algorithm, Kernel, Leaf, StopAt, visit_many};
use crate::tree::{NodeId, Tree};

/// Counts leaves: the least that keeps a compiler from leaving a traversal out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Visited leaves.
    pub leaves: u64,
    /// Those with something in them.
    pub occupied: u64,
}

impl<const D: usize> Observer<D> for Tally {
    #[inline]
    fn observe(&mut self, event: Event<D>) {
        if let Event::Leaf { full, .. } = event {
            self.leaves += 1;
            self.occupied += u64::from(full);
        }
    }
}

/// Cost of a query on many rays, summed over them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Counted {
    /// Events.
    pub n_steps: u64,
    /// Work of every kind; of the stack the greatest depth.
    pub counters: Counters,
    /// Leaves.
    pub tally: Tally,
    /// FNV-1a, 64 bits, of levels and codes of the leaves, ray by ray.
    pub checksum: u64,
    /// Lines of memory: all reads, those that were a ray's first of a line, those that
    /// a cache of 32 KiB did not have.
    pub lines: [u64; 3],
    /// Comparisons that decide the way, and those predicted wrongly.
    pub branches: [u64; 2],
}

/// Runs a query on `rays` and counts.
///
/// # Errors
/// Stops with [`Cancelled`] when `progress` is cancelled; every ray is a unit of it.
pub fn count<const D: usize>(
    tree: &Tree<D>,
    rays: &[Ray<D>],
    query: &Query<D>,
    progress: &Progress,
) -> Result<Counted, Cancelled> {
    let algorithm = match query {
        Query::Ray { algorithm, .. } => *algorithm,
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => {
            Algorithm::default()
        }
    };
    let mut counting = Counting {
        tree,
        counted: Counted { checksum: FNV_BASIS, ..Counted::default() },
        of_ray: Counters::default(),
        memory: Memory::of(tree, algorithm, Cache::usual()),
        branches: Branches::of(tree),
    };
    for ray in rays {
        counting.memory.next_ray();
        query.run(tree, ray, &mut counting);
        let of_ray = std::mem::take(&mut counting.of_ray);
        counting.counted.counters.absorb(&of_ray);
        counting.counted.checksum = with_end(counting.counted.checksum);
        progress.advance(1)?;
    }
    let Counting { mut counted, memory, branches, .. } = counting;
    counted.lines = [memory.n_reads, memory.n_lines, memory.n_misses];
    counted.branches = branches.total();
    Ok(counted)
}

/// Rays that the kernel for many rays gets at once where their leaves are kept.
const AT_ONCE: usize = 512;

/// The same by the kernel for many rays, of which nothing is counted but leaves.
///
/// # Errors
/// Stops with [`Cancelled`] when `progress` is cancelled; every ray is a unit of it.
pub fn count_batch<const D: usize>(
    tree: &Tree<D>,
    rays: &[Ray<D>],
    kernel: Kernel,
    progress: &Progress,
) -> Result<Counted, Cancelled> {
    let mut counted = Counted { checksum: FNV_BASIS, ..Counted::default() };
    for some in rays.chunks(AT_ONCE) {
        for leaves in found_by_batch(tree, some, kernel) {
            for leaf in leaves {
                counted.tally.leaves += 1;
                counted.tally.occupied += u64::from(leaf.is_full());
                counted.checksum = with_leaf(counted.checksum, tree, leaf.node());
            }
            counted.checksum = with_end(counted.checksum);
        }
        progress.advance(some.len() as u64)?;
    }
    Ok(counted)
}

/// The leaves on each of the rays, in their order.
pub(super) fn found_by_batch<const D: usize>(
    tree: &Tree<D>,
    rays: &[Ray<D>],
    kernel: Kernel,
) -> Vec<Vec<Leaf>> {
    let mut found = vec![Vec::new(); rays.len()];
    visit_many(tree, rays, StopAt::End, kernel, |ray, leaves| found[ray] = leaves.to_vec());
    found
}

/// Adds a leaf to a checksum.
fn with_leaf<const D: usize>(checksum: u64, tree: &Tree<D>, node: NodeId) -> u64 {
    let codes = tree.code(node).into_iter();
    codes.fold(fnv_1a(checksum, &[tree.level(node)]), |sum, code| fnv_1a(sum, &code.to_le_bytes()))
}

/// Adds the end of a ray: a level that no leaf has.
fn with_end(checksum: u64) -> u64 {
    fnv_1a(checksum, &[u8::MAX])
}

struct Counting<'a, const D: usize> {
    tree: &'a Tree<D>,
    counted: Counted,
    of_ray: Counters,
    memory: Memory<'a, D>,
    branches: Branches<'a, D>,
}

impl<const D: usize> Observer<D> for Counting<'_, D> {
    fn observe(&mut self, event: Event<D>) {
        self.counted.n_steps += 1;
        self.of_ray.add(&event);
        self.counted.tally.observe(event);
        self.memory.observe(event);
        self.branches.observe(event);
        if let Event::Leaf { node, .. } = event {
            self.counted.checksum = with_leaf(self.counted.checksum, self.tree, node);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::rays_from_outside;
    use crate::scene::made;
    use crate::trace::Counter;
    use crate::traverse::Method;
    use crate::tree::{Domain, Recipe, build};

    fn tree() -> Tree<3> {
        let recipe = Recipe { depth: 4, ..Recipe::default() };
        let content = made::sphere_grid(2);
        build(&content, Domain::unit(4), &recipe, &Progress::default()).unwrap()
    }

    #[test]
    fn all_algorithms_find_the_same_leaves_by_their_checksum() {
        let tree = tree();
        let rays = rays_from_outside(tree.domain(), 3, 40);
        let counted = Algorithm::ALL.map(|algorithm| {
            let query = Query::default().along_the_ray_by(Method::from(algorithm));
            count(&tree, &rays, &query, &Progress::default()).unwrap()
        });
        for (algorithm, counted_of) in Algorithm::ALL.iter().zip(&counted) {
            assert_eq!(counted_of.checksum, counted[0].checksum, "{algorithm:?}");
            assert_eq!(counted_of.tally, counted[0].tally, "{algorithm:?}");
            let leaves = counted_of.counters.get(Counter::Leaves);
            assert_eq!(leaves, counted_of.tally.leaves);
        }
        for kernel in [Kernel::Plain, Kernel::Vector] {
            let batch = count_batch(&tree, &rays, kernel, &Progress::default()).unwrap();
            assert_eq!((batch.checksum, batch.tally), (counted[0].checksum, counted[0].tally));
        }
        // Another order of the same rays is another run.
        let turned: Vec<_> = rays.iter().rev().copied().collect();
        let other = count(&tree, &turned, &Query::default(), &Progress::default()).unwrap();
        assert_ne!(other.checksum, counted[0].checksum);
        assert_eq!(other.tally, counted[0].tally);
    }

    #[test]
    fn the_stack_is_as_deep_as_on_the_deepest_ray() {
        let tree = tree();
        let rays = rays_from_outside(tree.domain(), 3, 40);
        let counted = count(&tree, &rays, &Query::default(), &Progress::default()).unwrap();
        assert_eq!(counted.counters.get(Counter::StackDepth), 5);
        let one = |ray| {
            let counted = count(&tree, &[ray], &Query::default(), &Progress::default()).unwrap();
            counted.counters.get(Counter::NodeTouches)
        };
        let sum: u64 = rays.iter().map(|&ray| one(ray)).sum();
        assert_eq!(counted.counters.get(Counter::NodeTouches), sum);
    }

    #[test]
    fn counting_can_be_cancelled() {
        let (tree, progress) = (tree(), Progress::default());
        progress.cancel();
        let rays = rays_from_outside(tree.domain(), 3, 1);
        assert_eq!(count(&tree, &rays, &Query::default(), &progress), Err(Cancelled));
    }
}
