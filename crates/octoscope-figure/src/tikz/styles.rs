//! Named styles and colours.

use super::{Tikz, decimal, length};
use crate::{
    Colour, Dash, Dashes, Drawn, Lettering, Paint, Palette, Part, Role, Style, Theme, Weight,
};

impl Tikz<'_> {
    /// Name of the style of a shape, which is defined; `None` if nothing is seen.
    pub(super) fn style(&mut self, drawn: &Drawn) -> Option<String> {
        let theme = self.options.theme;
        let paint = Paint::of(theme, drawn).with_lines(self.options.line_scale);
        let own = own_colour(theme, drawn.role).map(|colour| self.colour(colour));
        let part = match drawn.part {
            Part::Whole => String::new(),
            Part::Fine => " fine".to_owned(),
            Part::Face(axis) => format!(" face {}", ["x", "y", "z"][axis]),
            Part::Head => " head".to_owned(),
            Part::Lit(light) => format!(" lit {light}"),
            Part::Edge => " line".to_owned(),
            Part::HiddenEdge => " hidden line".to_owned(),
            Part::FineEdge => " fine line".to_owned(),
            Part::Casing => " casing".to_owned(),
        };
        let name = format!("octo {}{part}", drawn.role.class());
        let key = (drawn.role.layer() + 1, name);
        if !self.styles.contains_key(&key) {
            let style = self.painted(drawn, &paint)?;
            self.styles.insert(key.clone(), style);
        }
        Some(match own {
            Some(colour) => format!("{}={colour}", key.1),
            None => key.1,
        })
    }

    /// What a shape of dashes says beside its style, so that they fit into it.
    pub(super) fn dashes(&self, drawn: &Drawn) -> String {
        let paint = Paint::of(self.options.theme, drawn).with_lines(self.options.line_scale);
        if paint.dash == Dash::Solid || paint.stroke.is_none() {
            return String::new();
        }
        let Some(Dashes { lengths, offset }) = paint.dashes(&drawn.form) else {
            return ", solid".to_owned();
        };
        let points = self.options.scale.points();
        let pattern = dash_pattern(lengths.iter().map(|part| part * points));
        format!(", {pattern}, dash phase={}", length(offset * points))
    }

    /// What the style of a shape says.
    fn painted(&mut self, drawn: &Drawn, paint: &Paint) -> Option<String> {
        let own = own_colour(self.options.theme, drawn.role);
        let mut parts = Vec::new();
        let stroke = paint.stroke.filter(|_| paint.width > 0.0);
        for (name, colour) in [("fill", paint.fill), ("draw", stroke)] {
            let Some(colour) = colour else { continue };
            let shown = match own {
                Some(own) if own.rgb == colour.rgb => "#1".to_owned(),
                Some(_) | None => self.colour(colour),
            };
            parts.push(format!("{name}={shown}"));
            if colour.opacity < 1.0 {
                parts.push(format!("{name} opacity={}", decimal(colour.opacity, 2)));
            }
        }
        if parts.is_empty() {
            return None;
        }
        if stroke.is_some() {
            let points = self.options.scale.points();
            parts.push(format!("line width={}", length(paint.width * points)));
            parts.push("line join=round".to_owned());
            if paint.dash != Dash::Solid {
                let lengths = paint.dash.pattern().iter().map(|part| part * paint.width * points);
                parts.push(dash_pattern(lengths));
            }
        }
        Some(parts.join(", "))
    }

    /// Name of the style of a role's text, which is defined.
    pub(super) fn text_style(&mut self, role: Role) -> Option<String> {
        let Lettering { colour, size, weight } = Style::of(self.options.theme, role).text?;
        let name = format!("octo {} text", role.class());
        let key = (role.layer() + 1, name.clone());
        if !self.styles.contains_key(&key) {
            let size = size * self.options.scale.points();
            let family = match weight {
                Weight::Regular => "\\sffamily",
                Weight::Strong => "\\sffamily\\bfseries",
                Weight::Mono => "\\frenchspacing\\ttfamily",
                Weight::MonoStrong => "\\frenchspacing\\ttfamily\\bfseries",
            };
            let [height, skip, shift] = [size, 1.2 * size, -0.365 * size].map(length);
            let style = format!(
                "text={}, font={family}\\fontsize{{{height}}}{{{skip}}}\\selectfont, inner sep=0pt, \
                 anchor=base, yshift={shift}",
                self.colour(colour)
            );
            self.styles.insert(key, style);
        }
        Some(name)
    }

    /// Name of a colour, which is defined.
    pub(super) fn colour(&mut self, colour: Colour) -> String {
        let [r, g, b] = colour.rgb;
        let value = format!("{r:02X}{g:02X}{b:02X}");
        let name = match Palette::of(self.options.theme).name_of(colour.rgb) {
            Some(name) => format!("octo-{name}"),
            None => format!("octo-{value}"),
        };
        self.colours.entry(name.clone()).or_insert(value);
        name
    }
}

/// Dashes and gaps of these lengths in turn, in points.
fn dash_pattern(lengths: impl Iterator<Item = f64>) -> String {
    let parts = lengths.zip(["on", "off"].into_iter().cycle());
    let parts: Vec<_> = parts.map(|(part, is)| format!("{is} {}", length(part))).collect();
    format!("dash pattern={}", parts.join(" "))
}

/// The colour of a shape whose role has many, one for every shape.
fn own_colour(theme: Theme, role: Role) -> Option<Colour> {
    let has_many = matches!(role, Role::Visited { .. } | Role::Pixel(_));
    if has_many { Style::of(theme, role).fill } else { None }
}
