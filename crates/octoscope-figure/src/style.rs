//! How roles look.

mod of_roles;

use crate::Role;
use crate::palette::{Colour, Theme};
use octoscope_core::explain::Span;

/// Look of a role in a theme. Lengths are page units (points, logical pixels).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Style {
    /// Colour of areas.
    pub fill: Option<Colour>,
    /// Colour of lines.
    pub stroke: Option<Colour>,
    /// Width of lines.
    pub width: f64,
    /// Pattern of lines.
    pub dash: Dash,
    /// How far the line is parted from what lies below it, on either side.
    pub casing: f64,
    /// Radius of points.
    pub radius: f64,
    /// Look of text.
    pub text: Option<Lettering>,
}

/// Pattern of a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Dash {
    /// Unbroken.
    #[default]
    Solid,
    /// Dashes.
    Dashed,
    /// Dots.
    Dotted,
    /// Dashes and dots in turn.
    DashDotted,
}

impl Dash {
    /// Lengths of dash, gap, dash, gap… in units of the line's width; empty if unbroken.
    pub fn pattern(self) -> &'static [f64] {
        match self {
            Self::Solid => &[],
            Self::Dashed => &[4.0, 3.0],
            Self::Dotted => &[1.0, 2.0],
            Self::DashDotted => &[6.0, 2.0, 1.0, 2.0],
        }
    }
}

/// Look of text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lettering {
    /// Colour.
    pub colour: Colour,
    /// Height of the type, in page units.
    pub size: f64,
    /// Typeface and weight.
    pub weight: Weight,
}

/// Typeface and weight.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Weight {
    /// The sans, regular.
    Regular,
    /// The sans, semi-bold.
    Strong,
    /// The mono, regular.
    Mono,
    /// The mono, bold.
    MonoStrong,
}

impl Weight {
    /// The same typeface, bolder.
    pub fn bolder(self) -> Self {
        match self {
            Self::Regular | Self::Strong => Self::Strong,
            Self::Mono | Self::MonoStrong => Self::MonoStrong,
        }
    }
}

impl Lettering {
    /// Size of a subscript against that of the text.
    pub const SUB_SIZE: f64 = 0.72;
    /// How far below the text's line that of a subscript lies, in type heights of the text.
    pub const SUB_DROP: f64 = 0.2;

    /// Look of a piece of a text of this look.
    pub fn of_span(self, theme: Theme, span: &Span) -> Self {
        let of_axis = span.axis.and_then(|axis| Style::of(theme, Role::AxisLabel(axis)).text);
        let is_bold = span.strong || of_axis.is_some();
        Self {
            colour: of_axis.map_or(self.colour, |axis| axis.colour),
            size: if span.sub { Self::SUB_SIZE * self.size } else { self.size },
            weight: if is_bold { self.weight.bolder() } else { self.weight },
        }
    }
}

impl Role {
    /// Whether its lines are parted from what lies below them, in every theme.
    pub(crate) fn has_casing(self) -> bool {
        Style::of(Theme::Light, self).casing > 0.0
    }
}

impl Style {
    /// Radius of points in space, where many lie behind each other, with their line.
    pub const POINT_IN_SPACE: f64 = 1.8;

    fn lettered(self, colour: Colour, size: f64, weight: Weight) -> Self {
        Self { text: Some(Lettering { colour, size, weight }), ..self }
    }

