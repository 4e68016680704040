//! Why a file cannot be read.

use octoscope_core::progress::Cancelled;
use std::fmt;
use thiserror::Error;

/// Where in a file something is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Line and column of a text, both counted from 1, the column in characters.
    Line {
        /// Line.
        line: usize,
        /// Column.
        column: usize,
    },
    /// Offset in bytes from the start of a binary file.
    Byte(usize),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line { line, column } => write!(f, "line {line}, column {column}"),
            Self::Byte(offset) => write!(f, "byte {offset}"),
        }
    }
}

/// Why bytes are no image, mesh, point cloud, list of cells or list of rays.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ImportError {
    /// There is not one byte.
    #[error("the file is empty; choose a file that holds a picture, a mesh or points")]
    Empty,
    /// Neither the ending of the name nor the first bytes tell the kind.
    #[error(
        "files of this kind cannot be read; choose a file that ends in .png, .jpg, .obj, .stl, .ply, .xyz or .csv"
    )]
    UnknownKind,
    /// The content is of another kind than the name says.
    #[error(
        "the name says {expected}, but the file holds {found}; give it the ending of what it holds"
    )]
    WrongContent {
        /// What the ending of the name stands for.
        expected: &'static str,
        /// What the bytes look like.
        found: &'static str,
    },
    /// Text that is not in UTF-8.
    #[error("the text is in UTF-16; save it in UTF-8")]
    Utf16,
    /// The content breaks the rules of its format.
    #[error("{place}: {fact}; {remedy}")]
    Malformed {
        /// Where.
        place: Place,
        /// What is there.
        fact: String,
        /// What would be right.
        remedy: &'static str,
    },
    /// A picture that its decoder refuses; decoders do not tell where.
    #[error("the picture is damaged: {reason}; save it again as PNG or JPEG")]
    Picture {
        /// What the decoder says.
        reason: String,
    },
    /// More than this program is willing to hold in memory.
    #[error("the file holds {found} {what}, more than {limit}; reduce it first")]
    TooLarge {
        /// What is counted.
        what: &'static str,
        /// How many there are, at least.
        found: u64,
        /// How many are accepted.
        limit: u64,
    },
    /// Nothing wrong, but nothing there either.
    #[error("the file holds no points; choose a file with at least one point or triangle")]
    NoPoints,
    /// The reading was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl ImportError {
    /// Error at `place`.
    pub(crate) fn at(place: Place, fact: impl Into<String>, remedy: &'static str) -> Self {
        Self::Malformed { place, fact: fact.into(), remedy }
    }
}
