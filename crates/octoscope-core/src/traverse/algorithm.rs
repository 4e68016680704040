//! The algorithms by name.

use super::variant::{UnknownVariant, Variant, Variants};
use super::{
    all_children, bsp, codes, dda, esvo, exhaustive, gargantini, glassner, hero, parametric,
    parametric_table, samet, samet_corner, samet_net,
};
use crate::event::{Observer, Outcome};
use crate::geometry::{Parameter, Ray};
use crate::tree::Tree;
use serde::{Deserialize, Serialize};
use std::fmt;
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
    /// Parametric without recursion, back up by location codes.
    Esvo,
    /// Every child of every node on the ray is tested.
    AllChildren,
    /// Children in the order of penetration, by mask and sorted mid planes.
    Hero,
    /// Children by sorted cuts and their side of the mid planes.
    Gargantini,
    /// By location codes, bottom-up [Frisken, Perry 2002, §6].
    Codes,
    /// From every exit point down from the root again.
    Glassner,
    /// Neighbours by tables, bottom-up [Samet 1989].
    Samet,
    /// Neighbours by the corner in which all exit planes meet.
    SametCorner,
    /// Neighbours by links between the leaves.
    SametNet,
    /// By the binary tree that emulates the octree [Sung, Shirley 1992].
    Bsp,
    /// Cell by cell on the finest grid [Amanatides, Woo 1987].
    Dda,
    /// Cell by cell on the finest grid, each looked up in the tree.
    DdaOctree,
    /// Every leaf tested exactly: the oracle.
    Exhaustive,
}

/// What a traversal is asked to do beside finding the leaves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default, rename_all = "kebab-case")]
pub struct Options {
    /// Where the traversal ends.
    pub stop_at: StopAt,
    /// Parameter t at which the ray ends, if it does not go on for ever. What is no
    /// finite number ends nothing, see [`Options::end`].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub segment_end: Option<f64>,
    /// Rules in another form than the right one.
    #[serde(skip_serializing_if = "Variants::is_empty")]
    pub variants: Variants,
}

impl Options {
    /// Parameter t at which the ray ends, if it does.
    pub fn end(&self) -> Option<f64> {
        self.segment_end.filter(|end| end.is_finite())
    }
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
#[error("there is no algorithm ‘{0}’; there are {list}", list = all_ids())]
pub struct UnknownAlgorithm(pub String);

fn all_ids() -> String {
    Algorithm::ALL.map(Algorithm::id).join(", ")
}

impl Algorithm {
    /// All algorithms, the reference first, the oracle last.
    pub const ALL: [Self; 15] = [
        Self::Parametric,
        Self::ParametricTable,
        Self::Esvo,
        Self::AllChildren,
        Self::Hero,
        Self::Gargantini,
        Self::Codes,
        Self::Glassner,
        Self::Samet,
        Self::SametCorner,
        Self::SametNet,
        Self::Bsp,
        Self::Dda,
        Self::DdaOctree,
        Self::Exhaustive,
    ];

