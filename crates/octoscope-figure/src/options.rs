//! How a figure becomes a file, whatever its format.

use crate::Theme;
use serde::{Deserialize, Serialize};

/// How a figure is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FileOptions<'a> {
    /// Colours and lines.
    pub theme: Theme,
    /// What lies behind the figure.
    pub background: Background,
    /// Title for readers that cannot see it; none if empty.
    pub title: &'a str,
    /// The scenario as JSON, kept inside; none if empty.
    pub scenario: &'a str,
    /// How large a page unit is shown.
    pub scale: Scale,
    /// Width of lines against the usual, above 0.
    pub line_scale: f64,
}

impl Default for FileOptions<'_> {
    fn default() -> Self {
        Self {
            theme: Theme::default(),
            background: Background::default(),
            title: "",
            scenario: "",
            scale: Scale::default(),
            line_scale: 1.0,
        }
    }
}

/// What lies behind a figure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Background {
    /// The theme's background.
    #[default]
    Filled,
    /// Nothing.
    Transparent,
}

/// Length of one page unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// So many of the unit, above 0.
    pub factor: f64,
    /// The unit.
    pub unit: Unit,
}

impl Scale {
    /// So many points, 1/72 of an inch.
    pub fn points(self) -> f64 {
        self.factor * self.unit.points()
    }
}

impl Default for Scale {
    fn default() -> Self {
        Self { factor: 1.0, unit: Unit::Pixel }
    }
}

/// Unit of lengths on paper or on a screen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Unit {
    /// Millimetre.
    Millimetre,
    /// 1/72 of an inch.
    Point,
    /// 1/96 of an inch, as on the web.
    #[default]
    Pixel,
}

impl Unit {
    /// All units.
    pub const ALL: [Self; 3] = [Self::Millimetre, Self::Point, Self::Pixel];

    /// What is written behind a length.
    pub fn id(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Point => "pt",
            Self::Pixel => "px",
        }
    }

    /// Its length in points.
    pub fn points(self) -> f64 {
        match self {
            Self::Millimetre => 72.0 / 25.4,
            Self::Point => 1.0,
            Self::Pixel => 0.75,
        }
    }
}
