//! The themes as egui knows them: colours, type, spacing.

use crate::look::{Look, Palette};
use crate::text::texts;
use crate::view::View;
use eframe::egui::{
    Color32, Context, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, Stroke,
    TextStyle, Visuals, style::ScrollStyle, vec2,
};
use octoscope_core::text::Language;
use octoscope_figure::{Colour, Theme, contrast};
use std::sync::Arc;

/// Texts and colours for the panels.
pub fn look(language: Language, theme: Theme) -> Look {
    Look { texts: texts(language), palette: palette(theme), theme, least_type: 0.0 }
}

/// Texts, colours and least type of the window.
pub fn look_of(view: &View) -> Look {
    Look { least_type: view.preset.least_type(), ..look(view.language, view.theme) }
}

/// A colour of the stylesheet, as egui paints it.
pub fn color32(colour: Colour) -> Color32 {
    let [r, g, b] = colour.rgb;
    Color32::from_rgba_unmultiplied(r, g, b, (colour.opacity * 255.0).round() as u8)
}

fn palette(theme: Theme) -> Palette {
    let palette = octoscope_figure::Palette::of(theme);
    Palette {
        ink: color32(palette.ink),
        quiet: color32(palette.quiet_ink),
        background: color32(palette.background),
        panel: color32(palette.panel),
        field: color32(palette.field),
        hairline: color32(palette.hairline),
        grid: color32(palette.grid),
        rail: color32(rail(&palette)),
        axes: palette.axes.map(color32),
        ray: color32(palette.ray),
        current_fill: color32(palette.current.faded(palette.current_fill.max(0.22))),
        current_line: color32(palette.current_outline),
        lit: color32(palette.lit),
        rejected: color32(palette.rejected),
        shade: color32(palette.shade),
        blank: color32(palette.blank),
        accent: color32(palette.accent),
        on_accent: color32(palette.on_accent),
    }
}

/// The quietest colour that is told from what is behind a panel.
fn rail(palette: &octoscope_figure::Palette) -> Colour {
    let shares = (1..=20).map(|n| palette.quiet_ink.faded(0.05 * f64::from(n)).over(palette.panel));
    let mut seen = shares.filter(|&colour| contrast(colour, palette.panel) >= 3.2);
    seen.next().unwrap_or(palette.quiet_ink)
}

/// Makes the program's own fonts known.
pub fn install_fonts(context: &Context) {
    let mut fonts = FontDefinitions::empty();
    let families = [
        ("sans", octoscope_figure::fonts::SANS, FontFamily::Proportional),
        ("sans-strong", octoscope_figure::fonts::SANS_STRONG, FontFamily::Name("strong".into())),
        ("mono", octoscope_figure::fonts::MONO, FontFamily::Monospace),
        (
            "mono-strong",
            octoscope_figure::fonts::MONO_STRONG,
            FontFamily::Name("mono-strong".into()),
        ),
    ];
    for (name, bytes, family) in families {
        fonts.font_data.insert(name.to_owned(), Arc::new(FontData::from_static(bytes)));
        fonts.families.insert(family, vec![name.to_owned(), "mono".to_owned(), "sans".to_owned()]);
    }
    context.set_fonts(fonts);
    context.options_mut(|options| {
        // The window has a scale of its own, by the same keys.
        options.zoom_with_keyboard = false;
        // Where a frame takes long, a short click is seen as a long one.
        options.input_options.max_click_duration = f64::INFINITY;
    });
}

/// How long controls take to open, or to light up.
const ANIMATION_SECS: f32 = 0.08;

/// Sets colours, type and size for the frame that begins.
pub fn apply(context: &Context, view: &View) {
    let room = context.content_rect().size() * context.zoom_factor();
    let zoom = view.zoom(room);
    if (context.zoom_factor() - zoom).abs() > f32::EPSILON {
        context.set_zoom_factor(zoom);
    }
    let animation_time = if view.reduced_motion { 0.0 } else { ANIMATION_SECS };
    if context.global_style().animation_time != animation_time {
        context.all_styles_mut(|style| style.animation_time = animation_time);
    }
    let wanted = visuals(view.theme);
    if context.global_style().visuals != wanted {
        context.all_styles_mut(|style| {
            style.visuals = wanted.clone();
            style.text_styles = text_styles();
            style.spacing.item_spacing = vec2(8.0, 6.0);
            style.spacing.button_padding = vec2(8.0, 4.0);
            style.spacing.interact_size.y = 24.0;
            style.spacing.slider_width = 92.0;
            style.spacing.scroll = scroll_bars();
            style.interaction.resize_grab_radius_side = 6.0;
        });
    }
}

