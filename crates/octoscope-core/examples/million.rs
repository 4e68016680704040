//! Compares every algorithm with the oracle on a million rays, exactly and in
//! doubles, by the laws that the tests hold on a tenth of them.
//!
//! The rays are of all classes of the tests (random, lattice, corner, parallel, in a
//! plane, inside, …), through random quadtrees and octrees of depth 1 to 10, with the
//! root at 0 and elsewhere. Prints the rays, leaves and differences, and the time of
//! every algorithm with its checks; ends with an error if there is a difference.
//!
//!     cargo run --release -p octoscope-core --example million [RAYS [SEED]]

use octoscope_core::query::Arithmetic;
use octoscope_core::random::Random;
use octoscope_core::traverse::Algorithm;
use std::process::ExitCode;
use std::time::{Duration, Instant};

#[path = "../tests/laws/agreement.rs"]
mod agreement;
#[path = "../tests/laws/rays.rs"]
mod rays;
#[path = "../tests/laws/trees.rs"]
mod trees;

const ARITHMETICS: [Arithmetic; 2] = [Arithmetic::Exact, Arithmetic::Doubles];
/// Rays of every class through one tree.
const RAYS_A_CLASS: usize = 25;

/// What was compared so far.
struct Tally {
    n_rays: u64,
    n_by_class: [u64; rays::Class::ALL.len()],
    n_leaves: usize,
    n_differences: usize,
    times: [[Duration; 2]; Algorithm::ALL.len()],
}

fn main() -> ExitCode {
    let mut arguments =
        std::env::args().skip(1).map(|word| word.parse().expect("a number of rays, then a seed"));
    let n_rays = arguments.next().unwrap_or(1_000_000);
    let mut random = Random::new(arguments.next().unwrap_or(2026));
    let mut tally = Tally {
        n_rays: 0,
        n_by_class: Default::default(),
        n_leaves: 0,
        n_differences: 0,
        times: Default::default(),
    };
    let mut n_trees = 0;
    while tally.n_rays < n_rays {
        let (depth, kind) = (1 + (n_trees % 10) as u8, n_trees / 10);
        through_one_tree::<2>(depth, kind, &mut random, &mut tally);
        through_one_tree::<3>(depth, kind, &mut random, &mut tally);
        n_trees += 1;
    }

    let Tally { n_rays, n_by_class, n_leaves, n_differences, times } = tally;
    println!("{n_rays} rays through {n_trees} quadtrees and as many octrees, {n_leaves} leaves");
    for (class, n) in rays::Class::ALL.into_iter().zip(n_by_class) {
        println!("  {:<14}{n:>9}", format!("{class:?}"));
    }
    println!("{:<18}{:>12}{:>12}", "seconds", "exact", "doubles");
    for (algorithm, times) in Algorithm::ALL.into_iter().zip(times) {
        let [exact, doubles] = times.map(|time| time.as_secs_f64());
        println!("{:<18}{exact:>12.2}{doubles:>12.2}", algorithm.id());
    }
    println!("{n_differences} differences");
    if n_differences == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn through_one_tree<const D: usize>(depth: u8, kind: u64, random: &mut Random, tally: &mut Tally) {
    let tree = trees::random_tree(trees::domain::<D>(depth, kind), 30, random);
    for (index, class) in rays::Class::ALL.into_iter().enumerate() {
        for _ in 0..RAYS_A_CLASS {
            let ray = rays::random_ray(&tree, class, random);
            let start = Instant::now();
            let oracle = agreement::oracle(&tree, &ray);
            tally.times[Algorithm::ALL.len() - 1][0] += start.elapsed();
            tally.n_rays += 1;
            tally.n_by_class[index] += 1;
            tally.n_leaves += oracle.0.leaves.len();
            let others = Algorithm::ALL.into_iter().filter(|&a| a != Algorithm::Exhaustive);
            for (place, algorithm) in others.enumerate() {
                for (times, arithmetic) in tally.times[place].iter_mut().zip(ARITHMETICS) {
                    let start = Instant::now();
                    let compared = agreement::compare(&tree, &ray, &oracle, algorithm, arithmetic);
                    *times += start.elapsed();
                    if let Err(difference) = compared {
                        tally.n_differences += 1;
                        println!("{class:?} in depth {depth}, domain {kind}: {difference}");
                    }
                }
            }
        }
    }
}
