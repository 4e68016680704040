//! What the map of rays shows.

use crate::map::Colouring;
use serde::{Deserialize, Serialize};

/// What was chosen in the panel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct MapView {
    /// Which rays of space; in the plane there are only the lines.
    pub rays: RaysOf,
    /// What tells them apart.
    pub colouring: Colouring,
}

/// Families of rays in space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum RaysOf {
    /// Those that begin where the present ray does.
    #[default]
    Origin,
    /// The lines of sight of the space view.
    Picture,
}

impl RaysOf {
    /// Key of its name in the language files.
    pub fn id(self) -> &'static str {
        match self {
            Self::Origin => "map-rays-origin",
            Self::Picture => "map-rays-picture",
        }
    }
}
