//! Building a tree from content.
//!
//! Everything but a picture is first turned into a list of cells, sorted along
//! the order of the children from the root to the leaves, by digits of their Morton
//! codes. Then every node owns a range of the list and finds those of its children by
//! bisection. O(n · depth) for n points or cells; no copy of the content is made. All
//! processors share the work, and the tree is the same for any number of them.

use super::grow::grow_on;
use super::keys::{Key, Outside, child_ranges, keys_of_cells, keys_of_points};
use super::occupied::{Occupied, occupied_cells};
use super::picture::image_tree;
use super::sort::sort_by_key;
use super::{Cell, Child, Domain, DomainError, MAX_NODES, Merge, Recipe, Split, Tree};
use crate::progress::{Cancelled, Progress};
use crate::scene::Content;
use crate::threads::all_threads;
use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use thiserror::Error;

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
    Cancelled(#[from] Cancelled),
}

impl From<Outside> for BuildError {
    fn from(Outside { count, first }: Outside) -> Self {
        Self::Outside { count, first }
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
    build_within(MAX_NODES, threads, content, domain, recipe, progress)
}

/// The same with another limit than [`MAX_NODES`].
fn build_within<const D: usize>(
    max_nodes: usize,
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
    let growth = Growth { max_nodes, threads, domain, recipe, progress };
    match content {
        Content::Points(points) => {
            let keys = growth.sorted(keys_of_points(threads, points, &domain)?)?;
            bucket_tree(&keys, &growth)
        }
        Content::Cells(cells) => {
            let keys = growth.sorted(keys_of_cells(threads, cells, &domain)?)?;
            region_tree(&Occupied::cells(&keys), &growth)
        }
        Content::Image(image) => image_tree(image, &growth),
        Content::Spheres(_) | Content::Boxes(_) | Content::Triangles(_) => {
            region_tree(&occupied_cells(content, &growth)?, &growth)
        }
    }
}

/// Where and how a tree grows.
pub(super) struct Growth<'a, const D: usize> {
    pub max_nodes: usize,
    pub threads: NonZeroUsize,
    pub domain: Domain<D>,
    pub recipe: &'a Recipe,
    pub progress: &'a Progress,
}

impl<const D: usize> Growth<'_, D> {
    /// The keys, ascending.
    fn sorted(&self, mut keys: Vec<Key>) -> Result<Vec<Key>, Cancelled> {
        self.progress.check()?;
        sort_by_key(self.threads, &mut keys);
        self.progress.check()?;
        Ok(keys)
    }

    /// Grows a tree by [`grow_on`] and refuses one with too many nodes.
    pub fn tree<C, K: Clone + Send + Sync, I: IntoIterator<Item = C>>(
        &self,
        contents: C,
        divide: impl Fn(u8, K) -> I + Sync,
        judge: impl Fn(Cell<D>, C, &mut Vec<u32>) -> Split<K, ()> + Sync,
    ) -> Result<Tree<D>, BuildError> {
        let n_inner = AtomicUsize::new(0);
        grow_on(self.threads, self.domain, contents, divide, judge, |n_found| {
            self.progress.advance(n_found as u64)?;
            let n_inner = n_inner.fetch_add(n_found, Ordering::Relaxed) + n_found;
            let n_nodes = 1 + n_inner * Child::<D>::COUNT;
            if n_nodes > self.max_nodes { Err(BuildError::TooManyNodes) } else { Ok(()) }
        })
    }
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
            Split::Empty
        } else if range.len() <= capacity || cell.level == 0 {
            let n_before = items.len();
            items.extend(keys[range].iter().map(|&(_, item)| item));
            items[n_before..].sort_unstable();
            Split::Full(())
        } else {
            Split::Inner(range)
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
            Split::Empty
        } else if is_leaf() {
            occupied.append_items(&range, items);
            Split::Full(())
        } else {
            Split::Inner(range)
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Aabb;
    use crate::scene::{Sphere, made};

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

    /// Content of every kind that is built from many cells, with its depth.
    fn of_all_kinds() -> [(Content<3>, u8); 5] {
        let corners = |s: &Sphere<3>, sign: f64| s.centre.map(|c| c + sign * s.radius);
        let spheres = made::cloud::<3>(1, 40);
        let Content::Spheres(list) = &spheres else { panic!("spheres") };
        let boxes = list.iter().map(|s| Aabb { min: corners(s, -1.0), max: corners(s, 1.0) });
        [
            (made::clustered_points(1, 3000), 7),
            (made::chequered_cells(4), 4),
            (Content::Boxes(boxes.collect()), 6),
            (made::cylinders_and_spheres(1, 10), 6),
            (spheres, 6),
        ]
    }

    #[test]
    fn a_tree_has_as_many_nodes_as_it_may_and_no_more() {
        for (content, depth) in of_all_kinds() {
            let recipe = Recipe { depth, ..Recipe::default() };
            let (domain, progress) = (Domain::unit(depth), Progress::default());
            let tree = build(&content, domain, &recipe, &progress).unwrap();
            for threads in [1, 3] {
                let threads = NonZeroUsize::new(threads).unwrap();
                let within = |max_nodes| {
                    build_within(max_nodes, threads, &content, domain, &recipe, &progress)
                };
                assert_eq!(within(tree.n_nodes()).as_ref(), Ok(&tree));
                assert_eq!(within(tree.n_nodes() - 1), Err(BuildError::TooManyNodes));
                assert_eq!(within(10), Err(BuildError::TooManyNodes));
            }
        }
    }

    #[test]
    fn building_can_be_cancelled() {
        let progress = Progress::default();
        progress.cancel();
        let content = Content::Cells(vec![[0, 0]]);
        let tree = build(&content, Domain::unit(6), &Recipe::default(), &progress);
        assert_eq!(tree, Err(BuildError::Cancelled(Cancelled)));
    }
}
