//! Neighbours over faces, edges and corners the conventional way: up to the
//! nearest common ancestor, and down mirrored [Samet 1989; Samet 1990].
//!
//! What a child's index says of its place in the parent is looked up in three
//! tables, one entry for every direction and child. All three follow from the bits
//! of the index; the functions below are these rules, and what they return is
//! what the tables contain.

use super::neighbour::every_leaf;
use super::point::found;
use super::{Direction, Reach};
use crate::event::{End, Event, Lookup, Observer, Outcome};
use crate::tree::{Child, Node, NodeId, Tree};

/// Table ADJ: whether the child lies on that side of its parent. It does if its
/// bit is 1 exactly on the axes with a positive direction, of those with any.
pub fn adjacent<const D: usize>(direction: [i8; D], child: Child<D>) -> bool {
    common_part(direction, child) == direction
}

/// Table REFLECT: the child on the other side, its bits flipped on every axis with
/// a direction.
pub fn reflected<const D: usize>(direction: [i8; D], child: Child<D>) -> Child<D> {
    (0..D).filter(|&e| direction[e] != 0).fold(child, Child::across)
}

/// Table COMMON: the part of the direction along which the child lies on that side
/// of its parent, and in which the neighbour is therefore beyond the parent.
pub fn common_part<const D: usize>(direction: [i8; D], child: Child<D>) -> [i8; D] {
    std::array::from_fn(|e| {
        let on_side = child.is_upper(e) == (direction[e] > 0);
        if on_side { direction[e] } else { 0 }
    })
}

/// Neighbour of a node, found without codes or coordinates. O(distance to the
/// common ancestor); two steps up and two down on average.
pub fn neighbour_by_tables<const D: usize>(
    tree: &Tree<D>,
    id: NodeId,
    direction: Direction<D>,
    reach: Reach,
    observe: &mut impl Observer<D>,
) -> Outcome {
    observe.observe(Event::Begin { node: id });
    let components = direction.components();
    let neighbour = ascend_and_mirror(tree, id, components, observe);
    let Some(mut node) = neighbour else {
        observe.observe(Event::End(End::Outside));
        return Outcome::without_node(End::Outside);
    };
    match reach {
        Reach::EqualOrLarger => found(node, observe),
        Reach::Leaf => {
            // Down along the side that was crossed, at its minimum corner.
            let child = Child::from_upper_halves(components.map(|s| s < 0));
            while !node.is_leaf() {
                node = tree.child(node, child);
                observe.observe(Event::Facing { child, node: node.id });
            }
            found(node, observe)
        }
        Reach::EveryLeaf => every_leaf(tree, node, direction, observe),
    }
}

/// Neighbour of the same size or larger of a node; `None` beyond the border.
pub(crate) fn ascend_and_mirror<const D: usize>(
    tree: &Tree<D>,
    id: NodeId,
    direction: [i8; D],
    observe: &mut impl Observer<D>,
) -> Option<Node> {
    // Climb: to the parent, and on from there unless it holds the neighbour.
    let parent = tree.parent(id)?;
    let child = tree.child_index(id)?;
    let common = common_part(direction, child);
    let lookup = Lookup::Tables;
    observe.observe(Event::Parent { node: parent, child, direction, common, lookup });
    let beyond = if common == [0; D] {
        tree.node(parent)
    } else {
        ascend_and_mirror(tree, parent, common, observe)?
    };

    // Mirror down, unless a larger leaf is met.
    if beyond.is_leaf() {
        return Some(beyond);
    }
    let mirrored = reflected(direction, child);
    let node = tree.child(beyond, mirrored);
    observe.observe(Event::Mirror { child, mirrored, node: node.id });
    Some(node)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_son_lies_on_the_sides_of_its_upper_and_lower_halves() {
        assert!(adjacent([1, 0, -1], Child::<3>(0b100)));
        assert!(!adjacent([1, 0, -1], Child::<3>(0b101)));
        assert_eq!(common_part([1, 1, -1], Child::<3>(0b101)), [1, 0, 0]);
        assert_eq!(common_part([1, 0, 0], Child::<3>(0)), [0; 3]);
    }

    #[test]
    fn reflection_flips_the_axes_of_the_direction() {
        assert_eq!(reflected([1, 0, -1], Child::<3>(0b000)), Child(0b101));
        for direction in Direction::<3>::all() {
            for child in Child::all() {
                let direction = direction.components();
                assert_eq!(reflected(direction, reflected(direction, child)), child);
            }
        }
    }
}
