//! The look of every role, the only place where one is decided.

use super::{Dash, Style, Weight};
use crate::palette::{Colour, Palette, Theme, contrast, ramp};
use crate::{Part, Role};

impl Style {
    /// Look of `role` in `theme`.
    pub fn of(theme: Theme, role: Role) -> Self {
        let p = Palette::of(theme);
        let style = match role {
            Role::Root => line(p.ancestor, 1.6),
            Role::EmptyLeaf => line(p.grid, 1.0),
            // Too weak for a projector, where the contents tell it.
            Role::FullLeaf => {
                // Paper shows less than a screen.
                let share = if theme == Theme::Print { 0.12 } else { 0.055 };
                let fill = (theme.weakest_fill() == 0.0).then_some(p.quiet_ink.faded(share));
                Self { fill, ..line(p.grid, 1.0) }
            }
            Role::InnerNode => line(p.grid, 1.0),
            Role::FaintNode => line(p.grid.faded(0.45), 0.8),
            Role::EmptySection => line(p.quiet_ink.faded(0.75), 1.0),
            Role::FullSection => {
                let fill = p.quiet_ink.faded(0.3).over(p.background);
                Self { fill: Some(fill), ..line(p.quiet_ink, 1.0) }
            }
            Role::Apart => {
                Self { fill: Some(p.background.faded(0.88)), ..line(p.current_outline, 1.4) }
                    .lettered(p.ink, 13.0, Weight::Strong)
            }
            Role::ApartTaken => {
                let fill = p.current.faded(0.45).over(p.background).faded(0.92);
                Self { fill: Some(fill), ..line(p.current_outline, 2.4) }.lettered(
                    p.ink,
                    13.0,
                    Weight::Strong,
                )
            }
            Role::Tie => Self { dash: Dash::Dotted, ..line(p.current_outline, 1.2) },
            // Outlines alone: many lie over each other, and over what is really there.
            Role::MirroredNode => Self { dash: Dash::Dashed, ..line(p.ray.faded(0.6), 1.0) },
            Role::OwnedFace => Self { fill: Some(p.ink.faded(0.12)), ..Self::default() },
            // Thin, and parted from the outline below it: told from a side that is owned
            // where there is no room for dashes, too.
            Role::OpenSide => Self { dash: Dash::Dashed, casing: 2.0, ..line(p.ink, 1.3) },
            Role::Pixel(rgb) => {
                let colour = Colour { rgb, opacity: 1.0 };
                Self { fill: Some(colour), ..line(p.grid.faded(0.5), 0.5) }
            }
            Role::Content => {
                // A light rim, so that they are seen on visited leaves, too.
                let colour = p.quiet_ink.faded(0.95);
                Self { fill: Some(colour), radius: 2.7, ..line(p.background.faded(0.8), 1.0) }
            }
            Role::Solid => {
                Self { fill: Some(p.quiet_ink.faded(0.16)), ..line(p.quiet_ink.faded(0.8), 1.0) }
            }
            Role::Ancestor { above: 0 | 1 } => line(p.ancestor, 1.4),
            Role::Ancestor { above: 2 } => line(p.ancestor, 1.0),
            Role::Ancestor { above: 3.. } => line(p.ancestor, 0.7),
            Role::Current => {
                Self { fill: Some(p.current.faded(p.current_fill)), ..line(p.current_outline, 3.5) }
            }
            Role::Taken => Self {
                fill: Some(p.current.faded(2.2 * p.current_fill)),
                ..line(p.current_outline, 1.5)
            },
            Role::Rejected => Self { dash: Dash::Dashed, ..line(p.rejected, 1.5) },
            Role::Visited { share } => {
                let colour = ramp(theme, share);
                // On dark ground outlines tell them from each other.
                let edge = if theme == Theme::Dark { 0.95 } else { 0.6 };
                Self { fill: Some(colour.faded(0.45)), ..line(colour.faded(edge), 1.0) }
            }
            Role::Strayed => Self {
                fill: Some(p.rejected.faded(0.22)),
                dash: Dash::Dashed,
                ..line(p.rejected, 1.8).lettered(p.rejected, 12.0, Weight::Strong)
            },
            Role::OrderNumber => Self {
                fill: Some(p.background),
                radius: 9.0,
                ..line(p.ink, 1.0).lettered(p.ink, 11.0, Weight::Strong)
            },
            Role::Touch => Self { radius: 7.0, ..line(p.ray, 2.0) },
            // Unbroken: of a small box in space dashes would be all that is seen.
            Role::Missed => {
                Self { fill: Some(p.rejected.faded(0.12)), casing: 1.5, ..line(p.rejected, 2.6) }
            }
            // The current node, framed in ink: it is the answer.
            Role::Found => Self {
                fill: Some(p.current.faded(2.2 * p.current_fill)),
                casing: 1.2,
                ..line(p.ink, 3.0)
            },
            Role::QueryPoint => Self { fill: Some(p.ray), radius: 5.0, ..line(p.background, 1.5) },
            Role::Region => Self { fill: Some(p.ray.faded(0.12)), ..line(p.ray, 2.0) },
            Role::Target => Self { dash: Dash::Dashed, casing: 1.5, ..line(p.ink, 2.0) },
            Role::Direction => Self { fill: Some(p.ray), ..line(p.ray, 2.5) },
            Role::Pending => Self { dash: Dash::Dashed, ..line(p.ancestor, 2.0) },
            Role::GridCell => Self { fill: Some(p.ray.faded(0.25)), ..line(p.ray, 1.5) },
            Role::Push => Self { fill: Some(p.ray), ..line(p.ray, 2.5) },
            Role::WayUp => {
                Self { fill: Some(p.ink), dash: Dash::Dashed, casing: 1.0, ..line(p.ink, 2.3) }
            }
            Role::WayDown => Self { fill: Some(p.ancestor), casing: 0.8, ..line(p.ancestor, 2.3) },
            Role::Link => Self { fill: Some(p.ink), ..line(p.ink, 3.0) },
            Role::Cut(axis) => {
                Self { fill: Some(p.axes[axis]), radius: 5.0, ..line(p.background, 1.2) }
            }
            Role::Ray => Self { fill: Some(p.ray), ..line(p.ray, 2.2) },
            Role::RayOrigin => Self { fill: Some(p.background), radius: 7.0, ..line(p.ray, 2.2) },
            Role::RayTip => Self { fill: Some(p.ray), radius: 5.5, ..line(p.background, 1.0) },
            Role::RayAway => Self {
                fill: Some(p.background),
                ..line(p.ray, 1.8).lettered(p.ray, 12.0, Weight::Strong)
            },
            Role::RayBeyond => Self { dash: Dash::Dotted, ..line(p.ray.faded(0.85), 1.5) },
            Role::MirroredOrigin => {
                Self { fill: Some(p.background), radius: 5.5, ..line(p.ray.faded(0.75), 1.5) }
            }
            Role::MirroredRay => Self {
                fill: Some(p.ray.faded(0.75)),
                dash: Dash::Dashed,
                ..line(p.ray.faded(0.75), 1.5)
            },
            Role::MirroredWrongly => {
                Self { fill: Some(p.rejected), dash: Dash::Dashed, ..line(p.rejected, 1.5) }
            }
            Role::Ghost => Self {
                fill: Some(p.quiet_ink.faded(0.12)),
                dash: Dash::Dashed,
                ..line(p.quiet_ink.faded(0.8), 1.2)
            },
            Role::Expected => Self { dash: Dash::Dotted, ..line(p.ink, 3.5) },
            Role::Hover => line(p.quiet_ink, 1.6),
            Role::HoverSide => {
                Self { fill: Some(p.quiet_ink.faded(0.3)), ..line(p.quiet_ink, 4.0) }
            }
            Role::EntryPoint => Self { fill: Some(p.ray), radius: 4.5, ..line(p.background, 1.2) },
            Role::ExitPoint => Self { fill: Some(p.background), radius: 4.0, ..line(p.ray, 1.8) },
            Role::MidPlane(axis) => Self {
                fill: plane_fill(theme, p.axes[axis]),
                casing: 1.2,
                ..line(p.axes[axis], 3.0).lettered(p.axes[axis], 12.0, Weight::Strong)
            },
            Role::ExitPlane(axis) => Self {
                fill: plane_fill(theme, p.axes[axis]),
                casing: 1.2,
                ..line(p.axes[axis], 2.3).lettered(p.axes[axis], 12.0, Weight::Strong)
            },
            Role::ChildIndex => Self {
                fill: Some(p.background),
                ..line(p.quiet_ink.faded(0.6), 0.8).lettered(p.ink, 12.0, Weight::Strong)
            },
            // Letters in the colours of the axes stand on it.
            Role::CellCode => Self { fill: Some(p.background), ..Self::default() }.lettered(
                p.ink,
                12.0,
                Weight::MonoStrong,
            ),
            Role::OwnedSide => line(p.ink, 4.0),
            Role::AxisLabel(axis) => {
                line(p.axes[axis], 1.5).lettered(p.axes[axis], 11.0, Weight::Mono)
            }
            Role::Heading => Self::default().lettered(p.ink, 13.5, Weight::Strong),
            Role::Words => Self::default().lettered(p.ink, 12.5, Weight::Regular),
            Role::Note => Self::default().lettered(p.quiet_ink, 12.0, Weight::Regular),
            Role::Code => Self::default().lettered(p.ink, 11.5, Weight::Mono),
            Role::Bit => Self::default().lettered(p.ink, 14.0, Weight::MonoStrong),
            Role::Entry => Self { fill: Some(p.field), ..line(p.grid, 0.8) },
            // Letters in the colours of the axes stand on them.
            Role::LitEntry => Self { fill: Some(p.lit), ..line(p.current_outline, 1.8) },
            Role::LitLine => Self { fill: Some(p.lit), ..Self::default() },
            Role::Rule => line(p.quiet_ink, 1.0),
            Role::Inside => {
                Self { fill: Some(p.current.faded(1.2 * p.current_fill)), ..Self::default() }
            }
            Role::Limit => Self { dash: Dash::Dashed, ..line(p.ink, 1.3) },
            Role::Scale => line(p.grid, 1.0).lettered(p.quiet_ink, 12.0, Weight::Regular),
            Role::Zero => Self { fill: Some(p.ray), radius: 3.5, ..Self::default() }.lettered(
                p.ray,
                11.0,
                Weight::Strong,
            ),
            Role::Bar(axis) => line(p.axes[axis], 5.0),
            Role::Stop(axis) => Self { fill: Some(p.axes[axis]), ..line(p.axes[axis], 2.0) },
            Role::State => Self { fill: Some(p.field), radius: 13.0, ..line(p.quiet_ink, 1.2) }
                .lettered(p.ink, 14.0, Weight::Strong),
            Role::StateNow => {
                Self { fill: Some(p.current_outline), radius: 13.0, ..line(p.current_outline, 2.0) }
                    .lettered(readable_on(p.current_outline), 14.0, Weight::Strong)
            }
            Role::StateNext => {
                Self { fill: Some(p.field), radius: 13.0, ..line(p.current_outline, 3.0) }.lettered(
                    p.ink,
                    14.0,
                    Weight::Strong,
                )
            }
            Role::Transition(axis) => {
                Self { fill: Some(p.axes[axis].faded(0.75)), ..line(p.axes[axis].faded(0.75), 1.3) }
            }
            Role::TransitionTaken(axis) => {
                Self { fill: Some(p.axes[axis]), ..line(p.axes[axis], 3.6) }
            }
            Role::TransitionTogether => {
                Self { fill: Some(p.current_outline), ..line(p.current_outline, 3.6) }
            }
            Role::Spent => Self { fill: Some(p.accent), ..Self::default() },
            Role::Planned => Self { fill: Some(p.accent.faded(0.18)), ..line(p.accent, 0.8) },
            Role::Compared => Self { fill: Some(p.quiet_ink.faded(0.75)), ..Self::default() },
            Role::Series(number) => {
                // As yellow as is seen on a panel.
                let yellow = p.ink.faded(0.15).over(p.current_outline);
                let colours = [p.accent, p.ray, yellow, p.rejected, p.quiet_ink];
                let dash = [Dash::Solid, Dash::Dashed, Dash::Dotted, Dash::DashDotted];
                let colour = colours[number % Role::N_SERIES_COLOURS];
                let dash = dash[number / Role::N_SERIES_COLOURS % dash.len()];
                Self { dash, ..line(colour, 1.8) }
            }
            Role::Hit => Self { fill: Some(p.quiet_ink.faded(0.75)), ..Self::default() },
            Role::Miss => Self { fill: Some(p.ray), ..Self::default() },
            Role::BorderBit => line(p.ink, 2.0),
            Role::Conclusion => {
                Self { fill: Some(p.current_outline), ..line(p.current_outline, 2.0) }.lettered(
                    p.ink,
                    12.5,
                    Weight::Strong,
                )
            }
            Role::Blank => line(p.quiet_ink, 0.8),
            Role::Level => line(p.grid.faded(0.7), 0.8).lettered(p.quiet_ink, 11.0, Weight::Mono),
            Role::Branch => {
                line(p.quiet_ink.faded(0.7), 0.9).lettered(p.quiet_ink, 10.5, Weight::Regular)
            }
            Role::Path => line(p.ray, 3.0),
            Role::Formula(step) => {
                let size = 17.0 * 0.86_f64.powi(i32::from(step.min(7)));
                Self::default().lettered(p.ink, size, Weight::Regular)
            }
            Role::FormulaLine => line(p.ink, 1.1),
            Role::Node | Role::Ground => {
                Self { fill: Some(p.background), ..line(p.quiet_ink, 1.1) }
            }
        };
        style.for_theme(theme)
    }

