//! Pieces of text in views.

use octoscope_core::explain::{RichText, Span};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::tree::{NodeId, Tree};

/// Text in the colour of an axis.
pub(crate) fn on_axis(axis: usize, text: impl Into<String>) -> RichText {
    RichText(vec![Span { text: text.into(), axis: Some(axis), ..Span::default() }])
}

/// Name of the parameter of a plane: t with a subscript, as xm.
pub(crate) fn parameter(axis: usize, plane: &str) -> RichText {
    let name = Span { text: "t".to_owned(), axis: Some(axis), ..Span::default() };
    let sub = Span { text: format!("{}{plane}", AXIS_NAMES[axis]), sub: true, ..name.clone() };
    RichText(vec![name, sub])
}

/// Emphasised text.
pub(crate) fn strong(text: impl Into<String>) -> RichText {
    RichText(vec![Span { text: text.into(), strong: true, ..Span::default() }])
}

/// Texts one after the other.
pub(crate) fn joined(parts: impl IntoIterator<Item = RichText>) -> RichText {
    RichText(parts.into_iter().flat_map(|part| part.0).collect())
}

/// Text per axis in its colour, in brackets: (3, 5).
pub(crate) fn tuple<const D: usize>(parts: [String; D]) -> RichText {
    let inner = parts.into_iter().enumerate().flat_map(|(axis, part)| {
        [RichText::from(if axis == 0 { "(" } else { ", " }), on_axis(axis, part)]
    });
    joined(inner.chain([RichText::from(")")]))
}

/// Codes of a node, in the colours of the axes.
pub(crate) fn codes<const D: usize>(tree: &Tree<D>, node: NodeId) -> RichText {
    tuple(tree.code(node).map(|code| code.to_string()))
}
