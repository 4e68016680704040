//! Cells that content occupies, as a sorted list.

use super::overlap::{
    lies_in_ball, lies_in_box, lies_in_triangle, meets_ball, meets_box, meets_surface,
    meets_triangle,
};
use super::recipe::path_key;
use super::{BuildError, Cell, Child, Code, Domain, Fill, MAX_NODES, Merge, Recipe};
use crate::geometry::Aabb;
use crate::progress::Progress;
use crate::scene::Content;
use std::ops::Range;

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
        let mut occupied = Self::default();
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

    /// Items of a range of blocks, ascending, each once.
    pub fn items(&self, range: &Range<usize>) -> Vec<u32> {
        let before = |i: usize| self.blocks.get(i).map_or(self.items.len(), |b| b.first_item);
        let mut items = self.items[before(range.start)..before(range.end)].to_vec();
        items.sort_unstable();
        items.dedup();
        items
    }
}

/// Blocks that the primitives of `content` occupy. Parts outside the domain
/// occupy nothing.
pub(super) fn occupied_cells<const D: usize>(
    content: &Content<D>,
    domain: &Domain<D>,
    recipe: &Recipe,
    progress: &Progress,
) -> Result<Occupied, BuildError> {
    let unit_level = domain.root_level().saturating_sub(3);
    progress.start(cells_below::<D>(domain.root_level() - unit_level));
    let occupied = Occupied::default();
    let mut walk = Walk { content, domain, recipe, progress, unit_level, occupied };
    let mut candidates: Vec<u32> = (0..content.len() as u32).collect();
    walk.visit(domain.root_level(), [0; D], &mut candidates, 0)?;
    progress.start(0);
    Ok(walk.occupied)
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
    domain: &'a Domain<D>,
    recipe: &'a Recipe,
    progress: &'a Progress,
    /// Level whose cells are the units of the progress.
    unit_level: u8,
    occupied: Occupied,
}

impl<const D: usize> Walk<'_, D> {
    /// Adds the occupied blocks of one cell. The primitives that may meet it
    /// are `candidates[from..]`; the list is left as it was.
    fn visit(
        &mut self,
        level: u8,
        code: Code<D>,
        candidates: &mut Vec<u32>,
        from: usize,
    ) -> Result<(), BuildError> {
        let cell = self.domain.cell_box(level, code);
        let to = candidates.len();
        for i in from..to {
            if self.meets(&cell, candidates[i] as usize) {
                candidates.push(candidates[i]);
            }
        }
        let inside = &candidates[to..];
        let whole = || inside.iter().any(|&item| self.covers(item as usize, &cell));
        if inside.is_empty() {
            self.done(level)?;
        } else if level == 0 || self.recipe.merge == Merge::Whole && whole() {
            self.occupied.push(path_key(code), cells_below::<D>(level), inside);
            if self.occupied.blocks.len() > MAX_NODES || self.occupied.items.len() > MAX_ITEMS {
                return Err(BuildError::TooManyNodes);
            }
            self.done(level)?;
        } else {
            let cell = Cell { domain: self.domain, level, code };
            for child in Child::all() {
                self.visit(level - 1, cell.child_code(child), candidates, to)?;
            }
            if level == self.unit_level {
                self.done(level)?;
            }
        }
        candidates.truncate(to);
        Ok(())
    }

    fn done(&self, level: u8) -> Result<(), BuildError> {
        let units = level.checked_sub(self.unit_level).map_or(0, cells_below::<D>);
        Ok(self.progress.advance(units)?)
    }

    fn meets(&self, cell: &Aabb<D>, item: usize) -> bool {
        match (self.content, self.recipe.fill) {
            (Content::Spheres(spheres), Fill::Surface) => meets_surface(cell, &spheres[item]),
            (Content::Spheres(spheres), Fill::Solid) => meets_ball(cell, &spheres[item]),
            (Content::Boxes(boxes), _) => meets_box(cell, &boxes[item]),
            (Content::Triangles(triangles), _) => meets_triangle(cell, &triangles[item]),
            (Content::Points(_) | Content::Cells(_) | Content::Image(_), _) => false,
        }
    }

    fn covers(&self, item: usize, cell: &Aabb<D>) -> bool {
        match (self.content, self.recipe.fill) {
            (Content::Spheres(_), Fill::Surface) => false,
            (Content::Spheres(spheres), Fill::Solid) => lies_in_ball(cell, &spheres[item]),
            (Content::Boxes(boxes), _) => lies_in_box(cell, &boxes[item]),
            (Content::Triangles(triangles), _) => lies_in_triangle(cell, &triangles[item]),
            (Content::Points(_) | Content::Cells(_) | Content::Image(_), _) => false,
        }
    }
}
