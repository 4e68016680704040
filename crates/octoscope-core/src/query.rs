//! What can be asked of a tree.

use crate::event::{End, Event, Observer, Outcome};
use crate::geometry::Ray;
use crate::locate::{
    Direction, NeighbourMethod, Reach, locate_by_codes_as_printed, locate_by_comparison,
    locate_region_as_printed, neighbour_as_printed, neighbour_by_tables,
};
use crate::traverse::{Algorithm, Method, Options, Variant, Variants, doubles_suffice};
use crate::tree::{Code, Domain, Tree};
use serde::{Deserialize, Serialize};

/// One question to a tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Query<const D: usize> {
    /// The leaves along the ray.
    Ray {
        /// How they are found.
        algorithm: Algorithm,
        /// Where the search ends.
        options: Options,
        /// How parameters are compared.
        arithmetic: Arithmetic,
    },
    /// The leaf that owns a point.
    Point {
        /// The point, in world units.
        at: [f64; D],
        /// How it is found.
        method: PointMethod,
        /// Rules in another form than the right one.
        variants: Variants,
    },
    /// The smallest node that holds a box.
    Region {
        /// Smallest corner, in world units; inside the box.
        min: [f64; D],
        /// Largest corner, in world units; inside the box.
        max: [f64; D],
        /// Rules in another form than the right one.
        variants: Variants,
    },
    /// The neighbour of a node.
    Neighbour {
        /// Level of the node.
        level: u8,
        /// Code of the node. A place without a node of this level means the
        /// leaf that covers it.
        code: Code<D>,
        /// Where the neighbour lies.
        direction: Direction<D>,
        /// How large it may be.
        reach: Reach,
        /// How it is found.
        method: NeighbourMethod,
        /// Rules in another form than the right one.
        variants: Variants,
    },
}

/// In which numbers parameters are compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Arithmetic {
    /// Double precision: only slivers may differ from the exact result. Rays
    /// from so far away, or of such a speed, that doubles lose more than
    /// slivers are compared exactly, see [`doubles_suffice`].
    #[default]
    Doubles,
    /// Exactly, for any finite input.
    Exact,
}

/// How a point is located.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PointMethod {
    /// By its location codes.
    #[default]
    Codes,
    /// By comparing it with mid planes.
    Comparison,
}

impl<const D: usize> Default for Query<D> {
    fn default() -> Self {
        Self::Ray {
            algorithm: Algorithm::default(),
            options: Options::default(),
            arithmetic: Arithmetic::default(),
        }
    }
}

impl<const D: usize> Query<D> {
    /// Whether parameters on `ray` are compared exactly, be it that this is asked
    /// for or that doubles do not suffice.
    pub fn is_exact(&self, domain: &Domain<D>, ray: &Ray<D>) -> bool {
        let Self::Ray { algorithm, arithmetic, .. } = *self else { return false };
        if algorithm == Algorithm::Exhaustive {
            return true;
        }
        let suffice = arithmetic == Arithmetic::Doubles && doubles_suffice(domain, ray);
        !suffice && !self.variants_at_work().iter().any(Variant::is_about_doubles)
    }

    /// The leaves along the ray by this method; of other options, those of this
    /// question, if it is about the ray, else the usual ones.
    pub fn along_the_ray_by(self, method: Method) -> Self {
        let Method { algorithm, variants } = method;
        let (options, arithmetic) = match self {
            Self::Ray { options, arithmetic, .. } => (options, arithmetic),
            Self::Point { .. } | Self::Region { .. } | Self::Neighbour { .. } => Default::default(),
        };
        Self::Ray { algorithm, options: Options { variants, ..options }, arithmetic }
    }

    /// The same question with every rule in its right form.
    pub fn corrected(self) -> Self {
        self.with_variants(Variants::NONE)
    }

    /// The same question with just these rules in another form.
    pub fn with_variants(self, variants: Variants) -> Self {
        match self {
            Self::Ray { algorithm, options, arithmetic } => {
                let options = Options { variants, ..options };
                Self::Ray { algorithm, options, arithmetic }
            }
            Self::Point { at, method, .. } => Self::Point { at, method, variants },
            Self::Region { min, max, .. } => Self::Region { min, max, variants },
            Self::Neighbour { level, code, direction, reach, method, .. } => {
                Self::Neighbour { level, code, direction, reach, method, variants }
            }
        }
    }

