//! Why a file cannot be read.

use octoscope_core::progress::Cancelled;
use octoscope_core::text::{Language, Message, Texts};
use std::fmt;
use std::sync::LazyLock;
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
    #[error("{place}: {}", told.told(&IN_ENGLISH))]
    Malformed {
        /// Where.
        place: Place,
        /// What is there and what would be right, in words of [`import_texts`].
        told: Message,
    },
    /// A picture that its decoder refuses; decoders do not tell where.
    #[error("the picture is damaged: {0}; save it again as PNG or JPEG")]
    Picture(PictureFault),
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
    pub(crate) fn at(place: Place, told: Message) -> Self {
        Self::Malformed { place, told }
    }
}

/// Why a picture cannot be decoded.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum PictureFault {
    /// A part at its end is missing.
    #[error("it ends too early")]
    EndsEarly,
    /// The decoder fails at it.
    #[error("its decoder gave up")]
    GivenUp,
    /// What the decoder says, in its words.
    #[error("{0}")]
    Decoder(String),
}

/// Source of the texts of what is wrong inside files, in `language`.
pub fn import_texts(language: Language) -> &'static str {
    match language {
        Language::English => include_str!("../../../assets/texts/en/imports.ftl"),
        Language::German => include_str!("../../../assets/texts/de/imports.ftl"),
    }
}

static IN_ENGLISH: LazyLock<Texts> = LazyLock::new(|| {
    let language = Language::English;
    Texts::new(language, &[import_texts(language)])
});
