//! The panels beside the space view.

use serde::{Deserialize, Serialize};

/// One panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum PanelKind {
    /// Location codes.
    Codes,
    /// Region location by XOR.
    Region,
    /// Neighbour computation.
    Neighbour,
    /// Parameters t.
    Rail,
    /// States and tables.
    Automaton,
    /// Pseudocode.
    Listing,
    /// Variables.
    Variables,
    /// Nodes on the stack.
    Stack,
    /// Costs.
    Counters,
    /// Tables of neighbours.
    Tables,
    /// Sorted mid planes and the pieces between them.
    Cuts,
    /// Every child, tested one after the other.
    Children,
    /// From the root down again.
    WayDown,
    /// Links between neighbours.
    Links,
    /// A part and the plane that halves it.
    Halves,
    /// Comparisons of a point with mid planes.
    MidPlanes,
    /// Cells of the finest grid.
    Grid,
    /// All algorithms side by side.
    Compare,
    /// Rules as printed against corrected.
    Paper,
    /// The tree as a diagram.
    Tree,
    /// What rules the children of a node out.
    WhyNot,
    /// Many rays at once.
    Map,
}

impl PanelKind {
    /// All panels, in the order of the menu.
    pub const ALL: [Self; 22] = [
        Self::Tree,
        Self::WhyNot,
        Self::Rail,
        Self::Automaton,
        Self::Codes,
        Self::Region,
        Self::Neighbour,
        Self::Listing,
        Self::Variables,
        Self::Stack,
        Self::Counters,
        Self::Tables,
        Self::Cuts,
        Self::Children,
        Self::WayDown,
        Self::Links,
        Self::Halves,
        Self::MidPlanes,
        Self::Grid,
        Self::Compare,
        Self::Paper,
        Self::Map,
    ];

    /// Key of its title in the language files.
    pub fn id(self) -> &'static str {
        match self {
            Self::Codes => "panel-codes",
            Self::Region => "panel-region",
            Self::Neighbour => "panel-neighbour",
            Self::Rail => "panel-t-rail",
            Self::Automaton => "panel-automaton",
            Self::Listing => "panel-listing",
            Self::Variables => "panel-variables",
            Self::Stack => "panel-stack",
            Self::Counters => "panel-counters",
            Self::Tables => "panel-tables",
            Self::Cuts => "panel-cuts",
            Self::Children => "panel-children",
            Self::WayDown => "panel-way-down",
            Self::Links => "panel-links",
            Self::Halves => "panel-halves",
            Self::MidPlanes => "panel-mid-planes",
            Self::Grid => "panel-grid",
            Self::Compare => "panel-compare",
            Self::Paper => "panel-paper",
            Self::Tree => "panel-tree",
            Self::WhyNot => "panel-why-not",
            Self::Map => "panel-map",
        }
    }
}
