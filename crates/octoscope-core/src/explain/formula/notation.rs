//! The notations of the papers.

use super::term::Sign;
use serde::{Deserialize, Serialize};
use std::fmt::{Display, Formatter};
use std::str::FromStr;
use thiserror::Error;

/// How quantities are named and operations are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Notation {
    /// As in "Ray Tracing mit Octrees": maxima as lists, `xor`, `and`, `or` of bits as words.
    #[default]
    Seed,
    /// As Revelles, Ureña and Lastra write: parameters are functions of a node.
    Revelles,
    /// As Frisken and Perry write: operations on bits, children as x + 2y + 4z.
    FriskenPerry,
}

/// No notation has this identifier.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("there is no notation ‘{0}’; there are seed, revelles, frisken-perry")]
pub struct UnknownNotation(pub String);

impl Notation {
    /// All notations, in the order in which they follow each other.
    pub const ALL: [Self; 3] = [Self::Seed, Self::Revelles, Self::FriskenPerry];

    /// Identifier on the command line and in keys of texts.
    pub fn id(self) -> &'static str {
        match self {
            Self::Seed => "seed",
            Self::Revelles => "revelles",
            Self::FriskenPerry => "frisken-perry",
        }
    }

    /// Exclusive or.
    pub(super) fn xor(self) -> Sign {
        match self {
            Self::Seed => Sign::XorWord,
            Self::Revelles => Sign::Xor,
            Self::FriskenPerry => Sign::XorCaret,
        }
    }

    /// Bitwise and.
    pub(super) fn and(self) -> Sign {
        match self {
            Self::Seed => Sign::AndWord,
            Self::Revelles | Self::FriskenPerry => Sign::BitAnd,
        }
    }

    /// Bitwise or.
    pub(super) fn or(self) -> Sign {
        match self {
            Self::Seed => Sign::OrWord,
            Self::Revelles | Self::FriskenPerry => Sign::BitOr,
        }
    }

    /// Letter of a location code.
    pub(super) fn code(self) -> &'static str {
        match self {
            Self::Seed | Self::Revelles => "c",
            Self::FriskenPerry => "loc",
        }
    }

    /// Letter of the difference of two codes.
    pub(super) fn difference(self) -> &'static str {
        match self {
            Self::Seed | Self::Revelles => "Δ",
            Self::FriskenPerry => "diff",
        }
    }

    /// Letter of a level.
    pub(super) fn level(self) -> &'static str {
        match self {
            // A plain l is hard to tell from 1 and I.
            Self::Seed | Self::Revelles => "ℓ",
            Self::FriskenPerry => "k",
        }
    }

    /// Letter of a child or state.
    pub(super) fn child(self) -> &'static str {
        match self {
            Self::Seed | Self::FriskenPerry => "i",
            Self::Revelles => "q",
        }
    }

    /// Weight of the bit of `axis` in a child's index in `dimension`.
    pub(super) fn weight(self, axis: usize, dimension: usize) -> u8 {
        match self {
            Self::Seed | Self::Revelles => 1 << (dimension - 1 - axis),
            Self::FriskenPerry => 1 << axis,
        }
    }
}

impl Display for Notation {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.id())
    }
}

impl FromStr for Notation {
    type Err = UnknownNotation;

    fn from_str(id: &str) -> Result<Self, UnknownNotation> {
        let found = Self::ALL.into_iter().find(|notation| notation.id() == id);
        found.ok_or_else(|| UnknownNotation(id.to_owned()))
    }
}
