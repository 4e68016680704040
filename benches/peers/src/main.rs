//! Other systems on the workload of our benches, in one run with our own traversals.
//!
//!     cargo run --release --manifest-path benches/peers/Cargo.toml [-- WORD…]
//!
//! The occupied cells are given to bounding volume hierarchies as boxes. `first` asks
//! for the nearest box on a ray, `enum` for all of them; ours list the empty cells
//! between them as well, and everything in order, which the others do not. The boxes
//! of the others are closed and their parameters have single precision: rays on which
//! their answer is another one are counted. With words, only tables run whose name
//! holds one of them.

#[path = "../../../crates/octoscope-core/benches/clock/mod.rs"]
mod clock;
mod hierarchies;
mod ours;
#[allow(dead_code, reason = "the other benches need the rest")]
#[path = "../../../crates/octoscope-core/benches/workload/mod.rs"]
mod workload;

use clock::Clock;
use octoscope_core::geometry::{Aabb, Ray};
use octoscope_core::traverse::StopAt;
use octoscope_core::tree::{NodeId, Tree};
use workload::{Rays, Scene};

const N_RAYS: usize = 1000;
const N_ROUNDS: usize = 21;
const TABLES: [(Scene, u8, StopAt); 4] = [
    (Scene::Grid(3), 6, StopAt::End),
    (Scene::Cloud, 8, StopAt::End),
    (Scene::Grid(3), 6, StopAt::FirstFull),
    (Scene::Cloud, 8, StopAt::FirstFull),
];

/// The answer to `first` on a ray that meets nothing.
pub const NOTHING: u32 = u32::MAX;

/// Puts an answer for each ray into the list.
pub type Run<'a> = dyn Fn(&mut [u32]) + 'a;

/// A system with its rays: puts an answer for each of them into the list, the number of
/// the nearest box, or how many boxes there are.
pub struct Row<'a> {
    /// Its name.
    pub name: &'static str,
    /// Answers all rays.
    pub run: Box<Run<'a>>,
    /// Whether its boxes are numbered as nodes of the tree.
    pub is_ours: bool,
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    for (scene, depth, stop_at) in TABLES {
        let query = if stop_at == StopAt::End { "enum" } else { "first" };
        let name = format!("{query} {} d{depth} {}", scene.name(), Rays::Outside.name());
        if words.is_empty() || words.iter().any(|word| name.contains(word.as_str())) {
            measure(&name, &scene.tree(depth), stop_at);
        }
    }
}

fn measure(name: &str, tree: &Tree<3>, stop_at: StopAt) {
    let all = Rays::Outside.all();
    let rays: Vec<Ray<3>> = (0..N_RAYS).map(|i| all[i * all.len() / N_RAYS]).collect();
    let full: Vec<NodeId> =
        tree.leaves().filter(|leaf| leaf.is_full()).map(|leaf| leaf.id).collect();
    let boxes: Vec<Aabb<3>> = full.iter().map(|&node| tree.node_box(node)).collect();
    let mut rows = ours::rows(tree, &rays, stop_at);
    rows.extend(hierarchies::rows(&boxes, &rays, stop_at));

    let mut times = vec![Vec::new(); rows.len()];
    let mut answers = vec![vec![NOTHING; rays.len()]; rows.len()];
    for _ in 0..N_ROUNDS {
        for ((row, times), answers) in rows.iter().zip(&mut times).zip(&mut answers) {
            let start = Clock::start();
            (row.run)(answers);
            times.push(start.seconds() / rays.len() as f64);
        }
    }
    let found = answers[0].iter().filter(|answer| **answer != NOTHING);
    let met: u64 = match stop_at {
        StopAt::End => found.map(|&count| u64::from(count)).sum(),
        StopAt::FirstFull => found.count() as u64,
    };
    println!("\n{name}: {} boxes, met {met} times", boxes.len());
    println!("{:<24} {:>9} {:>9} {:>7} {:>8}", "", "Mrays/s", "best", "ratio", "differs");
    for (row, answers) in rows.iter().zip(&mut answers) {
        if !row.is_ours && stop_at == StopAt::FirstFull {
            for answer in answers.iter_mut().filter(|answer| **answer != NOTHING) {
                *answer = full[*answer as usize].0;
            }
        }
    }
    let mut first = None;
    for ((row, mut times), found) in rows.iter().zip(times).zip(&answers) {
        times.sort_by(f64::total_cmp);
        let (best, median) = (times[0], times[times.len() / 2]);
        let first = *first.get_or_insert(median);
        let differs = found.iter().zip(&answers[0]).filter(|(a, b)| a != b).count();
        println!(
            "{:<24} {:>9.3} {:>9.3} {:>7.2} {differs:>8}",
            row.name,
            1e-6 / median,
            1e-6 / best,
            first / median,
        );
    }
}
