//! What a mark means. Looks follow from it, and only from it.

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
    /// The one of them that is taken.
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
    /// The child of the current node that is taken.
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
    /// The smallest cell beyond the border that is crossed.
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
    /// What of the ray lies beyond the end that it is asked up to.
    RayBeyond,
    /// The ray as the algorithm mirrors it.
    MirroredRay,
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
    /// A formula, so many steps smaller than the largest.
    Formula(u8),
    /// Bar of a fraction, or a bracket.
    FormulaLine,
}

/// Classes of the lines of a chart.
const SERIES: [&str; 17] = [
    "series-1",
    "series-2",
    "series-3",
    "series-4",
    "series-5",
    "series-6",
    "series-7",
    "series-8",
    "series-9",
    "series-10",
    "series-11",
    "series-12",
    "series-13",
    "series-14",
    "series-15",
    "series-16",
    "series-17",
];

/// Names of formulas in their sizes, the largest first.
const FORMULAS: [&str; 8] = [
    "formula",
    "formula-1",
    "formula-2",
    "formula-3",
    "formula-4",
    "formula-5",
    "formula-6",
    "formula-7",
];

impl Role {
    /// Colours that lines of a chart have in turn; after them come other dashes.
    pub const N_SERIES_COLOURS: usize = 5;

    /// One role of every kind, in the order in which they cover each other,
    /// the lowest first.
    pub const KINDS: [Self; 129] = [
        Self::Pixel([128; 3]),
        Self::FaintNode,
        Self::InnerNode,
        Self::EmptyLeaf,
        Self::FullLeaf,
        Self::Solid,
        Self::EmptySection,
        Self::FullSection,
        Self::MirroredNode,
        Self::Missed,
        Self::Visited { share: 0.5 },
        Self::Strayed,
        Self::Root,
        Self::Ancestor { above: 3 },
        Self::Ancestor { above: 2 },
        Self::Ancestor { above: 1 },
        Self::Ghost,
        Self::Taken,
        Self::Rejected,
        Self::Content,
        Self::Touch,
        Self::Region,
        Self::Target,
        Self::Pending,
        Self::Current,
        Self::GridCell,
        Self::Found,
        Self::Expected,
        Self::OwnedFace,
        Self::OpenSide,
        Self::OwnedSide,
        Self::Hover,
        Self::HoverSide,
        Self::MidPlane(0),
        Self::MidPlane(1),
        Self::MidPlane(2),
        Self::ExitPlane(0),
        Self::ExitPlane(1),
        Self::ExitPlane(2),
        Self::Tie,
        Self::Apart,
        Self::ApartTaken,
        Self::MirroredRay,
        Self::RayBeyond,
        Self::Ray,
        Self::Direction,
        Self::WayUp,
        Self::WayDown,
        Self::Link,
        Self::Push,
        Self::Cut(0),
        Self::Cut(1),
        Self::Cut(2),
        Self::RayOrigin,
        Self::RayTip,
        Self::EntryPoint,
        Self::ExitPoint,
        Self::QueryPoint,
        Self::CellCode,
        Self::ChildIndex,
        Self::OrderNumber,
        Self::AxisLabel(0),
        Self::Bar(0),
        Self::Bar(1),
        Self::Bar(2),
        Self::Stop(0),
        Self::Stop(1),
        Self::Stop(2),
        Self::Transition(0),
        Self::Transition(1),
        Self::Transition(2),
        Self::TransitionTaken(0),
        Self::TransitionTaken(1),
        Self::TransitionTaken(2),
        Self::Heading,
        Self::Words,
        Self::Note,
        Self::Code,
        Self::Bit,
        Self::Entry,
        Self::LitEntry,
        Self::LitLine,
        Self::Rule,
        Self::Inside,
        Self::Limit,
        Self::Scale,
        Self::Zero,
        Self::State,
        Self::StateNow,
        Self::StateNext,
        Self::TransitionTogether,
        Self::Spent,
        Self::Planned,
        Self::Compared,
        Self::Series(0),
        Self::Series(1),
        Self::Series(2),
        Self::Series(3),
        Self::Series(4),
        Self::Series(5),
        Self::Series(6),
        Self::Series(7),
        Self::Series(8),
        Self::Series(9),
        Self::Series(10),
        Self::Series(11),
        Self::Series(12),
        Self::Series(13),
        Self::Series(14),
        Self::Series(15),
        Self::Series(16),
        Self::Hit,
        Self::Miss,
        Self::BorderBit,
        Self::Conclusion,
        Self::Blank,
        Self::Level,
        Self::Branch,
        Self::Path,
        Self::Node,
        Self::Formula(0),
        Self::Formula(1),
        Self::Formula(2),
        Self::Formula(3),
        Self::Formula(4),
        Self::Formula(5),
        Self::Formula(6),
        Self::Formula(7),
        Self::FormulaLine,
    ];

