//! What an exported file is to be like.

use super::{Format, Size};
use crate::figures::MARGIN;
use octoscope_figure::{Background, Page, Scale, Theme, TikzForm, Unit};

/// What an exported file is to be like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order {
    /// Its format.
    pub format: Format,
    /// Colours and lines.
    pub theme: Theme,
    /// What lies behind the figure.
    pub background: Background,
    /// Its extent; without one it ends around the figure.
    pub size: Option<Size>,
    /// So many times as large as the size says, in pixels per point for
    /// pictures whose size is in points; without one as [`Order::scale`] says.
    pub enlarged: Option<f64>,
    /// Size of type and lines against the usual.
    pub type_scale: f64,
    /// Width of lines against that.
    pub line_scale: f64,
    /// What is written around TikZ.
    pub tikz: TikzForm,
    /// How long each step of what moves is shown, in seconds.
    pub pause_secs: f64,
}

impl Default for Order {
    fn default() -> Self {
        Self {
            format: Format::default(),
            theme: Theme::Print,
            background: Background::Filled,
            size: None,
            enlarged: None,
            type_scale: 1.0,
            line_scale: 1.0,
            tikz: TikzForm::default(),
            pause_secs: 0.5,
        }
    }
}

impl Order {
    /// Size in which figures are laid out that are cropped then.
    const USUAL: Size = Size { width: 960.0, height: Some(720.0), unit: Unit::Pixel };
    /// The same on slides, which are 128 mm wide.
    const SLIDE: Size = Size { width: 120.0, height: Some(90.0), unit: Unit::Millimetre };
    /// Size of type on slides against the usual.
    const SLIDE_TYPE: f64 = 4.0 / 3.0;
    /// Dots per inch of pictures whose size is one on paper.
    const DOTS_PER_INCH: f64 = 300.0;

    /// Size in which a figure is laid out that is cropped then, and that of its type:
    /// on slides it has to be legible from afar.
    fn usual(&self) -> (Size, f64) {
        match self.tikz {
            TikzForm::Standalone | TikzForm::Snippet => (Self::USUAL, 1.0),
            TikzForm::Beamer | TikzForm::BeamerSnippet => (Self::SLIDE, Self::SLIDE_TYPE),
        }
    }

    /// The page on which the figure is laid out.
    pub fn page(&self) -> Page {
        let (size, type_scale) = self.usual();
        self.size.unwrap_or(size).page(self.type_scale * type_scale)
    }

    /// Width of that page within its margins, if the figure is as high as what is drawn
    /// on it.
    pub fn column(&self) -> Option<f64> {
        let has_own_height = self.size.is_some_and(|size| size.height.is_none());
        has_own_height.then(|| self.page().width - 2.0 * MARGIN)
    }

    /// Length of the page's units in the file. That of pictures is in pixels:
    /// so many that a size on paper has 300 dots per inch.
    pub fn scale(&self) -> Scale {
        let (size, type_scale) = self.usual();
        let scale = self.size.unwrap_or(size).scale(self.type_scale * type_scale);
        let is_of_pixels = self.format.is_of_pixels();
        let (factor, unit) = match scale.unit {
            Unit::Millimetre | Unit::Point if is_of_pixels => {
                let per_point = self.enlarged.unwrap_or(Self::DOTS_PER_INCH / 72.0);
                (scale.points() * per_point, Unit::Pixel)
            }
            unit => (scale.factor * self.enlarged.unwrap_or(1.0), unit),
        };
        Scale { factor, unit }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Width of the file in its unit.
    fn check(format: Format, size: &str, enlarged: Option<f64>, width: f64) {
        for type_scale in [1.0, 1.5] {
            let size = Some(size.parse().unwrap());
            let order = Order { format, size, enlarged, type_scale, ..Order::default() };
            let found = order.page().width * order.scale().factor;
            assert!((found - width).abs() < 1e-9, "{order:?}: {found}");
        }
    }

    #[test]
    fn files_are_as_large_as_asked_for() {
        check(Format::Svg, "120x80mm", None, 120.0);
        check(Format::Pdf, "85mm", None, 85.0);
        check(Format::Svg, "120x80mm", Some(2.0), 240.0);
        check(Format::Pdf, "300x200pt", None, 300.0);
        check(Format::Png, "640x480", None, 640.0);
        check(Format::Png, "640x480", Some(2.0), 1280.0);
        check(Format::Png, "25.4x25.4mm", None, 300.0);
        check(Format::Png, "25.4x25.4mm", Some(1.0), 72.0);
        check(Format::Png, "72x72pt", None, 300.0);
    }
}
