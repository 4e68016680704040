//! Whether two ways find the same leaves on many rays.

use super::Way;
use super::count::found_by_batch;
use crate::event::{Event, Observer};
use crate::geometry::Ray;
use crate::progress::{Cancelled, Progress};
use crate::query::Query;
use crate::traverse::{Slivers, first_difference};
use crate::tree::{NodeId, Tree};

/// Where two ways differ first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Disagreement {
    /// The one that is compared.
    pub way: Way,
    /// The one that it is compared with.
    pub reference: Way,
    /// Number of the ray, from 0.
    pub ray: usize,
    /// Number of the first leaf that is another one, from 0.
    pub leaf: usize,
}

/// The first ray on which `way` finds other leaves than `reference`, by more than
/// slivers.
///
/// # Errors
/// Stops with [`Cancelled`] when `progress` is cancelled; every ray is a unit of it.
pub fn disagreement<const D: usize>(
    tree: &Tree<D>,
    rays: &[Ray<D>],
    [reference, way]: [Way; 2],
    progress: &Progress,
) -> Result<Option<Disagreement>, Cancelled> {
    for (number, ray) in rays.iter().enumerate() {
        let [expected, found] = [reference, way].map(|way| leaves(tree, ray, way));
        let difference = first_difference(tree, ray, &expected, &found, Slivers::Ignore);
        if let Some(difference) = difference {
            let leaf = difference.index;
            return Ok(Some(Disagreement { way, reference, ray: number, leaf }));
        }
        progress.advance(1)?;
    }
    Ok(None)
}

fn leaves<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, way: Way) -> Vec<NodeId> {
    let method = match way {
        Way::Traced(method) => method,
        Way::Batch(kernel) => {
            let found = found_by_batch(tree, std::slice::from_ref(ray), kernel);
            return found.into_iter().flatten().map(|leaf| leaf.node()).collect();
        }
    };
    let mut list = List(Vec::new());
    Query::default().along_the_ray_by(method).run(tree, ray, &mut list);
    list.0
}

struct List(Vec<NodeId>);

impl<const D: usize> Observer<D> for List {
    fn observe(&mut self, event: Event<D>) {
        if let Event::Leaf { node, .. } = event {
            self.0.push(node);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::traverse::Method;
    use crate::tree::{Domain, Split, grow};

    #[test]
    fn a_misprint_is_found_out() {
        let tree = grow(Domain::<3>::unit(1), (), &Progress::default(), |cell, ()| {
            if cell.level > 0 { Split::Inner(vec![(); 8]) } else { Split::Empty }
        });
        let tree = tree.unwrap();
        let straight = Ray::new([0.75, 0.25, -1.0], [0.0, 0.0, 1.0]).unwrap();
        let slanted = Ray::new([0.75, 0.25, -1.0], [0.0625, 0.0625, 1.0]).unwrap();
        let rays = [straight, slanted];
        let reference = Way::default();
        for way in Way::all() {
            let progress = Progress::default();
            progress.start(2);
            assert_eq!(disagreement(&tree, &rays, [reference, way], &progress), Ok(None));
            assert_eq!(progress.fraction(), Some(1.0));
        }
        // Bits 0 and 2 interchanged: of leaves 4 and 5 only 5 is found.
        let printed = Way::from("parametric-table@B-2".parse::<Method>().unwrap());
        let progress = Progress::default();
        let found = disagreement(&tree, &rays[1..], [reference, printed], &progress);
        assert_eq!(found, Ok(Some(Disagreement { way: printed, reference, ray: 0, leaf: 0 })));
        progress.cancel();
        let found = disagreement(&tree, &rays, [reference, reference], &progress);
        assert_eq!(found, Err(Cancelled));
    }
}