/// Thin bars that are seen wherever there is more, and take no room.
fn scroll_bars() -> ScrollStyle {
    ScrollStyle {
        floating_width: 5.0,
        floating_allocated_width: 0.0,
        bar_width: 8.0,
        bar_inner_margin: 0.0,
        bar_outer_margin: 0.0,
        dormant_background_opacity: 0.0,
        active_background_opacity: 0.0,
        foreground_color: true,
        dormant_handle_opacity: 0.6,
        active_handle_opacity: 0.8,
        ..ScrollStyle::thin()
    }
}

fn text_styles() -> std::collections::BTreeMap<TextStyle, FontId> {
    [
        (TextStyle::Small, FontId::proportional(13.0)),
        (TextStyle::Body, FontId::proportional(15.0)),
        (TextStyle::Button, FontId::proportional(15.0)),
        (TextStyle::Heading, FontId::proportional(18.0)),
        (TextStyle::Monospace, FontId::monospace(13.0)),
    ]
    .into()
}

fn visuals(theme: Theme) -> Visuals {
    let p = palette(theme);
    let dark = matches!(theme, Theme::Dark);
    let mut visuals = if dark { Visuals::dark() } else { Visuals::light() };
    visuals.weak_text_color = Some(p.quiet);
    visuals.panel_fill = p.panel;
    visuals.window_fill = p.panel;
    visuals.window_stroke = Stroke::new(1.0, p.hairline);
    visuals.extreme_bg_color = p.field;
    visuals.text_edit_bg_color = Some(p.field);
    visuals.faint_bg_color = match theme {
        Theme::Light | Theme::Dark => p.hairline.gamma_multiply(0.45),
        // Their lines are too dark for stripes.
        Theme::Print | Theme::Projector => p.ink.gamma_multiply(0.07),
    };
    visuals.hyperlink_color = p.accent;
    visuals.selection.bg_fill = p.accent;
    visuals.selection.stroke = Stroke::new(1.0, p.on_accent);
    visuals.slider_trailing_fill = true;
    let corners = CornerRadius::same(5);
    let line = |color: Color32, width: f32| Stroke::new(width, color);
    let widgets = &mut visuals.widgets;
    widgets.noninteractive.bg_stroke = line(p.hairline, 1.0);
    widgets.noninteractive.fg_stroke = line(p.ink, 1.0);
    for (widget, fill, border) in [
        (&mut widgets.inactive, p.field, line(p.rail, 1.0)),
        (&mut widgets.hovered, p.hairline, line(p.quiet, 1.0)),
        (&mut widgets.active, p.hairline, line(p.accent, 2.0)),
        (&mut widgets.open, p.hairline, line(p.quiet, 1.0)),
    ] {
        widget.bg_fill = fill;
        widget.weak_bg_fill = fill;
        widget.bg_stroke = border;
        widget.fg_stroke = line(p.ink, 1.5);
        widget.corner_radius = corners;
        widget.expansion = 0.0;
    }
    visuals
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_border_of_a_field_is_seen_in_every_theme() {
        for theme in Theme::ALL {
            let palette = octoscope_figure::Palette::of(theme);
            assert_eq!(visuals(theme).widgets.inactive.bg_stroke.color, color32(rail(&palette)));
            for border in [rail(&palette), palette.accent] {
                let ratio = contrast(border, palette.panel);
                assert!(ratio >= 3.0, "{theme:?} {ratio:.2}");
            }
            for ground in [palette.accent, palette.rejected] {
                let selected = contrast(palette.on_accent, ground);
                assert!(selected >= 4.5, "what is selected in {theme:?}: {selected:.2}");
            }
        }
    }

    #[test]
    fn the_rail_of_a_slider_is_seen_in_every_theme() {
        for theme in Theme::ALL {
            let palette = octoscope_figure::Palette::of(theme);
            let ratio = contrast(rail(&palette), palette.panel);
            assert!(ratio >= 3.0, "{theme:?} {ratio:.2}");
            let knob = contrast(palette.ink, rail(&palette));
            assert!(knob >= 3.0, "its knob in {theme:?}: {knob:.2}");
        }
    }
}
