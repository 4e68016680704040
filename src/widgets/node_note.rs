//! The name of a node beside the title of a panel.

use crate::look::Look;
use octoscope_core::tree::{NodeId, Tree};
use octoscope_figure::views::place_note;

/// Level and codes of a node; nothing without one.
pub fn node_note<const D: usize>(look: &Look, tree: &Tree<D>, node: Option<NodeId>) -> String {
    let place = node.map(|node| (tree.level(node), tree.code(node)));
    place.map_or_else(String::new, |place| place_note(&look.texts, place))
}
