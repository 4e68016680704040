//! Where the content of a tree comes from.

use super::built_in;
use crate::scene::Content;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Where the content of a tree comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum Source<const D: usize> {
    /// A scene made by the program.
    BuiltIn {
        /// Its name.
        name: String,
        /// What of it is chosen.
        parameters: Parameters,
    },
    /// The content itself.
    Inline(Content<D>),
    /// A data file.
    File {
        /// Path relative to the scenario's file, with `/` between its parts.
        path: String,
        /// Hash of its bytes, as the importer prints it; may be empty, then
        /// nothing is checked.
        hash: String,
        /// Whether the domain is still to be fitted to what the file holds:
        /// [`Scenario::fit_to`](super::Scenario::fit_to).
        fit: bool,
    },
}

/// What of a built-in scene can be chosen; `None` is the scene's default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Parameters {
    /// Seed of the random numbers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// How many, or how large; each scene says what.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub n: Option<u32>,
}

/// Why a source gives no content.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum SourceError {
    /// No built-in scene of this name.
    #[error("there is no built-in scene ‘{name}’; there are {known}")]
    Unknown {
        /// The name asked for.
        name: String,
        /// The names there are.
        known: String,
    },
    /// The scene lives in another dimension.
    #[error("the built-in scene ‘{name}’ has {has} dimensions, not {asked}")]
    Dimension {
        /// Name of the scene.
        name: String,
        /// Its dimension.
        has: usize,
        /// The dimension asked for.
        asked: usize,
    },
    /// The scene does not know the parameter.
    #[error("the built-in scene ‘{name}’ has no parameter ‘{parameter}’; leave it out")]
    NoParameter {
        /// Name of the scene.
        name: String,
        /// Name of the parameter.
        parameter: &'static str,
    },
    /// The parameter is too small or too large.
    #[error("parameter ‘n’ of the built-in scene ‘{name}’ is {n}; give a number from 1 to {most}")]
    Range {
        /// Name of the scene.
        name: String,
        /// The number given.
        n: u32,
        /// The largest possible.
        most: u32,
    },
    /// The content lies in a file, which is not read here.
    #[error("the scene lies in a file that has to be read first: {0}")]
    NotRead(String),
}

impl<const D: usize> Source<D> {
    /// The content, unless it lies in a file.
    ///
    /// # Errors
    /// See [`SourceError`].
    pub fn content(&self) -> Result<Content<D>, SourceError> {
        match self {
            Self::BuiltIn { name, parameters } => built_in::content(name, *parameters),
            Self::Inline(content) => Ok(content.clone()),
            Self::File { path, .. } => Err(SourceError::NotRead(path.clone())),
        }
    }
}
