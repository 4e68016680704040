//! What lies over the window.

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
    /// A file is opened by typing its path.
    Path(String),
}

/// What is searched for, and which of the hits is chosen, from 0.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Search {
    /// Words as typed.
    pub wanted: String,
    /// Number of the chosen hit.
    pub chosen: usize,
}
