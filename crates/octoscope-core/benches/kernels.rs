//! Speed of all ways to find the leaves on rays, on one workload, in one run.
//!
//!     cargo bench -p octoscope-core --bench kernels [-- WORD…]
//!
//! For each tree and query a table: million rays a second (median and best of the
//! rounds), nanoseconds a step, and the ratio to the first row. A step is a node that
//! the parametric traversal visits, inner or leaf, so that the unit is the same for
//! all. Rounds go through all rows in turn, so that all meet the same weather. With
//! words, only rows and tables run whose name holds one of them; numbers of rounds and
//! rays are given as `rounds=15` and `rays=20000`.

mod clock;
mod workload;

use clock::Clock;
use octoscope_core::event::{Event, Observer};
use octoscope_core::geometry::Ray;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::traverse::{Algorithm, Kernel, Options, StopAt, visit_many};
use octoscope_core::tree::Tree;
use std::hint::black_box;
use workload::{Rays, Scene};

/// Trees of the tables, the rays through them and the wanted end.
const TABLES: [(Scene, u8, Rays, StopAt); 14] = [
    (Scene::Grid(3), 6, Rays::Outside, StopAt::End),
    (Scene::Cloud, 8, Rays::Outside, StopAt::End),
    (Scene::Grid(5), 8, Rays::Outside, StopAt::End),
    (Scene::Cloud, 10, Rays::Outside, StopAt::End),
    (Scene::Grid(3), 6, Rays::Outside, StopAt::FirstFull),
    (Scene::Cloud, 8, Rays::Outside, StopAt::FirstFull),
    (Scene::Grid(5), 8, Rays::Outside, StopAt::FirstFull),
    (Scene::Cloud, 10, Rays::Outside, StopAt::FirstFull),
    (Scene::Cloud, 8, Rays::Inside, StopAt::FirstFull),
    (Scene::Cloud, 8, Rays::Camera, StopAt::FirstFull),
    (Scene::Boxes, 8, Rays::Outside, StopAt::End),
    (Scene::Boxes, 8, Rays::Outside, StopAt::FirstFull),
    (Scene::Triangles, 8, Rays::Outside, StopAt::End),
    (Scene::Triangles, 8, Rays::Outside, StopAt::FirstFull),
];

/// The algorithms that keep to steps through the tree and report nothing else.
const ALGORITHMS: [Algorithm; 5] = [
    Algorithm::Parametric,
    Algorithm::Hero,
    Algorithm::Gargantini,
    Algorithm::Codes,
    Algorithm::Esvo,
];

/// What can be timed.
#[derive(Clone, Copy, PartialEq)]
enum Row {
    Traced(Algorithm, Arithmetic),
    Batch(Kernel),
}

impl Row {
    fn all() -> Vec<Self> {
        let doubles = ALGORITHMS.map(|algorithm| Self::Traced(algorithm, Arithmetic::Doubles));
        let exact = ALGORITHMS.map(|algorithm| Self::Traced(algorithm, Arithmetic::Exact));
        let batch = [Kernel::Plain, Kernel::Vector].map(Self::Batch);
        doubles.into_iter().chain(exact).chain(batch).collect()
    }

    fn name(self) -> String {
        match self {
            Self::Traced(algorithm, Arithmetic::Doubles) => algorithm.id().to_owned(),
            Self::Traced(algorithm, Arithmetic::Exact) => format!("{}, exact", algorithm.id()),
            Self::Batch(Kernel::Plain) => "batch, plain".to_owned(),
            Self::Batch(Kernel::Vector) => "batch, vectors".to_owned(),
        }
    }

    /// Number of full leaves that the rays meet.
    fn run(self, tree: &Tree<3>, rays: &[Ray<3>], stop_at: StopAt) -> u64 {
        let mut tally = Tally::default();
        match self {
            Self::Traced(algorithm, arithmetic) => {
                let options = Options { stop_at, ..Options::default() };
                let query = Query::Ray { algorithm, options, arithmetic };
                for ray in rays {
                    black_box(query.run(tree, ray, &mut tally));
                }
            }
            Self::Batch(kernel) => visit_many(tree, rays, stop_at, kernel, |_, leaves| {
                tally.full += leaves.iter().map(|leaf| u64::from(leaf.is_full())).sum::<u64>();
            }),
        }
        tally.full
    }
}

/// What the user asks for.
struct Wanted {
    words: Vec<String>,
    n_rounds: usize,
    n_rays: usize,
}

impl Wanted {
    fn read() -> Self {
        let mut wanted = Self { words: Vec::new(), n_rounds: 31, n_rays: 1000 };
        for word in std::env::args().skip(1).filter(|word| !word.starts_with("--")) {
            let number = |text: &str| text.parse().expect("a number");
            match word.split_once('=') {
                Some(("rounds", text)) => wanted.n_rounds = number(text),
                Some(("rays", text)) => wanted.n_rays = number(text),
                Some(_) => panic!("rounds=N or rays=N"),
                None => wanted.words.push(word),
            }
        }
        wanted
    }

