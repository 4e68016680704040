//! The steps of all algorithms.

use super::{End, Halves, Lookup, Search};
use crate::geometry::Axes;
use crate::tree::{Child, Code, NodeId, Part};

/// One step of an algorithm, with the numbers that it was made with.
///
/// Algorithms share events where they do the same, so that panels, sentences
/// and counters need to know events only. Parameters t are in units of the
/// ray's direction; `near` and `far` planes are those of the ray, so that
/// `near[e] ≤ far[e]` whatever the sign of its direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event<const D: usize> {
    // Rays and boxes.
    /// The ray is cut with the root: it is inside for `enter` ≤ t < `exit`.
    Clip {
        /// Parameters of the near planes.
        near: [f64; D],
        /// Parameters of the far planes.
        far: [f64; D],
        /// The latest near plane.
        enter: f64,
        /// The earliest far plane.
        exit: f64,
        /// Whether the ray meets the root at some t ≥ 0.
        hit: bool,
        /// Axes along which the direction is negative: the mirror mask a.
        mirror: Axes<D>,
    },
    /// One node is tested by itself, without its parent's help.
    Test {
        /// The node.
        node: NodeId,
        /// Parameters of entry and exit, if the ray meets it.
        interval: Option<[f64; 2]>,
        /// Whether it meets it in one point only.
        touch: bool,
        /// Axes whose two planes took a division each: not those without motion,
        /// and none where fractions are compared by multiplying crosswise.
        divided: Axes<D>,
    },
    /// All tested leaves are put in the order of their entry.
    Sort {
        /// Number of leaves on the ray.
        n_leaves: u32,
    },

    // Top-down, with a stack.
    /// A node is entered from its parent and becomes the current one.
    Visit {
        /// The node.
        node: NodeId,
        /// Its state: the child index in the mirrored numbering; `None` for the root.
        state: Option<Child<D>>,
        /// Parameters of its near planes.
        near: [f64; D],
        /// Parameters of its far planes.
        far: [f64; D],
    },
    /// The current node is compared with the origin of the ray.
    Skip {
        /// The earliest far plane.
        exit: f64,
        /// Whether the node lies behind the origin, and is left at once.
        behind: bool,
    },
    /// The parameters of the mid planes of the current node are computed.
    Halve {
        /// Parameters of the mid planes.
        mid: [f64; D],
        /// Axes along which it took a division: not those without motion, nor
        /// those along which it is the mean of the near and the far plane.
        divided: Axes<D>,
    },
    /// The first child on the ray is found.
    First {
        /// The parameter with which the mid planes are compared.
        entry: f64,
        /// The axis of the near plane that is reached last; `None` if the ray
        /// begins inside.
        entry_axis: Option<usize>,
        /// Axes whose mid planes are compared with `entry`.
        compared: Axes<D>,
        /// The child, in the mirrored numbering.
        state: Child<D>,
    },
    /// The automaton goes from one child of the current node to the next.
    Step {
        /// The child that is left, in the mirrored numbering.
        state: Child<D>,
        /// Parameters of the child's far planes.
        exits: [f64; D],
        /// The planes through which it is left.
        axes: Axes<D>,
        /// The next child; `None` if the parent is left as well.
        next: Option<Child<D>>,
    },
    /// The current node is done; its parent becomes the current one.
    Up {
        /// The parent, or `None` above the root.
        node: Option<NodeId>,
    },

    // Top-down, by intervals of the ray.
    /// A node is entered with the interval of the ray that lies in it, and
    /// becomes the current one.
    Enter {
        /// The node.
        node: NodeId,
        /// Parameters between which the ray is in it.
        interval: [f64; 2],
        /// Whether by a recursive call, and not in the same loop.
        call: bool,
    },
    /// The mid planes of the current node are put in the order in which the ray
    /// meets them.
    Cuts {
        /// The axes of the planes, the first plane first.
        order: [u8; D],
        /// Axes whose planes are met between the ends of the node's interval.
        inside: Axes<D>,
        /// Number of comparisons of planes with each other.
        sorting: u8,
        /// Number of comparisons of planes with the ends of the interval.
        ranging: u8,
    },
    /// The sides of the mid planes on which the ray is tell the child.
    Classify {
        /// The parameter with which the mid planes are compared.
        at: f64,
        /// The ends of the piece of the ray whose middle that is, if it is one.
        piece: Option<[f64; 2]>,
        /// The child, in the tree's own numbering.
        child: Child<D>,
    },
    /// Mid planes are crossed: the child's bits of their axes are flipped.
    Flip {
        /// Parameter of the planes.
        at: f64,
        /// Their axes.
        axes: Axes<D>,
        /// The next child, in the tree's own numbering.
        child: Child<D>,
    },

    // Binary space partition.
    /// One plane halves the current part; its parameter decides which halves
    /// the ray is in.
    Split {
        /// Axis of the plane.
        axis: u8,
        /// Coordinate of the plane, in world units.
        plane: f64,
        /// Its parameter; ±∞ if the ray does not move along the axis, and NaN by
        /// the rule of the gem for an origin in the plane.
        at: f64,
        /// Whether a division led to the parameter: without motion along the axis it
        /// does by the rule of the gem alone.
        divided: bool,
        /// Parameters between which the ray is in the part.
        interval: [f64; 2],
        /// The halves that the ray is in.
        halves: Halves,
        /// The half that becomes the current part.
        taken: Part<D>,
        /// The half that is kept on the stack for later.
        kept: Option<Part<D>>,
    },
    /// A part is taken from the stack and becomes the current one.
    Pop {
        /// The part.
        part: Part<D>,
        /// Parameters between which the ray is in it.
        interval: [f64; 2],
    },

    // The grid of smallest cells.
    /// The ray's first cell on the grid.
    Grid {
        /// Its code.
        cell: Code<D>,
        /// Parameters of the planes that the ray meets next, one an axis; +∞
        /// on axes that it does not move along.
        next: [f64; D],
        /// What finding the cell took.
        search: Search,
    },
    /// The ray goes on to the next cell of the grid.
    Cross {
        /// Parameters of the planes ahead, the crossed ones among them.
        next: [f64; D],
        /// Axes of the planes that are crossed.
        axes: Axes<D>,
        /// Code of the next cell; −1 or 2^R outside the domain.
        cell: [i64; D],
        /// Axes along which that is outside, if it leaves the grid.
        outside: Axes<D>,
        /// Parameters of the planes ahead of the next cell; as before outside.
        ahead: [f64; D],
    },

    // Neighbours by the path through the tree.
    /// From a child to its parent on the search for a neighbour; the parent
    /// becomes the current node.
    Parent {
        /// The parent.
        node: NodeId,
        /// Which of its children was left.
        child: Child<D>,
        /// Where the neighbour of the child is looked for.
        direction: [i8; D],
        /// What is left of the direction: the axes along which the child lies on
        /// that side of its parent. All 0 if the parent holds the neighbour.
        common: [i8; D],
        /// Where that is looked up.
        lookup: Lookup,
    },
    /// From a parent down to the child that mirrors the one on the way up.
    Mirror {
        /// The child on the way up.
        child: Child<D>,
        /// The mirrored one.
        mirrored: Child<D>,
        /// The mirrored child, which becomes the current node.
        node: NodeId,
    },
    /// From a node down to a child on the side towards the cell where the search began.
    Facing {
        /// The child.
        child: Child<D>,
        /// That child, which becomes the current node.
        node: NodeId,
    },
    /// A link leads through a side of the current leaf; the neighbour becomes
    /// the current node.
    Rope {
        /// Axis across which the side lies.
        axis: u8,
        /// The neighbour of the same size or larger; `None` at the border.
        node: Option<NodeId>,
    },
    /// The point where the ray leaves the leaf is pushed out of it.
    Push {
        /// The point on the ray.
        from: [f64; D],
        /// The point beyond the side.
        to: [f64; D],
        /// Axis across which the side lies.
        axis: u8,
    },

    // Location codes.
    /// A search begins at a node, which becomes the current one.
    Begin {
        /// The node.
        node: NodeId,
    },
    /// A place is turned into location codes: those of a given point, or those
    /// of the smallest cell in which the ray is just after some parameter.
    Encode {
        /// The point, in world units; on the ray, rounded.
        point: [f64; D],
        /// The codes.
        code: Code<D>,
        /// The parameter just after which the ray is in the cell. Its planes are
        /// then compared with that, and not with the point.
        after: Option<f64>,
        /// What finding the cell took.
        search: Search,
    },
    /// The mid planes of a node are compared with a point.
    Compare {
        /// The planes, in world units.
        mid: [f64; D],
        /// The point, in world units.
        point: [f64; D],
        /// The child that owns the point.
        child: Child<D>,
        /// That child, which becomes the current node.
        node: NodeId,
    },
    /// One bit of every code selects a child.
    Follow {
        /// Level of the parent; bit `level − 1` is read.
        level: u8,
        /// The codes that are followed.
        code: Code<D>,
        /// The child that the bits select.
        child: Child<D>,
        /// That child, which becomes the current node.
        node: NodeId,
    },
    /// The far planes of the current leaf are met.
    Exits {
        /// Coordinates of the planes, in world units.
        planes: [f64; D],
        /// Their parameters; +∞ on axes that the ray does not move along.
        exits: [f64; D],
        /// The planes that are met first.
        axes: Axes<D>,
    },
    /// The codes of the place just beyond the current cell.
    Target {
        /// Level of the cell.
        level: u8,
        /// Codes of the cell.
        from: Code<D>,
        /// Codes of the target; −1 or 2^R outside the domain.
        to: [i64; D],
        /// Axes along which the cell is left.
        axes: Axes<D>,
        /// What finding the codes along the other axes took.
        search: Search,
    },
    /// The target is compared with the border of the domain.
    Border {
        /// Axes along which it is; along the others it is inside anyway.
        tested: Axes<D>,
        /// Axes along which the target is outside.
        outside: Axes<D>,
    },
    /// The codes of two places are compared by XOR.
    Difference {
        /// One place.
        from: Code<D>,
        /// The other.
        to: Code<D>,
        /// Bitwise XOR, axis by axis.
        xor: Code<D>,
        /// Level of the smallest cell that holds both.
        level: u8,
    },
    /// The node is left through the first of its far planes, which are known.
    Leave {
        /// Parameters of the far planes.
        exits: [f64; D],
        /// The planes that are met first.
        axes: Axes<D>,
    },
    /// A node that was kept on the way down becomes the current one again.
    Resume {
        /// The node.
        node: NodeId,
        /// Its level.
        level: u8,
        /// Number of nodes on the stack above it, which are given up.
        popped: u8,
    },
    /// The parent becomes the current node, as the bit at its level differs.
    Climb {
        /// The parent.
        node: NodeId,
        /// Its level.
        level: u8,
    },
    /// The two corners of a region are turned into codes.
    Corners {
        /// Smallest corner, in world units.
        min: [f64; D],
        /// Largest corner, in world units.
        max: [f64; D],
        /// Codes of the smallest corner.
        from: Code<D>,
        /// Codes of the largest corner.
        to: Code<D>,
    },

    // Results.
    /// A leaf is on the ray for `enter` ≤ t < `exit`.
    Leaf {
        /// The leaf.
        node: NodeId,
        /// Where the ray enters it, at least 0.
        enter: f64,
        /// Where the ray leaves it.
        exit: f64,
        /// Whether something is in the leaf.
        full: bool,
    },
    /// The ray meets a leaf in one point.
    Touch {
        /// The leaf.
        node: NodeId,
        /// The parameter of the point.
        at: f64,
    },
    /// A query has found its node.
    Found {
        /// The node, which becomes the current one.
        node: NodeId,
    },
    /// The algorithm ends.
    End(End),
}
