//! Which result or node an event is about.

use super::Event;
use crate::tree::NodeId;

impl<const D: usize> Event<D> {
    /// Whether the event reports a leaf, a touch or a node.
    pub fn is_result(&self) -> bool {
        matches!(self, Self::Leaf { .. } | Self::Touch { .. } | Self::Found { .. })
    }

    /// The leaf that is visited, or the node that is found.
    pub fn result_node(&self) -> Option<NodeId> {
        let is_found = matches!(self, Self::Leaf { .. } | Self::Found { .. });
        self.node().filter(|_| is_found)
    }

    /// The node at which the algorithm looks or to which it goes, if it is one.
    pub fn node(&self) -> Option<NodeId> {
        match *self {
            Self::Test { node, .. }
            | Self::Visit { node, .. }
            | Self::Enter { node, .. }
            | Self::Parent { node, .. }
            | Self::Mirror { node, .. }
            | Self::Facing { node, .. }
            | Self::Begin { node }
            | Self::Compare { node, .. }
            | Self::Follow { node, .. }
            | Self::Resume { node, .. }
            | Self::Climb { node, .. }
            | Self::Leaf { node, .. }
            | Self::Touch { node, .. }
            | Self::Found { node } => Some(node),
            Self::Up { node } | Self::Rope { node, .. } => node,
            Self::Split { taken, .. } => Some(taken.node),
            Self::Pop { part, .. } => Some(part.node),
            Self::Clip { .. }
            | Self::Sort { .. }
            | Self::Skip { .. }
            | Self::Halve { .. }
            | Self::First { .. }
            | Self::Step { .. }
            | Self::Cuts { .. }
            | Self::Classify { .. }
            | Self::Flip { .. }
            | Self::Grid { .. }
            | Self::Cross { .. }
            | Self::Push { .. }
            | Self::Encode { .. }
            | Self::Exits { .. }
            | Self::Target { .. }
            | Self::Border { .. }
            | Self::Difference { .. }
            | Self::Leave { .. }
            | Self::Corners { .. }
            | Self::End(_) => None,
        }
    }
}
