//! Building a tree from content.
//!
//! Everything but a picture is first turned into a list of cells, sorted along
//! the order of the children from the root to the leaves, by digits of their Morton
//! codes. Then every node owns a range of the list and finds those of its children by
//! bisection. O(n · depth) for n points or cells; no copy of the content is made. All
//! processors share the work, and the tree is the same for any number of them.

use super::grow::{Fate, grow_on};
use super::occupied::{Occupied, occupied_cells};
use super::sort::sort_by_key;
use super::threads::{all_threads, in_order};
use super::{Cell, Child, Code, Domain, DomainError, Tree, morton};
use crate::progress::{Cancelled, Progress};
use crate::scene::{Content, Image, pixels_of};
use serde::{Deserialize, Serialize};
use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use thiserror::Error;

/// Most nodes that a tree may have.
pub const MAX_NODES: usize = 1 << 26;

/// How a tree is built. Each kind of content uses what concerns it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Recipe {
    /// Levels below the root, 0 … 20: a smallest cell has 2^-depth of its side.
    pub depth: u8,
    /// Most points in a leaf above level 0, at least 1.
    pub capacity: u32,
    /// Whether wholly full nodes are leaves.
    pub merge: Merge,
    /// Largest difference in a channel between two pixels of a leaf above
    /// level 0.
    pub threshold: u8,
    /// What of circles and spheres is occupied.
    pub fill: Fill,
}

impl Default for Recipe {
    fn default() -> Self {
        Self { depth: 6, capacity: 4, merge: Merge::Whole, threshold: 24, fill: Fill::Surface }
    }
}

/// Whether wholly full nodes are leaves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Merge {
    /// A node is a leaf when it is wholly full or wholly empty.
    #[default]
    Whole,
    /// Every occupied cell stays a leaf of level 0.
    Kept,
}

/// What of circles and spheres is occupied.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Fill {
    /// The cells whose closed box meets the surface.
    #[default]
    Surface,
    /// The cells whose closed box meets the surface or the inside.
    Solid,
}

/// Why no tree could be built.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum BuildError {
    /// The domain and the depth do not go together.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The domain is cut into another number of levels than the recipe says.
    #[error("the domain has {domain} levels and the recipe {recipe}; give both the same depth")]
    DepthsDiffer {
        /// Levels of the domain.
        domain: u8,
        /// Depth of the recipe.
        recipe: u8,
    },
    /// A bucket that holds nothing.
    #[error("the capacity is 0; a leaf must be allowed to hold at least one point")]
    NoCapacity,
    /// Points or cells outside.
    #[error(
        "{count} of the items lie outside the domain, the first of them is number {first} \
         (counted from 0); enlarge or move the domain, or leave them out"
    )]
    Outside {
        /// How many.
        count: usize,
        /// Number of the first.
        first: usize,
    },
    /// A coordinate that is not finite, a negative radius or a box turned
    /// inside out.
    #[error(
        "item number {0} (counted from 0) has a coordinate that is not finite, \
         a negative size or corners in the wrong order; mend it or leave it out"
    )]
    Unusable(usize),
    /// The pixels of a picture are not width × height.
    #[error("the picture should have {expected} pixels and has {found}")]
    PixelCount {
        /// Width × height.
        expected: u64,
        /// Number of pixels given.
        found: usize,
    },
    /// A picture in space.
    #[error("a picture lies in the plane; give the scene two dimensions")]
    ImageInSpace,
    /// More nodes than [`MAX_NODES`].
    #[error("the tree would have more than {MAX_NODES} nodes; use a smaller depth")]
    TooManyNodes,
    /// Nobody wants the tree any more.
    #[error("building the tree was cancelled")]
    Cancelled,
}

impl From<Cancelled> for BuildError {
    fn from(_: Cancelled) -> Self {
        Self::Cancelled
    }
}

