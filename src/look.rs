//! How the window speaks and looks: texts and colours for the panels.

use eframe::egui::text::TextFormat;
use eframe::egui::{Align, Color32, FontFamily, FontId};
use octoscope_core::explain::{RichText, Span};
use octoscope_core::text::Texts;
use octoscope_figure::{Lettering, Theme};

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
    /// The rail of a slider, and the border of a field.
    pub rail: Color32,
    /// The axes x, y, z.
    pub axes: [Color32; 3],
    /// The ray.
    pub ray: Color32,
    /// Inside what is current.
    pub current_fill: Color32,
    /// Around what is current.
    pub current_line: Color32,
    /// Behind what the step uses in tables.
    pub lit: Color32,
    /// What was not taken.
    pub rejected: Color32,
    /// Over what is not to be looked at.
    pub shade: Color32,
    /// All of a window that shows nothing.
    pub blank: Color32,
    /// What is chosen.
    pub accent: Color32,
    /// Text on what is chosen.
    pub on_accent: Color32,
}

/// Size of a subscript against that of the text.
const SUB_SIZE: f32 = Lettering::SUB_SIZE as f32;
/// Height of a line, and of what is above its baseline, against the type's.
const LINE: f32 = 1.21;
const ASCENT: f32 = 0.97;

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

    /// How a piece of a line of `size` points is set: a subscript is smaller and lower.
    pub fn set(&self, span: &Span, size: f32, family: FontFamily) -> TextFormat {
        let set = |size: f32, valign: Align| TextFormat {
            font_id: FontId::new(size, family.clone()),
            valign,
            ..TextFormat::default()
        };
        match (span.sub, self.drop(size)) {
            (false, None) => set(self.type_size(size), Align::Center),
            (true, None) => set(size * SUB_SIZE, Align::BOTTOM),
            (false, Some(_)) => set(self.type_size(size), Align::TOP),
            (true, Some(drop)) => {
                let size = self.least_type;
                let line_height = Some(LINE * size + 2.0 * drop);
                TextFormat { line_height, ..set(size, Align::TOP) }
            }
        }
    }

    /// By how much the middle of a line of `size` points lies above that of what is
    /// painted.
    pub fn lowered(&self, size: f32, text: &RichText) -> f32 {
        let drop = self.drop(size).filter(|_| text.0.iter().any(|span| span.sub));
        let line = LINE * (self.type_size(size) - self.least_type);
        drop.map_or(0.0, |drop| (drop - 0.5 * line).max(0.0))
    }

    /// How far a subscript has to be lowered that would be too small, in points from
    /// the top of the line; `None` if it is large enough.
    fn drop(&self, size: f32) -> Option<f32> {
        let text = self.type_size(size);
        let higher = ASCENT * (text - self.least_type);
        (size * SUB_SIZE < self.least_type).then_some(higher + Lettering::SUB_DROP as f32 * text)
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
