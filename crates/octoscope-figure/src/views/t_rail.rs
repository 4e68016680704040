//! Parameters t of the planes of the current node, on one axis.

mod labels;

use super::rail::{Rail, RailOf};
use super::sheet::Sheet;
use super::subject::Subject;
use super::words::{on_axis, parameter};
use crate::{Anchor, DiagramOf, Figure, Form, Part, Role, metrics};
pub use labels::RailRows;
use labels::{BADGE, Label, Sizes, spread};
use octoscope_core::explain::{RichText, distinct};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::query::Query;
use octoscope_core::text::Texts;
use octoscope_core::trace::{Moment, Reason, met};

/// The rail of a node: what is drawn, and where a t lies in it.
#[derive(Clone, Debug, PartialEq)]
pub struct RailFigure {
    /// What is drawn.
    pub figure: Figure,
    /// The latest entry and the earliest exit.
    pub limits: [f64; 2],
    /// Why it misses the node, in words, if it does.
    pub missed: Option<String>,
    /// The parameters of the planes, by their names, axis by axis.
    pub parameters: Vec<(RichText, f64)>,
    /// The t at both ends of the common axis.
    range: [f64; 2],
    /// Where that axis begins and ends on the page.
    track: [f64; 2],
}

impl RailFigure {
    /// The t at a distance from the left of the page.
    pub fn t_at(&self, x: f64) -> f64 {
        let [left, right] = self.track;
        at_share(((x - left) / (right - left)).clamp(0.0, 1.0), self.range)
    }
}

/// One bar per axis from t0 to t1 with tm, in rows set like this on a page of this
/// width, with room for type of at least `least` page units; `None` as long as no
/// parameter is known.
pub fn t_rail<const D: usize>(
    texts: &Texts,
    of: &DiagramOf<D>,
    width: f64,
    rows: RailRows,
    least: f64,
) -> Option<RailFigure> {
    let rail = Rail::of(of.moment)?.with_planes(of.tree, of.ray);
    let missed = missed(&rail, of, texts);
    let (range, track) = (rail.range(), track(width));
    let drawing = Drawing { rail: &rail, range, track, rows, sizes: rows.sizes(), least };
    let mut sheet = Sheet::default();
    drawing.draw(&mut sheet, texts, missed.as_deref());
    let figure = sheet.figure([width, t_rail_height::<D>(rows)]);
    let of_axis = |axis| rail.stops(axis).into_iter().map(move |(t, plane)| (axis, plane, t));
    let parameters = (0..D).flat_map(of_axis).map(|(axis, plane, t)| (parameter(axis, plane), t));
    let parameters = parameters.collect();
    let limits = rail.limits();
    Some(RailFigure { figure, limits, missed, parameters, range, track })
}

/// Where the common axis begins and ends on a page of this width.
fn track(width: f64) -> [f64; 2] {
    [24.0, width - 8.0]
}

/// Why the ray misses the node, in words, if it was found to.
fn missed<const D: usize>(rail: &Rail<D>, of: &DiagramOf<D>, texts: &Texts) -> Option<String> {
    let (RailOf::Node(node), None) = (rail.of, rail.interval) else { return None };
    let end = match of.query {
        Query::Ray { options, .. } => options.end(),
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => None,
    };
    let [enter, exit] = rail.limits();
    let say = |key: &str, names: [&'static str; 2], numbers: [f64; 2]| {
        let told = distinct(&numbers);
        let told: Vec<_> = names.into_iter().zip(told.into_iter().map(Into::into)).collect();
        texts.format(key, &told)
    };
    Some(match met(of.tree, of.ray, end, node) {
        Err(Reason::Beside { axis, .. }) => {
            texts.format("t-rail-beside", &[("axis", AXIS_NAMES[axis].into())])
        }
        Err(Reason::Behind { exit }) => say("t-rail-behind", ["exit", "start"], [exit.t, 0.0]),
        Err(Reason::BeyondEnd { enter, end }) => {
            let enter = enter.map_or(0.0, |enter| enter.t);
            say("t-rail-beyond", ["enter", "end"], [enter, end])
        }
        // What doubles find missed need not be, and what is need not be so in doubles.
        Err(
            Reason::Missed { .. }
            | Reason::Touched { .. }
            | Reason::AfterFull { .. }
            | Reason::Elsewhere { .. },
        )
        | Ok(_) => {
            let key = if exit < enter { "t-rail-missed" } else { "t-rail-closely" };
            say(key, ["exit", "enter"], [exit, enter])
        }
    })
}

