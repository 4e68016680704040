//! Figures as SVG.

use crate::{
    Anchor, Background, Colour, Dash, Dashes, Drawn, Figure, FileOptions, Form, Lettering, Paint,
    Palette, Part, Role, Style, Theme, Unit, Weight,
};
use octoscope_core::explain::RichText;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Text of an SVG document: a class for every role in one style sheet, text as
/// text, coordinates with two digits after the point.
pub fn svg(figure: &Figure, options: &FileOptions) -> String {
    let figure = &*figure.spelled_out();
    let page = [figure.page.width, figure.page.height];
    let [width, height] = page.map(number);
    let unit = if options.scale.unit == Unit::Pixel { "" } else { options.scale.unit.id() };
    let shown = |length: f64| format!("{}{unit}", number(length * options.scale.factor));
    let [shown_width, shown_height] = page.map(shown);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{shown_width}\" \
         height=\"{shown_height}\" \
         viewBox=\"0 0 {width} {height}\">\n"
    );
    for (element, text) in [("title", options.title), ("metadata", options.scenario)] {
        if !text.is_empty() {
            out += &format!("<{element}>{}</{element}>\n", escaped(text));
        }
    }
    out += &style_sheet(figure, options);
    if options.background == Background::Filled {
        let colour = hex(Palette::of(options.theme).background);
        out += &format!("<rect width=\"{width}\" height=\"{height}\" fill=\"{colour}\"/>\n");
    }
    for drawn in &figure.drawn {
        write_drawn(&mut out, drawn, options);
    }
    out + "</svg>\n"
}

fn style_sheet(figure: &Figure, options: &FileOptions) -> String {
    let theme = options.theme;
    let wide = |width: f64| number(width * options.line_scale);
    let roles: BTreeMap<&str, Role> =
        figure.drawn.iter().map(|drawn| (drawn.role.class(), drawn.role)).collect();
    let mut out = String::from("<style>\n");
    for (class, role) in roles {
        let style = Style::of(theme, role);
        let fill = if has_own_fill(role) { String::new() } else { paint("fill", style.fill) };
        let stroke = if has_own_fill(role) { String::new() } else { paint("stroke", style.stroke) };
        out += &format!(".{class}{{{fill}{stroke}stroke-width:{}", wide(style.width));
        if !style.dash.pattern().is_empty() {
            let lengths = style.dash.pattern().iter().map(|l| wide(l * style.width));
            out += &format!(";stroke-dasharray:{}", lengths.collect::<Vec<_>>().join(" "));
        }
        out += "}\n";
        if figure.drawn.iter().any(|d| d.part == Part::Head && d.role.class() == class) {
            let head = paint("fill", style.stroke);
            out += &format!(".{class}.head{{{head}stroke:none}}\n");
        }
        for (part, selector) in [(Part::Fine, "fine"), (Part::FineEdge, "fine.edge")] {
            if figure.drawn.iter().any(|d| d.part == part && d.role.class() == class) {
                let width = wide(part.width() * style.width);
                out += &format!(".{class}.{selector}{{stroke-width:{width}}}\n");
            }
        }
        if figure.drawn.iter().any(|d| d.part == Part::Casing && d.role.class() == class) {
            let background = paint("stroke-opacity:1;stroke", Some(Palette::of(theme).background));
            let width = wide(style.width + 2.0 * style.casing);
            out += &format!(
                ".{class}.casing{{fill:none;{background}stroke-width:{width};stroke-dasharray:none}}\n"
            );
        }
        for light in 0..=Part::MOST_LIGHT {
            let part = Part::Lit(light);
            if figure.drawn.iter().any(|d| d.part == part && d.role.class() == class) {
                let lit = Style::lit(theme, role, light);
                let fill = paint("fill-opacity:1;fill", lit.fill);
                let stroke = paint("stroke-opacity:1;stroke", lit.stroke);
                let width = wide(lit.width);
                out += &format!(".{class}.lit-{light}{{{fill}{stroke}stroke-width:{width}}}\n");
            }
        }
        if let Some(text) = style.text {
            let (weight, family) = match text.weight {
                Weight::Regular => (400, SANS),
                Weight::Strong => (600, SANS),
                Weight::Mono => (400, MONO),
                Weight::MonoStrong => (700, MONO),
            };
            let size = number(text.size);
            let fill = paint("fill-opacity:1;fill", Some(text.colour));
            out += &format!(
                "text.{class}{{{fill}stroke:none;font:{weight} {size}px {family};\
                 text-anchor:middle}}\n"
            );
        }
    }
    write_text_styles(&mut out, figure, theme);
    out + "polygon,polyline{stroke-linejoin:round}\n.face{stroke:none}\n.edge{fill:none}\n</style>\n"
}

