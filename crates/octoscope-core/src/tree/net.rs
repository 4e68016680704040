//! Links between neighbours: the net, or ropes.

use super::{Child, NodeId, Tree};
use std::sync::OnceLock;

/// For every node the neighbour of the same size or larger across each of its
/// sides: 2D links a node, made when they are first asked for.
#[derive(Clone, Debug, Default)]
pub(super) struct Net<const D: usize>(OnceLock<Vec<Links<D>>>);

/// Neighbour across the lower and the upper side of every axis.
type Links<const D: usize> = [[Option<NodeId>; 2]; D];

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
        self.net.0.get_or_init(|| self.links())[id.index()][axis][usize::from(upper)]
    }

    /// The links of all nodes: those between siblings, and those that lead to
    /// the children of the parent's neighbours.
    fn links(&self) -> Vec<Links<D>> {
        let mut links: Vec<Links<D>> = vec![[[None; 2]; D]; self.n_nodes()];
        for parent in self.nodes().filter(|node| !node.is_leaf()) {
            for (child, below) in Child::<D>::all().zip(self.children(parent)) {
                for axis in 0..D {
                    let across = child.across(axis);
                    let inner_side = usize::from(!child.is_upper(axis));
                    links[below.id.index()][axis][inner_side] = Some(self.child(parent, across).id);
                    let beyond = links[parent.id.index()][axis][1 - inner_side];
                    links[below.id.index()][axis][1 - inner_side] = beyond.map(|beyond| {
                        let node = self.node(beyond);
                        if node.is_leaf() { beyond } else { self.child(node, across).id }
                    });
                }
            }
        }
        links
    }
}
