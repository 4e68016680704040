//! Growing a tree from the root down, level by level, each of them in blocks.

use super::layout::{Place, Row};
use super::net::Net;
use super::{Child, Code, Domain, NodeId, Tree};
use crate::geometry::Aabb;
use crate::progress::{Cancelled, Progress};
use crate::threads::in_order;
use std::collections::VecDeque;
use std::num::NonZeroUsize;

/// A cell while its tree grows.
#[derive(Clone, Copy, Debug)]
pub struct Cell<'a, const D: usize> {
    /// The grid on which the tree grows.
    pub domain: &'a Domain<D>,
    /// Level of the cell; 0 cannot be split.
    pub level: u8,
    /// Location code of the cell.
    pub code: Code<D>,
}

impl<const D: usize> Cell<'_, D> {
    /// Extent of the cell, in world units.
    pub fn bounds(&self) -> Aabb<D> {
        self.domain.cell_box(self.level, self.code)
    }

    /// Code of child `child`, one level below.
    pub fn child_code(&self, child: Child<D>) -> Code<D> {
        std::array::from_fn(|e| self.code[e] | u32::from(child.is_upper(e)) << (self.level - 1))
    }
}

/// What becomes of a cell.
#[derive(Clone, Debug)]
pub enum Split<K, I = Vec<u32>> {
    /// It is an empty leaf.
    Empty,
    /// It is a full leaf with these items, which may be none.
    Full(I),
    /// It is an inner node; the contents of its 2^D children by index, or what they are
    /// made of.
    Inner(K),
}

/// Tree over `domain` in which `split` decides over every cell, starting from
/// the root with `contents`. Level by level, in O(nodes) calls of `split`.
///
/// # Errors
/// Stops with [`Cancelled`] when `progress` is cancelled.
///
/// # Panics
/// Panics if `split` divides a cell of level 0 or returns another number of
/// contents than 2^D.
pub fn grow<const D: usize, C>(
    domain: Domain<D>,
    contents: C,
    progress: &Progress,
    mut split: impl FnMut(Cell<D>, C) -> Split<Vec<C>>,
) -> Result<Tree<D>, Cancelled> {
    let mut judge = |cell: Cell<D>, contents, items: &mut Vec<u32>| {
        if progress.check().is_err() {
            return Split::Empty;
        }
        match split(cell, contents) {
            Split::Empty => Split::Empty,
            Split::Full(full) => {
                items.extend(full);
                Split::Full(())
            }
            Split::Inner(contents) => {
                assert_eq!(contents.len(), Child::<D>::COUNT, "one part for each child");
                Split::Inner(contents)
            }
        }
    };
    let (mut tree, root) = Tree::of_root(domain, contents, &mut judge);
    let mut blocks = VecDeque::from([root]);
    while let Some(kept) = blocks.pop_front() {
        progress.advance((kept.len() * Child::<D>::COUNT) as u64)?;
        let part = tree.divide(tree.rows.len(), kept, |_, contents| contents, &mut judge);
        let below = tree.append(part);
        if !below.is_empty() {
            blocks.push_back(below);
        }
    }
    progress.check()?;
    Ok(tree)
}

/// Like [`grow`], by so many threads; the tree is the same for any number. `judge`
/// appends the items of a full leaf to the list that it is handed, and `divide` makes
/// the contents of the children, by index, of what is kept of an inner node and its
/// level. `account` is called with 0 before every block, so that it can stop the work, and
/// after it with the number of inner nodes found.
///
/// # Errors
/// That of `account`.
///
/// # Panics
/// Panics if `judge` divides a cell of level 0.
pub(super) fn grow_on<const D: usize, C, K: Clone + Send + Sync, I, E: Send>(
    threads: NonZeroUsize,
    domain: Domain<D>,
    contents: C,
    divide: impl Fn(u8, K) -> I + Sync,
    judge: impl Fn(Cell<D>, C, &mut Vec<u32>) -> Split<K, ()> + Sync,
    account: impl Fn(usize) -> Result<(), E> + Sync,
) -> Result<Tree<D>, E>
where
    I: IntoIterator<Item = C>,
{
    let (mut tree, root) = Tree::of_root(domain, contents, &mut &judge);
    account(root.len())?;
    let mut of_level = vec![root];
    while !of_level.is_empty() {
        // Each block with its first row.
        let (mut row, mut blocks) = (tree.rows.len(), Vec::new());
        for kept in of_level.iter().flat_map(|kept| kept.chunks(BLOCK)) {
            blocks.push((row, kept));
            row += kept.len();
        }
        let mut below = Vec::new();
        for blocks in blocks.chunks(BLOCKS_A_THREAD * threads.get()) {
            let parts = in_order(threads, blocks.iter(), |&(row, kept)| {
                account(0)?;
                let part = tree.divide(row, kept.iter().cloned(), &divide, &mut &judge);
                account(part.kept.len()).map(|()| part)
            });
            for part in parts {
                below.push(tree.append(part?));
            }
        }
        of_level = below;
    }
    Ok(tree)
}

