//! Which nodes of a diagram show their children.

use super::DiagramOf;
use super::layout::{layout, width};
use octoscope_core::tree::NodeId;
use std::collections::HashSet;

/// Leaves visited longer ago than so many do not unfold what they lie in.
const MOST_LEAVES: usize = 64;

/// The nodes above the current one and that one itself, `wanted` nodes, and as
/// many of those above the leaves visited last as fit into `room`, in units of
/// the layout. O(path): what is off it is never looked into.
pub(super) fn unfolded<const D: usize>(
    of: &DiagramOf<D>,
    wanted: &[NodeId],
    room: f64,
) -> HashSet<NodeId> {
    let tree = of.tree;
    let known = |node: &NodeId| node.index() < tree.n_nodes();
    let mut open: HashSet<NodeId> = wanted.iter().copied().filter(known).collect();
    open.insert(NodeId::ROOT);
    let focus = of.moment.current.or(of.moment.found);
    open.extend(focus.into_iter().flat_map(|node| tree.ancestors(node).chain([node])));

    // Each visited leaf makes the diagram wider, or leaves it as it is.
    let leaves = of.moment.leaves.iter().rev().take(MOST_LEAVES);
    let leaves: Vec<NodeId> = leaves.map(|leaf| leaf.node).collect();
    let with = |n: usize| -> HashSet<NodeId> {
        let above = leaves[..n].iter().flat_map(|&leaf| tree.ancestors(leaf));
        open.iter().copied().chain(above).collect()
    };
    let fits = |n: usize| {
        let [left, right] = width(&layout(tree, &with(n)));
        right - left <= room
    };
    let (mut most, mut too_many) = (0, leaves.len() + 1);
    if fits(leaves.len()) {
        most = leaves.len();
    }
    while too_many - most > 1 {
        let n = most + (too_many - most) / 2;
        if n <= leaves.len() && fits(n) { most = n } else { too_many = n }
    }
    with(most)
}