    /// Name on the command line and in files.
    pub fn id(self) -> &'static str {
        match self {
            Self::Parametric => "parametric",
            Self::ParametricTable => "parametric-table",
            Self::Esvo => "esvo",
            Self::AllChildren => "all-children",
            Self::Hero => "hero",
            Self::Gargantini => "gargantini",
            Self::Codes => "codes",
            Self::Glassner => "glassner",
            Self::Samet => "samet",
            Self::SametCorner => "samet-corner",
            Self::SametNet => "samet-net",
            Self::Bsp => "bsp",
            Self::Dda => "dda",
            Self::DdaOctree => "dda-octree",
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
            Self::Esvo => esvo::traverse::<D, P>(tree, ray, options, observe),
            Self::AllChildren => all_children::traverse::<D, P>(tree, ray, options, observe),
            Self::Hero => hero::traverse::<D, P>(tree, ray, options, observe),
            Self::Gargantini => gargantini::traverse::<D, P>(tree, ray, options, observe),
            Self::Codes => codes::traverse::<D, P>(tree, ray, options, observe),
            Self::Glassner => glassner::traverse::<D, P>(tree, ray, options, observe),
            Self::Samet => samet::traverse::<D, P>(tree, ray, options, observe),
            Self::SametCorner => samet_corner::traverse::<D, P>(tree, ray, options, observe),
            Self::SametNet => samet_net::traverse::<D, P>(tree, ray, options, observe),
            Self::Bsp => bsp::traverse::<D, P>(tree, ray, options, observe),
            Self::Dda => dda::on_grid::<D, P>(tree, ray, options, observe),
            Self::DdaOctree => dda::in_tree::<D, P>(tree, ray, options, observe),
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

/// An algorithm with some rules in another form, as the command line names it:
/// `parametric`, `bsp@gem` or `parametric@averaged,one-by-one`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Method {
    /// The algorithm.
    pub algorithm: Algorithm,
    /// The rules that are not in their right form.
    pub variants: Variants,
}

/// Why a text names no method.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum MethodError {
    /// There is no such algorithm.
    #[error(transparent)]
    Algorithm(#[from] UnknownAlgorithm),
    /// There is no such variant.
    #[error(transparent)]
    Variant(#[from] UnknownVariant),
    /// Several variants without commas between them.
    #[error("several variants stand between commas; give {0}")]
    NoCommas(Method),
    /// The variant is one of another algorithm.
    #[error("‘{variant}’ is no variant of {algorithm}; {list}", list = variants_of(*.algorithm))]
    Stray {
        /// The variant.
        variant: &'static str,
        /// The algorithm that lacks it.
        algorithm: Method,
    },
    /// The variant is one of a rule for trees of the other dimension.
    #[error("‘{variant}’ is a rule for {} alone and changes nothing here; leave it out", trees(*.dimension))]
    OtherDimension {
        /// The variant.
        variant: &'static str,
        /// The dimension whose trees have the rule, 2 or 3.
        dimension: usize,
    },
}

fn trees(dimension: usize) -> &'static str {
    if dimension == 2 { "quadtrees" } else { "octrees" }
}

/// What variants there are instead.
fn variants_of(method: Method) -> String {
    let of_algorithm = |variant: &Variant| variant.belongs_to(method.algorithm);
    let ids: Vec<_> = Variant::ALL.into_iter().filter(of_algorithm).map(Variant::id).collect();
    if ids.is_empty() {
        return "it has none".to_owned();
    }
    format!("it has {}", ids.join(", "))
}

impl Method {
    /// The same, if all its rules are ones of trees of `dimension`, 2 or 3.
    ///
    /// # Errors
    /// Names the first variant of a rule that such trees do not have.
    pub fn in_dimension(self, dimension: usize) -> Result<Self, MethodError> {
        match self.variants.iter().find(|variant| !variant.is_of_dimension(dimension)) {
            None => Ok(self),
            Some(variant) => {
                Err(MethodError::OtherDimension { variant: variant.id(), dimension: 5 - dimension })
            }
        }
    }
}

impl From<Algorithm> for Method {
    fn from(algorithm: Algorithm) -> Self {
        Self { algorithm, variants: Variants::NONE }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.algorithm.id())?;
        for (n, variant) in self.variants.iter().enumerate() {
            write!(f, "{}{}", if n == 0 { '@' } else { ',' }, variant.id())?;
        }
        Ok(())
    }
}

impl std::str::FromStr for Method {
    type Err = MethodError;

    fn from_str(text: &str) -> Result<Self, MethodError> {
        let (id, rest) = text.split_once('@').map_or((text, None), |(id, rest)| (id, Some(rest)));
        let algorithm: Algorithm = id.parse()?;
        let mut variants = Variants::NONE;
        for id in rest.into_iter().flat_map(|rest| rest.split(',')) {
            let variant: Variant = match id.trim().parse() {
                Ok(variant) => variant,
                Err(unknown) => {
                    return Err(several(rest.unwrap_or_default())
                        .map_or(unknown.into(), |several| {
                            MethodError::NoCommas(Self { algorithm, variants: several })
                        }));
                }
            };
            if !variant.belongs_to(algorithm) {
                let algorithm = algorithm.into();
                return Err(MethodError::Stray { variant: variant.id(), algorithm });
            }
            variants = variants.with(variant);
        }
        Ok(Self { algorithm, variants })
    }
}

/// The variants of a text that has something else than commas between them.
fn several(text: &str) -> Option<Variants> {
    let ids = text.split([',', '@', '+', ';', '/', ' ']).filter(|id| !id.is_empty());
    let all =
        ids.map(|id| id.parse().ok()).try_fold(Variants::NONE, |all, one| Some(all.with(one?)));
    all.filter(|all| !all.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_read_back() {
        for text in ["parametric", "bsp@gem", "parametric@one-by-one,averaged"] {
            assert_eq!(text.parse::<Method>().unwrap().to_string(), text);
        }
    }

    #[test]
    fn what_is_no_method_is_named_with_what_there_is() {
        let message = |text: &str| text.parse::<Method>().unwrap_err().to_string();
        assert!(message("fast").starts_with("there is no algorithm ‘fast’; there are parametric,"));
        assert!(message("bsp@fast").starts_with("there is no variant ‘fast’"));
        let commas = "several variants stand between commas; give parametric@B-1,B-3";
        assert_eq!(message("parametric@B-1@B-3"), commas);
        assert_eq!(message("parametric@B-1+B-3"), commas);
        assert!(message("parametric@B-1+no").starts_with("there is no variant ‘B-1+no’"));
        assert_eq!(message("bsp@push"), "‘push’ is no variant of bsp; it has gem");
        assert_eq!(message("hero@gem"), "‘gem’ is no variant of hero; it has none");
    }

    #[test]
    fn rules_of_the_other_dimension_are_refused() {
        let method: Method = "parametric@B-1,B-2".parse().unwrap();
        assert_eq!(method.in_dimension(3), Ok(method));
        assert_eq!(
            method.in_dimension(2).unwrap_err().to_string(),
            "‘B-2’ is a rule for octrees alone and changes nothing here; leave it out"
        );
    }
}
