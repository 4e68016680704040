//! The views that can be exported, and the queries that they fit.

use octoscope_core::query::Query;
use octoscope_core::traverse::Algorithm;
use serde::{Deserialize, Serialize};
use std::fmt::{Display, Formatter};
use std::str::FromStr;
use thiserror::Error;

/// What a figure shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FigureView {
    /// The tree, the ray and the state of the algorithm.
    #[default]
    Space,
    /// The same as a diagram of nodes.
    Tree,
    /// States, transitions and tables.
    Automaton,
    /// Parameters t on a common axis.
    TRail,
    /// Location codes, bit by bit.
    Codes,
    /// Region location by XOR.
    Region,
    /// A neighbour's codes, as computed on paper.
    Neighbour,
    /// Pseudocode and variables.
    Listing,
    /// The steps with their sentences.
    Table,
    /// Costs as bars.
    Chart,
    /// What the step computes and compares, as formulas.
    Formula,
    /// Several moments with their sentences.
    Storyboard,
    /// An exercise on paper.
    Worksheet,
}

/// No view has this identifier.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("there is no view ‘{0}’ to export; there are {all}", all = all())]
pub struct UnknownView(pub String);

/// Why a view has nothing to show.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum ViewError {
    /// The view is of another kind of query.
    #[error("the view ‘{view}’ shows {shows}, but the scenario asks for {asked}; {remedy}")]
    Query {
        /// The view.
        view: FigureView,
        /// What it shows.
        shows: &'static str,
        /// What is asked instead.
        asked: String,
        /// What would be right.
        remedy: &'static str,
    },
    /// There will be something at a later step.
    #[error("the view ‘{view}’ has nothing to show after step {step}; it has after step {first}")]
    Step {
        /// The view.
        view: FigureView,
        /// The step that was asked for.
        step: usize,
        /// The first step with something to show.
        first: usize,
    },
    /// No step has anything to show.
    #[error(
        "the view ‘{view}’ has nothing to show in any step of this run; try another algorithm or ray"
    )]
    Never {
        /// The view.
        view: FigureView,
    },
}

impl FigureView {
    /// All views, in the order of menus and lists.
    pub const ALL: [Self; 13] = [
        Self::Space,
        Self::Tree,
        Self::Automaton,
        Self::TRail,
        Self::Codes,
        Self::Region,
        Self::Neighbour,
        Self::Listing,
        Self::Table,
        Self::Chart,
        Self::Formula,
        Self::Storyboard,
        Self::Worksheet,
    ];