/// Classes of anchors and of pieces of texts, as far as they occur.
fn write_text_styles(out: &mut String, figure: &Figure, theme: Theme) {
    let texts = || {
        figure.drawn.iter().filter_map(|drawn| match &drawn.form {
            Form::Text { anchor, text, .. } => Some((*anchor, text)),
            Form::Polygon(_) | Form::Polyline(_) | Form::Circle { .. } | Form::Formula { .. } => {
                None
            }
        })
    };
    for (anchor, name) in [(Anchor::Start, "start"), (Anchor::End, "end")] {
        if texts().any(|(other, _)| other == anchor) {
            *out += &format!("text.{name}{{text-anchor:{name}}}\n");
        }
    }
    let spans = || texts().flat_map(|(_, text)| &text.0);
    if spans().any(|span| span.strong || span.axis.is_some()) {
        *out += ".strong{font-weight:600}\n";
    }
    for axis in 0..AXIS_CLASSES.len() {
        if spans().any(|span| span.axis == Some(axis)) {
            let colour = Style::of(theme, Role::AxisLabel(axis)).text.map(|text| text.colour);
            *out += &format!(".{}{{{}}}\n", AXIS_CLASSES[axis], paint("fill", colour));
        }
    }
}

/// Classes of pieces of text in the colours of the axes.
const AXIS_CLASSES: [&str; 3] = ["on-x", "on-y", "on-z"];

/// The pieces of a text: one that looks as the text does is written as it is.
fn spans(text: &RichText, size: f64) -> String {
    let drop = Lettering::SUB_DROP * size;
    let mut out = String::new();
    let mut is_low = false;
    for span in &text.0 {
        let mut attributes = String::new();
        let axis = span.axis.and_then(|axis| AXIS_CLASSES.get(axis).copied());
        let strong = (span.strong || axis.is_some()).then_some("strong");
        let classes: Vec<&str> = axis.into_iter().chain(strong).collect();
        if !classes.is_empty() {
            attributes += &format!(" class=\"{}\"", classes.join(" "));
        }
        if span.sub != is_low {
            let by = if span.sub { drop } else { -drop };
            attributes += &format!(" dy=\"{}\"", number(by));
            is_low = span.sub;
        }
        if span.sub {
            let size = number(Lettering::SUB_SIZE * size);
            attributes += &format!(" style=\"font-size:{size}px\"");
        }
        let written = escaped(&span.text);
        if attributes.is_empty() {
            out += &written;
        } else {
            out += &format!("<tspan{attributes}>{written}</tspan>");
        }
    }
    out
}

const SANS: &str = "Inter,\"Helvetica Neue\",Arial,sans-serif";
const MONO: &str = "\"JetBrains Mono\",Menlo,Consolas,monospace";

/// Whether the colours of a role differ from one shape to the next.
fn has_own_fill(role: Role) -> bool {
    matches!(role, Role::Visited { .. } | Role::Pixel(_))
}

