//! The colours of every theme: the only place with colours in the product.

use serde::{Deserialize, Serialize};

/// Look of the whole program and of figures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Theme {
    /// Dark on white, for bright rooms.
    #[default]
    Light,
    /// Light on near black.
    Dark,
    /// Dark on white with thin lines, for paper.
    Print,
    /// Black on white with heavy lines, for weak projectors.
    Projector,
}

impl Theme {
    /// All themes.
    pub const ALL: [Self; 4] = [Self::Light, Self::Dark, Self::Print, Self::Projector];

    /// Name in files and arguments.
    pub fn id(self) -> &'static str {
        match self {
            Self::Light => "light",
            Self::Dark => "dark",
            Self::Print => "print",
            Self::Projector => "projector",
        }
    }

    /// Width of lines against that of the light theme.
    pub fn line_scale(self) -> f64 {
        match self {
            Self::Light | Self::Dark => 1.0,
            Self::Print => 0.8,
            Self::Projector => 1.5,
        }
    }

    /// Weakest opacity of a fill that is to be seen.
    pub(crate) fn weakest_fill(self) -> f64 {
        match self {
            Self::Light | Self::Dark | Self::Print => 0.0,
            Self::Projector => 0.35,
        }
    }
}

/// A colour with its opacity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colour {
    /// Red, green, blue in sRGB.
    pub rgb: [u8; 3],
    /// 0 is not to be seen, 1 covers.
    pub opacity: f64,
}

impl Colour {
    /// Covering colour from 0xRRGGBB.
    pub const fn hex(rgb: u32) -> Self {
        Self { rgb: [(rgb >> 16) as u8, (rgb >> 8) as u8, rgb as u8], opacity: 1.0 }
    }

    /// The same colour with another opacity.
    pub const fn faded(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }

    /// Covering colour that this one gives over `below`, mixed in sRGB.
    pub fn over(self, below: Self) -> Self {
        let mix = |a: u8, b: u8| {
            (f64::from(b) + self.opacity * (f64::from(a) - f64::from(b))).round() as u8
        };
        Self { rgb: std::array::from_fn(|i| mix(self.rgb[i], below.rgb[i])), opacity: 1.0 }
    }

    /// Relative luminance, 0 … 1 [WCAG 2.2].
    fn luminance(self) -> f64 {
        let linear = self.rgb.map(|c| {
            let c = f64::from(c) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        });
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    }
}

/// Contrast of a colour against a covering background, 1 … 21 [WCAG 2.2].
pub fn contrast(colour: Colour, background: Colour) -> f64 {
    let [a, b] = [colour.over(background).luminance(), background.luminance()];
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

/// Colours of one theme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Palette {
    /// Behind the picture.
    pub background: Colour,
    /// Behind panels.
    pub panel: Colour,
    /// Behind what can be edited.
    pub field: Colour,
    /// Lines between panels and around fields.
    pub hairline: Colour,
    /// Text.
    pub ink: Colour,
    /// Captions.
    pub quiet_ink: Colour,
    /// Cells; a hint only.
    pub grid: Colour,
    /// The axes x, y, z.
    pub axes: [Colour; 3],
    /// The ray.
    pub ray: Colour,
    /// Fill of the current node, covering; use it at `current_fill` opacity.
    pub current: Colour,
    /// Opacity of the fill of the current node.
    pub current_fill: f64,
    /// Outline of the current node.
    pub current_outline: Colour,
    /// Behind what the step uses in tables, covering: text of every colour is read on it.
    pub lit: Colour,
    /// Rejected, and what is wrong.
    pub rejected: Colour,
    /// Outline of the root and its descendants on the stack.
    pub ancestor: Colour,
    /// Over what is not to be looked at, covering in part.
    pub shade: Colour,
    /// All of a window that shows nothing: a hall is to be dark then.
    pub blank: Colour,
    /// Selected and ticked things.
    pub accent: Colour,
    /// Text on the accent.
    pub on_accent: Colour,
}

