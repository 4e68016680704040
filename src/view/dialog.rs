//! What lies over the window.

/// Window over the window.
#[derive(Clone, Debug, PartialEq)]
pub enum Dialog {
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
