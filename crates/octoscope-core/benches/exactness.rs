//! What exact comparisons cost: the time of every algorithm with them over its
//! time in doubles, on random rays from outside, in one run. Medians of several
//! rounds; run it with `cargo bench -p octoscope-core --bench exactness`.

mod clock;

use clock::Clock;
use octoscope_core::event::Outcome;
use octoscope_core::geometry::Ray;
use octoscope_core::progress::Progress;
use octoscope_core::random::Random;
use octoscope_core::traverse::{Algorithm, Options};
use octoscope_core::tree::{Domain, Split, Tree, grow};
use std::hint::black_box;

const N_RAYS: usize = 2000;
const N_ROUNDS: usize = 15;

fn main() {
    println!("{:<18} {:>10} {:>10} {:>7}", "ns a ray, 3-D", "doubles", "exact", "ratio");
    let tree = shell(6);
    let mut random = Random::new(1);
    let rays: Vec<Ray<3>> = (0..N_RAYS).map(|_| ray(&mut random)).collect();
    for algorithm in Algorithm::ALL.into_iter().filter(|&a| a != Algorithm::Exhaustive) {
        // In turns, so that both meet the same weather.
        let mut times: [Vec<f64>; 2] = Default::default();
        for _ in 0..N_ROUNDS {
            let options = Options::default();
            times[0].push(time(&rays, |ray| algorithm.run::<3, f64>(&tree, ray, options, &mut ())));
            times[1].push(time(&rays, |ray| algorithm.run_exactly(&tree, ray, options, &mut ())));
        }
        let [doubles, exact] = times.map(median);
        let ratio = exact / doubles;
        println!("{:<18} {doubles:>10.0} {exact:>10.0} {ratio:>7.2}", algorithm.id());
    }
}

/// The cells of a hollow sphere in the unit cube, each of level 0.
fn shell(root_level: u8) -> Tree<3> {
    grow(Domain::unit(root_level), (), &Progress::default(), |cell, ()| {
        let bounds = cell.bounds();
        let [mut nearest, mut farthest] = [0.0, 0.0];
        for e in 0..3 {
            let [low, high] = [bounds.min[e] - 0.5, bounds.max[e] - 0.5];
            nearest += low.max(-high).max(0.0f64).powi(2);
            farthest += low.abs().max(high.abs()).powi(2);
        }
        let meets = (nearest..=farthest).contains(&0.16);
        match (meets, cell.level) {
            (false, _) => Split::Empty,
            (true, 0) => Split::Full(vec![]),
            (true, _) => Split::Inner(vec![(); 8]),
        }
    })
    .expect("nobody cancels")
}

/// Ray from outside through a random point of the unit cube.
fn ray(random: &mut Random) -> Ray<3> {
    let target: [f64; 3] = std::array::from_fn(|_| random.unit());
    let direction: [f64; 3] = std::array::from_fn(|_| random.between(-1.0, 1.0));
    let origin = std::array::from_fn(|e| target[e] - 2.0 * direction[e]);
    Ray::new(origin, direction).expect("finite and not zero")
}

/// Nanoseconds a ray.
fn time(rays: &[Ray<3>], run: impl Fn(&Ray<3>) -> Outcome) -> f64 {
    let start = Clock::start();
    for ray in rays {
        black_box(run(ray));
    }
    start.seconds() * 1e9 / rays.len() as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
