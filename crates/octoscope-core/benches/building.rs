//! Speed of building trees, in one run: million points or cells a second on one
//! thread, best and median of several rounds.
//!
//!     cargo bench -p octoscope-core --bench building

mod clock;

use clock::Clock;
use octoscope_core::progress::Progress;
use octoscope_core::random::Random;
use octoscope_core::scene::{Content, made};
use octoscope_core::tree::{Domain, Merge, Recipe, Tree, build};

const N: u32 = 1_000_000;
const N_ROUNDS: usize = 5;

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
    println!("{:<34} {:>9} {:>9} {:>9}", "", "M items/s", "best", "ms");
    report("points, buckets of 8, depth 8", &Content::Points(points.clone()), buckets);
    report("cells, merged, depth 8", &cells(8), whole(8));
    report("cells, kept, depth 8", &cells(8), kept(8));
    report("cells, kept, depth 10", &cells(10), kept(10));
    report("cloud of spheres, depth 8", &made::cloud(0xC10D, 1890), whole(8));
    report("4096 spheres, depth 8", &made::sphere_grid(4), whole(8));
}

fn report(name: &str, content: &Content<3>, recipe: Recipe) {
    let mut times: Vec<f64> = (0..N_ROUNDS).map(|_| time(content, &recipe)).collect();
    times.sort_by(f64::total_cmp);
    let (best, median) = (times[0], times[times.len() / 2]);
    let rate = |seconds: f64| content.len() as f64 / seconds / 1e6;
    println!("{name:<34} {:>9.2} {:>9.2} {:>9.1}", rate(median), rate(best), median * 1e3);
}

fn time(content: &Content<3>, recipe: &Recipe) -> f64 {
    let start = Clock::start();
    let tree: Tree<3> = build(content, Domain::unit(recipe.depth), recipe, &Progress::default())
        .expect("the content lies in the unit cube");
    let seconds = start.seconds();
    assert!(tree.n_leaves() > 1);
    seconds
}
