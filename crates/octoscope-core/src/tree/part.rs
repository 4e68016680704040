//! Parts of nodes: what lies between the levels of the tree if its axes are
//! halved one after the other.

use super::{Child, NodeId, Tree};
use crate::geometry::{Aabb, Axes};

/// A node, or the half, the quarter … of it that is left when some of its axes
/// are halved: a node of the binary tree that emulates a quadtree or an octree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Part<const D: usize> {
    /// The node.
    pub node: NodeId,
    /// Axes that are halved.
    pub halved: Axes<D>,
    /// Those of them whose upper half it is.
    pub upper: Axes<D>,
}

impl<const D: usize> Part<D> {
    /// All of a node.
    pub fn whole(node: NodeId) -> Self {
        Self { node, halved: Axes::NONE, upper: Axes::NONE }
    }

    /// The next axis to be halved: x, then y, then z; `None` if all are.
    pub fn next_axis(self) -> Option<usize> {
        (0..D).find(|&axis| !self.halved.contains(axis))
    }

    /// One half of the part across `axis`.
    pub fn half(self, axis: usize, upper: bool) -> Self {
        let bit = Axes::<D>::one(axis).0;
        Self {
            node: self.node,
            halved: Axes(self.halved.0 | bit),
            upper: Axes(if upper { self.upper.0 | bit } else { self.upper.0 }),
        }
    }

    /// The child that the part is, once all axes are halved.
    pub fn as_child(self) -> Child<D> {
        Child(self.upper.0)
    }

    /// Box of the part, in world units.
    pub fn bounds(self, tree: &Tree<D>) -> Aabb<D> {
        let (level, code) = (tree.level(self.node), tree.code(self.node));
        let mut bounds = tree.node_box(self.node);
        for axis in self.halved.iter() {
            let middle = tree.domain().plane(axis, code[axis] + (1 << level) / 2);
            if self.upper.contains(axis) {
                bounds.min[axis] = middle;
            } else {
                bounds.max[axis] = middle;
            }
        }
        bounds
    }
}
