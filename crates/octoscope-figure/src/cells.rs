//! Marks of the nodes off the path.

use crate::marks::node_mark;
use crate::slice::Cut;
use crate::{Mark, Rest, Role, Show};
use octoscope_core::tree::{Node, Tree};

/// Marks of the nodes that are shown off the path: the ground on which the others
/// lie. Behind a cut, what is left of them, and where it meets them. O(nodes), and
/// the same as long as the tree is the same.
pub fn cells<const D: usize>(tree: &Tree<D>, show: &Show, cut: Option<&Cut>) -> Vec<Mark<D>> {
    let whole = show.nodes(tree).map(|node| node_mark(tree, node.id, role(show, node)));
    let Some(cut) = cut else {
        return whole.collect();
    };
    let sections = cut.nodes(tree).filter(|&node| show.shows(tree, node));
    let sections = sections.filter_map(|node| cut.section(tree, node, section_role(show, node)));
    whole.flat_map(|mark| cut.parts(mark)).chain(sections).collect()
}

/// Role of where a slice meets a node off the path.
pub fn section_role(show: &Show, node: Node) -> Role {
    match show.rest {
        Rest::Plain if node.is_full() => Role::FullSection,
        Rest::Plain => Role::EmptySection,
        Rest::Faint | Rest::Hidden => Role::FaintNode,
    }
}

/// Role of a node off the path.
pub fn role(show: &Show, node: Node) -> Role {
    match show.rest {
        Rest::Plain if !node.is_leaf() => Role::InnerNode,
        Rest::Plain if node.is_full() => Role::FullLeaf,
        Rest::Plain => Role::EmptyLeaf,
        Rest::Faint | Rest::Hidden => Role::FaintNode,
    }
}