/// Inner nodes that are divided together.
const BLOCK: usize = 4096;

/// Blocks that are divided before what was found below them is put together: so few
/// that it is still at hand.
const BLOCKS_A_THREAD: usize = 16;

/// What was found below the inner nodes of a block.
struct Part<const D: usize, K> {
    /// Of the nodes; their bases are counted from the first inner child of the block.
    rows: Vec<Row>,
    /// Of the inner children, with what is kept of them.
    places: Vec<Place<D>>,
    kept: Vec<K>,
    /// Of the nodes how many full leaves of the block come before their children.
    first_full: Vec<u32>,
    /// Of the full leaves, and how many there are up to and with each of these.
    items: Vec<u32>,
    n_items: Vec<u32>,
}

impl<const D: usize> Tree<D> {
    /// A tree of which the root alone is known, and what is kept of it if it is an
    /// inner node.
    fn of_root<C, K>(
        domain: Domain<D>,
        contents: C,
        judge: &mut impl FnMut(Cell<D>, C, &mut Vec<u32>) -> Split<K, ()>,
    ) -> (Self, Vec<K>) {
        let (level, code) = (domain.root_level(), [0; D]);
        let mut tree = Self {
            domain,
            root_full: false,
            rows: Vec::new(),
            places: Vec::new(),
            first_full: Vec::new(),
            first_item: vec![0],
            items: Vec::new(),
            net: Net::default(),
        };
        let cell = Cell { domain: &domain, level, code };
        let kept = match judge(cell, contents, &mut tree.items) {
            Split::Empty => None,
            Split::Full(()) => {
                tree.root_full = true;
                tree.first_item.push(tree.items.len() as u32);
                None
            }
            Split::Inner(kept) => {
                tree.places.push(Place { id: NodeId::ROOT, level, code });
                Some(kept)
            }
        };
        (tree, kept.into_iter().collect())
    }

    /// Lets `judge` decide over all children of the inner nodes from a row on of which
    /// something was kept.
    fn divide<C, K, I: IntoIterator<Item = C>>(
        &self,
        first_row: usize,
        kept: impl IntoIterator<Item = K>,
        divide: impl Fn(u8, K) -> I,
        judge: &mut impl FnMut(Cell<D>, C, &mut Vec<u32>) -> Split<K, ()>,
    ) -> Part<D, K> {
        let mut part = Part {
            rows: Vec::new(),
            places: Vec::new(),
            kept: Vec::new(),
            first_full: Vec::new(),
            items: Vec::new(),
            n_items: Vec::new(),
        };
        for (number, kept) in (first_row..).zip(kept) {
            let place = self.places[number];
            let level = place.level.checked_sub(1).expect("a cell of level 0 cannot be split");
            let (mut base, mut inner, mut full) = (0, 0u8, 0u8);
            part.first_full.push(part.n_items.len() as u32);
            for (child, contents) in Child::<D>::all().zip(divide(place.level, kept)) {
                let code = child.code_in(place.code, 1 << level);
                let cell = Cell { domain: &self.domain, level, code };
                match judge(cell, contents, &mut part.items) {
                    Split::Empty => {}
                    Split::Full(()) => {
                        full |= 1 << child.0;
                        part.n_items.push(part.items.len() as u32);
                    }
                    Split::Inner(kept) => {
                        if inner == 0 {
                            base = part.places.len() as u32;
                        }
                        inner |= 1 << child.0;
                        let id = NodeId(1 + ((number as u32) << D | u32::from(child.0)));
                        part.places.push(Place { id, level, code });
                        part.kept.push(kept);
                    }
                }
            }
            part.rows.push(Row::new(base, inner, full));
        }
        part
    }

