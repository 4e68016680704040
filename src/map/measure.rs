//! What becomes of the rays of a map, as numbers.

use super::asked::{Asked, Colouring};
use crate::counted::{Counted, counted};
use octoscope_core::geometry::Ray;
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::query::Query;
use octoscope_core::traverse::{
    Kernel, Leaf, Options, Slivers, StopAt, first_difference_of_run, visit_many,
};
use octoscope_core::tree::NodeId;

/// Value of a ray that visits nothing, and should not.
pub const NOTHING: u32 = 0;
/// Value of a ray that visits the leaves that it should, in [`Colouring::Differences`].
pub const RIGHT: u32 = 1;
/// Value of one that visits others.
pub const WRONG: u32 = 2;
/// The run was given up before it came to an end, and is right so far.
pub const UNKNOWN: u32 = 3;

/// The options of a search along the ray.
fn options_of<const D: usize>(query: &Query<D>) -> Options {
    match query {
        Query::Ray { options, .. } => *options,
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => Options::default(),
    }
}

/// The values of all cells in some rows, from left to right, row after row.
///
/// # Errors
/// Stops with [`Cancelled`] when `progress` is cancelled.
pub fn rows<const D: usize>(
    asked: &Asked<D>,
    rows: std::ops::Range<usize>,
    progress: &Progress,
) -> Result<Vec<u32>, Cancelled> {
    let width = asked.size[0];
    let mut values = vec![NOTHING; width * rows.len()];
    let places = rows.flat_map(|row| (0..width).map(move |column| (column, row)));
    let of_place = |(index, (column, row))| Some((index, asked.ray_of(column, row)?));
    let (indices, rays): (Vec<usize>, Vec<Ray<D>>) =
        places.enumerate().filter_map(of_place).unzip();
    let mut set = |index: usize, value: u32| values[indices[index]] = value;
    let tree = &*asked.tree;
    let stop_at = options_of(&asked.query).stop_at;
    match asked.colouring {
        Colouring::Sequence => {
            visit_many(tree, &rays, stop_at, Kernel::Vector, |ray, leaves| {
                set(ray, name_of(leaves));
            });
        }
        Colouring::Leaves => {
            visit_many(tree, &rays, stop_at, Kernel::Vector, |ray, leaves| {
                set(ray, clamped(leaves.len()));
            });
        }
        Colouring::Steps | Colouring::Comparisons => {
            let is_steps = asked.colouring == Colouring::Steps;
            for (index, ray) in rays.iter().enumerate() {
                let counted = counted(tree, ray, &asked.query, progress)?;
                let comparisons = counted.counters.comparisons() as usize;
                set(index, clamped(if is_steps { counted.n_steps } else { comparisons }));
            }
        }
        Colouring::Differences => {
            visit_many(tree, &rays, StopAt::End, Kernel::Vector, |index, leaves| {
                // What is cancelled is thrown away below.
                set(index, verdict(asked, &rays[index], leaves, progress).unwrap_or(NOTHING));
            });
        }
    }
    progress.check()?;
    Ok(values)
}

/// Whether the search visits the leaves that it should.
fn verdict<const D: usize>(
    asked: &Asked<D>,
    ray: &Ray<D>,
    expected: &[Leaf],
    progress: &Progress,
) -> Result<u32, Cancelled> {
    let Counted { leaves: found, is_cut, .. } = counted(&asked.tree, ray, &asked.query, progress)?;
    let expected: Vec<NodeId> = expected.iter().map(|leaf| leaf.node()).collect();
    if is_cut && expected.starts_with(&found) {
        return Ok(UNKNOWN);
    }
    if found.is_empty() && expected.is_empty() {
        return Ok(NOTHING);
    }
    let options = options_of(&asked.query);
    let slivers = Slivers::Ignore;
    let difference = first_difference_of_run(&asked.tree, ray, options, &expected, &found, slivers);
    Ok(if difference.is_none() { RIGHT } else { WRONG })
}

/// A number that is the same for the same leaves in the same order, and nearly always
/// another one for others [FNV-1a].
fn name_of(leaves: &[Leaf]) -> u32 {
    if leaves.is_empty() {
        return NOTHING;
    }
    let mix = |hash: u32, leaf: &Leaf| (hash ^ leaf.node().0).wrapping_mul(0x0100_0193);
    leaves.iter().fold(0x811c_9dc5, mix).max(1)
}

fn clamped(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}