    /// The same search along the ray by another algorithm, with the variants that this has, too:
    /// those of another mean nothing. Other queries stay as they are.
    pub fn with_algorithm(self, algorithm: Algorithm) -> Self {
        match self {
            Self::Ray { options, arithmetic, .. } => {
                let own = options.variants.iter().filter(|variant| variant.belongs_to(algorithm));
                let options = Options { variants: own.collect(), ..options };
                Self::Ray { algorithm, options, arithmetic }
            }
            Self::Point { .. } | Self::Region { .. } | Self::Neighbour { .. } => self,
        }
    }

    /// The rules that are not in their right form.
    pub fn variants(&self) -> Variants {
        match *self {
            Self::Ray { options: Options { variants, .. }, .. }
            | Self::Point { variants, .. }
            | Self::Region { variants, .. }
            | Self::Neighbour { variants, .. } => variants,
        }
    }

    /// Those of them that the query has a rule for. The others do nothing.
    pub fn variants_at_work(&self) -> Variants {
        self.variants().iter().filter(|&variant| self.takes(variant)).collect()
    }

    /// Whether it follows a rule of the paper as it is printed.
    pub fn is_misprinted(&self) -> bool {
        self.variants_at_work().iter().any(Variant::is_misprint)
    }

    /// Whether what is looked for beyond a border is a cell as large as the one that is left;
    /// else it is the smallest one there.
    pub fn looks_for_equal_size(&self) -> bool {
        matches!(self, Self::Ray { algorithm: Algorithm::Esvo, .. })
    }

    /// Whether the query has the rule; variants of other rules do nothing.
    pub fn takes(&self, variant: Variant) -> bool {
        use Variant::{B18, B19, B21, B24a, B24b, B24c, B25Leftmost, B25Rightmost, B28};
        match self {
            Self::Ray { algorithm, .. } => {
                variant.belongs_to(*algorithm) && variant.is_of_dimension(D)
            }
            Self::Point { method: PointMethod::Codes, .. } => matches!(variant, B18 | B19 | B21),
            Self::Region { .. } => matches!(variant, B24a | B24b | B24c),
            Self::Neighbour { method: NeighbourMethod::Codes, .. } => {
                matches!(variant, B25Leftmost | B25Rightmost | B28)
            }
            Self::Point { method: PointMethod::Comparison, .. }
            | Self::Neighbour { method: NeighbourMethod::Tables, .. } => false,
        }
    }

    /// Runs the query in `tree`; `ray` is used by [`Query::Ray`].
    pub fn run(&self, tree: &Tree<D>, ray: &Ray<D>, observe: &mut impl Observer<D>) -> Outcome {
        match *self {
            Self::Ray { algorithm, options, .. } => {
                let variants = self.variants_at_work();
                let options = Options { variants, ..options };
                if self.is_exact(tree.domain(), ray) {
                    algorithm.run_exactly(tree, ray, options, observe)
                } else {
                    algorithm.run::<D, f64>(tree, ray, options, observe)
                }
            }
            Self::Point { at, method: PointMethod::Codes, variants } => {
                locate_by_codes_as_printed(tree, at, variants, observe)
            }
            Self::Point { at, method: PointMethod::Comparison, .. } => {
                locate_by_comparison(tree, at, observe)
            }
            Self::Region { min, max, variants } => {
                locate_region_as_printed(tree, min, max, variants, observe)
            }
            Self::Neighbour { level, code, direction, reach, method, variants } => {
                let Some(node) = tree.node_at(level, code) else {
                    observe.observe(Event::End(End::Outside));
                    return Outcome::without_node(End::Outside);
                };
                match method {
                    NeighbourMethod::Codes => {
                        neighbour_as_printed(tree, node.id, direction, reach, variants, observe)
                    }
                    NeighbourMethod::Tables => {
                        neighbour_by_tables(tree, node.id, direction, reach, observe)
                    }
                }
            }
        }
    }
}
