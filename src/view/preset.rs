//! The panels, and which of them stand beside the space view.

use octoscope_core::locate::NeighbourMethod;
use octoscope_core::query::Query;
use octoscope_core::traverse::Algorithm;
use serde::{Deserialize, Serialize};

/// Selection of panels beside the space view.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
pub enum Preset {
    /// Codes of nodes and points, bit by bit.
    Bits,
    /// Parameters on their common axis.
    #[default]
    Rail,
    /// States and tables.
    Automaton,
    /// Listing, variables, stack, counters.
    Debug,
    /// All algorithms on the same ray.
    Compare,
    /// Large picture, large sentence, one panel.
    Lecture,
    /// The tree as a diagram, and what rules children out.
    Tree,
    /// Many rays at once.
    Map,
}

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
    pub const ALL: [Self; 21] = [
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
            Self::Grid => "panel-grid",
            Self::Compare => "panel-compare",
            Self::Paper => "panel-paper",
            Self::Tree => "panel-tree",
            Self::WhyNot => "panel-why-not",
            Self::Map => "panel-map",
        }
    }
}

impl Preset {
    /// All presets, in the order of their keys.
    pub const ALL: [Self; 8] = [
        Self::Bits,
        Self::Rail,
        Self::Automaton,
        Self::Debug,
        Self::Compare,
        Self::Lecture,
        Self::Tree,
        Self::Map,
    ];

    /// The panels from top to bottom, for a query: those that have nothing to
    /// say about it give way to the one that explains it.
    pub fn panels<const D: usize>(self, query: &Query<D>) -> Vec<PanelKind> {
        use PanelKind::{
            Automaton, Children, Codes, Compare, Counters, Cuts, Grid, Halves, Links, Listing, Map,
            Neighbour, Paper, Rail, Region, Stack, Tables, Tree, Variables, WayDown, WhyNot,
        };
        let own = own_panel(query);
        let about_rays = matches!(query, Query::Ray { .. });
        let chosen: &[PanelKind] = match self {
            // The path through the tree is what the codes say, bit by bit.
            Self::Bits if matches!(own, None | Some(Codes)) => &[Codes, Tree, Counters],
            Self::Bits => &[Codes, Neighbour, Counters],
            // In space, rail and automaton fill a side each.
            Self::Rail if D == 2 => &[Rail, Automaton, Codes, Counters],
            // Its sums need all the room.
            Self::Rail if own == Some(Neighbour) && about_rays => &[Rail],
            Self::Rail if own.is_none() || own == Some(Neighbour) => &[Rail, Codes, Counters],
            // What is peculiar to the algorithm takes the place of the codes.
            Self::Rail => &[Rail, Counters],
            Self::Automaton if D == 2 => &[Automaton, Rail, Counters],
            Self::Automaton => &[Automaton, Rail],
            Self::Debug => &[Listing, Variables, Stack, Counters],
            Self::Compare if about_rays => &[Compare],
            Self::Compare => &[Counters],
            // The algorithm's own panel, if it has one.
            Self::Lecture if own.is_some() => &[],
            // Its rail has no planes.
            Self::Lecture if is_by_codes(query) => &[Codes],
            Self::Lecture => &[Rail],
            Self::Tree => &[Tree, WhyNot],
            Self::Map => &[Map, Counters],
        };
        let has_states = matches!(
            query,
            Query::Ray { algorithm: Algorithm::Parametric | Algorithm::ParametricTable, .. }
        );
        let has_stack = match query {
            Query::Ray { algorithm, .. } => is_top_down(*algorithm),
            Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => false,
        };
        let says_something = |kind: &PanelKind| match kind {
            Rail | Compare | Map => about_rays,
            Automaton => has_states,
            Stack => has_stack,
            Region | Neighbour | Tables | Cuts | Children | WayDown | Links | Halves | Grid => {
                own == Some(*kind)
            }
            // Beside these there is no room for them.
            Codes => self != Self::Rail || !matches!(own, Some(Tables | Halves)),
            WhyNot => matches!(query, Query::Ray { .. } | Query::Point { .. }),
            Listing | Variables | Counters | Paper | Tree => true,
        };
        let mut panels: Vec<_> = chosen.iter().copied().filter(says_something).collect();
        if let Some(own) = own.filter(|own| !panels.contains(own))
            && !matches!(self, Self::Debug | Self::Tree | Self::Map)
        {
            panels.insert(usize::from(about_rays).min(panels.len()), own);
            // What waits on the stack is half of what its panel shows.
            if own == Halves && self != Self::Lecture {
                panels.insert(2.min(panels.len()), Stack);
            }
        }
        if query.is_misprinted() {
            if self == Self::Lecture {
                panels.clear();
            }
            panels.insert(0, Paper);
        }
        panels
    }

    /// Least height of type, in points of the window: in a lecture, of the 20 points
    /// that are read from the back row what its scale leaves; else 0.
    pub fn least_type(self) -> f32 {
        if self == Self::Lecture { 20.0 / self.scale() } else { 0.0 }
    }

    /// Factor of type and lines.
    pub fn scale(self) -> f32 {
        match self {
            Self::Lecture => 1.6,
            Self::Bits
            | Self::Rail
            | Self::Automaton
            | Self::Debug
            | Self::Compare
            | Self::Tree
            | Self::Map => 1.0,
        }
    }
}

/// The panel that shows what is peculiar to a query and its algorithm.
fn own_panel<const D: usize>(query: &Query<D>) -> Option<PanelKind> {
    match query {
        Query::Ray { algorithm, .. } => match algorithm {
            Algorithm::Parametric
            | Algorithm::ParametricTable
            | Algorithm::Esvo
            | Algorithm::Exhaustive => None,
            Algorithm::AllChildren => Some(PanelKind::Children),
            Algorithm::Hero | Algorithm::Gargantini => Some(PanelKind::Cuts),
            Algorithm::Codes => Some(PanelKind::Neighbour),
            Algorithm::Glassner => Some(PanelKind::WayDown),
            Algorithm::Samet | Algorithm::SametCorner => Some(PanelKind::Tables),
            Algorithm::SametNet => Some(PanelKind::Links),
            Algorithm::Bsp => Some(PanelKind::Halves),
            Algorithm::Dda | Algorithm::DdaOctree => Some(PanelKind::Grid),
        },
        Query::Point { .. } => Some(PanelKind::Codes),
        Query::Region { .. } => Some(PanelKind::Region),
        Query::Neighbour { method, .. } => Some(match method {
            NeighbourMethod::Codes => PanelKind::Neighbour,
            NeighbourMethod::Tables => PanelKind::Tables,
        }),
    }
}

/// Whether the ray goes on from the codes of the node that it leaves.
fn is_by_codes<const D: usize>(query: &Query<D>) -> bool {
    matches!(query, Query::Ray { algorithm: Algorithm::Esvo, .. })
}

/// Whether an algorithm keeps a stack of nodes.
fn is_top_down(algorithm: Algorithm) -> bool {
    match algorithm {
        Algorithm::Parametric
        | Algorithm::ParametricTable
        | Algorithm::Esvo
        | Algorithm::AllChildren
        | Algorithm::Hero
        | Algorithm::Gargantini
        | Algorithm::Bsp => true,
        Algorithm::Codes
        | Algorithm::Glassner
        | Algorithm::Samet
        | Algorithm::SametCorner
        | Algorithm::SametNet
        | Algorithm::Dda
        | Algorithm::DdaOctree
        | Algorithm::Exhaustive => false,
    }
}
