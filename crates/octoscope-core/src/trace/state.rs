//! The pieces of a moment.

use crate::geometry::Axes;
use crate::tree::{Child, Code, NodeId};

/// Node on the stack of a top-down traversal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<const D: usize> {
    /// The node.
    pub node: NodeId,
    /// Its child index in the mirrored numbering, where there is one.
    pub state: Option<Child<D>>,
    /// Where the ray is in the node.
    pub extent: Extent<D>,
    /// Parameters of its mid planes, once they are known.
    pub mid: Option<[f64; D]>,
    /// The parameter with which they are compared for the first child, once it is
    /// known: where the ray enters, or t = 0 if it begins inside.
    pub entry: Option<f64>,
    /// State of its automaton: the child that is visited or was left last, in
    /// the mirrored numbering.
    pub child_state: Option<Child<D>>,
    /// The child that is visited or was left last, in the tree's own numbering.
    pub child: Option<Child<D>>,
    /// Its mid planes in the order of the ray, once they are sorted.
    pub cuts: Option<Cuts<D>>,
}

/// Where a ray is in a node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent<const D: usize> {
    /// As far as all axes say.
    Planes {
        /// Parameters of the near planes.
        near: [f64; D],
        /// Parameters of the far planes.
        far: [f64; D],
    },
    /// Between two parameters.
    Interval([f64; 2]),
}

/// Mid planes in the order in which the ray meets them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuts<const D: usize> {
    /// Their axes, the first plane first.
    pub order: [u8; D],
    /// The axes of those that cut the node's interval.
    pub inside: Axes<D>,
}

impl<const D: usize> Frame<D> {
    /// Parameter at which the ray enters the node.
    pub fn enter(&self) -> f64 {
        match self.extent {
            Extent::Planes { near, .. } => near.into_iter().fold(f64::NEG_INFINITY, f64::max),
            Extent::Interval([enter, _]) => enter,
        }
    }

    /// Parameter at which the ray leaves the node.
    pub fn exit(&self) -> f64 {
        match self.extent {
            Extent::Planes { far, .. } => far.into_iter().fold(f64::INFINITY, f64::min),
            Extent::Interval([_, exit]) => exit,
        }
    }

    /// Parameters of the near and far planes, if the algorithm knows them.
    pub fn planes(&self) -> Option<[[f64; D]; 2]> {
        match self.extent {
            Extent::Planes { near, far } => Some([near, far]),
            Extent::Interval(_) => None,
        }
    }
}

/// A cell of the grid of smallest cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridCell<const D: usize> {
    /// Parameter at which the ray comes into it.
    pub enter: f64,
    /// Its code; `None` once the ray has left the domain.
    pub cell: Option<Code<D>>,
    /// Parameters of the planes ahead; +∞ along axes without motion.
    pub next: [f64; D],
    /// Axes of the planes that were crossed into it.
    pub crossed: Axes<D>,
    /// Parameters of the planes that were ahead before, in the step that crosses.
    pub left: Option<[f64; D]>,
}

/// The way from a node up, down again or across to its neighbour.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Detour {
    /// Parents on the way up, the lowest first.
    pub up: Vec<NodeId>,
    /// Mirrored children on the way down, the highest first.
    pub down: Vec<NodeId>,
    /// Nodes that links lead to, with the node from which each does.
    pub links: Vec<[NodeId; 2]>,
}

/// The side on which the neighbour of a node is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Towards<const D: usize> {
    /// The direction to it; all 0 once a parent holds it.
    pub direction: [i8; D],
    /// The child at which the tables are read.
    pub child: Child<D>,
}

/// The plane by which a part was halved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalvingPlane {
    /// The node through whose middle it goes.
    pub node: NodeId,
    /// Its axis.
    pub axis: usize,
    /// Its parameter; NaN or ±∞ if the ray does not move along the axis.
    pub at: f64,
}

/// A visited leaf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeafOnRay {
    /// The leaf.
    pub node: NodeId,
    /// Where the ray enters it, at least 0.
    pub enter: f64,
    /// Where the ray leaves it.
    pub exit: f64,
}

/// Codes on the way down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Codes<const D: usize> {
    /// One code an axis.
    pub code: Code<D>,
    /// Number of the bit that was read last.
    pub bit: Option<u8>,
}

/// A cell and the codes of the place beyond it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target<const D: usize> {
    /// Level of the cell.
    pub level: u8,
    /// Codes of the cell.
    pub from: Code<D>,
    /// Codes beyond it; −1 or 2^R outside the domain.
    pub to: [i64; D],
    /// Axes along which the cell is left.
    pub axes: Axes<D>,
    /// Axes along which the target is outside, once they are known.
    pub outside: Option<Axes<D>>,
}

/// Two codes and their XOR.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference<const D: usize> {
    /// One place.
    pub from: Code<D>,
    /// The other.
    pub to: Code<D>,
    /// Bitwise XOR, axis by axis.
    pub xor: Code<D>,
    /// Level of the smallest cell that holds both.
    pub level: u8,
    /// Level that climbing has reached.
    pub climbed: u8,
}

/// The far planes of a leaf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exits<const D: usize> {
    /// Coordinates of the planes, in world units.
    pub planes: [f64; D],
    /// Their parameters; +∞ on axes that the ray does not move along.
    pub exits: [f64; D],
    /// The planes that are met first.
    pub axes: Axes<D>,
}

/// The ray cut with the root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RootClip<const D: usize> {
    /// Parameters of the near planes.
    pub near: [f64; D],
    /// Parameters of the far planes.
    pub far: [f64; D],
    /// When the root is entered and left.
    pub interval: [f64; 2],
    /// Whether the ray meets the root at some t ≥ 0.
    pub hit: bool,
    /// Axes along which the direction is negative.
    pub mirror: Axes<D>,
}