/// Tree over `domain`, built from `content` by `recipe`; the items of a leaf
/// are numbers into the content, ascending.
///
/// Points: a node is a leaf if it holds at most `capacity` points or has level
/// 0, where duplicates stay together. Cells and solids: a node is a leaf if it
/// is wholly empty or, with [`Merge::Whole`], wholly full. A picture lies in
/// the lower left corner of the smallest fitting grid of 2^k × 2^k pixels; a
/// node is a leaf if it is beside the picture (empty) or if it is inside and
/// its pixels differ by at most `threshold` (full, without items).
///
/// # Errors
/// See [`BuildError`].
pub fn build<const D: usize>(
    content: &Content<D>,
    domain: Domain<D>,
    recipe: &Recipe,
    progress: &Progress,
) -> Result<Tree<D>, BuildError> {
    build_on(all_threads(), content, domain, recipe, progress)
}

/// The same as [`build`], by so many threads; the tree is the same for any number.
///
/// # Errors
/// See [`BuildError`].
pub fn build_on<const D: usize>(
    threads: NonZeroUsize,
    content: &Content<D>,
    domain: Domain<D>,
    recipe: &Recipe,
    progress: &Progress,
) -> Result<Tree<D>, BuildError> {
    if domain.root_level() != recipe.depth {
        let (domain, recipe) = (domain.root_level(), recipe.depth);
        return Err(BuildError::DepthsDiffer { domain, recipe });
    }
    if recipe.capacity == 0 {
        return Err(BuildError::NoCapacity);
    }
    if let Some(item) = content.first_unusable() {
        return Err(BuildError::Unusable(item));
    }
    progress.start(0);
    let growth = Growth { threads, domain, recipe, progress };
    match content {
        Content::Points(points) => {
            let keys = sorted_keys(threads, points, |&point| domain.encode_point(point))?;
            bucket_tree(&keys, &growth)
        }
        Content::Cells(cells) => {
            let is_inside = |cell: &Code<D>| cell.iter().all(|&c| c < domain.grid_size());
            let keys = sorted_keys(threads, cells, |cell| is_inside(cell).then_some(*cell))?;
            region_tree(&Occupied::cells(&keys), &growth)
        }
        Content::Image(image) => image_tree(image, &growth),
        Content::Spheres(_) | Content::Boxes(_) | Content::Triangles(_) => {
            let occupied = occupied_cells(threads, content, &domain, recipe, progress)?;
            region_tree(&occupied, &growth)
        }
    }
}

/// Place of a smallest cell in the order of the children: D bits a level, in
/// the numbering of [`Child`].
pub(super) fn path_key<const D: usize>(mut code: Code<D>) -> u64 {
    code.reverse();
    morton(code)
}

/// Keys with item numbers, ascending.
fn sorted_keys<const D: usize, T: Sync>(
    threads: NonZeroUsize,
    items: &[T],
    code: impl Fn(&T) -> Option<Code<D>> + Sync,
) -> Result<Vec<(u64, u32)>, BuildError> {
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
    if let Some(&first) = outside.first() {
        return Err(BuildError::Outside { count: outside.len(), first });
    }
    sort_by_key(threads, &mut keys);
    Ok(keys)
}

/// Where and how a tree grows.
struct Growth<'a, const D: usize> {
    threads: NonZeroUsize,
    domain: Domain<D>,
    recipe: &'a Recipe,
    progress: &'a Progress,
}

impl<const D: usize> Growth<'_, D> {
    /// Grows a tree by [`grow_on`] and refuses one with too many nodes.
    fn tree<C, K: Clone + Send + Sync, I: IntoIterator<Item = C>>(
        &self,
        contents: C,
        divide: impl Fn(u8, K) -> I + Sync,
        judge: impl Fn(Cell<D>, C, &mut Vec<u32>) -> Fate<K> + Sync,
    ) -> Result<Tree<D>, BuildError> {
        let n_inner = AtomicUsize::new(0);
        grow_on(self.threads, self.domain, contents, divide, judge, |n_found| {
            self.progress.advance(n_found as u64)?;
            let n_inner = n_inner.fetch_add(n_found, Ordering::Relaxed) + n_found;
            let n_nodes = 1 + n_inner * Child::<D>::COUNT;
            if n_nodes > MAX_NODES { Err(BuildError::TooManyNodes) } else { Ok(()) }
        })
    }
}

