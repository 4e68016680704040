//! A sheet on which a view is drawn.

use crate::{Anchor, Drawn, Figure, Form, Page, Part, Role, Style, Theme, metrics};
use octoscope_core::explain::RichText;

/// Shapes of a view in the order in which they are drawn; y points down.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sheet {
    drawn: Vec<Drawn>,
}

impl Sheet {
    /// Writes a line of text; returns its width.
    pub fn text(
        &mut self,
        role: Role,
        at: [f64; 2],
        anchor: Anchor,
        text: impl Into<RichText>,
    ) -> f64 {
        let text = text.into();
        let width = metrics::width(role, &text);
        if !text.0.is_empty() {
            self.push(role, Part::Whole, Form::Text { at, anchor, text });
        }
        width
    }

    /// Writes text in lines of at most `width`, the first one at the middle height
    /// `top` + half a line; returns the height of all lines.
    pub fn paragraph(
        &mut self,
        role: Role,
        [x, top]: [f64; 2],
        width: f64,
        text: &RichText,
    ) -> f64 {
        let height = line_height(role);
        let lines = metrics::wrapped(role, text, width);
        for (n, line) in lines.iter().enumerate() {
            self.text(role, [x, top + height * (n as f64 + 0.5)], Anchor::Start, line.clone());
        }
        height * lines.len() as f64
    }

    /// Draws a line.
    pub fn line(&mut self, role: Role, points: impl Into<Vec<[f64; 2]>>) {
        self.push(role, Part::Edge, Form::Polyline(points.into()));
    }

    /// Draws a rectangle from its upper left corner.
    pub fn rect(&mut self, role: Role, [x, y]: [f64; 2], [width, height]: [f64; 2]) {
        let [right, bottom] = [x + width, y + height];
        let points = vec![[x, y], [right, y], [right, bottom], [x, bottom]];
        self.push(role, Part::Whole, Form::Polygon(points));
    }

    /// Draws a disc as large as the role wants it.
    pub fn disc(&mut self, role: Role, centre: [f64; 2]) {
        let radius = Style::of(Theme::Light, role).radius;
        self.push(role, Part::Whole, Form::Circle { centre, radius });
    }

    /// Draws an arrow with a head of this length.
    pub fn arrow(&mut self, role: Role, [from, to]: [[f64; 2]; 2], head: f64) {
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        if length < 1e-9 {
            return;
        }
        let along: [f64; 2] = std::array::from_fn(|e| (to[e] - from[e]) / length);
        let neck: [f64; 2] = std::array::from_fn(|e| to[e] - head.min(length) * along[e]);
        let wing = |side: f64| {
            [neck[0] - side * 0.45 * head * along[1], neck[1] + side * 0.45 * head * along[0]]
        };
        self.push(role, Part::Edge, Form::Polyline(vec![from, neck]));
        self.push(role, Part::Head, Form::Polygon(vec![to, wing(1.0), wing(-1.0)]));
    }

    /// Draws another sheet or figure with its corner at a point.
    pub fn place(&mut self, drawn: impl IntoIterator<Item = Drawn>, at: [f64; 2]) {
        self.drawn.extend(drawn.into_iter().map(|mut drawn| {
            drawn.form.shift(at);
            drawn
        }));
    }

    /// The sheet as a page of this size.
    pub fn figure(self, [width, height]: [f64; 2]) -> Figure {
        Figure { page: Page { width, height }, drawn: self.drawn }
    }

    /// Draws a part of something.
    pub fn push(&mut self, role: Role, part: Part, form: Form) {
        self.drawn.push(Drawn { form, role, part, node: None });
    }
}

/// Distance of lines of text of a role.
pub(crate) fn line_height(role: Role) -> f64 {
    1.4 * metrics::size(role)
}
