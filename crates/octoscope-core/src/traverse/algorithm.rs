//! The algorithms by name.

use super::{codes, exhaustive, parametric, parametric_table};
use crate::event::{Observer, Outcome};
use crate::geometry::{Parameter, Ray};
use crate::tree::Tree;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A ray traversal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Algorithm {
    /// Parametric, by one rule instead of tables.
    #[default]
    Parametric,
    /// Parametric, by Tables 1 to 3 as corrected.
    ParametricTable,
    /// By location codes, bottom-up [Frisken, Perry 2002, §6].
    Codes,
    /// Every leaf tested exactly: the oracle.
    Exhaustive,
}

/// What a traversal is asked to do beside finding the leaves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default, rename_all = "kebab-case")]
pub struct Options {
    /// Where the traversal ends.
    pub stop_at: StopAt,
}

/// Where a traversal ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum StopAt {
    /// Where the ray leaves the root.
    #[default]
    End,
    /// At the first leaf with something in it.
    FirstFull,
}

/// No algorithm has this name.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error(
    "there is no algorithm ‘{0}’; there are parametric, parametric-table, codes and exhaustive"
)]
pub struct UnknownAlgorithm(pub String);

impl Algorithm {
    /// All algorithms, the reference first.
    pub const ALL: [Self; 4] =
        [Self::Parametric, Self::ParametricTable, Self::Codes, Self::Exhaustive];

    /// Name on the command line and in files.
    pub fn id(self) -> &'static str {
        match self {
            Self::Parametric => "parametric",
            Self::ParametricTable => "parametric-table",
            Self::Codes => "codes",
            Self::Exhaustive => "exhaustive",
        }
    }

    /// The leaves of `tree` along `ray`, told to `observe`; comparisons of
    /// parameters are made in `P`, doubles or exact. The oracle is always exact.
    pub fn run<const D: usize, P: Parameter>(
        self,
        tree: &Tree<D>,
        ray: &Ray<D>,
        options: Options,
        observe: &mut impl Observer<D>,
    ) -> Outcome {
        match self {
            Self::Parametric => parametric::traverse::<D, P>(tree, ray, options, observe),
            Self::ParametricTable => {
                parametric_table::traverse::<D, P>(tree, ray, options, observe)
            }
            Self::Codes => codes::traverse::<D, P>(tree, ray, options, observe),
            Self::Exhaustive => exhaustive::traverse(tree, ray, options, observe),
        }
    }
}

impl std::str::FromStr for Algorithm {
    type Err = UnknownAlgorithm;

    fn from_str(id: &str) -> Result<Self, UnknownAlgorithm> {
        let found = Self::ALL.into_iter().find(|algorithm| algorithm.id() == id);
        found.ok_or_else(|| UnknownAlgorithm(id.to_owned()))
    }
}
