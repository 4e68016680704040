//! Point location: the leaf that owns a point.

use super::misprint;
use crate::event::{End, Event, Observer, Outcome, Search};
use crate::geometry::Aabb;
use crate::tree::{Child, Code, Node, Tree, branch};
use crate::variant::Variants;

/// Leaf that owns `point`, by comparing it with the mid planes of every node on
/// the way down: D comparisons and one leaf test a level, O(depth).
pub fn locate_by_comparison<const D: usize>(
    tree: &Tree<D>,
    point: [f64; D],
    observe: &mut impl Observer<D>,
) -> Outcome {
    let domain = tree.domain();
    let root_box: Aabb<D> = domain.root_box();
    if !root_box.owns(point) {
        observe.observe(Event::End(End::Outside));
        return Outcome::without_node(End::Outside);
    }

    let mut node = tree.root();
    observe.observe(Event::Begin { node: node.id });
    let mut code: Code<D> = [0; D];
    let mut half = domain.grid_size() / 2;
    while !node.is_leaf() {
        // Compare: a point on a mid plane belongs to the upper half.
        let mid = std::array::from_fn(|e| domain.plane(e, code[e] + half));
        let child = Child::from_upper_halves(std::array::from_fn(|e| point[e] >= mid[e]));
        node = tree.child(node, child);
        observe.observe(Event::Compare { mid, point, child, node: node.id });
        code = child.code_in(code, half);
        half /= 2;
    }
    found(node, observe)
}

/// Leaf that owns `point`, by its location codes [Frisken, Perry 2002, §3]: no
/// comparison of coordinates on the way down, one leaf test a level, O(depth).
pub fn locate_by_codes<const D: usize>(
    tree: &Tree<D>,
    point: [f64; D],
    observe: &mut impl Observer<D>,
) -> Outcome {
    locate_by_codes_as_printed(tree, point, Variants::NONE, observe)
}

/// The same by rules of which some may be misprinted.
pub fn locate_by_codes_as_printed<const D: usize>(
    tree: &Tree<D>,
    point: [f64; D],
    variants: Variants,
    observe: &mut impl Observer<D>,
) -> Outcome {
    // Encode: refuse what is outside, lest the upper face wrap round to 0.
    let Some(code) = misprint::encode(tree.domain(), point, variants) else {
        observe.observe(Event::End(End::Outside));
        return Outcome::without_node(End::Outside);
    };
    observe.observe(Event::Encode { point, code, after: None, search: Search::NONE });

    // Follow one bit of every code a level, until a leaf stops it.
    observe.observe(Event::Begin { node: tree.root().id });
    let root_level = tree.domain().root_level();
    let read = misprint::as_read(code, root_level, variants);
    let (leaf, _) = descend(tree, tree.root(), root_level, read, 0, observe);
    found(leaf, observe)
}

/// Follows `code` from `node`, of this `level`, down to `stop_level` or a leaf;
/// returns the node that is reached, with its level.
#[inline(always)]
pub(crate) fn descend<const D: usize>(
    tree: &Tree<D>,
    mut node: Node,
    mut level: u8,
    code: Code<D>,
    stop_level: u8,
    observe: &mut impl Observer<D>,
) -> (Node, u8) {
    while level > stop_level && !node.is_leaf() {
        let child = branch(code, level);
        node = tree.child(node, child);
        observe.observe(Event::Follow { level, code, child, node: node.id });
        level -= 1;
    }
    (node, level)
}

/// Reports the node that a query has found.
pub(super) fn found<const D: usize>(node: Node, observe: &mut impl Observer<D>) -> Outcome {
    observe.observe(Event::Found { node: node.id });
    observe.observe(Event::End(End::Found));
    Outcome::at(End::Found, node.id)
}
