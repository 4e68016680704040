//! How algorithms end.

use crate::tree::NodeId;

/// Why an algorithm ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum End {
    /// The ray does not meet the root.
    Missed,
    /// The ray has left the root.
    #[default]
    LeftRoot,
    /// A full leaf was met and no more was asked for.
    FirstFull,
    /// The end of the wanted segment was reached.
    SegmentEnd,
    /// The ray does not get any further: the algorithm goes round in circles.
    Looped,
    /// Whoever watches wants no more: the run has become too long.
    Cut,
    /// A node was found.
    Found,
    /// The asked-for place lies outside the domain.
    Outside,
}

/// What a run came to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outcome {
    /// Why it ended.
    pub end: End,
    /// The node that a query found; the first full leaf of a ray that stops there.
    pub node: Option<NodeId>,
}

impl Outcome {
    /// End without a node.
    pub fn without_node(end: End) -> Self {
        Self { end, node: None }
    }

    /// End at a node.
    pub fn at(end: End, node: NodeId) -> Self {
        Self { end, node: Some(node) }
    }
}
