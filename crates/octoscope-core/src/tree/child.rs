//! Child indices, in the numbering of Revelles: x is the most significant bit.

use super::Code;
use crate::geometry::{Axes, per_axis};

/// Index of a child in its parent, 0 … 2^D−1: bit D−1−e is 1 in the upper half
/// of axis e, so that i = 2x + y in a quadtree and i = 4x + 2y + z in an octree
/// [Revelles 2000, §3].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Child<const D: usize>(
    /// The index.
    pub u8,
);

impl<const D: usize> Child<D> {
    /// Number of children of an inner node.
    pub const COUNT: usize = 1 << D;

    /// All children in the order of their indices.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..Self::COUNT as u8).map(Self)
    }

    /// The child that lies in the upper half of the axes that are true.
    #[inline]
    pub fn from_upper_halves(upper: [bool; D]) -> Self {
        Self(Axes::where_true(upper).0)
    }

    /// The child that lies in the upper half of the axes that `holds` for.
    #[inline(always)]
    pub fn in_upper_half_where(holds: impl FnMut(usize) -> bool) -> Self {
        Self(Axes::<D>::of(holds).0)
    }

    /// The child that lies in the upper half of these axes.
    #[inline(always)]
    pub fn in_upper_halves(axes: Axes<D>) -> Self {
        Self(axes.0)
    }

    /// Whether the child lies in the upper half of `axis`.
    #[inline]
    pub fn is_upper(self, axis: usize) -> bool {
        Axes::<D>(self.0).contains(axis)
    }

    /// The sibling on the other side of the mid plane of `axis`.
    #[inline]
    pub fn across(self, axis: usize) -> Self {
        Self(self.0 ^ Axes::<D>::one(axis).0)
    }

    /// The same child in the mirrored tree, and back: f(i) = i xor a
    /// [Revelles 2000, eq. 17].
    #[inline]
    pub fn mirrored(self, mask: Axes<D>) -> Self {
        Self(self.0 ^ mask.0)
    }

    /// Code of the child of a node with code `parent`; the child's side is `half`.
    #[inline(always)]
    pub fn code_in(self, parent: Code<D>, half: u32) -> Code<D> {
        per_axis(|e| parent[e] + u32::from(self.is_upper(e)) * half)
    }

    /// Of every axis the value of the half that the child lies in. By an index and not by
    /// a jump, which would be mispredicted half of the times.
    #[inline(always)]
    pub fn pick<T: Copy>(self, halves: &[[T; D]; 2]) -> [T; D] {
        per_axis(|e| halves[usize::from(self.is_upper(e))][e])
    }

    /// The near and the far planes of the child, of the near, mid and far planes of its
    /// parent.
    #[inline(always)]
    pub fn slabs<T: Copy>(self, planes: &[[T; D]; 3]) -> [[T; D]; 2] {
        let half = |e| usize::from(self.is_upper(e));
        [per_axis(|e| planes[half(e)][e]), per_axis(|e| planes[half(e) + 1][e])]
    }

    /// Index in the numbering of Frisken–Perry and of Morton codes, where x is
    /// the least significant bit. The only place that converts.
    pub fn morton_index(self) -> u8 {
        (0..D).fold(0, |index, axis| index | u8::from(self.is_upper(axis)) << axis)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn x_is_the_most_significant_bit() {
        assert_eq!(Child::from_upper_halves([true, false]), Child::<2>(2));
        assert_eq!(Child::from_upper_halves([true, false, false]), Child::<3>(4));
        assert_eq!(Child::from_upper_halves([false, false, true]), Child::<3>(1));
    }

    #[test]
    fn morton_numbering_reverses_the_bits() {
        let indices: Vec<u8> = Child::<3>::all().map(Child::morton_index).collect();
        assert_eq!(indices, [0, 4, 2, 6, 1, 5, 3, 7]);
    }

    #[test]
    fn mirroring_x_swaps_the_halves() {
        let mirrored: Vec<u8> = Child::<3>::all().map(|c| c.mirrored(Axes::one(0)).0).collect();
        assert_eq!(mirrored, [4, 5, 6, 7, 0, 1, 2, 3]);
    }
}
