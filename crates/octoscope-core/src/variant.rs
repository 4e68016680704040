//! Rules of algorithms in another form than the one that is right.

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
    /// An interval is the hull of the slabs instead of what they have in common:
    /// t_min is the earliest near plane, t_max the latest far plane [Kirschmann,
    /// eq. 12].
    B1,
    /// Table 2 with the bits of x and z interchanged; in space [Kirschmann,
    /// Table 2; Revelles 2000].
    B2,
    /// Table 2 as printed, which is right if children are numbered x + 2y + 4z, with
    /// Table 3 and the mirror mask, which number them 4x + 2y + z; in space [Kirschmann,
    /// Table 2, read as Morton order].
    B2Morton,
    /// The selection of children with q1 in either branch, t_y1 for t_x1 and no
    /// branch for equality; in the plane [Kirschmann, §4.2.1].
    B3,
    /// The mean of the near plane and a plane without an index, read as the near
    /// plane once more [Kirschmann, eq. 13].
    B4,
    /// 0/0 is left open: no number [Kirschmann, eq. 14].
    B5,
    /// Without motion, too, the mid plane is the mean of the near and the far
    /// plane: of −∞ and +∞, no number [Kirschmann, eq. 13 without eq. 15].
    B6,
    /// The origin mirrored by p' = s − p, which is right for a root at 0 only
    /// [Kirschmann, eq. 16].
    B7,
    /// The entry is that of the near planes even if the origin comes later, so
    /// that the last child is never the first [Kirschmann, §4.2.2].
    B9,
    /// Nobody asks for t ≥ 0 [Kirschmann, §4].
    B10,
    /// Closed cells: ≤ instead of <, so that touching is crossing [Kirschmann,
    /// eq. 2, 3, 10, 11].
    B11,
    /// Codes are read with the least significant bit first [Kirschmann, §3].
    B18,
    /// At level k bit k of the codes is read [Kirschmann, §3].
    B19,
    /// Points may lie on the upper faces of the domain [Kirschmann, §3].
    B21,
    /// The level of a region is the number of the first different bit itself
    /// [Kirschmann, §3].
    B24a,
    /// Of the differences of a region the first 1 that all have in common counts
    /// [Kirschmann, §3].
    B24b,
    /// The way to a region is read from the differences of its codes [Kirschmann,
    /// §3].
    B24c,
    /// On the way to a neighbour one climbs until the leftmost digit of the
    /// difference is 0 [Kirschmann, §3].
    B25Leftmost,
    /// On the way to a neighbour one climbs until the rightmost digit of the
    /// difference is 0 [Kirschmann, §3].
    B25Rightmost,
    /// Lower neighbours, too, differ by the side length [Kirschmann, §3].
    B28,
}

/// Printed rules that can be read in two ways.
const READINGS: [[Variant; 2]; 2] =
    [[Variant::B2, Variant::B2Morton], [Variant::B25Leftmost, Variant::B25Rightmost]];

/// No variant has this name.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("there is no variant ‘{0}’; see ‘octoscope scenes’ for those of every algorithm")]
pub struct UnknownVariant(pub String);

impl Variant {
    /// All variants.
    pub const ALL: [Self; 24] = [
        Self::OneByOne,
        Self::Averaged,
        Self::Push,
        Self::Gem,
        Self::B1,
        Self::B2,
        Self::B2Morton,
        Self::B3,
        Self::B4,
        Self::B5,
        Self::B6,
        Self::B7,
        Self::B9,
        Self::B10,
        Self::B11,
        Self::B18,
        Self::B19,
        Self::B21,
        Self::B24a,
        Self::B24b,
        Self::B24c,
        Self::B25Leftmost,
        Self::B25Rightmost,
        Self::B28,
    ];

    /// Name on the command line and in files.
    pub fn id(self) -> &'static str {
        match self {
            Self::OneByOne => "one-by-one",
            Self::Averaged => "averaged",
            Self::Push => "push",
            Self::Gem => "gem",
            Self::B1 => "B-1",
            Self::B2 => "B-2",
            Self::B2Morton => "B-2-morton",
            Self::B3 => "B-3",
            Self::B4 => "B-4",
            Self::B5 => "B-5",
            Self::B6 => "B-6",
            Self::B7 => "B-7",
            Self::B9 => "B-9",
            Self::B10 => "B-10",
            Self::B11 => "B-11",
            Self::B18 => "B-18",
            Self::B19 => "B-19",
            Self::B21 => "B-21",
            Self::B24a => "B-24a",
            Self::B24b => "B-24b",
            Self::B24c => "B-24c",
            Self::B25Leftmost => "B-25-leftmost",
            Self::B25Rightmost => "B-25-rightmost",
            Self::B28 => "B-28",
        }
    }

    /// The other reading of the same printed rule, which excludes this one; `None` where
    /// what is printed can be read in one way only.
    pub fn other_reading(self) -> Option<Self> {
        let both = READINGS.into_iter().find(|both| both.contains(&self))?;
        both.into_iter().find(|reading| *reading != self)
    }

    /// Whether the variant is about doubles, so that it runs in them even where
    /// exact comparisons are asked for.
    pub fn is_about_doubles(self) -> bool {
        self.is_misprint() || matches!(self, Self::Averaged | Self::Push | Self::Gem)
    }

    /// Whether the variant is a misprint: an erratum's rule as printed. Its name
    /// is then that of the erratum.
    pub fn is_misprint(self) -> bool {
        match self {
            Self::OneByOne | Self::Averaged | Self::Push | Self::Gem => false,
            Self::B1
            | Self::B2
            | Self::B2Morton
            | Self::B3
            | Self::B4
            | Self::B5
            | Self::B6
            | Self::B7
            | Self::B9
            | Self::B10
            | Self::B11
            | Self::B18
            | Self::B19
            | Self::B21
            | Self::B24a
            | Self::B24b
            | Self::B24c
            | Self::B25Leftmost
            | Self::B25Rightmost
            | Self::B28 => true,
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
        let found = Self::ALL.into_iter().find(|variant| variant.id().eq_ignore_ascii_case(id));
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

    /// The set without `variant`, or if it was not in there, with it and without the other
    /// reading of the same printed rule.
    pub fn switched(self, variant: Variant) -> Self {
        if self.has(variant) {
            return self.without(variant);
        }
        variant.other_reading().map_or(self, |other| self.without(other)).with(variant)
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
    fn a_printed_rule_is_read_in_one_way_at_a_time() {
        for variant in Variant::ALL {
            let all: Variants = Variant::ALL.into_iter().collect();
            let others = all.switched(variant);
            assert_eq!(others, all.without(variant));
            match variant.other_reading() {
                None => assert_eq!(others.switched(variant), all),
                Some(other) => {
                    assert_eq!(other.other_reading(), Some(variant));
                    assert_eq!(others.switched(variant), all.without(other));
                }
            }
        }
    }
}
