//! Formats of exported figures.

use serde::{Deserialize, Serialize};

/// Format of an exported figure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Format {
    /// Vectors, text as text.
    #[default]
    Svg,
    /// Vectors on a page, letters embedded.
    Pdf,
    /// Pixels.
    Png,
    /// Vectors as commands for LaTeX.
    Tikz,
    /// Moving pixels of few colours.
    Gif,
    /// Moving pixels.
    Apng,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 6] = [Self::Svg, Self::Pdf, Self::Png, Self::Tikz, Self::Gif, Self::Apng];

    /// Its name in arguments.
    pub fn id(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Pdf => "pdf",
            Self::Png => "png",
            Self::Tikz => "tikz",
            Self::Gif => "gif",
            Self::Apng => "apng",
        }
    }

    /// Its name as it is usually written.
    pub fn name(self) -> &'static str {
        match self {
            Self::Svg => "SVG",
            Self::Pdf => "PDF",
            Self::Png => "PNG",
            Self::Tikz => "TikZ",
            Self::Gif => "GIF",
            Self::Apng => "APNG",
        }
    }

    /// Its file ending.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Svg | Self::Pdf | Self::Png | Self::Gif | Self::Apng => self.id(),
            Self::Tikz => "tex",
        }
    }

    /// Format of this name.
    pub fn of_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| id.eq_ignore_ascii_case(format.id()))
    }

    /// Format of this file ending.
    pub fn of_ending(ending: &str) -> Option<Self> {
        let is_it = |format: &Self| ending.eq_ignore_ascii_case(format.ending());
        Self::of_id(ending).or_else(|| Self::ALL.into_iter().find(is_it))
    }

    /// All names, to be told to the user.
    pub fn known() -> String {
        Self::ALL.map(Self::id).join(", ")
    }

    /// Whether its figures are of pixels.
    pub fn is_of_pixels(self) -> bool {
        match self {
            Self::Png | Self::Gif | Self::Apng => true,
            Self::Svg | Self::Pdf | Self::Tikz => false,
        }
    }

    /// Whether one file holds several steps.
    pub fn holds_steps(self) -> bool {
        match self {
            Self::Pdf | Self::Tikz | Self::Gif | Self::Apng => true,
            Self::Svg | Self::Png => false,
        }
    }

    /// Whether it moves: all steps are meant where nothing else is said.
    pub fn moves(self) -> bool {
        match self {
            Self::Gif | Self::Apng => true,
            Self::Svg | Self::Pdf | Self::Png | Self::Tikz => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn endings_and_names_tell_the_format() {
        for format in Format::ALL {
            assert_eq!(Format::of_id(format.id()), Some(format));
            assert_eq!(Format::of_ending(&format.ending().to_uppercase()), Some(format));
        }
        assert_eq!(Format::of_ending("tikz"), Some(Format::Tikz));
        assert_eq!(Format::of_id("tex"), None);
    }
}
