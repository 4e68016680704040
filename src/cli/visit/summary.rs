//! What an algorithm finds on all rays, and how long that takes.

use super::Asked;
use super::in_order::in_order;
use super::line::{Met, met, push_line};
use octoscope_core::geometry::Ray;
use octoscope_core::measure::{FNV_BASIS, Tally, fnv_1a};
use octoscope_core::threads::in_parts;
use octoscope_core::traverse::Method;
use octoscope_core::tree::Tree;
use std::hint::black_box;
use std::io;
use std::num::NonZeroUsize;
use std::time::{Duration, Instant};

/// Row of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// What has found the leaves.
    name: String,
    n_rays: usize,
    /// How many were found.
    pub tally: Tally,
    /// FNV-1a, 64 bits, of the lines that would be printed.
    pub checksum: u64,
    /// Times of the runs, the shortest first.
    pub times: Vec<Duration>,
}

impl Summary {
    /// Before anything was found.
    pub fn new(name: String, n_rays: usize) -> Self {
        let (tally, times) = (Tally::default(), Vec::new());
        Self { name, n_rays, tally, checksum: FNV_BASIS, times }
    }

    /// Adds the lines of the next rays, with the number of leaves that they tell.
    pub fn add(&mut self, (lines, tally): (String, Tally)) {
        self.checksum = fnv_1a(self.checksum, lines.as_bytes());
        self.tally.leaves += tally.leaves;
        self.tally.occupied += tally.occupied;
    }
}

/// Runs `method` over all rays: once for the lines, then `repeat` times for
/// the time of the traversals alone.
///
/// # Errors
/// None of its own; that of [`in_order`] is passed on.
pub fn measure<const D: usize>(
    tree: &Tree<D>,
    rays: &[Ray<D>],
    method: Method,
    asked: Asked,
    threads: NonZeroUsize,
    repeat: NonZeroUsize,
) -> io::Result<Summary> {
    let mut summary = Summary::new(method.to_string(), rays.len());
    let work = |rays: &[Ray<D>]| {
        let (mut lines, mut sum) = (String::new(), Tally::default());
        for ray in rays {
            let met = met(tree, ray, method, asked);
            push_line(&mut lines, tree, &met);
            tally(&mut sum, &met);
        }
        (lines, sum)
    };
    in_order(rays, threads, work, |block| {
        summary.add(block);
        Ok(())
    })?;
    let query = asked.along(method);
    summary.times = times(rays, threads, repeat, |rays| {
        let mut tally = Tally::default();
        for ray in rays {
            black_box(query.run(tree, ray, &mut tally));
        }
        black_box(tally);
    });
    Ok(summary)
}

/// The rows as a table with a head, in columns.
pub fn table(rows: &[Summary]) -> String {
    let head = [
        "algorithm",
        "rays",
        "leaves",
        "occupied",
        "checksum",
        "rays/s-median",
        "rays/s-best",
        "ns/leaf-median",
        "ns/leaf-best",
    ]
    .map(str::to_owned);
    let cells: Vec<[String; 9]> = std::iter::once(head).chain(rows.iter().map(row)).collect();
    let mut table = String::new();
    for line in &cells {
        let padded = line.iter().enumerate().map(|(column, cell)| {
            let width = cells.iter().map(|line| line[column].len()).max().unwrap_or(0);
            if column == 0 { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
        });
        table.push_str(&padded.collect::<Vec<_>>().join("  "));
        table.push('\n');
    }
    table
}

fn row(summary: &Summary) -> [String; 9] {
    let Summary { name, n_rays, tally, checksum, times } = summary;
    let best = times.first().copied().unwrap_or_default();
    let median = times.get(times.len() / 2).copied().unwrap_or_default();
    let rate = |time: Duration| quotient(*n_rays as f64, time.as_secs_f64(), 0);
    let per_leaf = |time: Duration| quotient(time.as_secs_f64() * 1e9, tally.leaves as f64, 2);
    [
        name.clone(),
        n_rays.to_string(),
        tally.leaves.to_string(),
        tally.occupied.to_string(),
        format!("{checksum:016x}"),
        rate(median),
        rate(best),
        per_leaf(median),
        per_leaf(best),
    ]
}

/// `a / b` with so many decimals, or `-` if there is none.
fn quotient(a: f64, b: f64, decimals: usize) -> String {
    if a > 0.0 && b > 0.0 { format!("{:.decimals$}", a / b) } else { "-".to_owned() }
}

/// Times of so many runs over all rays, which are divided among the threads; the
/// shortest first.
pub fn times<const D: usize>(
    rays: &[Ray<D>],
    threads: NonZeroUsize,
    repeat: NonZeroUsize,
    run: impl Fn(&[Ray<D>]) + Sync,
) -> Vec<Duration> {
    let time = || {
        let start = Instant::now();
        in_parts(threads, rays, &run);
        start.elapsed()
    };
    let mut times: Vec<Duration> = (0..repeat.get()).map(|_| time()).collect();
    times.sort_unstable();
    times
}

/// Counts the visited ones of these leaves.
pub fn tally(tally: &mut Tally, met: &[Met]) {
    for met in met {
        let occupied = match met {
            Met::Empty(_) => 0,
            Met::Full(_) => 1,
            Met::Touch(_) => continue,
        };
        tally.leaves += 1;
        tally.occupied += occupied;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_shows_median_and_best() {
        let summary = Summary {
            name: "codes".to_owned(),
            n_rays: 10,
            tally: Tally { leaves: 20, occupied: 5 },
            checksum: 0xff,
            times: [1, 2, 4].map(Duration::from_micros).to_vec(),
        };
        let table = table(&[summary]);
        let cells: Vec<&str> = table.lines().nth(1).unwrap().split_whitespace().collect();
        let expected = "codes 10 20 5 00000000000000ff 5000000 10000000 100.00 50.00";
        assert_eq!(cells.join(" "), expected);
    }

    #[test]
    fn nothing_is_divided_by_nothing() {
        assert_eq!(quotient(0.0, 0.0, 2), "-");
        assert_eq!(quotient(1.0, 0.0, 2), "-");
    }
}
