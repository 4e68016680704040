//! What a search costs, and what it finds, without a record of it.

use crate::traced::{QUICK_EVENTS, is_prepared};
use octoscope_core::event::{Event, Observer};
use octoscope_core::geometry::Ray;
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::query::Query;
use octoscope_core::trace::Counters;
use octoscope_core::tree::{NodeId, Tree};

/// A run of more steps is cut: a printed rule may go round for ever.
const MOST_STEPS: usize = 1_000_000;

/// What a search costs on one ray.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Counted {
    /// Its steps.
    pub n_steps: usize,
    /// What they cost.
    pub counters: Counters,
    /// Visited leaves, in order.
    pub leaves: Vec<NodeId>,
    /// Whether the run was given up after the most steps that are allowed, so that
    /// everything above tells of its beginning only.
    pub is_cut: bool,
}

/// Runs a search on one ray.
///
/// # Errors
/// Stops with [`Cancelled`] when `progress` is cancelled.
pub fn counted<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    query: &Query<D>,
    progress: &Progress,
) -> Result<Counted, Cancelled> {
    let mut counting = Counting { counted: Counted::default(), most_steps: MOST_STEPS, progress };
    query.run(tree, ray, &mut counting);
    progress.check()?;
    Ok(counting.counted)
}

/// The same, if it takes a small part of a frame.
pub fn counted_quickly<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    query: &Query<D>,
) -> Option<Counted> {
    if !is_prepared(tree, query) {
        return None;
    }
    let (counted, progress) = (Counted::default(), &Progress::default());
    let mut counting = Counting { counted, most_steps: QUICK_EVENTS, progress };
    query.run(tree, ray, &mut counting);
    Some(counting.counted).filter(|counted| !counted.is_cut)
}

/// Counts as long as the result is wanted.
struct Counting<'a> {
    counted: Counted,
    most_steps: usize,
    progress: &'a Progress,
}

impl<const D: usize> Observer<D> for Counting<'_> {
    fn observe(&mut self, event: Event<D>) {
        // The first step that would be one too many.
        self.counted.is_cut = self.counted.n_steps == self.most_steps;
        if self.counted.is_cut {
            return;
        }
        self.counted.n_steps += 1;
        self.counted.counters.add(&event);
        if let Event::Leaf { node, .. } = event {
            self.counted.leaves.push(node);
        }
    }

    fn wants_more(&self) -> bool {
        !self.counted.is_cut && self.progress.check().is_ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::query::Arithmetic;
    use octoscope_core::traverse::{Algorithm, Options};
    use octoscope_core::tree::{Domain, Split, grow};

    fn asked(algorithm: Algorithm) -> Query<2> {
        Query::Ray { algorithm, options: Options::default(), arithmetic: Arithmetic::Doubles }
    }

    #[test]
    fn what_takes_long_is_not_counted_at_once() {
        let tree = grow(Domain::<2>::unit(9), (), &Progress::default(), |cell, ()| {
            // All cells along one side are small.
            let is_inner = cell.level > 0 && cell.code[0] == 0;
            if is_inner { Split::Inner(vec![(); 4]) } else { Split::Empty }
        });
        let tree = tree.unwrap();
        let ray = Ray::new([-0.1, 0.3], [1.0, 0.01]).unwrap();
        let along = Ray::new([1e-4, -0.1], [0.0, 1.0]).unwrap();
        let whole = |ray| counted(&tree, ray, &asked(Algorithm::Hero), &Progress::default());
        assert_eq!(counted_quickly(&tree, &ray, &asked(Algorithm::Hero)), whole(&ray).ok());
        assert!(whole(&along).unwrap().n_steps > 1000);

        let mut counting = Counting {
            counted: Counted::default(),
            most_steps: 100,
            progress: &Progress::default(),
        };
        asked(Algorithm::Hero).run(&tree, &along, &mut counting);
        assert_eq!((counting.counted.n_steps, counting.counted.is_cut), (100, true));
    }
}