    /// Lines as wide and fills as strong as the theme wants them.
    fn for_theme(self, theme: Theme) -> Self {
        let strong = |c: Colour| c.faded(c.opacity.max(theme.weakest_fill()));
        let width = self.width * theme.line_scale();
        Self { width, fill: self.fill.map(strong), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::palette::{Palette, contrast};

    /// Roles that are hints, or are told by their area and the marks on it.
    fn is_hint(role: Role) -> bool {
        matches!(
            role,
            Role::EmptyLeaf
                | Role::InnerNode
                | Role::FaintNode
                | Role::MirroredNode
                | Role::OwnedFace
                | Role::FullLeaf
                | Role::Pixel(_)
                | Role::Visited { .. }
                | Role::Entry
                | Role::LitLine
                | Role::Inside
                | Role::Transition(_)
        )
    }

    #[test]
    fn every_role_can_be_seen_in_every_theme() {
        for theme in Theme::ALL {
            let background = Palette::of(theme).background;
            for role in Role::KINDS {
                let style = Style::of(theme, role);
                let seen = [style.fill, style.stroke, style.text.map(|t| t.colour)];
                let best =
                    seen.into_iter().flatten().map(|c| contrast(c, background)).fold(0.0, f64::max);
                assert!(
                    best >= 3.0 || is_hint(role) && best > 1.05,
                    "{theme:?} {role:?} {best:.2}"
                );
                if let Some(text) = style.text {
                    // A state covers what is below its number.
                    let below = style.fill.filter(|fill| fill.opacity == 1.0 && style.radius > 8.0);
                    let ratio = contrast(text.colour, below.unwrap_or(background));
                    assert!(ratio >= 4.5, "{theme:?} {role:?} text {ratio:.2}");
                }
            }
        }
    }

    #[test]
    fn codes_can_be_read_on_every_fill_in_the_colour_of_every_axis() {
        for theme in Theme::ALL {
            let style = Style::of(theme, Role::CellCode);
            let [text, ground] = [style.text.unwrap().colour, style.fill.unwrap()];
            let axes = (0..3).map(|axis| Style::of(theme, Role::AxisLabel(axis)).text.unwrap());
            let colours: Vec<_> = axes.map(|text| text.colour).chain([text]).collect();
            // Their own ground covers every fill below them.
            assert_eq!(ground.opacity, 1.0, "{theme:?}");
            for colour in &colours {
                let ratio = contrast(*colour, ground);
                assert!(ratio >= 4.5, "{theme:?} {colour:?} {ratio:.2}");
            }
        }
    }

    #[test]
    fn the_colours_of_the_axes_are_of_axes_alone() {
        for theme in Theme::ALL {
            for role in Role::KINDS {
                let style = Style::of(theme, role);
                let own = [style.fill, style.stroke, style.text.map(|text| text.colour)];
                let axes = Palette::of(theme).axes.map(|axis| axis.rgb);
                let is_of_axis = own.into_iter().flatten().any(|own| axes.contains(&own.rgb));
                let class = role.class();
                let names_axis = ["-x", "-y", "-z"].iter().any(|end| class.ends_with(end));
                assert!(names_axis || !is_of_axis, "{theme:?} {role:?}");
            }
        }
    }

    #[test]
    fn an_open_side_is_told_from_an_owned_one_where_there_is_no_room_for_dashes() {
        for theme in Theme::ALL {
            let [open, owned, current] =
                [Role::OpenSide, Role::OwnedSide, Role::Current].map(|role| Style::of(theme, role));
            assert!(owned.width >= 2.5 * open.width, "{theme:?}");
            // Neither leaves the outline to be seen on which it lies.
            assert!(open.width + 2.0 * open.casing >= current.width, "{theme:?}");
            assert!(owned.width >= current.width, "{theme:?}");
        }
    }

    #[test]
    fn order_numbers_can_be_read_on_their_disc() {
        for theme in Theme::ALL {
            let style = Style::of(theme, Role::OrderNumber);
            let (text, disc) = (style.text.unwrap(), style.fill.unwrap());
            assert!(contrast(text.colour, disc) >= 4.5);
        }
    }

    #[test]
    fn the_projector_has_no_weak_fills_and_wide_lines() {
        for role in Role::KINDS {
            let style = Style::of(Theme::Projector, role);
            assert!(style.fill.is_none_or(|fill| fill.opacity >= 0.35));
            assert_eq!(style.width, 1.5 * Style::of(Theme::Light, role).width);
        }
    }
}
