//! Neighbours over faces, edges and corners by codes [Frisken, Perry 2002, §5].

use super::point::{descend, found};
use super::{climb, misprint};
use crate::event::{End, Event, Observer, Outcome, Search};
use crate::geometry::Axes;
use crate::tree::{Child, Node, NodeId, Tree};
use crate::variant::{Variant, Variants};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Direction to a neighbour: −1, 0 or 1 per axis, not all 0. One component is
/// over a face (an edge in 2-D), more of them are over an edge or a corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Direction<const D: usize>([i8; D]);

/// These numbers are no direction to a neighbour.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("a direction to a neighbour has components −1, 0 or 1, not all of them 0")]
pub struct DirectionError;

/// How large a neighbour may be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reach {
    /// The node of equal size, inner or not, or the larger leaf that covers it.
    #[default]
    EqualOrLarger,
    /// The leaf that touches the cell at its minimum corner, on the crossed side.
    Leaf,
    /// All leaves along the crossed side.
    EveryLeaf,
}

/// How a neighbour is found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum NeighbourMethod {
    /// By location codes [Frisken, Perry 2002, §5].
    #[default]
    Codes,
    /// By tables: up to the common ancestor, and down mirrored [Samet 1990].
    Tables,
}

impl<const D: usize> Direction<D> {
    /// Direction with these components.
    ///
    /// # Errors
    /// Refuses components other than −1, 0, 1, and all zeros.
    pub fn new(components: [i8; D]) -> Result<Self, DirectionError> {
        let valid = components.iter().all(|s| (-1..=1).contains(s)) && components != [0; D];
        if valid { Ok(Self(components)) } else { Err(DirectionError) }
    }

    /// The components.
    pub fn components(self) -> [i8; D] {
        self.0
    }

    /// All 3^D − 1 directions, by their components in ascending order.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..3u32.pow(D as u32)).filter_map(|n| {
            let digit = |e: usize| (n / 3u32.pow((D - 1 - e) as u32) % 3) as i8 - 1;
            Self::new(std::array::from_fn(digit)).ok()
        })
    }
}

/// Neighbour of a node. Climbs to the common ancestor and descends again:
/// O(distance to it), no comparison of coordinates but with the border.
pub fn neighbour<const D: usize>(
    tree: &Tree<D>,
    id: NodeId,
    direction: Direction<D>,
    reach: Reach,
    observe: &mut impl Observer<D>,
) -> Outcome {
    neighbour_as_printed(tree, id, direction, reach, Variants::NONE, observe)
}

/// The same by rules of which some may be misprinted.
pub fn neighbour_as_printed<const D: usize>(
    tree: &Tree<D>,
    id: NodeId,
    direction: Direction<D>,
    reach: Reach,
    variants: Variants,
    observe: &mut impl Observer<D>,
) -> Outcome {
    let (level, from) = (tree.level(id), tree.code(id));
    observe.observe(Event::Begin { node: id });

    // Offset: upwards the size of the cell, downwards one smallest cell, since
    // the sizes beyond are unknown but that cell lies in all of them.
    let to = misprint::target(level, from, direction, variants);
    let axes = Axes::where_true(direction.0.map(|s| s != 0));
    observe.observe(Event::Target { level, from, to, axes, search: Search::NONE });

    // Border: beyond it there is no neighbour.
    let outside = tree.domain().outside(to, axes);
    observe.observe(Event::Border { tested: axes, outside });
    if !outside.is_empty() {
        observe.observe(Event::End(End::Outside));
        return Outcome::without_node(End::Outside);
    }

    // Climb to the common ancestor, then descend along the target codes.
    let target = to.map(|c| c as u32);
    let misread = variants.has(Variant::B25Leftmost) || variants.has(Variant::B25Rightmost);
    let (ancestor, ancestor_level) = if misread {
        misprint::climb(tree, tree.node(id), level, [from, target], variants, observe)
    } else {
        climb(tree, tree.node(id), level, from, target, observe)
    };
    let stop_level = match reach {
        Reach::EqualOrLarger | Reach::EveryLeaf => level,
        Reach::Leaf => 0,
    };
    let (node, _) = descend(tree, ancestor, ancestor_level, target, stop_level, observe);
    match reach {
        Reach::EqualOrLarger | Reach::Leaf => found(node, observe),
        Reach::EveryLeaf => every_leaf(tree, node, direction, observe),
    }
}

/// Reports all leaves below `node` that touch its side towards the cell from
/// which it was reached by `direction`; the first of them is the outcome.
pub(super) fn every_leaf<const D: usize>(
    tree: &Tree<D>,
    node: Node,
    direction: Direction<D>,
    observe: &mut impl Observer<D>,
) -> Outcome {
    let first = leaves_facing(tree, node, direction, observe);
    observe.observe(Event::End(End::Found));
    Outcome::at(End::Found, first)
}

/// Reports the leaves below `node` on its side against `direction`, in the order
/// of their indices; returns the first.
fn leaves_facing<const D: usize>(
    tree: &Tree<D>,
    node: Node,
    direction: Direction<D>,
    observe: &mut impl Observer<D>,
) -> NodeId {
    if node.is_leaf() {
        observe.observe(Event::Found { node: node.id });
        return node.id;
    }
    let faces = |child: &Child<D>| {
        (0..D).all(|e| direction.0[e] == 0 || child.is_upper(e) == (direction.0[e] < 0))
    };
    let mut first = None;
    for child in Child::all().filter(faces) {
        let below = tree.child(node, child);
        observe.observe(Event::Facing { child, node: below.id });
        let leaf = leaves_facing(tree, below, direction, observe);
        first.get_or_insert(leaf);
    }
    first.expect("on every side of a node some children lie")
}
