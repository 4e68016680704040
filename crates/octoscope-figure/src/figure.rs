//! Figures: what is drawn on a page, in the order in which it is drawn.

use crate::{FormulaType, Page, Role, SetFormula, Style, Theme, metrics};
use octoscope_core::explain::{Formula, RichText};
use octoscope_core::tree::NodeId;

/// Shapes on a page, the lowest first.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Extent of the page.
    pub page: Page,
    /// What is drawn on it.
    pub drawn: Vec<Drawn>,
}

/// A shape on a page.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// Its form.
    pub form: Form,
    /// What it means, and so how it looks.
    pub role: Role,
    /// Which part of a mark it is.
    pub part: Part,
    /// The node that it stands for.
    pub node: Option<NodeId>,
}

/// A form in page units; y points down.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// Closed area.
    Polygon(Vec<[f64; 2]>),
    /// Line.
    Polyline(Vec<[f64; 2]>),
    /// Circle.
    Circle {
        /// Its middle.
        centre: [f64; 2],
        /// Its radius.
        radius: f64,
    },
    /// One line of text.
    Text {
        /// The point of it that `anchor` says, at half the height of its capitals.
        at: [f64; 2],
        /// Which point of the text that is.
        anchor: Anchor,
        /// What is written.
        text: RichText,
    },
    /// A formula.
    Formula {
        /// Where its baseline begins.
        at: [f64; 2],
        /// Size of its type.
        of: FormulaType,
        /// What it says.
        formula: Box<Formula>,
    },
}

/// Point of a line of text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Anchor {
    /// Where it begins.
    Start,
    /// Its middle.
    #[default]
    Middle,
    /// Where it ends.
    End,
}

impl Anchor {
    /// Share of the text's width that lies before the point.
    pub fn share(self) -> f64 {
        match self {
            Self::Start => 0.0,
            Self::Middle => 0.5,
            Self::End => 1.0,
        }
    }
}

/// Part of a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// All of it: area and line.
    Whole,
    /// All of it, with a finer line: a cell of which little is seen otherwise.
    Fine,
    /// Only the area: a side of a box across this axis, which is shaded by it.
    Face(usize),
    /// Only the area, in the colour of the line: the head of an arrow.
    Head,
    /// Only the area, covering what is behind it: a side of something solid,
    /// and how much light falls on it, 0 … [`Part::MOST_LIGHT`].
    Lit(u8),
    /// Only the line.
    Edge,
    /// Only the line, finer and unbroken: of a box of which little is seen otherwise.
    FineEdge,
    /// Only the line, behind the box to which it belongs.
    HiddenEdge,
    /// What parts the line from all below it: wider, in the colour of the background.
    Casing,
}

impl Part {
    /// The most light that falls on an area.
    pub const MOST_LIGHT: u8 = 7;

    /// Share of the role's width that lines of this part have.
    pub fn width(self) -> f64 {
        match self {
            Self::Fine => 0.4,
            Self::FineEdge => 0.6,
            Self::Whole
            | Self::Head
            | Self::Lit(_)
            | Self::Edge
            | Self::Face(_)
            | Self::HiddenEdge
            | Self::Casing => 1.0,
        }
    }

    /// Share of the role's opacity that areas and lines of this part have.
    pub fn opacity(self) -> f64 {
        match self {
            Self::Whole
            | Self::Fine
            | Self::Head
            | Self::Lit(_)
            | Self::Edge
            | Self::FineEdge
            | Self::Casing => 1.0,
            Self::Face(axis) => [1.0, 0.8, 0.62][axis],
            Self::HiddenEdge => 0.3,
        }
    }
}

impl Figure {
    /// What the drawing covers, lines and letters included; `None` if nothing is
    /// drawn.
    pub fn extent(&self) -> Option<Extent> {
        let covered = self.drawn.iter().flat_map(Drawn::extent);
        Extent::around(covered.flat_map(|(point, reach)| {
            [-1.0, 1.0].map(|sign| std::array::from_fn(|e| point[e] + sign * reach[e]))
        }))
    }

    /// What the drawn parts of these roles cover, one by one.
    pub fn extents_of(&self, is_wanted: impl Fn(Role) -> bool) -> Vec<Extent> {
        let parts = self.drawn.iter().filter(|drawn| is_wanted(drawn.role));
        let alone = |part: &Drawn| Self { page: self.page, drawn: vec![part.clone()] }.extent();
        parts.filter_map(alone).collect()
    }

