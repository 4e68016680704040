//! The name of a node beside the title of a panel.

use crate::look::Look;
use octoscope_core::tree::{NodeId, Tree};

/// Level and codes of a node; nothing without one.
pub fn node_note<const D: usize>(look: &Look, tree: &Tree<D>, node: Option<NodeId>) -> String {
    let Some(node) = node else { return String::new() };
    let codes = tree.code(node).map(|c| c.to_string()).join(", ");
    let arguments = [("level", tree.level(node).into()), ("codes", codes.into())];
    look.texts.format("node-note", &arguments)
}
