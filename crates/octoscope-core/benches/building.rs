//! Speed of building trees, in one run: million points, cells or spheres a second on
//! one thread and on several, best and median of several rounds. Rounds go through all
//! numbers of threads in turn, and time is that which has passed: a busy machine makes
//! several threads look worse than they are.
//!
//!     cargo bench -p octoscope-core --bench building [-- THREADS]

#[allow(dead_code, reason = "the other benches need the rest")]
mod workload;

use octoscope_core::progress::Progress;
use octoscope_core::random::Random;
use octoscope_core::scene::Content;
use octoscope_core::tree::{Domain, Merge, Recipe, Tree, build_on};
use std::num::NonZeroUsize;
use std::time::Instant;
use workload::Scene;

const N: u32 = 1_000_000;
const N_ROUNDS: usize = 11;

fn main() {
    let mut random = Random::new(1);
    let points: Vec<[f64; 3]> = (0..N).map(|_| [(); 3].map(|()| random.unit())).collect();
    let cells = |depth: u8| {
        let size = f64::from(1u32 << depth);
        Content::Cells(points.iter().map(|p| p.map(|x| (x * size) as u32)).collect())
    };
    let buckets = Recipe { depth: 8, capacity: 8, ..Recipe::default() };
    let whole = |depth| Recipe { depth, ..Recipe::default() };
    let kept = |depth| Recipe { depth, merge: Merge::Kept, ..Recipe::default() };
    println!(
        "{:<32} {:>7} {:>9} {:>9} {:>9} {:>7} {:>7}",
        "", "threads", "M items/s", "best", "ms", "ratio", "best"
    );
    report("points, buckets of 8, depth 8", &Content::Points(points.clone()), buckets);
    report("cells, merged, depth 8", &cells(8), whole(8));
    report("cells, kept, depth 8", &cells(8), kept(8));
    report("cells, kept, depth 10", &cells(10), kept(10));
    // Seven of eight in a cube with a side of 1/512.
    let close = |&point: &[f64; 3]| match random.below(8) {
        0 => point,
        _ => point.map(|x| 0.25 + x / 512.0),
    };
    let close = Content::Points(points.iter().map(close).collect());
    report("points close together, depth 20", &close, Recipe { depth: 20, ..buckets });
    report("1890 spheres, depth 8", &Scene::Cloud.content(), whole(8));
    report("4096 spheres, depth 8", &Scene::Grid(4).content(), whole(8));
    report("1890 boxes, depth 8", &Scene::Boxes.content(), whole(8));
    report("triangles, depth 8", &Scene::Triangles.content(), whole(8));
}

fn report(name: &str, content: &Content<3>, recipe: Recipe) {
    let all = std::env::args().skip(1).find_map(|word| word.parse().ok());
    let all = all.or(std::thread::available_parallelism().ok()).unwrap_or(NonZeroUsize::MIN);
    let threads = [NonZeroUsize::MIN, all];
    let mut times = threads.map(|_| Vec::new());
    for _ in 0..N_ROUNDS {
        for (threads, times) in threads.into_iter().zip(&mut times) {
            times.push(time(threads, content, &recipe));
        }
    }
    let mut first = None;
    for (threads, mut times) in threads.into_iter().zip(times) {
        times.sort_by(f64::total_cmp);
        let (best, median) = (times[0], times[times.len() / 2]);
        let rate = |seconds: f64| content.len() as f64 / seconds / 1e6;
        let [median_of_one, best_of_one] = *first.get_or_insert([median, best]);
        println!(
            "{name:<32} {threads:>7} {:>9.3} {:>9.3} {:>9.1} {:>7.2} {:>7.2}",
            rate(median),
            rate(best),
            median * 1e3,
            median_of_one / median,
            best_of_one / best
        );
    }
}

fn time(threads: NonZeroUsize, content: &Content<3>, recipe: &Recipe) -> f64 {
    let (domain, progress) = (Domain::unit(recipe.depth), Progress::default());
    let start = Instant::now();
    let tree: Tree<3> = build_on(threads, content, domain, recipe, &progress)
        .expect("the content lies in the unit cube");
    let seconds = start.elapsed().as_secs_f64();
    assert!(tree.n_leaves() > 1);
    seconds
}
