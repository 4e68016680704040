//! What one ray has a processor fetch and predict.

use super::{Branch, BranchKind, Branches, Cache, Memory, Read};
use crate::event::{Event, Observer};
use crate::geometry::Ray;
use crate::query::Query;
use crate::traverse::{Algorithm, Method};
use crate::tree::Tree;

/// What an algorithm reads and compares on one ray, in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Watched {
    /// The algorithm.
    pub algorithm: Algorithm,
    /// Lines of memory, from an empty cache of 32 KiB.
    pub reads: Vec<Read>,
    /// Different lines among them.
    pub n_lines: u64,
    /// Comparisons, predicted by counters that know nothing yet.
    pub branches: Vec<Branch>,
    /// Of every kind the number of comparisons, and of those predicted wrongly.
    pub kinds: [[u64; 2]; BranchKind::ALL.len()],
    /// Whether the run was too long to be watched to its end.
    pub is_cut: bool,
}

impl Watched {
    /// Comparisons predicted wrongly.
    pub fn n_wrong(&self) -> u64 {
        self.kinds.iter().map(|[_, wrong]| wrong).sum()
    }
}

/// Events after which a run is cut.
const MOST_EVENTS: usize = 20_000;

/// Watches these algorithms on a ray, in doubles, with every rule in its right form.
pub fn watch<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    algorithms: &[Algorithm],
) -> Vec<Watched> {
    algorithms.iter().map(|&algorithm| watch_one(tree, ray, algorithm)).collect()
}

fn watch_one<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, algorithm: Algorithm) -> Watched {
    let mut memory = Memory::of(tree, algorithm, Cache::usual());
    let mut branches = Branches::of(tree);
    (memory.history, branches.history) = (Some(Vec::new()), Some(Vec::new()));
    let mut both = Both { memory, branches, n_events: 0 };
    Query::default().along_the_ray_by(Method::from(algorithm)).run(tree, ray, &mut both);
    let Both { memory, branches, n_events } = both;
    Watched {
        algorithm,
        n_lines: memory.n_lines,
        reads: memory.history.unwrap_or_default(),
        kinds: branches.counts,
        branches: branches.history.unwrap_or_default(),
        is_cut: n_events >= MOST_EVENTS,
    }
}

struct Both<'a, const D: usize> {
    memory: Memory<'a, D>,
    branches: Branches<'a, D>,
    n_events: usize,
}

impl<const D: usize> Observer<D> for Both<'_, D> {
    fn observe(&mut self, event: Event<D>) {
        self.memory.observe(event);
        self.branches.observe(event);
        self.n_events += 1;
    }

    fn wants_more(&self) -> bool {
        self.n_events < MOST_EVENTS
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::count;
    use crate::progress::Progress;
    use crate::scene::made;
    use crate::tree::{Domain, Recipe, Split, build, grow};

    #[test]
    fn one_ray_costs_what_is_counted_of_many() {
        let recipe = Recipe { depth: 6, ..Recipe::default() };
        let cloud = made::cloud::<3>(1, 100);
        let tree = build(&cloud, Domain::unit(6), &recipe, &Progress::default()).unwrap();
        let ray = Ray::new([-0.5, 0.21, 0.4], [1.0, 0.13, 0.07]).unwrap();
        for watched in watch(&tree, &ray, &Algorithm::ALL) {
            let query = Query::default().along_the_ray_by(watched.algorithm.into());
            let counted = count(&tree, &[ray], &query, &Progress::default()).unwrap();
            let n_misses = watched.reads.iter().filter(|read| !read.is_cached).count();
            let lines = [watched.reads.len() as u64, watched.n_lines, n_misses as u64];
            let branches = [watched.branches.len() as u64, watched.n_wrong()];
            let both = (counted.lines, counted.branches);
            assert_eq!((lines, branches), both, "{:?}", watched.algorithm);
            assert!(!watched.is_cut);
        }
    }

    #[test]
    fn every_algorithm_can_be_watched_and_long_runs_are_cut() {
        let tree = grow(Domain::<2>::unit(4), (), &Progress::default(), |cell, ()| {
            if cell.level > 0 { Split::Inner(vec![(); 4]) } else { Split::Empty }
        });
        let tree = tree.unwrap();
        let ray = Ray::new([-0.5, 0.21], [1.0, 0.13]).unwrap();
        for watched in watch(&tree, &ray, &Algorithm::ALL) {
            let of_kinds: u64 = watched.kinds.iter().map(|[n, _]| n).sum();
            assert_eq!(of_kinds, watched.branches.len() as u64);
            let wrong = watched.branches.iter().filter(|branch| !branch.is_predicted).count();
            assert_eq!(wrong as u64, watched.n_wrong());
            assert!(watched.n_lines <= watched.reads.len() as u64 && !watched.is_cut);
        }
        let deep = grow(Domain::<2>::unit(16), (), &Progress::default(), |cell, ()| {
            if cell.level > 15 { Split::Inner(vec![(); 4]) } else { Split::Empty }
        });
        let [grid] = &watch(&deep.unwrap(), &ray, &[Algorithm::Dda])[..] else { panic!() };
        assert!(grid.is_cut);
    }
}