/// What the rail tells of; `None` as long as no parameter is known.
pub fn rail_of<const D: usize>(moment: &Moment<D>) -> Option<RailOf<D>> {
    Rail::of(moment).map(|rail| rail.of)
}

/// The rail with the node above it, as a figure of this width.
pub(super) fn view<const D: usize>(subject: &Subject<D>, width: f64) -> Option<Figure> {
    const HEAD: f64 = 20.0;
    let Subject { tree, ray, moment, .. } = *subject;
    let of = DiagramOf {
        tree,
        ray,
        query: subject.query(),
        moment,
        event: subject.event(),
        strayed: &[],
    };
    let rail = t_rail(subject.texts, &of, width, RailRows::Small, 0.0)?;
    let mut sheet = Sheet::default();
    let text = rail_of(subject.moment)?.note(subject.texts, subject.tree);
    sheet.text(Role::Note, [0.0, 8.0], Anchor::Start, text);
    sheet.place(rail.figure.drawn, [0.0, HEAD]);
    Some(sheet.figure([width, rail.figure.page.height + HEAD]))
}

/// Height of a rail with rows that are set like this.
pub fn t_rail_height<const D: usize>(rows: RailRows) -> f64 {
    /// Room below the bars.
    const BELOW: f64 = 40.0;
    rows.sizes().row * D as f64 + BELOW
}

/// Where `t` lies between `low` and `high`, from 0 to 1; halved, as the whole
/// length may be larger than any number.
fn share_of(t: f64, [low, high]: [f64; 2]) -> f64 {
    ((t / 2.0 - low / 2.0) / (high / 2.0 - low / 2.0)).clamp(0.0, 1.0)
}

/// The parameter at this share of the way from `low` to `high`.
fn at_share(share: f64, [low, high]: [f64; 2]) -> f64 {
    low * (1.0 - share) + high * share
}

/// A rail on its page.
struct Drawing<'a, const D: usize> {
    rail: &'a Rail<D>,
    range: [f64; 2],
    track: [f64; 2],
    rows: RailRows,
    sizes: Sizes,
    least: f64,
}