    /// Look of a side of something solid on which `light` falls, 0 …
    /// [`Part::MOST_LIGHT`]: it hides what is behind it.
    pub fn lit(theme: Theme, role: Role, light: u8) -> Self {
        let p = Palette::of(theme);
        // Where the background is dark, ink is what shines.
        let is_dark = theme == Theme::Dark;
        let light = f64::from(light) / f64::from(Part::MOST_LIGHT);
        let shade = if is_dark { light } else { 1.0 - light };
        let is_leaf = matches!(role, Role::FullLeaf | Role::EmptyLeaf | Role::Pixel(_));
        // Leaves are a hint, and told by their lines alone on a projector.
        let [least, most] = match (is_leaf, theme.weakest_fill() > 0.0) {
            (true, true) => [0.0, 0.0],
            (true, false) => [0.02, 0.12],
            (false, true) => [0.35, 0.7],
            // Light on dark is seen less than dark on light.
            (false, false) if is_dark => [0.42, 0.85],
            (false, false) => [0.14, 0.58],
        };
        let colour = p.quiet_ink.faded(least + shade * (most - least)).over(p.background);
        let (stroke, width) = if is_leaf { (p.grid, 0.6) } else { (colour, 0.5) };
        Self { fill: Some(colour), stroke: Some(stroke), width, ..Self::default() }
    }
}

/// Area of a plane in space: weak, for it lies before what is asked. Too weak for a
/// projector, where its outline tells it.
fn plane_fill(theme: Theme, colour: Colour) -> Option<Colour> {
    (theme.weakest_fill() == 0.0).then_some(colour.faded(0.06))
}

/// Black or white, whichever is read better on `colour`.
fn readable_on(colour: Colour) -> Colour {
    let [black, white] = [0x000000, 0xffffff].map(Colour::hex);
    if contrast(black, colour) >= contrast(white, colour) { black } else { white }
}

fn line(colour: Colour, width: f64) -> Style {
    Style { stroke: Some(colour), width, ..Style::default() }
}