    /// Whether one of `of` is asked for, or none of them is ever asked for.
    fn wants<'a>(&self, name: &str, of: impl IntoIterator<Item = &'a String>) -> bool {
        let of: Vec<&String> = of.into_iter().collect();
        let asked = |name: &str| self.words.iter().any(|word| name.contains(word.as_str()));
        asked(name) || !of.into_iter().any(|name| asked(name))
    }
}

fn main() {
    let wanted = Wanted::read();
    let names: Vec<String> = TABLES.into_iter().map(table_name).collect();
    let mut built: Option<(Scene, u8, Tree<3>)> = None;
    for (table, name) in TABLES.into_iter().zip(&names) {
        if !wanted.wants(name, &names) {
            continue;
        }
        let (scene, depth, rays, stop_at) = table;
        let is_built = built.as_ref().is_some_and(|(s, d, _)| (*s, *d) == (scene, depth));
        if !is_built {
            built = Some((scene, depth, scene.tree(depth)));
        }
        let Some((_, _, tree)) = &built else { continue };
        measure(name, tree, &rays.all(), stop_at, &wanted);
    }
}

fn table_name((scene, depth, rays, stop_at): (Scene, u8, Rays, StopAt)) -> String {
    let query = match stop_at {
        StopAt::End => "enum",
        StopAt::FirstFull => "first",
    };
    format!("{query} {} d{depth} {}", scene.name(), rays.name())
}

/// Prints one table.
fn measure(name: &str, tree: &Tree<3>, rays: &[Ray<3>], stop_at: StopAt, wanted: &Wanted) {
    let names: Vec<String> = Row::all().into_iter().map(Row::name).collect();
    let rows: Vec<Row> =
        Row::all().into_iter().filter(|row| wanted.wants(&row.name(), &names)).collect();
    // Spread over all rays; the same ones in every round.
    let n = wanted.n_rays.min(rays.len());
    let rays: Vec<Ray<3>> = (0..n).map(|i| rays[i * rays.len() / n]).collect();

    let mut steps = Steps::default();
    let options = Options { stop_at, ..Options::default() };
    let arithmetic = Arithmetic::Doubles;
    let query = Query::Ray { algorithm: Algorithm::Parametric, options, arithmetic };
    for ray in &rays {
        query.run(tree, ray, &mut steps);
    }
    let per_ray = |count: u64| count as f64 / n as f64;
    println!(
        "\n{name}: {} leaves; a ray has {:.1} steps, {:.1} leaves, {:.1} full",
        tree.n_leaves(),
        per_ray(steps.inner + steps.leaves),
        per_ray(steps.leaves),
        per_ray(steps.full)
    );
    println!("{:<24} {:>9} {:>9} {:>9} {:>7}", "", "Mrays/s", "best", "ns/step", "ratio");

    let mut times = vec![Vec::new(); rows.len()];
    for _ in 0..wanted.n_rounds {
        let mut full = None;
        for (row, times) in rows.iter().zip(&mut times) {
            let start = Clock::start();
            let found = row.run(tree, &rays, stop_at);
            times.push(start.seconds() / n as f64);
            let expected = *full.get_or_insert(found);
            assert_eq!(found, expected, "{} finds other leaves", row.name());
        }
    }
    let mut first = None;
    for (row, mut times) in rows.iter().zip(times) {
        times.sort_by(f64::total_cmp);
        let (best, median) = (times[0], times[times.len() / 2]);
        let first = *first.get_or_insert(median);
        println!(
            "{:<24} {:>9.3} {:>9.3} {:>9.2} {:>7.2}",
            row.name(),
            1e-6 / median,
            1e-6 / best,
            median * 1e9 / per_ray(steps.inner + steps.leaves),
            first / median
        );
    }
}

/// Counts what the rays meet.
#[derive(Default)]
struct Tally {
    full: u64,
}

impl Observer<3> for Tally {
    #[inline]
    fn observe(&mut self, event: Event<3>) {
        if let Event::Leaf { full, .. } = event {
            self.full += u64::from(full);
        }
    }
}

/// Counts the nodes on the rays.
#[derive(Default)]
struct Steps {
    inner: u64,
    leaves: u64,
    full: u64,
}

impl Observer<3> for Steps {
    fn observe(&mut self, event: Event<3>) {
        match event {
            Event::Halve { .. } => self.inner += 1,
            Event::Leaf { full, .. } => {
                self.leaves += 1;
                self.full += u64::from(full);
            }
            _ => {}
        }
    }
}
