//! How a tree is to be built.

use serde::{Deserialize, Serialize};

/// Most nodes that a tree may have.
pub const MAX_NODES: usize = 1 << 26;

/// How a tree is built. Each kind of content uses what concerns it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Recipe {
    /// Levels below the root, 0 … 20: a smallest cell has 2^-depth of its side.
    pub depth: u8,
    /// Most points in a leaf above level 0, at least 1.
    pub capacity: u32,
    /// Whether wholly full nodes are leaves.
    pub merge: Merge,
    /// Largest difference in a channel between two pixels of a leaf above
    /// level 0.
    pub threshold: u8,
    /// What of circles and spheres is occupied.
    pub fill: Fill,
}

impl Default for Recipe {
    fn default() -> Self {
        Self { depth: 6, capacity: 4, merge: Merge::Whole, threshold: 24, fill: Fill::Surface }
    }
}

/// Whether wholly full nodes are leaves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Merge {
    /// A node is a leaf when it is wholly full or wholly empty.
    #[default]
    Whole,
    /// Every occupied cell stays a leaf of level 0.
    Kept,
}

/// What of circles and spheres is occupied.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Fill {
    /// The cells whose closed box meets the surface.
    #[default]
    Surface,
    /// The cells whose closed box meets the surface or the inside.
    Solid,
}
