//! Many rays at once.

use super::in_order::in_order;
use super::line::{Met, push_line};
use super::summary::{Summary, tally, times};
use octoscope_core::geometry::Ray;
use octoscope_core::measure::Tally;
use octoscope_core::traverse::{Kernel, Leaf, StopAt, visit_many};
use octoscope_core::tree::Tree;
use std::hint::black_box;
use std::io;
use std::num::NonZeroUsize;

/// Name of the kernel, where others have that of their algorithm.
pub const BATCH: &str = "batch";

/// Hands the lines of all rays to `take`, in order and in blocks, with the number of
/// leaves that they tell.
///
/// # Errors
/// Stops at the first error of `take`.
pub fn lines<const D: usize>(
    tree: &Tree<D>,
    rays: &[Ray<D>],
    stop_at: StopAt,
    threads: NonZeroUsize,
    take: impl FnMut((String, Tally)) -> io::Result<()>,
) -> io::Result<()> {
    let work = |rays: &[Ray<D>]| {
        // Rays end in any order.
        let mut found = vec![Vec::new(); rays.len()];
        visit_many(tree, rays, stop_at, Kernel::Vector, |index, leaves| {
            found[index] = leaves.iter().map(|&leaf| met(leaf)).collect();
        });
        let (mut lines, mut sum) = (String::new(), Tally::default());
        for met in found {
            push_line(&mut lines, tree, &met);
            tally(&mut sum, &met);
        }
        (lines, sum)
    };
    in_order(rays, threads, work, take)
}

fn met(leaf: Leaf) -> Met {
    if leaf.is_full() { Met::Full(leaf.node()) } else { Met::Empty(leaf.node()) }
}

/// Visits all rays once for the lines, then `repeat` times for the time of the kernel
/// alone.
///
/// # Errors
/// None of its own.
pub fn measure<const D: usize>(
    tree: &Tree<D>,
    rays: &[Ray<D>],
    stop_at: StopAt,
    threads: NonZeroUsize,
    repeat: NonZeroUsize,
) -> io::Result<Summary> {
    let mut summary = Summary::new(BATCH.to_owned(), rays.len());
    lines(tree, rays, stop_at, threads, |block| {
        summary.add(block);
        Ok(())
    })?;
    summary.times = times(rays, threads, repeat, |rays| {
        let mut tally = Tally::default();
        visit_many(tree, rays, stop_at, Kernel::Vector, |_, leaves| {
            tally.leaves += leaves.len() as u64;
            tally.occupied += leaves.iter().map(|leaf| u64::from(leaf.is_full())).sum::<u64>();
        });
        black_box(tally);
    });
    Ok(summary)
}