impl Palette {
    /// Name of one of its colours, for files in which colours have names.
    pub(crate) fn name_of(&self, rgb: [u8; 3]) -> Option<&'static str> {
        let named = [
            ("background", self.background),
            ("ink", self.ink),
            ("quiet-ink", self.quiet_ink),
            ("grid", self.grid),
            ("axis-x", self.axes[0]),
            ("axis-y", self.axes[1]),
            ("axis-z", self.axes[2]),
            ("ray", self.ray),
            ("current", self.current),
            ("current-outline", self.current_outline),
            ("lit", self.lit),
            ("rejected", self.rejected),
            ("ancestor", self.ancestor),
            ("accent", self.accent),
        ];
        named.into_iter().find(|(_, colour)| colour.rgb == rgb).map(|(name, _)| name)
    }

    /// The colours of a theme.
    pub fn of(theme: Theme) -> Self {
        let light = Self {
            background: Colour::hex(0xffffff),
            panel: Colour::hex(0xf4f6f8),
            field: Colour::hex(0xffffff),
            hairline: Colour::hex(0xdde3e8),
            ink: Colour::hex(0x1b1f24),
            quiet_ink: Colour::hex(0x56616c),
            grid: Colour::hex(0xc9d1d9),
            axes: [0x9f3e00, 0x18694a, 0x0f75a3].map(Colour::hex),
            ray: Colour::hex(0xc7105e),
            current: Colour::hex(0xe69f00),
            current_fill: 0.18,
            current_outline: Colour::hex(0xbe8402),
            lit: Colour::hex(0xfdf5e5),
            rejected: Colour::hex(0x6f33a5),
            ancestor: Colour::hex(0x6d8faf),
            shade: Colour::hex(0x000000).faded(0.6),
            blank: Colour::hex(0x000000),
            accent: Colour::hex(0x00619e),
            on_accent: Colour::hex(0xffffff),
        };
        match theme {
            Theme::Light => light,
            // Lines that are thin on paper are darker.
            Theme::Print => Self { panel: light.background, grid: Colour::hex(0xa3adb7), ..light },
            Theme::Projector => Self {
                panel: light.background,
                hairline: Colour::hex(0x8a949e),
                ink: Colour::hex(0x000000),
                quiet_ink: Colour::hex(0x000000),
                grid: Colour::hex(0x9aa4ae),
                // Darker than elsewhere, and as far from each other.
                axes: [0x9c3a06, 0x18684b, 0x0c76a6].map(Colour::hex),
                ray: Colour::hex(0xc80663),
                current_fill: 0.35,
                current_outline: Colour::hex(0xbe8402),
                lit: Colour::hex(0xfdf3de),
                rejected: Colour::hex(0x6f339c),
                ancestor: Colour::hex(0x000000),
                ..light
            },
            Theme::Dark => Self {
                background: Colour::hex(0x12161b),
                panel: Colour::hex(0x1a2027),
                field: Colour::hex(0x12161b),
                hairline: Colour::hex(0x2c353f),
                ink: Colour::hex(0xe9eef3),
                quiet_ink: Colour::hex(0x9fadba),
                grid: Colour::hex(0x36414d),
                axes: [0xf58f50, 0x2fdea9, 0x6ba1fa].map(Colour::hex),
                ray: Colour::hex(0xfe5285),
                current: Colour::hex(0xffc147),
                current_fill: 0.15,
                current_outline: Colour::hex(0xffc147),
                lit: Colour::hex(0x3d3523),
                rejected: Colour::hex(0xc9b9f7),
                ancestor: Colour::hex(0x96a1bf),
                shade: Colour::hex(0x000000).faded(0.7),
                blank: Colour::hex(0x000000),
                accent: Colour::hex(0x66b7ff),
                on_accent: Colour::hex(0x12161b),
            },
        }
    }
}

/// Place `share`, 0 … 1, on the ramp cividis [Nuñez, Anderton, Renslow 2018]:
/// even in lightness, the same to colour-blind eyes. Dark themes begin a good third along
/// it, so that nothing sinks into the background; all end before its lightest part, which
/// would look like the current node, to colour-blind eyes first.
pub fn ramp(theme: Theme, share: f64) -> Colour {
    const STOPS: [u32; 10] = [
        0x00224e, 0x123570, 0x3b496c, 0x575d6d, 0x707173, 0x8a8678, 0xa59c74, 0xc3b369, 0xe1cc55,
        0xfee838,
    ];
    let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
    let share = match theme {
        Theme::Light | Theme::Print | Theme::Projector => 0.68 * share,
        Theme::Dark => 0.36 + 0.4 * share,
    };
    let place = share * (STOPS.len() - 1) as f64;
    let below = (place.floor() as usize).min(STOPS.len() - 2);
    Colour::hex(STOPS[below + 1]).faded(place - below as f64).over(Colour::hex(STOPS[below]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contrast_is_that_of_the_standard() {
        let [black, white] = [0x000000, 0xffffff].map(Colour::hex);
        assert!((contrast(black, white) - 21.0).abs() < 1e-9);
        assert!((contrast(Colour::hex(0x767676), white) - 4.54).abs() < 0.01);
        assert_eq!(contrast(black.faded(0.0), white), 1.0);
    }

    #[test]
    fn text_can_be_read_in_every_theme() {
        for theme in Theme::ALL {
            let p = Palette::of(theme);
            for text in
                [p.ink, p.quiet_ink, p.ray, p.rejected, p.accent, p.axes[0], p.axes[1], p.axes[2]]
            {
                for below in [p.background, p.panel, p.field] {
                    let ratio = contrast(text, below);
                    assert!(ratio >= 4.5, "{theme:?} {text:?} has {ratio:.2}");
                }
            }
            // Nothing in the colours of the ray and of controls stands in a table.
            for text in [p.ink, p.quiet_ink, p.rejected, p.axes[0], p.axes[1], p.axes[2]] {
                let ratio = contrast(text, p.lit);
                assert!(ratio >= 4.5, "{theme:?} {text:?} has {ratio:.2} where it is lit");
            }
            assert!(contrast(p.on_accent, p.accent) >= 4.5);
        }
    }

    #[test]
    fn the_ramp_grows_lighter() {
        for theme in Theme::ALL {
            let lightness: Vec<f64> =
                (0..=20).map(|i| ramp(theme, f64::from(i) / 20.0).luminance()).collect();
            assert!(lightness.is_sorted());
        }
    }
}
