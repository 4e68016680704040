//! Colours and lines of one shape of a figure.

use crate::{Colour, Dash, Drawn, Palette, Part, Style, Theme};

/// How a shape is painted; [`Style`] without what its part leaves out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Paint {
    /// Colour of the area.
    pub fill: Option<Colour>,
    /// Colour of the line.
    pub stroke: Option<Colour>,
    /// Width of the line, in page units.
    pub width: f64,
    /// Pattern of the line.
    pub dash: Dash,
}

impl Paint {
    /// Paint of `drawn` in `theme`.
    pub fn of(theme: Theme, drawn: &Drawn) -> Self {
        let style = match drawn.part {
            Part::Lit(light) => Style::lit(theme, drawn.role, light),
            Part::Whole
            | Part::Fine
            | Part::Face(_)
            | Part::Head
            | Part::Edge
            | Part::FineEdge
            | Part::HiddenEdge
            | Part::Casing => Style::of(theme, drawn.role),
        };
        let opacity = drawn.part.opacity();
        let shown = |colour: Option<Colour>| colour.map(|c| c.faded(c.opacity * opacity));
        let (fill, stroke) = match drawn.part {
            Part::Whole | Part::Fine | Part::Lit(_) => (style.fill, style.stroke),
            Part::Face(_) => (style.fill, None),
            Part::Head => (style.stroke, None),
            Part::Edge | Part::FineEdge | Part::HiddenEdge => (None, style.stroke),
            Part::Casing => (None, Some(Palette::of(theme).background)),
        };
        let (casing, dash) = match drawn.part {
            Part::Casing => (style.casing, Dash::Solid),
            // There is no room for dashes.
            Part::FineEdge => (0.0, Dash::Solid),
            Part::Whole
            | Part::Fine
            | Part::Face(_)
            | Part::Head
            | Part::Lit(_)
            | Part::Edge
            | Part::HiddenEdge => (0.0, style.dash),
        };
        Self {
            fill: shown(fill),
            stroke: shown(stroke),
            width: style.width * drawn.part.width() + 2.0 * casing,
            dash,
        }
    }

    /// The same with lines so many times as wide.
    pub(crate) fn with_lines(self, factor: f64) -> Self {
        Self { width: self.width * factor, ..self }
    }
}
