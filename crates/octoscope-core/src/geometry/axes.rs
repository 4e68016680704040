//! Sets of axes.

/// Names of the axes, by index.
pub const AXIS_NAMES: [&str; 3] = ["x", "y", "z"];

/// Set of axes, one bit each; x is the most significant of the D bits, as in
/// a [`Child`](crate::tree::Child).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Axes<const D: usize>(
    /// Bit D−1−e stands for axis e.
    pub u8,
);

impl<const D: usize> Axes<D> {
    /// No axis.
    pub const NONE: Self = Self(0);

    /// The axes for which `flags` is true.
    #[inline]
    pub fn where_true(flags: [bool; D]) -> Self {
        let mut bits = 0;
        for flag in flags {
            bits = bits << 1 | u8::from(flag);
        }
        Self(bits)
    }

    /// The axes for which `holds`.
    #[inline(always)]
    pub fn of(holds: impl FnMut(usize) -> bool) -> Self {
        Self::where_true(super::per_axis(holds))
    }

    /// The set of one axis, 0 = x.
    #[inline]
    pub fn one(axis: usize) -> Self {
        Self(1 << (D - 1 - axis))
    }

    /// Whether axis 0 = x, 1 = y, 2 = z is in the set.
    #[inline]
    pub fn contains(self, axis: usize) -> bool {
        self.0 >> (D - 1 - axis) & 1 == 1
    }

    /// Whether no axis is in the set.
    #[inline]
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The first axis of the set alone.
    #[inline]
    pub fn first(self) -> Self {
        self.0.checked_ilog2().map_or(Self::NONE, |bit| Self(1 << bit))
    }

    /// Number of axes in the set.
    #[inline]
    pub fn count(self) -> usize {
        self.0.count_ones() as usize
    }

    /// The axes in the set, x first.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        (0..D).filter(move |&axis| self.contains(axis))
    }
}
