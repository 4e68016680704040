//! Where in memory the tree keeps what it knows of a node.

use super::layout::{Place, Row};
use super::net::Links;
use super::{NodeId, Tree};
use std::ops::Range;

/// One of the arrays that a tree lies in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Array {
    /// What is walked of the inner nodes: their children.
    Rows,
    /// Their levels, codes and parents.
    Places,
    /// Links of all nodes to their neighbours.
    Links,
}

impl<const D: usize> Tree<D> {
    /// Bytes of `array`, counted from its beginning, in which something about a node
    /// is kept: what its children and it are, and where it lies, in what belongs to
    /// its parent. `None` where nothing has to be read: the root is known.
    pub fn bytes_of(&self, array: Array, id: NodeId) -> Option<Range<usize>> {
        let parent_row = id.index().checked_sub(1).map(|place| place >> D);
        let (index, size) = match array {
            Array::Rows => (parent_row?, size_of::<Row>()),
            Array::Places => (parent_row?, size_of::<Place<D>>()),
            Array::Links => (id.index(), size_of::<Links<D>>()),
        };
        Some(index * size..(index + 1) * size)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Progress;
    use crate::tree::{Domain, Split, grow};

    #[test]
    fn siblings_share_what_their_parent_keeps() {
        let tree = grow(Domain::<2>::unit(2), (), &Progress::default(), |cell, ()| {
            if cell.level > 0 { Split::Inner(vec![(); 4]) } else { Split::Empty }
        });
        let tree = tree.unwrap();
        let bytes = |array, id| tree.bytes_of(array, NodeId(id));
        assert_eq!(bytes(Array::Rows, 0), None);
        // Rows of 8 bytes: the root's is the first, then those of its children.
        for child in 1..=4 {
            assert_eq!(bytes(Array::Rows, child), Some(0..8));
        }
        assert_eq!(bytes(Array::Rows, 5), Some(8..16));
        assert_eq!(bytes(Array::Places, 5), Some(16..32));
        // Four links of 4 bytes a node, the root among them.
        assert_eq!(bytes(Array::Links, 0), Some(0..16));
        assert_eq!(bytes(Array::Links, 3), Some(48..64));
    }
}
