//! Links between neighbours: the net, or ropes.

use super::{Child, NodeId, Tree};
use crate::progress::{Cancelled, Progress};
use std::sync::OnceLock;

/// For every node the neighbour of the same size or larger across each of its
/// sides: 2D links of 4 bytes a node, made when they are first asked for.
#[derive(Clone, Debug, Default)]
pub(super) struct Net<const D: usize>(OnceLock<Vec<Links<D>>>);

/// Neighbour across the lower and the upper side of every axis.
pub(super) type Links<const D: usize> = [[Link; 2]; D];

/// A neighbour, or the border.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link(u32);

impl Link {
    /// No tree has so many nodes.
    const BORDER: Self = Self(u32::MAX);

    fn node(self) -> Option<NodeId> {
        (self.0 != u32::MAX).then_some(NodeId(self.0))
    }
}

impl From<NodeId> for Link {
    fn from(node: NodeId) -> Self {
        Self(node.0)
    }
}

/// Nodes between two looks whether the links are still wanted.
const NODES_AT_ONCE: u64 = 4096;

/// Made from the nodes alone, a net makes no difference between trees.
impl<const D: usize> PartialEq for Net<D> {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl<const D: usize> Tree<D> {
    /// Neighbour of a node across its lower or upper side on `axis`: of the same
    /// size, a leaf or not, or a larger leaf; `None` at the border. O(1), but
    /// the first call for a tree links all its nodes, in O(nodes).
    pub fn neighbour_across(&self, id: NodeId, axis: usize, upper: bool) -> Option<NodeId> {
        let unasked = || self.links(&Progress::default()).expect("nobody cancels it");
        self.net.0.get_or_init(unasked)[id.index()][axis][usize::from(upper)].node()
    }

    /// Whether the nodes are linked already.
    pub fn is_linked(&self) -> bool {
        self.net.0.get().is_some()
    }

    /// Links all nodes, unless they are: O(nodes), and 8D bytes a node.
    ///
    /// # Errors
    /// Stops with [`Cancelled`] when `progress` is cancelled.
    pub fn link(&self, progress: &Progress) -> Result<(), Cancelled> {
        if !self.is_linked() {
            let links = self.links(progress)?;
            // Another thread may have been quicker: it has made the same.
            let _ = self.net.0.set(links);
        }
        Ok(())
    }

    /// The links of all nodes: those between siblings, and those that lead to
    /// the children of the parent's neighbours.
    fn links(&self, progress: &Progress) -> Result<Vec<Links<D>>, Cancelled> {
        let n_children = Child::<D>::COUNT as u64;
        progress.start(self.n_nodes() as u64);
        let mut since_look = 0;
        let mut links: Vec<Links<D>> = vec![[[Link::BORDER; 2]; D]; self.n_nodes()];
        for parent in self.nodes().filter(|node| !node.is_leaf()) {
            since_look += n_children;
            if since_look >= NODES_AT_ONCE {
                progress.advance(std::mem::take(&mut since_look))?;
            }
            for (child, below) in Child::<D>::all().zip(self.children(parent)) {
                for axis in 0..D {
                    let across = child.across(axis);
                    let inner_side = usize::from(!child.is_upper(axis));
                    links[below.id.index()][axis][inner_side] =
                        self.child(parent, across).id.into();
                    let beyond = links[parent.id.index()][axis][1 - inner_side];
                    let Some(beyond) = beyond.node() else { continue };
                    let node = self.node(beyond);
                    let nearest = if node.is_leaf() { beyond } else { self.child(node, across).id };
                    links[below.id.index()][axis][1 - inner_side] = nearest.into();
                }
            }
        }
        Ok(links)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tree::{Domain, Split, grow};

    #[test]
    fn links_take_4_bytes_each_and_are_not_made_for_nobody() {
        assert_eq!(size_of::<Links<3>>(), 24);
        let tree = grow(Domain::<2>::unit(7), (), &Progress::default(), |cell, ()| {
            if cell.level > 0 { Split::Inner(vec![(); 4]) } else { Split::Empty }
        });
        let tree = tree.unwrap();
        let cancelled = Progress::default();
        cancelled.cancel();
        assert_eq!(tree.link(&cancelled), Err(Cancelled));
        assert!(!tree.is_linked());
        let progress = Progress::default();
        assert_eq!(tree.link(&progress), Ok(()));
        assert!(tree.is_linked() && progress.fraction().is_some_and(|part| part > 0.5));
    }
}