    /// Identifier on the command line and in keys of texts.
    pub fn id(self) -> &'static str {
        match self {
            Self::Space => "space",
            Self::Tree => "tree",
            Self::Automaton => "automaton",
            Self::TRail => "t-rail",
            Self::Codes => "codes",
            Self::Region => "region",
            Self::Neighbour => "neighbour",
            Self::Listing => "listing",
            Self::Table => "table",
            Self::Chart => "chart",
            Self::Formula => "formula",
            Self::Storyboard => "storyboard",
            Self::Worksheet => "worksheet",
        }
    }

    /// Whether it shows the tree in space, alone or beside something else.
    pub fn shows_space(self) -> bool {
        match self {
            Self::Space | Self::Storyboard | Self::Worksheet => true,
            Self::Tree
            | Self::Automaton
            | Self::TRail
            | Self::Codes
            | Self::Region
            | Self::Neighbour
            | Self::Listing
            | Self::Table
            | Self::Chart
            | Self::Formula => false,
        }
    }

    /// Whether it tells of all the steps up to one.
    pub fn is_of_the_way(self) -> bool {
        matches!(self, Self::Table | Self::Chart)
    }

    /// Whether it shows one step: a storyboard chooses its own, and a worksheet is
    /// the same at all.
    pub fn is_of_a_step(self) -> bool {
        match self {
            Self::Storyboard | Self::Worksheet => false,
            Self::Space
            | Self::Tree
            | Self::Automaton
            | Self::TRail
            | Self::Codes
            | Self::Region
            | Self::Neighbour
            | Self::Listing
            | Self::Table
            | Self::Chart
            | Self::Formula => true,
        }
    }

    /// Width for which the view is laid out, in page units: with its type in the
    /// size of text, a figure 100 to 160 mm wide.
    pub fn width<const D: usize>(self) -> f64 {
        match self {
            Self::TRail | Self::Codes | Self::Region | Self::Neighbour => 360.0,
            Self::Automaton if D == 2 => 360.0,
            Self::Automaton | Self::Listing | Self::Chart => 420.0,
            Self::Formula => 560.0,
            Self::Space | Self::Tree | Self::Table => 460.0,
            Self::Storyboard | Self::Worksheet => 500.0,
        }
    }

    /// Width for which the view is laid out in a column of this width, if there is one:
    /// texts are broken there, what is drawn keeps its size.
    pub fn width_in<const D: usize>(self, column: Option<f64>) -> f64 {
        let (usual, least) = (self.width::<D>(), 280.0);
        let Some(column) = column else { return usual };
        match self {
            Self::Codes | Self::Region | Self::Neighbour | Self::Automaton => usual,
            Self::Space
            | Self::Tree
            | Self::TRail
            | Self::Listing
            | Self::Table
            | Self::Chart
            | Self::Formula
            | Self::Storyboard
            | Self::Worksheet => column.clamp(least, 1.5 * usual),
        }
    }

    /// Whether a query has what the view shows.
    ///
    /// # Errors
    /// Says which query would be right.
    pub fn fits<const D: usize>(self, query: &Query<D>) -> Result<(), ViewError> {
        let refuse = |shows, remedy| {
            Err(ViewError::Query { view: self, shows, asked: asked(query), remedy })
        };
        match self {
            Self::Space
            | Self::Tree
            | Self::Codes
            | Self::Listing
            | Self::Table
            | Self::Chart
            | Self::Formula
            | Self::Storyboard
            | Self::Worksheet => Ok(()),
            Self::TRail => match query {
                Query::Ray { .. } => Ok(()),
                Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => {
                    refuse("parameters t of a ray", "give a scenario whose query is ‘ray’")
                }
            },
            Self::Automaton => match query {
                Query::Ray {
                    algorithm: Algorithm::Parametric | Algorithm::ParametricTable,
                    ..
                } => Ok(()),
                Query::Ray { .. }
                | Query::Point { .. }
                | Query::Region { .. }
                | Query::Neighbour { .. } => refuse(
                    "the states of the parametric algorithm",
                    "give --algorithm parametric or parametric-table",
                ),
            },
            Self::Region => match query {
                Query::Region { .. } => Ok(()),
                Query::Ray { .. } | Query::Point { .. } | Query::Neighbour { .. } => refuse(
                    "how a region is located",
                    "give a scenario whose query is ‘region’, as the window saves it after a drag \
                     with Shift",
                ),
            },
            Self::Neighbour => match query {
                Query::Neighbour { .. } | Query::Ray { algorithm: Algorithm::Codes, .. } => Ok(()),
                Query::Ray { .. } | Query::Point { .. } | Query::Region { .. } => refuse(
                    "how the codes of a neighbour are computed",
                    "give --algorithm codes, or a scenario whose query is ‘neighbour’",
                ),
            },
        }
    }
}

/// What a query asks for, in the middle of a message.
fn asked<const D: usize>(query: &Query<D>) -> String {
    match query {
        Query::Ray { algorithm, .. } => format!("the leaves along a ray by ‘{}’", algorithm.id()),
        Query::Point { .. } => "the leaf of a point".to_owned(),
        Query::Region { .. } => "the node around a region".to_owned(),
        Query::Neighbour { .. } => "the neighbour of a node".to_owned(),
    }
}

fn all() -> String {
    FigureView::ALL.map(FigureView::id).join(", ")
}

impl Display for FigureView {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.id())
    }
}

impl FromStr for FigureView {
    type Err = UnknownView;

    fn from_str(id: &str) -> Result<Self, UnknownView> {
        let found = Self::ALL.into_iter().find(|view| view.id() == id);
        found.ok_or_else(|| UnknownView(id.to_owned()))
    }
}
