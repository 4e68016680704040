//! Growing a tree from the root down.

use super::layout::{Place, Row};
use super::net::Net;
use super::{Child, Code, Domain, NodeId, Tree};
use crate::geometry::Aabb;
use crate::progress::{Cancelled, Progress};

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

/// What becomes of a cell with contents `C`.
#[derive(Clone, Debug)]
pub enum Split<C> {
    /// It is an empty leaf.
    Empty,
    /// It is a full leaf with these items, which may be none.
    Full(Vec<u32>),
    /// It is an inner node; the contents of its 2^D children by index.
    Inner(Vec<C>),
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
    mut split: impl FnMut(Cell<D>, C) -> Split<C>,
) -> Result<Tree<D>, Cancelled> {
    progress.advance(1)?;
    let mut tree = Tree {
        domain,
        root_full: false,
        rows: Vec::new(),
        places: Vec::new(),
        first_item: vec![0],
        items: Vec::new(),
        net: Net::default(),
    };
    // The inner nodes of one level in the order of their numbers, with the contents of
    // their children. Leaves are done with where they are met: there are far more.
    let mut inner = Vec::new();
    tree.settle(NodeId::ROOT, domain.root_level(), [0; D], contents, &mut split, &mut inner);
    let mut level = domain.root_level();
    while !inner.is_empty() {
        let mut below = Vec::new();
        let first_row = tree.rows.len() - inner.len();
        level -= 1;
        for (row, (code, contents)) in (first_row as u32..).zip(inner) {
            progress.advance(Child::<D>::COUNT as u64)?;
            for (child, contents) in Child::<D>::all().zip(contents) {
                let id = NodeId(1 + (row << D | u32::from(child.0)));
                let code = child.code_in(code, 1 << level);
                tree.settle(id, level, code, contents, &mut split, &mut below);
            }
        }
        inner = below;
    }
    Ok(tree)
}

impl<const D: usize> Tree<D> {
    /// Adds the node with the next number, as `split` decides; what is an inner node
    /// goes to `inner` as well.
    #[inline]
    fn settle<C>(
        &mut self,
        id: NodeId,
        level: u8,
        code: Code<D>,
        contents: C,
        split: &mut impl FnMut(Cell<D>, C) -> Split<C>,
        inner: &mut Vec<(Code<D>, Vec<C>)>,
    ) {
        match split(Cell { domain: &self.domain, level, code }, contents) {
            Split::Empty => {}
            Split::Full(items) => {
                self.mark(id, |row, bit| row.full |= bit);
                self.root_full = id == NodeId::ROOT;
                self.items.extend(items);
            }
            Split::Inner(contents) => {
                assert!(level > 0, "a cell of level 0 cannot be split");
                assert_eq!(contents.len(), Child::<D>::COUNT, "one part for each child");
                let row = self.rows.len() as u32;
                self.mark(id, |parent, bit| {
                    if parent.inner == 0 {
                        parent.base = row;
                    }
                    parent.inner |= bit;
                });
                self.rows.push(Row::default());
                self.places.push(Place { id, level, code });
                inner.push((code, contents));
            }
        }
        self.first_item.push(self.items.len() as u32);
    }

    /// Changes the parent's row of a node, given the node's bit in its masks.
    fn mark(&mut self, id: NodeId, change: impl FnOnce(&mut Row, u8)) {
        if let Some(place) = id.0.checked_sub(1) {
            let bit = 1 << (place & ((1 << D) - 1));
            change(&mut self.rows[(place >> D) as usize], bit);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
