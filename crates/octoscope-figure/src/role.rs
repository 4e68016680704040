//! What a mark means. Looks follow from it, and only from it.

mod class;
mod layers;

/// Meaning of a mark.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Role {
    /// Outline of the root.
    Root,
    /// A leaf without contents.
    EmptyLeaf,
    /// A leaf with contents.
    FullLeaf,
    /// An inner node off the path.
    InnerNode,
    /// A node off the path, where such nodes are but hinted at.
    FaintNode,
    /// Where a slice meets a node without contents.
    EmptySection,
    /// Where a slice meets a leaf with contents.
    FullSection,
    /// A child of the current node, moved away from the others.
    Apart,
    /// The one of them that is taken, or from which the algorithm comes back.
    ApartTaken,
    /// From the place of a child to where it is moved.
    Tie,
    /// A node of the path as the algorithm mirrors it.
    MirroredNode,
    /// Side of a cell that the cell does not own.
    OpenSide,
    /// Face of a cell that the cell owns.
    OwnedFace,
    /// Mean colour of a leaf of an image, red, green, blue.
    Pixel([u8; 3]),
    /// A point in the tree.
    Content,
    /// A solid in the tree: a sphere, box or triangle.
    Solid,
    /// A node above the current one.
    Ancestor {
        /// Number of levels above the current node; 1 is its parent.
        above: u8,
    },
    /// The node at which the algorithm is.
    Current,
    /// The child of the current node that is taken, or from which the algorithm comes back.
    Taken,
    /// A child of the current node that is not taken.
    Rejected,
    /// A leaf on the ray.
    Visited {
        /// Where along the ray it begins: 0 where the ray enters the root, 1
        /// where it leaves.
        share: f64,
    },
    /// A node that a misprint has reported although it is not right; crossed out.
    Strayed,
    /// Number of a visited leaf in the order of the ray.
    OrderNumber,
    /// A leaf that the ray meets in one point, and the point.
    Touch,
    /// A leaf that was tested and is not on the ray.
    Missed,
    /// A leaf or node that would be right where a misprint is followed.
    Expected,
    /// The node that a query has found.
    Found,
    /// The point that is located.
    QueryPoint,
    /// The box that is located.
    Region,
    /// The cell that is looked for beyond the border that is crossed.
    Target,
    /// Direction to a neighbour.
    Direction,
    /// Part of a node that waits on a stack.
    Pending,
    /// Cell of the finest grid through which an algorithm walks.
    GridCell,
    /// From a node up to its parent, on the way to a neighbour.
    WayUp,
    /// Down again, mirrored.
    WayDown,
    /// Along a link to a neighbour.
    Link,
    /// From an exit point out of the leaf.
    Push,
    /// Where the ray crosses a mid plane, across an axis, 0 = x.
    Cut(usize),
    /// The ray.
    Ray,
    /// Handle on the ray's origin.
    RayOrigin,
    /// Handle on the ray's tip.
    RayTip,
    /// How far away the origin of the ray is, where it begins beyond the page.
    RayAway,
    /// What of the ray lies beyond the end that it is asked up to.
    RayBeyond,
    /// The ray as the algorithm mirrors it.
    MirroredRay,
    /// Where that begins.
    MirroredOrigin,
    /// The ray as a misprint mirrors it.
    MirroredWrongly,
    /// What was there before a change, or what is being drawn.
    Ghost,
    /// The node under the pointer, in whichever view.
    Hover,
    /// The side of it that is pointed at.
    HoverSide,
    /// Where the ray enters the current node.
    EntryPoint,
    /// Where the ray leaves the current node.
    ExitPoint,
    /// Middle plane of the current node across an axis, 0 = x.
    MidPlane(usize),
    /// Plane through which a cell is left, across an axis, 0 = x.
    ExitPlane(usize),
    /// Index of a child, written into it.
    ChildIndex,
    /// Location code of a cell, written into it.
    CellCode,
    /// Side of a cell that the cell owns.
    OwnedSide,
    /// Name or number on an axis, 0 = x.
    AxisLabel(usize),
    /// Heading of a part of a figure.
    Heading,
    /// Words in a figure.
    Words,
    /// Quiet words: captions, units, heads of columns.
    Note,
    /// Code and other text in which columns matter.
    Code,
    /// A bit of a code.
    Bit,
    /// Field of a table or a bit.
    Entry,
    /// Field that the step is about.
    LitEntry,
    /// Row or column in which that field lies.
    LitLine,
    /// Line under a sum or the head of a table.
    Rule,
    /// Interval of t in which the ray is in a node.
    Inside,
    /// Where that interval begins and ends.
    Limit,
    /// The axis of t, and what is written at it.
    Scale,
    /// Where t is 0: the origin of the ray.
    Zero,
    /// State of an automaton.
    State,
    /// The state that it is in.
    StateNow,
    /// The state that it goes to.
    StateNext,
    /// Transition through several planes at once, as it happens.
    TransitionTogether,
    /// Work that is done.
    Spent,
    /// Work of the whole run.
    Planned,
    /// Work of others, beside the least.
    Compared,
    /// Line of an algorithm in a chart, by its number among all.
    Series(usize),
    /// What was at hand, or guessed right.
    Hit,
    /// What had to be fetched, or was guessed wrong.
    Miss,
    /// Frame round the bit that tells whether a code has left the domain.
    BorderBit,
    /// Arrow to what follows from a bit, and what is written at it.
    Conclusion,
    /// Field that is to be filled in by hand.
    Blank,
    /// Where the ray is between the planes across an axis, 0 = x.
    Bar(usize),
    /// Parameter of a plane across an axis, 0 = x.
    Stop(usize),
    /// Transition of an automaton through a plane across an axis, 0 = x.
    Transition(usize),
    /// Such a transition as it happens.
    TransitionTaken(usize),
    /// A level of a diagram, and its number.
    Level,
    /// Branch of a diagram to a child, and what is written beside it.
    Branch,
    /// Branch on the way that the algorithm has taken.
    Path,
    /// A node of a diagram.
    Node,
    /// Ground below letters that stand on lines.
    Ground,
    /// A formula, so many steps smaller than the largest.
    Formula(u8),
    /// Bar of a fraction, or a bracket.
    FormulaLine,
}

impl Role {
    /// Colours that lines of a chart have in turn; after them come other dashes.
    pub const N_SERIES_COLOURS: usize = 5;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn classes_differ_and_are_plain() {
        let mut classes: Vec<_> = Role::KINDS.iter().map(|role| role.class()).collect();
        assert!(classes.iter().all(|c| c.chars().all(|c| c.is_ascii_alphanumeric() || c == '-')));
        classes.sort_unstable();
        classes.dedup();
        assert_eq!(classes.len(), Role::KINDS.len());
    }

    #[test]
    fn the_current_node_lies_above_its_ancestors_and_the_ray_above_it() {
        let [ancestor, current, ray] =
            [Role::Ancestor { above: 7 }, Role::Current, Role::Ray].map(Role::layer);
        assert!(ancestor < current && current < ray);
        assert_eq!(Role::AxisLabel(2).layer(), Role::AxisLabel(0).layer());
    }
}
