//! What lies over the window.

use crate::files::Purpose;
use std::path::{Path, PathBuf};

/// Window over the window.
#[derive(Clone, Debug, PartialEq)]
pub enum Dialog {
    /// Search everything that has a name.
    Find(Search),
    /// All keys.
    Keys,
    /// What this program is.
    About,
    /// Something went wrong: the whole message.
    Error(String),
    /// Where and how to export.
    Export,
    /// What algorithms cost.
    Lab,
    /// A path is typed, where the system has no dialog for that.
    Path(Typed),
}

/// A path that is being typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Typed {
    /// What the file is for.
    pub purpose: Purpose,
    /// The path so far.
    pub path: String,
    /// Whether it is known that this replaces a file.
    pub replaces: bool,
    /// Why it came to nothing the last time, in words.
    pub refused: Option<String>,
}

impl Typed {
    /// A path to begin with.
    pub fn new(purpose: Purpose, path: String) -> Self {
        Self { purpose, path, replaces: false, refused: None }
    }

    /// The file that it names.
    pub fn named(&self) -> PathBuf {
        self.purpose.named(Path::new(self.path.trim()))
    }
}

/// What is searched for, and which of the hits is chosen, from 0.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Search {
    /// Words as typed.
    pub wanted: String,
    /// Number of the chosen hit.
    pub chosen: usize,
}
