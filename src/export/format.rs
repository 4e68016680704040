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
    /// A table of the steps for Markdown.
    Markdown,
    /// A table of the steps, in columns between commas.
    Csv,
    /// A table of the steps for LaTeX.
    Latex,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 9] = [
        Self::Svg,
        Self::Pdf,
        Self::Png,
        Self::Tikz,
        Self::Gif,
        Self::Apng,
        Self::Markdown,
        Self::Csv,
        Self::Latex,
    ];

    /// Its name in arguments.
    pub fn id(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Pdf => "pdf",
            Self::Png => "png",
            Self::Tikz => "tikz",
            Self::Gif => "gif",
            Self::Apng => "apng",
            Self::Markdown => "markdown",
            Self::Csv => "csv",
            Self::Latex => "latex",
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
            Self::Markdown => "Markdown",
            Self::Csv => "CSV",
            Self::Latex => "LaTeX",
        }
    }

    /// Its file ending.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Svg | Self::Pdf | Self::Png | Self::Gif | Self::Apng | Self::Csv => self.id(),
            Self::Tikz | Self::Latex => "tex",
            Self::Markdown => "md",
        }
    }

    /// Whether a file of it may have this ending, one of [`Format::ending`]: what moves
    /// is shown by programs for PNG, too.
    pub fn may_end_in(self, ending: &str) -> bool {
        ending == self.ending() || self == Self::Apng && ending == Self::Png.ending()
    }

    /// Format of this name.
    pub fn of_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| id.eq_ignore_ascii_case(format.id()))
    }

    /// Format of this file ending: a figure, where a table of steps ends alike.
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
            Self::Svg | Self::Pdf | Self::Tikz | Self::Markdown | Self::Csv | Self::Latex => false,
        }
    }

    /// Whether it is a table of all steps as text, no figure.
    pub fn is_of_text(self) -> bool {
        match self {
            Self::Markdown | Self::Csv | Self::Latex => true,
            Self::Svg | Self::Pdf | Self::Png | Self::Tikz | Self::Gif | Self::Apng => false,
        }
    }

    /// Whether one file holds several steps.
    pub fn holds_steps(self) -> bool {
        match self {
            Self::Pdf | Self::Tikz | Self::Gif | Self::Apng => true,
            Self::Markdown | Self::Csv | Self::Latex => true,
            Self::Svg | Self::Png => false,
        }
    }

    /// Whether it moves: all steps are meant where nothing else is said.
    pub fn moves(self) -> bool {
        match self {
            Self::Gif | Self::Apng => true,
            Self::Svg | Self::Pdf | Self::Png | Self::Tikz => false,
            Self::Markdown | Self::Csv | Self::Latex => false,
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
            let figure = if format == Format::Latex { Format::Tikz } else { format };
            assert_eq!(Format::of_ending(&format.ending().to_uppercase()), Some(figure));
        }
        assert_eq!(Format::of_ending("tikz"), Some(Format::Tikz));
        assert_eq!(Format::of_id("tex"), None);
    }
}
