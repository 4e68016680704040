//! Rules of algorithms in another form than the one that is right.

use super::Algorithm;
use serde::{Deserialize, Serialize};
use std::fmt;
use thiserror::Error;

/// Another form of one rule of an algorithm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(try_from = "String", into = "&'static str")]
pub enum Variant {
    /// Of planes that are met at once only one is crossed, and comparisons are
    /// strict, so that cells are touched on the way [Revelles 2000; Amanatides,
    /// Woo 1987].
    OneByOne,
    /// The parameter of a mid plane is the mean of those of the near and the far
    /// plane [Revelles 2000, eq. 13], rounding included.
    Averaged,
    /// From the exit point half a smallest cell along the normal of the exit
    /// face, instead of on by codes [Glassner 1984].
    Push,
    /// Near and far half as in the gem, which does not settle equal parameters
    /// [Sung, Shirley 1992].
    Gem,
}

/// No variant has this name.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("there is no variant ‘{0}’; see ‘octoscope scenes’ for those of every algorithm")]
pub struct UnknownVariant(pub String);

impl Variant {
    /// All variants.
    pub const ALL: [Self; 4] = [Self::OneByOne, Self::Averaged, Self::Push, Self::Gem];

    /// Name on the command line and in files.
    pub fn id(self) -> &'static str {
        match self {
            Self::OneByOne => "one-by-one",
            Self::Averaged => "averaged",
            Self::Push => "push",
            Self::Gem => "gem",
        }
    }

    /// Whether the variant is about doubles, so that it runs in them even where
    /// exact comparisons are asked for.
    pub fn is_about_doubles(self) -> bool {
        match self {
            Self::OneByOne => false,
            Self::Averaged | Self::Push | Self::Gem => true,
        }
    }

    /// Whether a traversal has the rule.
    pub fn belongs_to(self, algorithm: Algorithm) -> bool {
        use Algorithm::{Bsp, Dda, DdaOctree, Glassner, Parametric, ParametricTable};
        match self {
            Self::OneByOne => matches!(algorithm, Parametric | Dda | DdaOctree),
            Self::Averaged => matches!(algorithm, Parametric | ParametricTable),
            Self::Push => algorithm == Glassner,
            Self::Gem => algorithm == Bsp,
        }
    }
}

impl From<Variant> for &'static str {
    fn from(variant: Variant) -> Self {
        variant.id()
    }
}

impl TryFrom<String> for Variant {
    type Error = UnknownVariant;

    fn try_from(id: String) -> Result<Self, UnknownVariant> {
        id.parse()
    }
}

impl std::str::FromStr for Variant {
    type Err = UnknownVariant;

    fn from_str(id: &str) -> Result<Self, UnknownVariant> {
        let found = Self::ALL.into_iter().find(|variant| variant.id() == id);
        found.ok_or_else(|| UnknownVariant(id.to_owned()))
    }
}

/// Set of variants.
#[derive(Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(from = "Vec<Variant>", into = "Vec<Variant>")]
pub struct Variants(u64);

impl Variants {
    /// Every rule in its right form.
    pub const NONE: Self = Self(0);

    /// Whether `variant` is in the set.
    #[inline]
    pub fn has(self, variant: Variant) -> bool {
        self.0 >> variant as u32 & 1 == 1
    }

    /// The set with `variant`.
    pub fn with(self, variant: Variant) -> Self {
        Self(self.0 | 1 << variant as u32)
    }

    /// The set without `variant`.
    pub fn without(self, variant: Variant) -> Self {
        Self(self.0 & !(1 << variant as u32))
    }

    /// Whether the set is empty.
    pub fn is_empty(&self) -> bool {
        *self == Self::NONE
    }

    /// The variants in the set.
    pub fn iter(self) -> impl Iterator<Item = Variant> {
        Variant::ALL.into_iter().filter(move |&variant| self.has(variant))
    }
}

impl FromIterator<Variant> for Variants {
    fn from_iter<I: IntoIterator<Item = Variant>>(variants: I) -> Self {
        variants.into_iter().fold(Self::NONE, Self::with)
    }
}

impl From<Vec<Variant>> for Variants {
    fn from(variants: Vec<Variant>) -> Self {
        variants.into_iter().collect()
    }
}

impl From<Variants> for Vec<Variant> {
    fn from(variants: Variants) -> Self {
        variants.iter().collect()
    }
}

impl fmt::Debug for Variants {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.iter()).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_hold_what_is_put_in() {
        let set = Variants::NONE.with(Variant::Gem).with(Variant::Averaged);
        assert_eq!(set.iter().collect::<Vec<_>>(), [Variant::Averaged, Variant::Gem]);
        assert!(!set.without(Variant::Gem).has(Variant::Gem));
        for variant in Variant::ALL {
            assert_eq!(variant.id().parse(), Ok(variant));
            assert_eq!(Variants::NONE.with(variant).without(variant), Variants::NONE);
        }
    }

    #[test]
    fn every_variant_belongs_to_some_algorithm() {
        for variant in Variant::ALL {
            let belongs = |algorithm: &Algorithm| variant.belongs_to(*algorithm);
            assert!(Algorithm::ALL.iter().any(belongs), "{variant:?}");
        }
    }
}
