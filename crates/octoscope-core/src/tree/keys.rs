//! Points and cells as keys: where they lie in the order of the children.

use super::{Child, Code, Domain, morton};
use crate::scene::Content;
use crate::threads::in_order;
use std::num::NonZeroUsize;
use std::ops::Range;

/// Points or cells outside a domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outside {
    /// How many.
    pub count: usize,
    /// Number of the first, from 0.
    pub first: usize,
}

/// The points or cells of `content` that lie outside `domain`, if there are any. Other
/// content may stick out.
pub fn outside<const D: usize>(content: &Content<D>, domain: &Domain<D>) -> Option<Outside> {
    match content {
        Content::Points(points) => {
            those_outside(points, |&point| domain.encode_point(point).is_some())
        }
        Content::Cells(cells) => those_outside(cells, |cell| is_inside(cell, domain)),
        Content::Image(_) | Content::Spheres(_) | Content::Boxes(_) | Content::Triangles(_) => None,
    }
}

/// Those of the items that are not inside, if there are any.
fn those_outside<T>(items: &[T], is_inside: impl Fn(&T) -> bool) -> Option<Outside> {
    let mut outside = (0..items.len()).filter(|&number| !is_inside(&items[number]));
    let first = outside.next()?;
    Some(Outside { count: 1 + outside.count(), first })
}

fn is_inside<const D: usize>(cell: &Code<D>, domain: &Domain<D>) -> bool {
    cell.iter().all(|&c| c < domain.grid_size())
}

/// A key and the number of its item.
pub(super) type Key = (u64, u32);

/// Keys of points, in the order of the points.
pub(super) fn keys_of_points<const D: usize>(
    threads: NonZeroUsize,
    points: &[[f64; D]],
    domain: &Domain<D>,
) -> Result<Vec<Key>, Outside> {
    keys_of(threads, points, |&point| domain.encode_point(point))
}

/// Keys of cells, in the order of the cells.
pub(super) fn keys_of_cells<const D: usize>(
    threads: NonZeroUsize,
    cells: &[Code<D>],
    domain: &Domain<D>,
) -> Result<Vec<Key>, Outside> {
    keys_of(threads, cells, |cell| is_inside(cell, domain).then_some(*cell))
}

fn keys_of<const D: usize, T: Sync>(
    threads: NonZeroUsize,
    items: &[T],
    code: impl Fn(&T) -> Option<Code<D>> + Sync,
) -> Result<Vec<Key>, Outside> {
    /// Items whose keys a thread finds at once.
    const BLOCK: usize = 1 << 14;
    let mut keys = vec![(0, 0); items.len()];
    let blocks = items.chunks(BLOCK).zip(keys.chunks_mut(BLOCK)).enumerate();
    let outside = in_order(threads, blocks, |(block, (items, keys))| {
        let mut outside = Vec::new();
        for (number, (item, key)) in (block * BLOCK..).zip(items.iter().zip(keys)) {
            match code(item) {
                Some(code) => *key = (path_key(code), number as u32),
                None => outside.push(number),
            }
        }
        outside
    });
    let outside = outside.concat();
    match outside.first() {
        Some(&first) => Err(Outside { count: outside.len(), first }),
        None => Ok(keys),
    }
}

/// Place of a smallest cell in the order of the children: D bits a level, in
/// the numbering of [`Child`].
pub(super) fn path_key<const D: usize>(mut code: Code<D>) -> u64 {
    code.reverse();
    morton(code)
}

/// Ranges of the children of a cell of `level` within its own `range` of
/// sorted items.
pub(super) fn child_ranges<const D: usize>(
    level: u8,
    range: Range<usize>,
    key: impl Fn(usize) -> u64,
) -> impl Iterator<Item = Range<usize>> {
    let shift = u32::from(level - 1) * D as u32;
    let child_of = move |item| key(item) >> shift & ((1 << D) - 1);
    let mut from = range.start;
    Child::<D>::all().map(move |child| {
        let to = partition_point(from..range.end, |item| child_of(item) <= u64::from(child.0));
        std::mem::replace(&mut from, to)..to
    })
}

/// First of `range` for which `before` is false; it is true up to there.
fn partition_point(range: Range<usize>, before: impl Fn(usize) -> bool) -> usize {
    let (mut from, mut to) = (range.start, range.end);
    // In most nodes there is little to look at.
    if range.len() <= 8 {
        return range.into_iter().find(|&item| !before(item)).unwrap_or(to);
    }
    while from < to {
        let middle = from + (to - from) / 2;
        if before(middle) { from = middle + 1 } else { to = middle }
    }
    from
}
