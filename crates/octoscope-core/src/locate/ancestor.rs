//! The smallest common ancestor of a node and a place [Frisken, Perry 2002, §5].

use crate::event::{Event, Observer};
use crate::tree::{Code, Node, Tree, common_level};

/// Climbs from `node`, of this `level` and code `from`, to its smallest ancestor
/// that holds `to` as well; returns that ancestor and its level.
///
/// A neighbour's code comes about by adding 1 at the node's own level or by
/// subtracting 1, and the carry or borrow changes an unbroken run of bits
/// upwards: their XOR has ones up to the level below the common ancestor.
#[inline(always)]
pub fn climb<const D: usize>(
    tree: &Tree<D>,
    mut node: Node,
    mut level: u8,
    from: Code<D>,
    to: Code<D>,
    observe: &mut impl Observer<D>,
) -> (Node, u8) {
    let ancestor_level = common_level(from, to).max(level);
    let xor = std::array::from_fn(|e| from[e] ^ to[e]);
    observe.observe(Event::Difference { from, to, xor, level: ancestor_level });
    while level < ancestor_level {
        let parent = tree.parent(node.id).expect("codes below 2^R have the root in common");
        node = tree.node(parent);
        level += 1;
        observe.observe(Event::Climb { node: parent, level });
    }
    (node, level)
}