    /// Name for classes in SVG and styles in TikZ: lower case, with hyphens.
    pub fn class(self) -> &'static str {
        match self {
            Self::Root => "root",
            Self::EmptyLeaf => "empty-leaf",
            Self::FullLeaf => "full-leaf",
            Self::InnerNode => "inner-node",
            Self::FaintNode => "faint-node",
            Self::EmptySection => "empty-section",
            Self::FullSection => "full-section",
            Self::Apart => "apart",
            Self::ApartTaken => "apart-taken",
            Self::Tie => "tie",
            Self::MirroredNode => "mirrored-node",
            Self::OpenSide => "open-side",
            Self::OwnedFace => "owned-face",
            Self::Pixel(_) => "pixel",
            Self::Content => "content",
            Self::Solid => "solid",
            Self::Ancestor { above: 0 | 1 } => "ancestor-1",
            Self::Ancestor { above: 2 } => "ancestor-2",
            Self::Ancestor { above: 3.. } => "ancestor-3",
            Self::Current => "current",
            Self::Taken => "taken",
            Self::Rejected => "rejected",
            Self::Visited { .. } => "visited",
            Self::Strayed => "strayed",
            Self::OrderNumber => "order-number",
            Self::Touch => "touch",
            Self::Missed => "missed",
            Self::Expected => "expected",
            Self::Found => "found",
            Self::QueryPoint => "query-point",
            Self::Region => "region",
            Self::Target => "target",
            Self::Direction => "direction",
            Self::Pending => "pending",
            Self::GridCell => "grid-cell",
            Self::WayUp => "way-up",
            Self::WayDown => "way-down",
            Self::Link => "link",
            Self::Push => "push",
            Self::Cut(axis) => ["cut-x", "cut-y", "cut-z"][axis],
            Self::Ray => "ray",
            Self::RayOrigin => "ray-origin",
            Self::RayTip => "ray-tip",
            Self::RayBeyond => "ray-beyond",
            Self::MirroredRay => "mirrored-ray",
            Self::Ghost => "ghost",
            Self::Hover => "hover",
            Self::HoverSide => "hover-side",
            Self::EntryPoint => "entry-point",
            Self::ExitPoint => "exit-point",
            Self::MidPlane(axis) => ["mid-plane-x", "mid-plane-y", "mid-plane-z"][axis],
            Self::ExitPlane(axis) => ["exit-plane-x", "exit-plane-y", "exit-plane-z"][axis],
            Self::ChildIndex => "child-index",
            Self::CellCode => "cell-code",
            Self::OwnedSide => "owned-side",
            Self::AxisLabel(axis) => ["axis-x", "axis-y", "axis-z"][axis],
            Self::Heading => "heading",
            Self::Words => "words",
            Self::Note => "note",
            Self::Code => "code",
            Self::Bit => "bit",
            Self::Entry => "entry",
            Self::LitEntry => "lit-entry",
            Self::LitLine => "lit-line",
            Self::Rule => "rule",
            Self::Inside => "inside",
            Self::Limit => "limit",
            Self::Scale => "scale",
            Self::Zero => "zero",
            Self::State => "state",
            Self::StateNow => "state-now",
            Self::StateNext => "state-next",
            Self::TransitionTogether => "transition-together",
            Self::Spent => "spent",
            Self::Planned => "planned",
            Self::Compared => "compared",
            Self::Series(number) => SERIES[number % SERIES.len()],
            Self::Hit => "hit",
            Self::Miss => "miss",
            Self::BorderBit => "border-bit",
            Self::Conclusion => "conclusion",
            Self::Blank => "blank",
            Self::Bar(axis) => ["bar-x", "bar-y", "bar-z"][axis],
            Self::Stop(axis) => ["stop-x", "stop-y", "stop-z"][axis],
            Self::Transition(axis) => ["transition-x", "transition-y", "transition-z"][axis],
            Self::TransitionTaken(axis) => {
                ["transition-taken-x", "transition-taken-y", "transition-taken-z"][axis]
            }
            Self::Level => "level",
            Self::Branch => "branch",
            Self::Path => "path",
            Self::Node => "node",
            Self::Formula(step) => FORMULAS[usize::from(step).min(FORMULAS.len() - 1)],
            Self::FormulaLine => "formula-line",
        }
    }

    /// Place among [`Role::KINDS`]: marks with a larger number lie above.
    pub fn layer(self) -> usize {
        let kind = |role: &Self| match (*role, self) {
            (Self::AxisLabel(_), Self::AxisLabel(_)) => true,
            (other, own) => other.class() == own.class(),
        };
        Self::KINDS.iter().position(kind).expect("every role is of one of the kinds")
    }
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
