//! Speed of many rays on one thread and on several, in one run.
//!
//!     cargo bench -p octoscope-core --bench threads [-- THREADS]
//!
//! Rays are divided among the threads as `octoscope visit --threads` divides them to
//! measure. For each tree million rays a second (median and best of the rounds) and the
//! ratio to one thread. Rounds go through all rows in turn. Time is that which has
//! passed: a busy machine makes several threads look worse than they are.

mod workload;

use octoscope_core::geometry::Ray;
use octoscope_core::measure::Tally;
use octoscope_core::query::Query;
use octoscope_core::threads::in_parts;
use octoscope_core::traverse::{Algorithm, Kernel, StopAt, visit_many};
use octoscope_core::tree::Tree;
use std::hint::black_box;
use std::num::NonZeroUsize;
use std::time::Instant;
use workload::{Rays, Scene};

/// Trees and the rays through them.
const TABLE: [(Scene, u8, Rays); 7] = [
    (Scene::Grid(3), 6, Rays::Outside),
    (Scene::Cloud, 8, Rays::Outside),
    (Scene::Cloud, 8, Rays::Inside),
    (Scene::Cloud, 8, Rays::Camera),
    (Scene::Grid(5), 8, Rays::Outside),
    (Scene::Boxes, 8, Rays::Outside),
    (Scene::Triangles, 8, Rays::Outside),
];
const N_RAYS: usize = 20_000;
const N_ROUNDS: usize = 9;

fn main() {
    let asked = std::env::args().skip(1).find_map(|word| word.parse().ok());
    let all = asked.or(std::thread::available_parallelism().ok()).unwrap_or(NonZeroUsize::MIN);
    println!(
        "{:<38} {:>7} {:>9} {:>9} {:>7} {:>7}",
        "enum", "threads", "Mrays/s", "best", "ratio", "best"
    );
    for (scene, depth, rays) in TABLE {
        let (tree, place) =
            (scene.tree(depth), format!("{} d{depth} {}", scene.name(), rays.name()));
        // Spread over all of them.
        let all_rays = rays.all();
        let rays: Vec<Ray<3>> =
            (0..N_RAYS).map(|i| all_rays[i * all_rays.len() / N_RAYS]).collect();
        for (name, run) in [("parametric", walk as fn(&_, &[_])), ("batch, vectors", fly)] {
            let threads = [NonZeroUsize::MIN, all];
            report(&format!("{place} {name}"), threads, |threads| time(&tree, &rays, threads, run));
        }
    }
}

fn report(name: &str, threads: [NonZeroUsize; 2], time: impl Fn(NonZeroUsize) -> f64) {
    let mut times = threads.map(|_| Vec::new());
    for _ in 0..N_ROUNDS {
        for (threads, times) in threads.into_iter().zip(&mut times) {
            times.push(time(threads));
        }
    }
    let [one, all] = times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        [times[times.len() / 2], times[0]]
    });
    for (threads, [median, best]) in threads.into_iter().zip([one, all]) {
        let rate = |seconds: f64| N_RAYS as f64 / seconds / 1e6;
        println!(
            "{name:<38} {threads:>7} {:>9.3} {:>9.3} {:>7.2} {:>7.2}",
            rate(median),
            rate(best),
            one[0] / median,
            one[1] / best
        );
    }
}

/// Seconds until so many threads have run over all rays.
fn time(
    tree: &Tree<3>,
    rays: &[Ray<3>],
    threads: NonZeroUsize,
    run: fn(&Tree<3>, &[Ray<3>]),
) -> f64 {
    let start = Instant::now();
    in_parts(threads, rays, |rays| run(tree, rays));
    start.elapsed().as_secs_f64()
}

fn walk(tree: &Tree<3>, rays: &[Ray<3>]) {
    let mut tally = Tally::default();
    let query = Query::default().along_the_ray_by(Algorithm::Parametric.into());
    for ray in rays {
        black_box(query.run(tree, ray, &mut tally));
    }
    black_box(tally);
}

fn fly(tree: &Tree<3>, rays: &[Ray<3>]) {
    let mut n_full = 0;
    visit_many(tree, rays, StopAt::End, Kernel::Vector, |_, leaves| {
        n_full += leaves.iter().map(|leaf| u64::from(leaf.is_full())).sum::<u64>();
    });
    black_box(n_full);
}
