//! Cells that content occupies, as a sorted list.

use super::build::Growth;
use super::keys::path_key;
use super::overlap::{
    lies_in_ball, lies_in_box, lies_in_triangle, meets_ball, meets_box, meets_surface,
    meets_triangle,
};
use super::{BuildError, Child, Code, Fill, Merge};
use crate::geometry::Aabb;
use crate::scene::Content;
use crate::threads::in_order;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Disjoint occupied blocks in the order of the children, with their items.
#[derive(Debug, Default)]
pub(super) struct Occupied {
    /// The blocks, by ascending keys.
    pub blocks: Vec<Block>,
    /// The items of the blocks, block after block.
    items: Vec<u32>,
    /// Smallest cells in the blocks.
    n_cells: u64,
}

/// Occupied cell of any level.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block {
    /// Key of the smallest cell in the block that comes first.
    pub key: u64,
    /// Number of smallest cells in the blocks before this one.
    cells_before: u64,
    /// Index of the block's first item.
    first_item: usize,
}

impl Occupied {
    /// Cells of level 0 by their sorted keys, with item numbers; the same key
    /// may come more than once.
    pub fn cells(keys: &[(u64, u32)]) -> Self {
        let (blocks, items) = (Vec::with_capacity(keys.len()), Vec::with_capacity(keys.len()));
        let mut occupied = Self { blocks, items, n_cells: 0 };
        for &(key, item) in keys {
            if occupied.blocks.last().is_none_or(|last| last.key != key) {
                occupied.push(key, 1, &[]);
            }
            occupied.items.push(item);
        }
        occupied
    }

    /// Appends a block of `n_cells` smallest cells.
    fn push(&mut self, key: u64, n_cells: u64, items: &[u32]) {
        let (cells_before, first_item) = (self.n_cells, self.items.len());
        self.blocks.push(Block { key, cells_before, first_item });
        self.items.extend_from_slice(items);
        self.n_cells += n_cells;
    }

    /// Number of smallest cells in a range of blocks.
    pub fn n_cells(&self, range: &Range<usize>) -> u64 {
        let before = |i: usize| self.blocks.get(i).map_or(self.n_cells, |b| b.cells_before);
        before(range.end) - before(range.start)
    }

    /// Appends the items of a range of blocks to `items`: ascending, each once.
    pub fn append_items(&self, range: &Range<usize>, items: &mut Vec<u32>) {
        let before = |i: usize| self.blocks.get(i).map_or(self.items.len(), |b| b.first_item);
        match &self.items[before(range.start)..before(range.end)] {
            [item] => items.push(*item),
            several => {
                let mut several = several.to_vec();
                several.sort_unstable();
                several.dedup();
                items.extend(several);
            }
        }
    }

    /// Appends blocks that come after all these.
    fn append(&mut self, other: Self) {
        let (n_cells, n_items) = (self.n_cells, self.items.len());
        self.blocks.extend(other.blocks.into_iter().map(|block| Block {
            cells_before: n_cells + block.cells_before,
            first_item: n_items + block.first_item,
            ..block
        }));
        self.items.extend(other.items);
        self.n_cells += other.n_cells;
    }
}

/// Levels from the root down to the cells that are the units of the work.
const UNITS_BELOW: u8 = 3;

/// Blocks that the primitives of `content` occupy. Parts outside the domain
/// occupy nothing.
pub(super) fn occupied_cells<const D: usize>(
    content: &Content<D>,
    growth: &Growth<D>,
) -> Result<Occupied, BuildError> {
    let &Growth { threads, domain, progress, .. } = growth;
    let root_level = domain.root_level();
    let unit_level = root_level.saturating_sub(UNITS_BELOW);
    progress.start(cells_below::<D>(root_level - unit_level));
    let walk = Walk { content, growth, n_found: Default::default() };

    // The units, in their order, with the primitives that may meet them.
    let mut units: Vec<(Code<D>, Vec<u32>)> = vec![([0; D], (0..content.len() as u32).collect())];
    for level in (unit_level..root_level).rev() {
        let children = units.iter().flat_map(|(code, candidates)| {
            Child::<D>::all().map(move |child| (child.code_in(*code, 1 << level), candidates))
        });
        let children: Vec<_> = children.collect();
        let narrowed = in_order(threads, children.into_iter(), |(code, candidates)| {
            let inside = walk.narrowed(level, code, candidates);
            let units_left_out =
                if inside.is_empty() { cells_below::<D>(level - unit_level) } else { 0 };
            progress.advance(units_left_out).map(|()| (code, inside))
        });
        units = narrowed.into_iter().collect::<Result<_, _>>()?;
        units.retain(|(_, candidates)| !candidates.is_empty());
    }

    let parts = in_order(threads, units.into_iter(), |(code, mut candidates)| {
        let mut unit = Unit::default();
        walk.visit(unit_level, code, &mut candidates, 0, &mut unit)?;
        walk.tell(&mut unit, [0, 0])?;
        progress.advance(1)?;
        Ok::<_, BuildError>(unit.occupied)
    });
    let mut occupied = Occupied::default();
    for part in parts {
        occupied.append(part?);
    }
    progress.start(0);
    Ok(occupied)
}

