//! Figures as TikZ, written so that a person can edit them: named styles for
//! the roles, coordinates with few digits, text as text.

mod slides;
mod styles;

use crate::typeset::Line;
use crate::{Anchor, Background, Drawn, Figure, FileOptions, Form, Palette, Role, metrics};
use octoscope_core::explain::{RichText, latex, math};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, HashMap};
use std::fmt::Write;
use std::rc::Rc;

/// What is written around the pictures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum TikzForm {
    /// A document that has a page a figure.
    #[default]
    Standalone,
    /// Pictures to be put into a document that uses the package tikz.
    Snippet,
    /// A document of slides: one frame, on which the figures follow each other.
    Beamer,
    /// One picture for a frame of slides, on which the figures follow each other.
    BeamerSnippet,
}

/// Beginning of the lines that hold the scenario.
pub(crate) const SCENARIO_LINE: &str = "%%octoscope ";

/// Names of the colours of the axes, see [`Palette::name_of`].
const AXES: [&str; 3] = ["octo-axis-x", "octo-axis-y", "octo-axis-z"];

/// TikZ that is being written.
pub struct Tikz<'a> {
    options: FileOptions<'a>,
    form: TikzForm,
    /// Styles and what they say, in the order of the roles.
    styles: BTreeMap<(usize, String), String>,
    /// Colours and their values in hexadecimal.
    colours: BTreeMap<String, String>,
    /// Every line that occurs, once: the steps of a run share most of theirs.
    lines: Vec<Rc<str>>,
    numbers: HashMap<Rc<str>, u32>,
    pictures: Vec<Picture>,
}

struct Picture {
    width: f64,
    height: f64,
    /// Numbers of its lines.
    lines: Vec<u32>,
    /// What is said below it, for LaTeX; only slides show it.
    caption: String,
}

/// TikZ of one figure.
pub fn tikz(figure: &Figure, form: TikzForm, options: &FileOptions) -> String {
    let mut tikz = Tikz::new(form, options);
    tikz.figure(figure, &RichText::default());
    tikz.finish()
}

impl<'a> Tikz<'a> {
    /// TikZ without figures.
    pub fn new(form: TikzForm, options: &FileOptions<'a>) -> Self {
        Self {
            options: *options,
            form,
            styles: BTreeMap::new(),
            colours: BTreeMap::new(),
            lines: Vec::new(),
            numbers: HashMap::new(),
            pictures: Vec::new(),
        }
    }

    /// Appends a figure: a picture of its own, or the next slide with a caption.
    pub fn figure(&mut self, figure: &Figure, caption: &RichText) {
        let mut lines = Vec::with_capacity(figure.drawn.len());
        for drawn in &figure.drawn {
            let Some(line) = self.line(drawn, figure.page.height) else { continue };
            let number = self.numbers.get(line.as_str()).copied().unwrap_or_else(|| {
                let (line, number) = (Rc::from(line), self.lines.len() as u32);
                self.lines.push(Rc::clone(&line));
                self.numbers.insert(line, number);
                number
            });
            lines.push(number);
        }
        let (width, height) = (figure.page.width, figure.page.height);
        let caption = match self.form {
            TikzForm::Standalone | TikzForm::Snippet => String::new(),
            TikzForm::Beamer | TikzForm::BeamerSnippet => self.text(caption),
        };
        self.pictures.push(Picture { width, height, lines, caption });
    }

    /// The text.
    pub fn finish(mut self) -> String {
        let FileOptions { title, scenario, theme, background, .. } = self.options;
        let mut out = String::new();
        if !title.is_empty() {
            out += &format!("% {}\n", title.replace(['\n', '\r'], " "));
        }
        scenario.lines().for_each(|line| out += &format!("{SCENARIO_LINE}{line}\n"));
        let is_document = matches!(self.form, TikzForm::Standalone | TikzForm::Beamer);
        out += match self.form {
            TikzForm::Standalone => "\\documentclass[tikz]{standalone}\n",
            TikzForm::Beamer => {
                "\\documentclass{beamer}\n\\usepackage{tikz}\n\
                                 \\setbeamertemplate{navigation symbols}{}\n"
            }
            TikzForm::Snippet | TikzForm::BeamerSnippet => "% Needs \\usepackage{tikz}.\n",
        };
        if is_document {
            out += "\\usepackage[utf8]{inputenc}\n\\usepackage[T1]{fontenc}\n\
                    \\IfFileExists{lmodern.sty}{\\usepackage{lmodern}}{}\n";
        }
        if background == Background::Filled {
            let colour = self.colour(Palette::of(theme).background);
            self.styles.insert((0, "octo background".to_owned()), format!("fill={colour}"));
        }
        for (name, value) in &self.colours {
            out += &format!("\\definecolor{{{name}}}{{HTML}}{{{value}}}\n");
        }
        out += "\\tikzset{\n";
        for ((_, name), style) in &self.styles {
            out += &format!("  {name}/.style={{{style}}},\n");
        }
        out += "}\n";
        if is_document {
            out += "\\begin{document}\n";
        }
        match self.form {
            TikzForm::Standalone | TikzForm::Snippet => {
                self.pictures.iter().for_each(|picture| self.picture(&mut out, picture));
            }
            TikzForm::Beamer => self.frame(&mut out),
            TikzForm::BeamerSnippet => {
                let shared = self.shared(&mut out);
                self.overlays(&mut out, &shared);
                self.captions(&mut out);
            }
        }
        if is_document {
            out += "\\end{document}\n";
        }
        out
    }

