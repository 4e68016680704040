//! Walks rays by one algorithm while nobody watches: the program whose instructions
//! `tests/events_cost_nothing.rs` counts.
//!
//!     cargo run --release -p octoscope-core --example walks ALGORITHM
//!
//! Prints how the walks ended, as one number.

use octoscope_core::geometry::Ray;
use octoscope_core::measure::{FNV_BASIS, fnv_1a, rays_from_outside};
use octoscope_core::progress::Progress;
use octoscope_core::scene::made;
use octoscope_core::traverse::{Algorithm, Options, StopAt};
use octoscope_core::tree::{Domain, Recipe, Tree, build};
use std::hint::black_box;

fn main() {
    let id = std::env::args().nth(1).expect("the name of an algorithm");
    let algorithm: Algorithm = id.parse().expect("the name of an algorithm");
    let recipe = Recipe { depth: 5, ..Recipe::default() };
    let tree = build(&made::sphere_grid(2), Domain::unit(5), &recipe, &Progress::default())
        .expect("the spheres lie in the unit cube");
    tree.link(&Progress::default()).expect("nobody cancels");
    // The oracle tests every leaf of the tree.
    let n_rays = if algorithm == Algorithm::Exhaustive { 2 } else { 200 };
    let rays = rays_from_outside(tree.domain(), 1, n_rays);
    let mut ends = FNV_BASIS;
    for stop_at in [StopAt::End, StopAt::FirstFull] {
        let options = Options { stop_at, ..Options::default() };
        ends = walk_the_rays(algorithm, &tree, &rays, black_box(options), ends);
    }
    println!("{ends:016x}");
}

/// The only function whose instructions are counted.
#[inline(never)]
fn walk_the_rays(
    algorithm: Algorithm,
    tree: &Tree<3>,
    rays: &[Ray<3>],
    options: Options,
    mut ends: u64,
) -> u64 {
    for ray in rays {
        let outcome = algorithm.run::<3, f64>(tree, ray, options, &mut ());
        let node = outcome.node.map_or(u32::MAX, |node| node.0);
        ends = fnv_1a(ends, &[outcome.end as u8]);
        ends = fnv_1a(ends, &node.to_le_bytes());
    }
    ends
}
