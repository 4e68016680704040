//! The node that is pointed at, in whichever view.

use octoscope_core::tree::{NodeId, Tree};

/// The node under the pointer: every view lights it, and the one that is pointed
/// at offers it for the next frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Hover {
    lit: Option<NodeId>,
    offered: Option<NodeId>,
}

impl Hover {
    /// The node to be lit, if it is one of `tree`, which may have changed.
    pub fn lit<const D: usize>(&self, tree: &Tree<D>) -> Option<NodeId> {
        self.lit.filter(|node| node.index() < tree.n_nodes())
    }

    /// Offers the node that is pointed at in this frame.
    pub fn offer(&mut self, node: NodeId) {
        self.offered = Some(node);
    }

    /// Ends the frame: what was offered is lit. Tells whether that is new.
    pub fn turn(&mut self) -> bool {
        let before = std::mem::replace(&mut self.lit, self.offered.take());
        before != self.lit
    }
}