    fn picture(&self, out: &mut String, picture: &Picture) {
        self.begin(out, picture);
        self.write_lines(out, &picture.lines);
        *out += "\\end{tikzpicture}\n";
    }

    fn write_lines(&self, out: &mut String, lines: &[u32]) {
        lines.iter().for_each(|&line| *out += &self.lines[line as usize]);
    }

    fn begin(&self, out: &mut String, picture: &Picture) {
        let unit = length(self.options.scale.points());
        let corner = self.point([picture.width, 0.0], picture.height);
        *out += &format!(
            "\\begin{{tikzpicture}}[x={unit}, y={unit}]\n\
             \\useasboundingbox (0,0) rectangle {corner};\n"
        );
        if self.options.background == Background::Filled {
            *out += &format!("\\path[octo background] (0,0) rectangle {corner};\n");
        }
    }

    /// Line of a shape on a page of `height`; `None` if nothing of it is seen.
    fn line(&mut self, drawn: &Drawn, height: f64) -> Option<String> {
        if let Some(Line { at, anchor, text }) = Line::of(&drawn.form) {
            let style = self.text_style(drawn.role)?;
            let anchor = match anchor {
                Anchor::Start => ", anchor=base west",
                Anchor::Middle => "",
                Anchor::End => ", anchor=base east",
            };
            let at = self.point(at, height);
            let text = self.text(text);
            return Some(format!("\\node[{style}{anchor}] at {at} {{{text}}};\n"));
        }
        if let Form::Formula { at: [x, y], formula, of } = &drawn.form {
            let style = self.text_style(drawn.role)?;
            for axis in 0..AXES.len() {
                self.colour(Palette::of(self.options.theme).axes[axis]);
            }
            // Other texts hang from half the height of their capitals.
            let half = 0.365 * metrics::size(Role::Formula(of.step));
            let at = self.point([*x, y - half], height);
            let formula = math(formula, Some(AXES));
            return Some(format!(
                "\\node[{style}, anchor=base west] at {at} {{$\\displaystyle {formula}$}};\n"
            ));
        }
        let style = self.style(drawn)?;
        let path = match &drawn.form {
            Form::Polygon(points) => match rectangle(points) {
                Some(corners) => {
                    let [a, b] = corners.map(|corner| self.point(corner, height));
                    format!("{a} rectangle {b}")
                }
                None => format!("{} -- cycle", self.points(points, height)),
            },
            Form::Polyline(points) => self.points(points, height),
            Form::Circle { centre, radius } => {
                let centre = self.point(*centre, height);
                format!("{centre} circle[radius={}]", self.number(*radius))
            }
            Form::Text { .. } | Form::Formula { .. } => return None,
        };
        let dashes = self.dashes(drawn);
        Some(format!("\\path[{style}{dashes}] {path};\n"))
    }

    /// Text for LaTeX; the colours of its axes are defined.
    fn text(&mut self, text: &RichText) -> String {
        for axis in text.0.iter().filter_map(|span| span.axis) {
            self.colour(Palette::of(self.options.theme).axes[axis]);
        }
        latex(text, Some(AXES))
    }

    fn points(&self, points: &[[f64; 2]], height: f64) -> String {
        let mut out = String::new();
        for (index, &point) in points.iter().enumerate() {
            let line = if index == 0 { "" } else { " -- " };
            write!(out, "{line}{}", self.point(point, height)).expect("a string takes all");
        }
        out
    }

    /// A point of the page; y points up in TikZ.
    fn point(&self, [x, y]: [f64; 2], height: f64) -> String {
        format!("({},{})", self.number(x), self.number(height - y))
    }

    /// A length in page units, as fine as a tenth of a point.
    fn number(&self, x: f64) -> String {
        decimal(x, if self.options.scale.points() > 1.5 { 2 } else { 1 })
    }
}

/// Two opposite corners, if the polygon is a rectangle along the page.
fn rectangle(points: &[[f64; 2]]) -> Option<[[f64; 2]; 2]> {
    let [a, b, c, d] = points else { return None };
    let level = |p: &[f64; 2], q: &[f64; 2]| (p[1] - q[1]).abs() < 1e-6;
    let plumb = |p: &[f64; 2], q: &[f64; 2]| (p[0] - q[0]).abs() < 1e-6;
    let is_one = level(a, b) && plumb(b, c) && level(c, d) && plumb(d, a)
        || plumb(a, b) && level(b, c) && plumb(c, d) && level(d, a);
    is_one.then_some([*a, *c])
}

fn length(points: f64) -> String {
    format!("{}bp", decimal(points, 3))
}

/// Number with at most so many digits after the point.
fn decimal(x: f64, digits: usize) -> String {
    let text = format!("{x:.digits$}");
    let text =
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