fn write_drawn(out: &mut String, drawn: &Drawn, options: &FileOptions) {
    let theme = options.theme;
    let mut attributes = format!(" class=\"{}", drawn.role.class());
    match drawn.part {
        Part::Whole => {}
        Part::Fine => attributes += " fine",
        Part::Face(_) => attributes += " face",
        Part::Head => attributes += " head",
        Part::Lit(light) => attributes += &format!(" lit-{light}"),
        Part::Edge | Part::HiddenEdge => attributes += " edge",
        Part::FineEdge => attributes += " fine edge",
        Part::Casing => attributes += " casing",
    }
    if let Form::Text { anchor, .. } = drawn.form {
        attributes += match anchor {
            Anchor::Start => " start",
            Anchor::Middle => "",
            Anchor::End => " end",
        };
    }
    attributes += "\"";
    if has_own_fill(drawn.role) {
        let style = Style::of(theme, drawn.role);
        for (name, colour) in [("fill", style.fill), ("stroke", style.stroke)] {
            if let Some(colour) = colour {
                let (rgb, opacity) = (hex(colour), number(colour.opacity));
                attributes += &format!(" {name}=\"{rgb}\" {name}-opacity=\"{opacity}\"");
            }
        }
    }
    if drawn.part.opacity() < 1.0 {
        attributes += &format!(" opacity=\"{}\"", number(drawn.part.opacity()));
    }
    let paint = Paint::of(theme, drawn).with_lines(options.line_scale);
    let of_class = Style::of(theme, drawn.role).dash;
    if of_class != Dash::Solid && drawn.part != Part::Casing && paint.stroke.is_some() {
        attributes += &match paint.dashes(&drawn.form) {
            Some(Dashes { lengths, offset }) => {
                let lengths: Vec<_> = lengths.into_iter().map(number).collect();
                let (lengths, offset) = (lengths.join(" "), number(offset));
                format!(" style=\"stroke-dasharray:{lengths};stroke-dashoffset:{offset}\"")
            }
            None => " style=\"stroke-dasharray:none\"".to_owned(),
        };
    }
    let written = match &drawn.form {
        Form::Polygon(points) => {
            writeln!(out, "<polygon{attributes} points=\"{}\"/>", list(points))
        }
        Form::Polyline(points) => {
            writeln!(out, "<polyline{attributes} points=\"{}\"/>", list(points))
        }
        Form::Circle { centre: [x, y], radius } => writeln!(
            out,
            "<circle{attributes} cx=\"{}\" cy=\"{}\" r=\"{}\"/>",
            number(*x),
            number(*y),
            number(*radius)
        ),
        Form::Text { at: [x, y], text, .. } => {
            // Capitals and digits are 0.73 of the type's height: centre them.
            let size = Style::of(theme, drawn.role).text.map_or(0.0, |text| text.size);
            let y = y + 0.365 * size;
            let text = spans(text, size);
            writeln!(
                out,
                "<text{attributes} x=\"{}\" y=\"{}\">{text}</text>",
                number(*x),
                number(y)
            )
        }
        // It is spelled out.
        Form::Formula { .. } => Ok(()),
    };
    written.expect("a string takes all that is written");
}

fn list(points: &[[f64; 2]]) -> String {
    let points = points.iter().map(|[x, y]| format!("{},{}", number(*x), number(*y)));
    points.collect::<Vec<_>>().join(" ")
}

fn paint(name: &str, colour: Option<Colour>) -> String {
    match colour {
        None => format!("{name}:none;"),
        Some(colour) if colour.opacity < 1.0 => {
            format!("{name}:{};{name}-opacity:{};", hex(colour), number(colour.opacity))
        }
        Some(colour) => format!("{name}:{};", hex(colour)),
    }
}

fn hex(colour: Colour) -> String {
    let [r, g, b] = colour.rgb;
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Number with at most two digits after the point.
fn number(x: f64) -> String {
    let text = format!("{x:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.to_string() }
}

/// Text that XML reads as text; what XML has no place for becomes a space.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            '\t' | '\n' | '\r' => out.push(c),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(
            [1.0, 0.5, -0.001, 12.345, 100.0].map(number),
            ["1", "0.5", "0", "12.35", "100"]
                .map(|s| s.replace("12.35", &format!("{:.2}", 12.345)))
        );
    }

    #[test]
    fn markup_in_text_is_text() {
        assert_eq!(escaped("a<b & \"c\"\u{1}"), "a&lt;b &amp; &quot;c&quot; ");
    }
}