    /// Adds what was found below the next rows; returns what was kept of inner nodes.
    fn append<K>(&mut self, part: Part<D, K>) -> Vec<K> {
        let [first_row, first_full, first_item] =
            [self.places.len(), self.first_item.len() - 1, self.items.len()].map(|n| n as u32);
        let moved = |row: Row| match row.inner() {
            0 => row,
            inner => Row::new(first_row + row.base(), inner, row.full()),
        };
        self.rows.extend(part.rows.into_iter().map(moved));
        self.places.extend(part.places);
        self.first_full.extend(part.first_full.into_iter().map(|n| first_full + n));
        self.first_item.extend(part.n_items.into_iter().map(|n| first_item + n));
        self.items.extend(part.items);
        part.kept
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// Divides every cell that holds the origin, down to level 0.
    fn corner_tree() -> Tree<2> {
        grow(Domain::unit(3), (), &Progress::default(), |cell, ()| match cell {
            Cell { code: [0, 0], level: 0, .. } => Split::Full(vec![7]),
            Cell { code: [0, 0], .. } => Split::Inner(vec![(); 4]),
            _ => Split::Empty,
        })
        .unwrap()
    }

    #[test]
    fn numbers_levels_codes_and_parents_fit_together() {
        let tree = corner_tree();
        assert_eq!((tree.n_nodes(), tree.n_leaves()), (13, 10));
        for node in tree.nodes() {
            let (level, code) = (tree.level(node.id), tree.code(node.id));
            assert_eq!(tree.node_at(level, code), Some(node));
            for (child, node_below) in Child::all().zip(tree.children(node)) {
                assert_eq!(tree.parent(node_below.id), Some(node.id));
                assert_eq!(tree.child_index(node_below.id), Some(child));
                assert_eq!(tree.level(node_below.id), level - 1);
            }
        }
    }

    #[test]
    fn contents_lie_in_their_leaf() {
        let tree = corner_tree();
        let full: Vec<_> = tree.leaves().filter(|leaf| leaf.is_full()).collect();
        assert_eq!(full.len(), 1);
        assert_eq!(tree.items(full[0].id), [7]);
        assert_eq!((tree.level(full[0].id), tree.code(full[0].id)), (0, [0, 0]));
    }

    #[test]
    fn a_root_can_be_a_leaf() {
        let tree =
            grow(Domain::<3>::unit(0), (), &Progress::default(), |_, ()| Split::Full(vec![1, 2]))
                .unwrap();
        assert!(tree.root().is_leaf() && tree.root().is_full());
        assert_eq!(tree.items(NodeId::ROOT), [1, 2]);
        assert_eq!(tree.level(NodeId::ROOT), 0);
    }

    #[test]
    fn growing_can_be_cancelled() {
        let progress = Progress::default();
        progress.cancel();
        let tree = grow(Domain::<2>::unit(1), (), &progress, |_, ()| Split::Empty);
        assert_eq!(tree, Err(Cancelled));
    }

    #[test]
    fn whoever_accounts_for_inner_nodes_can_stop_the_growth() {
        for (threads, most) in [(1, 100), (3, 100), (3, 1_000_000)] {
            let threads = NonZeroUsize::new(threads).unwrap();
            let n_inner = Mutex::new(0);
            let divide = |_, ()| [(); 8];
            let judge = |cell: Cell<3>, (), _: &mut _| {
                if cell.level > 0 { Split::Inner(()) } else { Split::Full(()) }
            };
            let grown = grow_on(threads, Domain::unit(5), (), divide, judge, |n| {
                let mut n_inner = n_inner.lock().unwrap();
                *n_inner += n;
                if *n_inner > most { Err("too many") } else { Ok(()) }
            });
            // 1 + 8 + 64 + 512 + 4096.
            let expected = if most > 4681 { Ok(8 * 4681 + 1) } else { Err("too many") };
            assert_eq!(grown.map(|tree| tree.n_nodes()), expected);
        }
    }

    #[test]
    fn who_cancels_waits_for_one_block_a_thread() {
        for n_threads in [1, 3] {
            let (progress, n_judged) = (Progress::default(), AtomicUsize::new(0));
            let judge = |cell: Cell<3>, (), _: &mut _| {
                if cell.level > 0 {
                    return Split::Inner(());
                }
                progress.cancel();
                n_judged.fetch_add(1, Ordering::Relaxed);
                Split::Full(())
            };
            let threads = NonZeroUsize::new(n_threads).unwrap();
            let divide = |_, ()| [(); 8];
            let domain = Domain::unit(6);
            let grown = grow_on(threads, domain, (), divide, judge, |_| progress.check());
            assert_eq!(grown, Err(Cancelled));
            // Of 2^18 cells.
            assert!((1..=n_threads * BLOCK * 8).contains(&n_judged.into_inner()));
        }
    }
}
