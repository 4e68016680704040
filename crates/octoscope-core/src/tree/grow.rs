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
    let mut tree = Tree {
        domain,
        root_full: false,
        rows: Vec::new(),
        places: Vec::new(),
        first_item: vec![0],
        items: Vec::new(),
        net: Net::default(),
    };
    // Cells of one level in the order of their numbers, with the cells' parents.
    let mut cells = vec![(NodeId::ROOT, [0; D], contents)];
    let mut level = domain.root_level();
    loop {
        let mut below = Vec::new();
        for (id, code, contents) in cells {
            progress.advance(1)?;
            let cell = Cell { domain: &domain, level, code };
            match split(cell, contents) {
                Split::Empty => {}
                Split::Full(items) => {
                    tree.mark(id, |row, bit| row.full |= bit);
                    tree.root_full = id == NodeId::ROOT;
                    tree.items.extend(items);
                }
                Split::Inner(contents) => {
                    assert!(level > 0, "a cell of level 0 cannot be split");
                    assert_eq!(contents.len(), Child::<D>::COUNT, "one part for each child");
                    let row = tree.rows.len() as u32;
                    tree.mark(id, |parent, bit| {
                        if parent.inner == 0 {
                            parent.base = row;
                        }
                        parent.inner |= bit;
                    });
                    tree.rows.push(Row::default());
                    tree.places.push(Place { id, level, code });
                    for (child, contents) in Child::all().zip(contents) {
                        let id = NodeId(1 + (row << D | u32::from(child.0)));
                        below.push((id, cell.child_code(child), contents));
                    }
                }
            }
            tree.first_item.push(tree.items.len() as u32);
        }
        if below.is_empty() {
            return Ok(tree);
        }
        cells = below;
        level -= 1;
    }
}

impl<const D: usize> Tree<D> {
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