/// Ranges of the children of a cell of `level` within its own `range` of
/// sorted items.
fn child_ranges<const D: usize>(
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

/// PR tree of points given by their sorted keys [Samet 1990, §2.6].
fn bucket_tree<const D: usize>(
    keys: &[(u64, u32)],
    growth: &Growth<D>,
) -> Result<Tree<D>, BuildError> {
    let capacity = growth.recipe.capacity as usize;
    let divide = |level, range| child_ranges::<D>(level, range, |i| keys[i].0);
    growth.tree(0..keys.len(), divide, |cell, range: Range<usize>, items| {
        if range.is_empty() {
            Fate::Empty
        } else if range.len() <= capacity || cell.level == 0 {
            let n_before = items.len();
            items.extend(keys[range].iter().map(|&(_, item)| item));
            items[n_before..].sort_unstable();
            Fate::Full
        } else {
            Fate::Inner(range)
        }
    })
}

/// Region tree of occupied cells.
fn region_tree<const D: usize>(
    occupied: &Occupied,
    growth: &Growth<D>,
) -> Result<Tree<D>, BuildError> {
    let blocks = &occupied.blocks;
    let divide = |level, range| child_ranges::<D>(level, range, |i| blocks[i].key);
    growth.tree(0..blocks.len(), divide, |cell, range: Range<usize>, items| {
        let whole = 1 << (u32::from(cell.level) * D as u32);
        let is_leaf = || match growth.recipe.merge {
            Merge::Whole => occupied.n_cells(&range) == whole,
            Merge::Kept => cell.level == 0,
        };
        if range.is_empty() {
            Fate::Empty
        } else if is_leaf() {
            occupied.append_items(&range, items);
            Fate::Full
        } else {
            Fate::Inner(range)
        }
    })
}

/// Region quadtree of a picture.
fn image_tree<const D: usize>(image: &Image, growth: &Growth<D>) -> Result<Tree<D>, BuildError> {
    if D != 2 {
        return Err(BuildError::ImageInSpace);
    }
    let expected = u64::from(image.width) * u64::from(image.height);
    if expected != image.pixels.len() as u64 {
        return Err(BuildError::PixelCount { expected, found: image.pixels.len() });
    }
    let (root_level, threshold) = (growth.domain.root_level(), growth.recipe.threshold);
    // Side of the root in pixels, or of a pixel in cells.
    let pixels_a_side = 1u64 << image.grid_level();
    let divide = |_, ()| std::iter::repeat_n((), Child::<D>::COUNT);
    growth.tree((), divide, |cell, (), _| {
        let code = [cell.code[0], cell.code[1]];
        let [columns, rows] = pixels_of(image, root_level, cell.level, code);
        let side = (pixels_a_side << cell.level >> root_level).max(1);
        let inside = columns.len() as u64 == side && rows.len() as u64 == side;
        if columns.is_empty() || rows.is_empty() {
            Fate::Empty
        } else if cell.level == 0 || inside && is_even(image, columns, rows, threshold) {
            Fate::Full
        } else {
            Fate::Inner(())
        }
    })
}

/// Whether no channel differs by more than `threshold` between two pixels.
fn is_even(image: &Image, columns: Range<u32>, rows: Range<u32>, threshold: u8) -> bool {
    let (mut low, mut high) = ([u8::MAX; 3], [0; 3]);
    for row in rows {
        for column in columns.clone() {
            let pixel = image.pixel_from_below(column, row);
            for channel in 0..3 {
                low[channel] = low[channel].min(pixel[channel]);
                high[channel] = high[channel].max(pixel[channel]);
                if high[channel] - low[channel] > threshold {
                    return false;
                }
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::made;

    fn tree<const D: usize>(content: &Content<D>, recipe: Recipe) -> Tree<D> {
        build(content, Domain::unit(recipe.depth), &recipe, &Progress::default()).unwrap()
    }

    #[test]
    fn every_point_lies_in_its_leaf_and_no_leaf_overflows() {
        let content = made::clustered_points::<3>(1, 3000);
        let Content::Points(points) = &content else { panic!("points") };
        let recipe = Recipe { depth: 6, capacity: 3, ..Recipe::default() };
        let tree = tree(&content, recipe);
        let mut found = 0;
        for leaf in tree.leaves() {
            let items = tree.items(leaf.id);
            assert_eq!(leaf.is_full(), !items.is_empty());
            assert!(items.len() <= 3 || tree.level(leaf.id) == 0);
            assert!(items.iter().all(|&i| tree.node_box(leaf.id).owns(points[i as usize])));
            found += items.len();
        }
        assert_eq!(found, 3000);
    }

    #[test]
    fn duplicates_stay_together_at_level_0() {
        let recipe = Recipe { depth: 3, capacity: 1, ..Recipe::default() };
        let tree = tree(&Content::Points(vec![[0.3, 0.3]; 5]), recipe);
        let full: Vec<_> = tree.leaves().filter(|leaf| leaf.is_full()).collect();
        assert_eq!(full.len(), 1);
        assert_eq!(tree.level(full[0].id), 0);
        assert_eq!(tree.items(full[0].id), [0, 1, 2, 3, 4]);
    }

    #[test]
    fn points_outside_are_counted_and_the_first_is_named() {
        let content = Content::Points(vec![[0.5, 0.5], [1.0, 0.5], [0.0, -0.1]]);
        let recipe = Recipe::default();
        let tree = build(&content, Domain::unit(6), &recipe, &Progress::default());
        assert_eq!(tree, Err(BuildError::Outside { count: 2, first: 1 }));
    }

    #[test]
    fn four_full_siblings_are_one_leaf_unless_kept() {
        let content = Content::Cells(vec![[0, 0], [0, 1], [1, 0], [1, 1], [1, 1], [2, 0]]);
        let whole = Recipe { depth: 2, ..Recipe::default() };
        let full = |recipe| {
            let tree = tree(&content, recipe);
            let full = tree.leaves().filter(|leaf| leaf.is_full());
            full.map(|leaf| (tree.level(leaf.id), tree.items(leaf.id).to_vec())).collect::<Vec<_>>()
        };
        assert_eq!(full(whole), [(1, vec![0, 1, 2, 3, 4]), (0, vec![5])]);
        let kept = full(Recipe { merge: Merge::Kept, ..whole });
        assert_eq!(kept.iter().map(|(level, _)| *level).collect::<Vec<_>>(), [0; 5]);
    }

    #[test]
    fn a_picture_is_cut_where_it_is_uneven_and_empty_beside() {
        // Three columns, two rows: 0 0 9 above 0 0 0, in a grid of 4 × 4.
        let pixels = [0, 0, 9, 0, 0, 0].map(|grey| [grey; 3]).to_vec();
        let content = Content::Image(Image { width: 3, height: 2, pixels });
        let tree = tree(&content, Recipe { depth: 2, threshold: 8, ..Recipe::default() });
        let full: Vec<_> = tree.leaves().filter(|leaf| leaf.is_full()).collect();
        let places: Vec<_> = full.iter().map(|f| (tree.level(f.id), tree.code(f.id))).collect();
        assert_eq!(places, [(1, [0, 0]), (0, [2, 0]), (0, [2, 1])]);
    }

    #[test]
    fn building_can_be_cancelled() {
        let progress = Progress::default();
        progress.cancel();
        let content = Content::Cells(vec![[0, 0]]);
        let tree = build(&content, Domain::unit(6), &Recipe::default(), &progress);
        assert_eq!(tree, Err(BuildError::Cancelled));
    }
}