/// Number of cells `levels` below one cell.
fn cells_below<const D: usize>(levels: u8) -> u64 {
    1 << (u32::from(levels) * D as u32)
}

/// Most entries in the lists of items.
const MAX_ITEMS: usize = 1 << 28;

/// Descent to the occupied cells.
struct Walk<'a, const D: usize> {
    content: &'a Content<D>,
    growth: &'a Growth<'a, D>,
    /// Number of blocks and of items that were found so far, by all threads.
    n_found: [AtomicUsize; 2],
}

/// What was found in a unit so far.
#[derive(Default)]
struct Unit {
    occupied: Occupied,
    /// Number of blocks and of items that are counted in those of all threads.
    n_told: [usize; 2],
}

impl<const D: usize> Walk<'_, D> {
    /// Those of `candidates` that meet a cell.
    fn narrowed(&self, level: u8, code: Code<D>, candidates: &[u32]) -> Vec<u32> {
        let cell = self.growth.domain.cell_box(level, code);
        candidates.iter().copied().filter(|&item| self.meets(&cell, item as usize)).collect()
    }

    /// Adds the occupied blocks of one cell. The primitives that may meet it
    /// are `candidates[from..]`; the list is left as it was.
    fn visit(
        &self,
        level: u8,
        code: Code<D>,
        candidates: &mut Vec<u32>,
        from: usize,
        unit: &mut Unit,
    ) -> Result<(), BuildError> {
        self.growth.progress.check()?;
        let cell = self.growth.domain.cell_box(level, code);
        let to = candidates.len();
        for i in from..to {
            if self.meets(&cell, candidates[i] as usize) {
                candidates.push(candidates[i]);
            }
        }
        let inside = &candidates[to..];
        let whole = || inside.iter().any(|&item| self.covers(item as usize, &cell));
        if inside.is_empty() {
            return Ok(());
        }
        if level == 0 || self.growth.recipe.merge == Merge::Whole && whole() {
            unit.occupied.push(path_key(code), cells_below::<D>(level), inside);
            self.tell(unit, [1024, 1 << 16])?;
        } else {
            for child in Child::<D>::all() {
                let code = child.code_in(code, 1 << (level - 1));
                self.visit(level - 1, code, candidates, to, unit)?;
            }
        }
        candidates.truncate(to);
        Ok(())
    }

    /// Counts what was found in a unit, once it is so much, and refuses too much.
    fn tell(&self, unit: &mut Unit, so_much: [usize; 2]) -> Result<(), BuildError> {
        let n = [unit.occupied.blocks.len(), unit.occupied.items.len()];
        let new = [n[0] - unit.n_told[0], n[1] - unit.n_told[1]];
        if new[0] < so_much[0] && new[1] < so_much[1] {
            return Ok(());
        }
        unit.n_told = n;
        let [n_blocks, n_items] =
            [0, 1].map(|k| self.n_found[k].fetch_add(new[k], Ordering::Relaxed) + new[k]);
        let is_too_much = n_blocks > self.growth.max_nodes || n_items > MAX_ITEMS;
        if is_too_much { Err(BuildError::TooManyNodes) } else { Ok(()) }
    }

    fn meets(&self, cell: &Aabb<D>, item: usize) -> bool {
        match (self.content, self.growth.recipe.fill) {
            (Content::Spheres(spheres), Fill::Surface) => meets_surface(cell, &spheres[item]),
            (Content::Spheres(spheres), Fill::Solid) => meets_ball(cell, &spheres[item]),
            (Content::Boxes(boxes), _) => meets_box(cell, &boxes[item]),
            (Content::Triangles(triangles), _) => meets_triangle(cell, &triangles[item]),
            (Content::Points(_) | Content::Cells(_) | Content::Image(_), _) => false,
        }
    }

    fn covers(&self, item: usize, cell: &Aabb<D>) -> bool {
        match (self.content, self.growth.recipe.fill) {
            (Content::Spheres(_), Fill::Surface) => false,
            (Content::Spheres(spheres), Fill::Solid) => lies_in_ball(cell, &spheres[item]),
            (Content::Boxes(boxes), _) => lies_in_box(cell, &boxes[item]),
            (Content::Triangles(triangles), _) => lies_in_triangle(cell, &triangles[item]),
            (Content::Points(_) | Content::Cells(_) | Content::Image(_), _) => false,
        }
    }
}
