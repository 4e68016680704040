//! Whether algorithms find the same leaves on many rays.

use crate::event::{Event, Observer};
use crate::geometry::Ray;
use crate::query::Query;
use crate::traverse::{Method, Slivers, first_difference};
use crate::tree::{NodeId, Tree};

/// Where two algorithms differ first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Disagreement {
    /// The one that is compared.
    pub method: Method,
    /// The one that it is compared with.
    pub reference: Method,
    /// Number of the ray, from 0.
    pub ray: usize,
    /// Number of the first leaf that is another one, from 0.
    pub leaf: usize,
}

/// The first ray on which `method` finds other leaves than `reference`, by more than
/// slivers.
pub fn disagreement<const D: usize>(
    tree: &Tree<D>,
    rays: &[Ray<D>],
    reference: Method,
    method: Method,
) -> Option<Disagreement> {
    rays.iter().enumerate().find_map(|(number, ray)| {
        let [expected, found] = [reference, method].map(|method| leaves(tree, ray, method));
        let difference = first_difference(tree, ray, &expected, &found, Slivers::Ignore)?;
        Some(Disagreement { method, reference, ray: number, leaf: difference.index })
    })
}

fn leaves<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, method: Method) -> Vec<NodeId> {
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
    use crate::progress::Progress;
    use crate::traverse::Algorithm;
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
        let reference = Method::default();
        for algorithm in Algorithm::ALL {
            assert_eq!(disagreement(&tree, &rays, reference, algorithm.into()), None);
        }
        // Bits 0 and 2 interchanged: of leaves 4 and 5 only 5 is found.
        let printed: Method = "parametric-table@B-2".parse().unwrap();
        let found = disagreement(&tree, &rays[1..], reference, printed);
        assert_eq!(found, Some(Disagreement { method: printed, reference, ray: 0, leaf: 0 }));
    }
}