    /// The same drawing on a page that ends `margin` beyond it.
    pub fn cropped(self, margin: f64) -> Self {
        match self.extent() {
            Some(extent) => self.on(extent.widened(margin)),
            None => self,
        }
    }

    /// The same drawing on a page of this extent.
    pub fn on(self, extent: Extent) -> Self {
        let [width, height] = extent.size();
        self.on_page(Page { width, height }, extent.min.map(|x| -x))
    }

    /// The same drawing on another page, with its corner at a point of that.
    pub fn on_page(mut self, page: Page, corner: [f64; 2]) -> Self {
        self.drawn.iter_mut().for_each(|drawn| drawn.form.shift(corner));
        Self { page, ..self }
    }
}

/// Part of a page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Upper left corner.
    pub min: [f64; 2],
    /// Lower right corner.
    pub max: [f64; 2],
}

impl Extent {
    /// The smallest that holds all of some points; `None` without any.
    pub fn around(points: impl IntoIterator<Item = [f64; 2]>) -> Option<Self> {
        points.into_iter().map(|point| Self { min: point, max: point }).reduce(Self::and)
    }

    /// Its middle.
    pub fn middle(self) -> [f64; 2] {
        std::array::from_fn(|e| 0.5 * (self.min[e] + self.max[e]))
    }

    /// The same, and `margin` more on every side.
    pub fn widened(self, margin: f64) -> Self {
        Self { min: self.min.map(|x| x - margin), max: self.max.map(|x| x + margin) }
    }

    /// The smallest that holds both.
    pub fn and(self, other: Self) -> Self {
        Self {
            min: std::array::from_fn(|e| self.min[e].min(other.min[e])),
            max: std::array::from_fn(|e| self.max[e].max(other.max[e])),
        }
    }

    /// Width and height.
    pub fn size(self) -> [f64; 2] {
        std::array::from_fn(|e| self.max[e] - self.min[e])
    }
}

impl Drawn {
    /// Points that it covers, with what it covers around them.
    fn extent(&self) -> Vec<([f64; 2], [f64; 2])> {
        let style = Style::of(Theme::Light, self.role);
        let half = 0.5 * style.width;
        match &self.form {
            Form::Polygon(points) | Form::Polyline(points) => {
                points.iter().map(|&p| (p, [half; 2])).collect()
            }
            Form::Circle { centre, radius } => vec![(*centre, [radius + half; 2])],
            Form::Text { at, anchor, text } => {
                let [left, right] = text_span(self.role, *anchor, text).map(|x| at[0] + x);
                let reach = [0.0, 0.6 * metrics::size(self.role)];
                vec![([left, at[1]], reach), ([right, at[1]], reach)]
            }
            Form::Formula { at: [x, y], of, formula } => {
                let set = SetFormula::of(formula, *of);
                vec![([*x, y - set.above], [0.0; 2]), ([x + set.width, y + set.below], [0.0; 2])]
            }
        }
    }
}

impl Form {
    pub(crate) fn shift(&mut self, by: [f64; 2]) {
        let shift = |p: &mut [f64; 2]| *p = [p[0] + by[0], p[1] + by[1]];
        match self {
            Self::Polygon(points) | Self::Polyline(points) => points.iter_mut().for_each(shift),
            Self::Circle { centre, .. } => shift(centre),
            Self::Text { at, .. } | Self::Formula { at, .. } => shift(at),
        }
    }
}

/// How far a text reaches to the left and to the right of its point.
pub(crate) fn text_span(role: Role, anchor: Anchor, text: &RichText) -> [f64; 2] {
    let width = metrics::width(role, text);
    [-anchor.share() * width, (1.0 - anchor.share()) * width]
}

/// Half width and half height of a text, estimated from its number of letters.
pub(crate) fn text_reach(role: Role, text: &str) -> [f64; 2] {
    const LETTER: f64 = 0.62;
    let size = Style::of(Theme::Light, role).text.map_or(0.0, |text| text.size);
    [0.5 * LETTER * size * text.chars().count() as f64, 0.6 * size]
}

/// Radius of the smallest disc around a number.
pub(crate) fn radius_around(role: Role, number: &str) -> f64 {
    /// Half the height of digits in type heights, and room around them.
    const DIGIT: f64 = 0.37;
    const ROOM: f64 = 0.6;
    let half = [0.5 * metrics::width(role, &number.into()), DIGIT * metrics::size(role)];
    half[0].hypot(half[1]) + ROOM
}
