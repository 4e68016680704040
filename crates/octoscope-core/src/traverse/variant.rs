//! Which traversal has which rules.

pub use crate::variant::{UnknownVariant, Variant, Variants};

use super::Algorithm;
use crate::geometry::Axes;
use crate::tree::Child;

impl Variant {
    /// Whether the rule is one of quadtrees (2) or octrees (3): Table 2 is of space, the
    /// selection of children of the plane.
    pub fn is_of_dimension(self, dimension: usize) -> bool {
        match (self, dimension) {
            (Self::B2 | Self::B2Morton, 2) | (Self::B3, 3) => false,
            (_, dimension) => matches!(dimension, 2 | 3),
        }
    }

    /// Whether a traversal has the rule.
    pub fn belongs_to(self, algorithm: Algorithm) -> bool {
        use Algorithm::{Bsp, Dda, DdaOctree, Glassner, Parametric, ParametricTable};
        match self {
            Self::OneByOne => matches!(algorithm, Parametric | Dda | DdaOctree),
            Self::Averaged => matches!(algorithm, Parametric | ParametricTable),
            Self::Push => algorithm == Glassner,
            Self::Gem => algorithm == Bsp,
            Self::B1
            | Self::B2
            | Self::B2Morton
            | Self::B3
            | Self::B4
            | Self::B5
            | Self::B6
            | Self::B7
            | Self::B10
            | Self::B11 => {
                matches!(algorithm, Parametric | ParametricTable)
            }
            // The tables begin at the near planes anyway.
            Self::B9 => algorithm == Parametric,
            // Of other queries.
            Self::B18
            | Self::B19
            | Self::B21
            | Self::B24a
            | Self::B24b
            | Self::B24c
            | Self::B25Leftmost
            | Self::B25Rightmost
            | Self::B28 => false,
        }
    }
}

impl Variants {
    /// The child of the tree that a state of the parametric automaton means, as
    /// f(i) = i xor a numbers it. Where Table 2 is read in Morton order, the number
    /// is as well.
    pub fn child_of_state<const D: usize>(self, state: Child<D>, mask: Axes<D>) -> Child<D> {
        let child = state.mirrored(mask);
        if D == 3 && self.has(Variant::B2Morton) { Child(child.morton_index()) } else { child }
    }
}
