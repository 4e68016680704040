//! How the window speaks and looks: texts and colours for the panels.

use eframe::egui::{Color32, FontFamily};
use octoscope_core::text::Texts;
use octoscope_figure::Theme;

/// Texts of the chosen language and colours of the chosen theme.
pub struct Look {
    /// Texts.
    pub texts: Texts,
    /// Colours.
    pub palette: Palette,
    /// The theme, for what figures look like.
    pub theme: Theme,
    /// Least height of type, in points of the window; 0 where any is legible.
    pub least_type: f32,
}

/// Colours of the theme, as the window paints them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Palette {
    /// Text and strong lines.
    pub ink: Color32,
    /// Captions and quiet lines.
    pub quiet: Color32,
    /// Behind the space view.
    pub background: Color32,
    /// Behind panels.
    pub panel: Color32,
    /// Behind fields in panels.
    pub field: Color32,
    /// Lines between panels.
    pub hairline: Color32,
    /// Hints of structure.
    pub grid: Color32,
    /// The axes x, y, z.
    pub axes: [Color32; 3],
    /// The ray.
    pub ray: Color32,
    /// Inside what is current.
    pub current_fill: Color32,
    /// Around what is current.
    pub current_line: Color32,
    /// What was not taken.
    pub rejected: Color32,
    /// Over what is not to be looked at.
    pub shade: Color32,
    /// What is chosen.
    pub accent: Color32,
    /// Text on what is chosen.
    pub on_accent: Color32,
}

impl Look {
    /// Text of a key.
    pub fn text(&self, key: &str) -> String {
        self.texts.get(key)
    }

    /// Whether a hall sees it: little at once, in large type.
    pub fn is_for_hall(&self) -> bool {
        self.least_type > 0.0
    }

    /// Height of type that is of `size` points where any is legible.
    pub fn type_size(&self, size: f32) -> f32 {
        size.max(self.least_type)
    }

    /// Family of emphasised text.
    pub fn strong_family(&self) -> FontFamily {
        FontFamily::Name("strong".into())
    }

    /// Family of emphasised bits.
    pub fn mono_strong_family(&self) -> FontFamily {
        FontFamily::Name("mono-strong".into())
    }
}
