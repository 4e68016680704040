//! Queries by codes with rules as "Ray Tracing mit Octrees" prints them.
//!
//! Codes that are misread are followed as what they are taken for, so that in
//! every step bit `level − 1` of the shown code is the one that is read.

use super::Direction;
use crate::event::{Event, Observer};
use crate::tree::{Code, Domain, Node, Tree, common_level};
use crate::variant::{Variant, Variants};

/// Code of a point. As printed, the domain is closed: the coordinate of its
/// upper face has a code as well, 2^R.
pub fn encode<const D: usize>(
    domain: &Domain<D>,
    point: [f64; D],
    variants: Variants,
) -> Option<Code<D>> {
    if !variants.has(Variant::B21) {
        return domain.encode_point(point);
    }
    let size = domain.grid_size();
    let mut code = [0; D];
    for e in 0..D {
        let on_face = point[e] == domain.plane(e, size);
        code[e] = if on_face { size } else { domain.encode(e, point[e])? };
    }
    Some(code)
}

/// What a point's code is taken for on the way down.
pub fn as_read<const D: usize>(code: Code<D>, root_level: u8, variants: Variants) -> Code<D> {
    let read = |c: u32| {
        // The least significant bit of the R + 1 first.
        let reversed = c.reverse_bits() >> (u32::BITS - 1 - u32::from(root_level));
        let c = if variants.has(Variant::B18) { reversed } else { c };
        // Bit k at level k, instead of bit k − 1.
        if variants.has(Variant::B19) { c >> 1 } else { c }
    };
    code.map(read)
}

/// Level of the smallest cell of a region, from the XOR codes of its corners.
pub fn region_level<const D: usize>(xor: Code<D>, variants: Variants) -> u8 {
    let level = if variants.has(Variant::B24b) {
        // The first 1 that all have in common.
        let common = xor.into_iter().fold(u32::MAX, |bits, c| bits & c);
        (u32::BITS - common.leading_zeros()) as u8
    } else {
        common_level(xor, [0; D])
    };
    // The number of the bit itself.
    if variants.has(Variant::B24a) { level.saturating_sub(1) } else { level }
}

/// Codes beyond a side: as printed, by the side length on either side.
pub fn target<const D: usize>(
    level: u8,
    from: Code<D>,
    direction: Direction<D>,
    variants: Variants,
) -> [i64; D] {
    let down = if variants.has(Variant::B28) { 1 << level } else { 1 };
    let components = direction.components();
    std::array::from_fn(|e| match components[e] {
        0 => i64::from(from[e]),
        s if s > 0 => i64::from(from[e]) + (1 << level),
        _ => i64::from(from[e]) - down,
    })
}

/// Climbs until "the first binary digit" of the difference is 0: the leftmost
/// one, which always is, or the rightmost one, which does not change.
pub fn climb<const D: usize>(
    tree: &Tree<D>,
    mut node: Node,
    mut level: u8,
    [from, to]: [Code<D>; 2],
    variants: Variants,
    observe: &mut impl Observer<D>,
) -> (Node, u8) {
    let xor: Code<D> = std::array::from_fn(|e| from[e] ^ to[e]);
    let odd = xor.iter().any(|c| c & 1 == 1);
    let climbs = odd && !variants.has(Variant::B25Leftmost);
    let top = if climbs { tree.domain().root_level() } else { level };
    observe.observe(Event::Difference { from, to, xor, level: top });
    while let Some(parent) = tree.parent(node.id).filter(|_| level < top) {
        node = tree.node(parent);
        level += 1;
        observe.observe(Event::Climb { node: parent, level });
    }
    (node, level)
}
