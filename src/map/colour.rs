//! How the values of a map look.

use super::asked::Colouring;
use super::drawing::Raster;
use super::measure::{NOTHING, UNKNOWN, WRONG};
use octoscope_figure::{Colour, Theme, contrast, ramp};

/// Colour of every cell, over the background of the theme.
pub fn colours(theme: Theme, colouring: Colouring, raster: &Raster) -> Vec<Colour> {
    let scale = Scale::of(colouring, raster);
    raster.values.iter().map(|&value| scale.colour(theme, value)).collect()
}

/// What the values of a raster range over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scale {
    colouring: Colouring,
    /// Smallest and largest value that is not `NOTHING`; 0 and 0 if there is none.
    pub range: [u32; 2],
    /// Number of rays that are not right, where that is told.
    pub n_wrong: usize,
    /// Number of rays of which that is not known, as the run was given up.
    pub n_unknown: usize,
}

impl Scale {
    /// Scale of the values of `raster`.
    pub fn of(colouring: Colouring, raster: &Raster) -> Self {
        let values = || raster.values.iter().copied().filter(|&value| value != NOTHING);
        let range = [values().min().unwrap_or(0), values().max().unwrap_or(0)];
        let count = |what| match colouring {
            Colouring::Differences => values().filter(|&value| value == what).count(),
            Colouring::Sequence | Colouring::Leaves | Colouring::Steps | Colouring::Comparisons => {
                0
            }
        };
        Self { colouring, range, n_wrong: count(WRONG), n_unknown: count(UNKNOWN) }
    }

    /// Colour of a value.
    pub fn colour(&self, theme: Theme, value: u32) -> Colour {
        let palette = octoscope_figure::Palette::of(theme);
        if value == NOTHING {
            return palette.background;
        }
        match self.colouring {
            // Neighbours differ in lightness, and so to every eye.
            Colouring::Sequence => {
                let [low, high] =
                    [value & 0xffff, value >> 16].map(|bits| f64::from(bits) / 65535.0);
                ramp(theme, low).faded(0.55 + 0.45 * high).over(palette.background)
            }
            Colouring::Leaves | Colouring::Steps | Colouring::Comparisons => {
                let [least, most] = self.range.map(f64::from);
                ramp(theme, (f64::from(value) - least) / (most - least).max(1.0))
            }
            Colouring::Differences if value == WRONG => palette.rejected,
            Colouring::Differences if value == UNKNOWN => palette.quiet_ink,
            Colouring::Differences => right(&palette),
        }
    }
}

/// Colour of a ray that is right: grey, as far from nothing as from what is wrong.
fn right(palette: &octoscope_figure::Palette) -> Colour {
    let greys = (1..=20).map(|n| palette.ink.faded(0.05 * f64::from(n)).over(palette.background));
    let apart =
        |grey: Colour| contrast(grey, palette.background).min(contrast(grey, palette.rejected));
    greys.max_by(|a, b| apart(*a).total_cmp(&apart(*b))).unwrap_or(palette.grid)
}

#[cfg(test)]
mod tests {
    use super::super::measure::RIGHT;
    use super::*;

    #[test]
    fn right_and_wrong_and_nothing_are_told_apart_in_every_theme() {
        let colouring = Colouring::Differences;
        let scale = Scale { colouring, range: [RIGHT, WRONG], n_wrong: 1, n_unknown: 0 };
        for theme in Theme::ALL {
            let [nothing, right, wrong] =
                [NOTHING, RIGHT, WRONG].map(|value| scale.colour(theme, value));
            for [a, b] in [[nothing, right], [right, wrong], [nothing, wrong]] {
                let ratio = contrast(a, b);
                assert!(ratio >= 2.4, "{theme:?}: {ratio:.2}");
            }
        }
    }
}
