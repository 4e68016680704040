//! Many rays at once meet the leaves that each of them meets alone.

use crate::rays::{Class, random_ray};
use crate::trees::{domain, random_tree};
use octoscope_core::event::{Event, Observer};
use octoscope_core::geometry::Ray;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::random::Random;
use octoscope_core::traverse::{Algorithm, Kernel, Options, StopAt, visit_many};
use octoscope_core::tree::{NodeId, Tree};

/// Visited leaves, and whether they are full.
#[derive(Default)]
struct Leaves(Vec<(NodeId, bool)>);

impl<const D: usize> Observer<D> for Leaves {
    fn observe(&mut self, event: Event<D>) {
        if let Event::Leaf { node, full, .. } = event {
            self.0.push((node, full));
        }
    }
}

fn check<const D: usize>(tree: &Tree<D>, rays: &[Ray<D>], stop_at: StopAt) {
    let options = Options { stop_at, ..Options::default() };
    let algorithm = Algorithm::Parametric;
    let query = Query::Ray { algorithm, options, arithmetic: Arithmetic::Exact };
    for kernel in [Kernel::Plain, Kernel::Vector] {
        let mut found = vec![None; rays.len()];
        visit_many(tree, rays, stop_at, kernel, |index, leaves| {
            let leaves = leaves.iter().map(|leaf| (leaf.node(), leaf.is_full()));
            let before = found[index].replace(leaves.collect::<Vec<_>>());
            assert_eq!(before, None, "a ray ends twice");
        });
        for (ray, found) in rays.iter().zip(found) {
            let mut expected = Leaves::default();
            query.run(tree, ray, &mut expected);
            assert_eq!(found, Some(expected.0), "{kernel:?} {stop_at:?} {ray:?}");
        }
    }
}

/// Rays of all classes through random trees; 25 of each class a tree.
fn check_many<const D: usize>(seed: u64, n_trees: u64) -> usize {
    let mut random = Random::new(seed);
    let mut n_rays = 0;
    for n in 0..n_trees {
        let tree = random_tree(domain::<D>((n % 11) as u8, n / 11), 40, &mut random);
        let rays: Vec<Ray<D>> = Class::ALL
            .into_iter()
            .flat_map(|class| [class; 25])
            .map(|class| random_ray(&tree, class, &mut random))
            .collect();
        check(&tree, &rays, StopAt::End);
        check(&tree, &rays[..rays.len() / 2], StopAt::FirstFull);
        n_rays += rays.len();
    }
    n_rays
}

#[test]
fn rays_in_lanes_meet_what_each_meets_alone() {
    let n_rays = check_many::<2>(11, 132) + check_many::<3>(12, 132);
    assert!(n_rays >= 100_000, "only {n_rays}");
}

/// Codes reach no deeper.
#[test]
fn rays_in_lanes_meet_what_each_meets_alone_in_the_deepest_tree() {
    let (mut random, mut n_deep) = (Random::new(14), 0);
    for n in 0..12 {
        let tree = random_tree(domain::<3>(20, n), 200, &mut random);
        n_deep += usize::from(tree.nodes().any(|node| tree.level(node.id) == 0));
        let rays: Vec<_> = Class::ALL
            .into_iter()
            .flat_map(|class| [class; 25])
            .map(|class| random_ray(&tree, class, &mut random))
            .collect();
        check(&tree, &rays, StopAt::End);
        check(&tree, &rays, StopAt::FirstFull);
    }
    assert!(n_deep >= 6, "only {n_deep} reach the leaf grid");
}

#[test]
fn lanes_without_rays_do_no_harm() {
    let mut random = Random::new(13);
    let tree = random_tree(domain::<3>(5, 0), 40, &mut random);
    for n_rays in 0..40 {
        let classes = Class::ALL.into_iter().cycle().take(n_rays);
        let rays: Vec<_> = classes.map(|class| random_ray(&tree, class, &mut random)).collect();
        check(&tree, &rays, StopAt::End);
    }
}