impl<const D: usize> Drawing<'_, D> {
    fn x_of(&self, t: f64) -> f64 {
        let [left, right] = self.track;
        left + share_of(t, self.range) * (right - left)
    }

    fn bar_y(&self, axis: usize) -> f64 {
        self.sizes.row * axis as f64 + self.sizes.bar
    }

    fn bottom(&self) -> f64 {
        self.sizes.row * D as f64
    }

    fn draw(&self, sheet: &mut Sheet, texts: &Texts, missed: Option<&str>) {
        let [enter, exit] = self.rail.limits();
        if let Some([enter, exit]) = self.rail.interval.filter(|[enter, exit]| enter < exit) {
            let [from, to] = [enter, exit].map(|t| self.x_of(t));
            sheet.rect(Role::Inside, [from, 0.0], [to - from, self.bottom()]);
        }
        let labels: Vec<Label> = (0..D).flat_map(|axis| self.labels(axis)).collect();
        for t in [enter, exit].into_iter().filter(|t| t.is_finite()) {
            self.limit(sheet, self.x_of(t), &labels);
        }
        for axis in 0..D {
            self.bar(sheet, axis);
            self.labels(axis).iter().filter_map(Label::leader).for_each(|line| {
                sheet.push(Role::Stop(axis), Part::Fine, Form::Polyline(line.to_vec()));
            });
        }
        for Label { role, at, width, text, is_framed, .. } in labels {
            let mut start = at;
            if is_framed {
                let half = self.half_line();
                sheet.rect(Role::Blank, [at[0], at[1] - half], [width, 2.0 * half]);
                start[0] += BADGE;
            }
            sheet.text(role, start, Anchor::Start, text);
        }
        self.scale(sheet);
        match missed {
            Some(text) => self.note(sheet, text),
            None => self.ends(sheet, texts, [enter, exit]),
        }
    }

    /// Bar of an axis and the marks on it.
    fn bar(&self, sheet: &mut Sheet, axis: usize) {
        let y = self.bar_y(axis);
        sheet.text(Role::Heading, [0.0, y], Anchor::Start, on_axis(axis, AXIS_NAMES[axis]));
        if let Some([near, far]) = self.rail.bar(axis).filter(|[near, far]| near < far) {
            let [from, to] = [near, far].map(|t| self.x_of(t));
            sheet.line(Role::Bar(axis), [[from, y], [to, y]]);
            if !self.rail.begins_at_planes() {
                // Since when it is between the planes of this axis, is not known.
                let unknown = vec![[self.track[0], y], [from, y]];
                sheet.push(Role::Stop(axis), Part::Fine, Form::Polyline(unknown));
            }
            if self.rows == RailRows::Large {
                // As thick again.
                for off in [-2.5, 2.5] {
                    sheet.line(Role::Bar(axis), [[from, y + off], [to, y + off]]);
                }
            }
        }
        let [low, high] = self.range;
        for (t, _) in self.rail.stops(axis) {
            let x = self.x_of(t);
            if (low..=high).contains(&t) {
                sheet.line(Role::Stop(axis), [[x, y - self.sizes.tick], [x, y + self.sizes.tick]]);
            } else if !t.is_nan() {
                // Beyond the end: a head that is higher than the bar.
                let way = if t > high { 9.0 } else { -9.0 };
                let head = vec![[x, y], [x - way, y + 7.0], [x - way, y - 7.0]];
                sheet.push(Role::Stop(axis), Part::Head, Form::Polygon(head));
            }
        }
    }

    /// A dashed line across all bars, interrupted where something is written.
    fn limit(&self, sheet: &mut Sheet, x: f64, labels: &[Label]) {
        // Of less, a dash or two would be left.
        const LEAST: f64 = 10.0;
        let mut piece = |from: f64, to: f64| {
            if to - from >= LEAST {
                sheet.line(Role::Limit, [[x, from], [x, to]]);
            }
        };
        let mut from = 0.0;
        for label in labels {
            let [left, y] = label.at;
            if (left - 4.0..=left + label.width + 4.0).contains(&x) {
                let half = self.half_line();
                piece(from, y - half);
                from = y + half;
            }
        }
        piece(from, self.bottom() + 3.0);
    }

    /// The common axis, with 0 where it is in sight.
    fn scale(&self, sheet: &mut Sheet) {
        let (y, [left, right]) = (self.bottom() + 3.0, self.track);
        sheet.arrow(Role::Rule, [[left, y], [right + 6.0, y]], 6.0);
        sheet.text(Role::Scale, [right + 4.0, y + 11.0], Anchor::End, "t");
        let [low, high] = self.range;
        if low < 0.0 && high > 0.0 {
            let x = self.x_of(0.0);
            sheet.disc(Role::Zero, [x, y]);
            if x < right - 16.0 {
                sheet.text(Role::Zero, [x, y + 11.0], Anchor::Middle, "0");
            }
        }
    }

    /// A line below the bars, in the middle.
    fn note(&self, sheet: &mut Sheet, text: &str) {
        let middle = 0.5 * (self.track[0] + self.track[1]);
        sheet.text(Role::Note, [middle, self.notes_y()], Anchor::Middle, text);
    }

    /// Middle height of what is written below the bars.
    fn notes_y(&self) -> f64 {
        self.bottom() + 27.0
    }

    /// The latest entry and the earliest exit in words, below their lines.
    fn ends(&self, sheet: &mut Sheet, texts: &Texts, ends: [f64; 2]) {
        const GAP: f64 = 14.0;
        let y = self.notes_y();
        let texts: Vec<(f64, RichText)> = ["t-rail-enter", "t-rail-exit"]
            .into_iter()
            .zip(ends)
            .filter(|(_, t)| t.is_finite())
            .map(|(key, t)| {
                (self.x_of(t), format!("{} {}", texts.get(key), self.rail.told(t)).into())
            })
            .collect();
        let wanted: Vec<[f64; 2]> = texts
            .iter()
            .map(|(x, text)| {
                let width = metrics::width(Role::Note, text);
                [x - 0.5 * width, width]
            })
            .collect();
        // Not below the name of the axis, with which they would be read, if there is room.
        let beside = self.track[1] - 12.0;
        let all = wanted.iter().map(|[_, width]| width + GAP).sum::<f64>() - GAP;
        let right = if all <= beside { beside } else { self.track[1] + 6.0 };
        let starts = spread(&wanted, GAP, [0.0, right]);
        for ((_, text), start) in texts.into_iter().zip(starts) {
            sheet.text(Role::Note, [start, y], Anchor::Start, text);
        }
    }
}

#[cfg(test)]
mod tests;
