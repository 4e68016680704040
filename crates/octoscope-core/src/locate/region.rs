//! Region location: the smallest node that holds a box [Frisken, Perry 2002, §4].

use super::misprint;
use super::point::{descend, found};
use crate::event::{End, Event, Observer, Outcome};
use crate::tree::Tree;
use crate::variant::{Variant, Variants};

/// Smallest node that holds the smallest cells of both corners, `min` and `max`
/// included. The level is one more than the highest bit in which their codes
/// differ; a leaf on the way down is the answer although it is larger. O(depth),
/// no comparison of coordinates.
pub fn locate_region<const D: usize>(
    tree: &Tree<D>,
    min: [f64; D],
    max: [f64; D],
    observe: &mut impl Observer<D>,
) -> Outcome {
    locate_region_as_printed(tree, min, max, Variants::NONE, observe)
}

/// The same by rules of which some may be misprinted.
pub fn locate_region_as_printed<const D: usize>(
    tree: &Tree<D>,
    min: [f64; D],
    max: [f64; D],
    variants: Variants,
    observe: &mut impl Observer<D>,
) -> Outcome {
    // Encode both corners.
    let domain = tree.domain();
    let (Some(from), Some(to)) = (domain.encode_point(min), domain.encode_point(max)) else {
        observe.observe(Event::End(End::Outside));
        return Outcome::without_node(End::Outside);
    };
    observe.observe(Event::Corners { min, max, from, to });

    // XOR: the highest one in any of the differences, plus 1, is the level.
    let xor = std::array::from_fn(|e| from[e] ^ to[e]);
    let level = misprint::region_level(xor, variants);
    observe.observe(Event::Difference { from, to, xor, level });

    // Descend along the codes of a point of the region.
    observe.observe(Event::Begin { node: tree.root().id });
    let way = if variants.has(Variant::B24c) { xor } else { from };
    let (node, _) = descend(tree, tree.root(), domain.root_level(), way, level, observe);
    found(node, observe)
}
