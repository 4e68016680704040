//! How costs grow: lines in logarithmic axes, with the exponents of the laws fitted to
//! them.

use super::marker::marker;
use super::names::{in_unit, measured_once, ratio, scene_name, short, way_name};
use crate::views::sheet::Sheet;
use crate::{Anchor, Figure, Form, Part, Role, metrics};
use octoscope_core::explain::RichText;
use octoscope_core::measure::{PowerLaw, Quantity, Results, Way, growth};
use octoscope_core::text::Texts;
use octoscope_core::traverse::{Algorithm, Kernel};

/// What is drawn against what.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Growth<'a> {
    /// The scene.
    pub scene: &'a str,
    /// What it grows with.
    pub size: Quantity,
    /// What grows.
    pub cost: Quantity,
}

/// How far a mark reaches; lengths of what leads to a name, and of the line beside it.
const MARK: f64 = 4.0;
const LEADER: f64 = 24.0;
const SAMPLE: f64 = 30.0;
/// Distance of two names.
const LABEL: f64 = 14.5;

/// One line.
struct Series {
    way: Way,
    points: Vec<[f64; 2]>,
    law: Option<PowerLaw>,
}

/// A line for each way over the depths of a scene, as a figure of this size.
pub fn growth_chart(
    results: &Results,
    of: Growth,
    texts: &Texts,
    [width, height]: [f64; 2],
) -> Figure {
    let mut sheet = Sheet::default();
    let all = all_series(results, of);
    if all.is_empty() {
        let key = match results.depths().len() {
            0 => "lab-nothing",
            1 => "lab-one-depth",
            _ => "lab-uncounted",
        };
        sheet.text(Role::Words, [0.0, 10.0], Anchor::Start, texts.get(key));
        return sheet.figure([width, 20.0]);
    }
    let shifts = shifts(&all);
    let mut note =
        texts.format("lab-growth-note", &[("scene", scene_name(of.scene, texts).into())]);
    note += &measured_once(results, of.cost, texts);
    if shifts.iter().any(|&shift| shift > 0.0) {
        note += &texts.get("lab-side-by-side");
    }
    let title = texts.get(&format!("lab-quantity-{}", of.cost.id()));
    sheet.text(Role::Heading, [0.0, 9.0], Anchor::Start, title);
    let top = 22.0 + sheet.paragraph(Role::Note, [0.0, 22.0], width, &note.into());

    let labels = labels(&all, texts);
    let widest = labels.iter().map(|label| metrics::width(Role::Note, label)).fold(0.0, f64::max);
    let right = width - widest - LEADER - SAMPLE - 8.0;
    let plot = Plot::of(&all, right, [top + 28.0, height - 40.0]);
    let units = [of.size, of.cost].map(|of| texts.get(&format!("lab-unit-{}", of.id())));
    plot.draw_axes(&mut sheet, units);
    plot.draw_curves(&mut sheet, &all, &shifts);
    plot.draw_names(&mut sheet, &all, &shifts, labels);
    sheet.figure([width, height])
}

/// The line of each way that has two points at least, in the units of the chart.
fn all_series(results: &Results, of: Growth) -> Vec<Series> {
    let in_units = |p: &[f64; 2]| [in_unit(of.size, p[0]), in_unit(of.cost, p[1])];
    let usable = |p: &[f64; 2]| p.iter().all(|x| *x > 0.0 && x.is_finite());
    let series = |way: Way| {
        let (points, law) = growth(results, of.scene, way, [of.size, of.cost]);
        Series { way, points: points.iter().map(in_units).filter(usable).collect(), law }
    };
    let all = results.ways().into_iter().map(series);
    all.filter(|series| series.points.len() > 1).collect()
}

/// What stands at the ends of the lines: names with exponents.
fn labels(all: &[Series], texts: &Texts) -> Vec<RichText> {
    let label = |series: &Series| {
        let exponent = ratio(series.law.map(|law| law.exponent));
        format!("{}  {exponent}", way_name(series.way, texts)).into()
    };
    all.iter().map(label).collect()
}

/// The axes, and between which places of the figure they lie.
struct Plot {
    axes: [Axis; 2],
    left: f64,
    right: f64,
    upper: f64,
    lower: f64,
}

impl Plot {
    /// With room for the numbers of the upright axis to the left of it.
    fn of(all: &[Series], right: f64, [upper, lower]: [f64; 2]) -> Self {
        let points = || all.iter().flat_map(|series| series.points.iter().copied());
        let axes = [0, 1].map(|e| Axis::around(points().map(|p| p[e])));
        let ticks = axes[1].ticks();
        let wide = ticks.iter().map(|&tick| metrics::width(Role::Scale, &short(tick).into()));
        let left = 10.0 + wide.fold(0.0, f64::max);
        Self { axes, left, right, upper, lower }
    }

    fn place(&self, p: [f64; 2]) -> [f64; 2] {
        let [x, y] = [0, 1].map(|e| self.axes[e].share(p[e]));
        let Self { left, right, upper, lower, .. } = *self;
        [left + x * (right - left), lower - y * (lower - upper)]
    }

    /// Lines of the axes with their numbers, as far as these have room, and units.
    fn draw_axes(&self, sheet: &mut Sheet, [x_unit, y_unit]: [String; 2]) {
        let Self { axes: [x_axis, y_axis], left, right, upper, lower } = self;
        sheet.text(Role::Scale, [0.0, upper - 18.0], Anchor::Start, y_unit);
        for tick in y_axis.ticks() {
            let y = self.place([1.0, tick])[1];
            sheet.line(Role::Scale, [[*left, y], [*right, y]]);
            sheet.text(Role::Scale, [left - 6.0, y], Anchor::End, short(tick));
        }
        let mut free_from = f64::NEG_INFINITY;
        for tick in x_axis.ticks() {
            let x = self.place([tick, 1.0])[0];
            sheet.line(Role::Scale, [[x, *upper], [x, *lower]]);
            let text = RichText::from(short(tick));
            let half = 0.5 * metrics::width(Role::Scale, &text);
            if x - half > free_from {
                sheet.text(Role::Scale, [x, lower + 12.0], Anchor::Middle, text);
                free_from = x + half + 6.0;
            }
        }
        sheet.text(Role::Scale, [*right, lower + 30.0], Anchor::End, x_unit);
    }

    fn draw_curves(&self, sheet: &mut Sheet, all: &[Series], shifts: &[f64]) {
        for (series, shift) in all.iter().zip(shifts) {
            let shifted = |[x, y]: [f64; 2]| [x, y + shift];
            let line: Vec<[f64; 2]> =
                series.points.iter().map(|&p| shifted(self.place(p))).collect();
            sheet.line(role_of(series.way), line.clone());
            for at in line {
                mark(sheet, series.way, at);
            }
        }
    }

    /// Names at the ends of the curves, as near to them as there is room.
    fn draw_names(&self, sheet: &mut Sheet, all: &[Series], shifts: &[f64], names: Vec<RichText>) {
        let Self { right, upper, lower, .. } = *self;
        let end = |series: &Series| series.points.last().map_or(lower, |&p| self.place(p)[1]);
        let ends: Vec<f64> = all.iter().zip(shifts).map(|(s, shift)| end(s) + shift).collect();
        let places = spread(&ends, LABEL, [upper - 8.0, lower + 8.0]);
        for (((series, name), end), y) in all.iter().zip(names).zip(ends).zip(places) {
            let role = role_of(series.way);
            let leader = vec![[right + 7.0, end], [right + LEADER, y]];
            sheet.push(role, Part::FineEdge, Form::Polyline(leader));
            // The line and the mark of the curve, beside its name.
            let [from, to] = [right + LEADER, right + LEADER + SAMPLE];
            sheet.line(role, [[from, y], [to, y]]);
            mark(sheet, series.way, [0.5 * (from + to), y]);
            sheet.text(Role::Note, [to + 6.0, y], Anchor::Start, name);
        }
    }
}

/// Least height of a chart in which the names of all ways have room.
pub fn growth_least_height(results: &Results) -> f64 {
    const WITHOUT_NAMES: f64 = 120.0;
    WITHOUT_NAMES + LABEL * results.ways().len() as f64
}

/// How far each curve is drawn below its place: those that coincide are all seen.
fn shifts(all: &[Series]) -> Vec<f64> {
    const APART: f64 = 3.5;
    let is_near = |a: f64, b: f64| (a - b).abs() <= 0.005 * a.abs().max(b.abs());
    let coincide = |a: &Series, b: &Series| {
        let mut pairs = a.points.iter().zip(&b.points);
        let is_same = pairs.all(|(p, q)| is_near(p[0], q[0]) && is_near(p[1], q[1]));
        a.points.len() == b.points.len() && is_same
    };
    let n_before = |n: usize| all[..n].iter().filter(|other| coincide(other, &all[n])).count();
    (0..all.len()).map(|n| APART * n_before(n) as f64).collect()
}

/// Every algorithm has a look of its own, and so have the kernels.
fn role_of(way: Way) -> Role {
    Role::Series(number_of(way))
}

fn number_of(way: Way) -> usize {
    match way {
        Way::Traced(method) => {
            Algorithm::ALL.iter().position(|&one| one == method.algorithm).unwrap_or(0)
        }
        Way::Batch(Kernel::Plain) => Algorithm::ALL.len(),
        Way::Batch(Kernel::Vector) => Algorithm::ALL.len() + 1,
    }
}

/// The mark of a way.
fn mark(sheet: &mut Sheet, way: Way, at: [f64; 2]) {
    for piece in marker(number_of(way), at, MARK) {
        sheet.push(role_of(way), Part::Head, Form::Polygon(piece));
    }
}

/// A logarithmic axis.
struct Axis {
    from: f64,
    to: f64,
}

impl Axis {
    /// Axis that holds all numbers, which are positive, with some room around them.
    fn around(numbers: impl Iterator<Item = f64> + Clone) -> Self {
        let least = numbers.clone().fold(f64::INFINITY, f64::min).ln();
        let most = numbers.fold(0.0, f64::max).ln();
        let room = (0.04 * (most - least)).max(0.05);
        Self { from: least - room, to: most + room }
    }

    fn share(&self, x: f64) -> f64 {
        (x.ln() - self.from) / (self.to - self.from)
    }

    /// Powers of ten with 2 and 5 between them, or only the powers where there are many;
    /// powers of two where hardly any of these fits.
    fn ticks(&self) -> Vec<f64> {
        let inside = |x: &f64| (self.from..=self.to).contains(&x.ln());
        let powers = || (-9..=15).map(|n| 10f64.powi(n));
        let few: Vec<f64> = powers().filter(inside).collect();
        if few.len() > 4 {
            return few;
        }
        let more: Vec<f64> = powers().flat_map(|p| [p, 2.0 * p, 5.0 * p]).filter(inside).collect();
        if more.len() > 1 {
            return more;
        }
        (-30..=50)
            .flat_map(|n| [2f64.powi(n), 1.25 * 2f64.powi(n), 1.5 * 2f64.powi(n)])
            .filter(inside)
            .collect()
    }
}

/// Places for labels that want to be at `wanted`, at least `gap` apart and between two
/// limits as far as there is room.
fn spread(wanted: &[f64], gap: f64, [upper, lower]: [f64; 2]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|&a, &b| wanted[a].total_cmp(&wanted[b]));
    let mut places = wanted.to_vec();
    // Downwards each as high as it may be, then up again from the lower limit.
    let mut least = upper;
    for &n in &order {
        places[n] = places[n].max(least);
        least = places[n] + gap;
    }
    let mut most = lower;
    for &n in order.iter().rev() {
        places[n] = places[n].min(most);
        most = places[n] - gap;
    }
    places
}

#[cfg(test)]
mod tests {
    use super::super::marker::N_SHAPES;
    use super::*;
    use crate::{Palette, Style, Theme, contrast};

    #[test]
    fn every_way_has_a_name_and_a_look_of_its_own() {
        let mut looks: Vec<(&str, String)> = Vec::new();
        for way in Way::all() {
            let (role, style) = (role_of(way), Style::of(Theme::Light, role_of(way)));
            let look = format!("{:?} {:?}", style.stroke, style.dash);
            assert!(looks.iter().all(|(class, of)| *class != role.class() && *of != look), "{way}");
            looks.push((role.class(), look));
        }
        assert!(looks.len() <= N_SHAPES, "and a mark");
    }

    #[test]
    fn lines_are_seen_in_every_theme() {
        for theme in Theme::ALL {
            for way in Way::all() {
                let line = Style::of(theme, role_of(way)).stroke.unwrap();
                for ground in [Palette::of(theme).panel, Palette::of(theme).background] {
                    let ratio = contrast(line, ground);
                    assert!(ratio >= 3.0, "{way} in {theme:?}: {ratio:.2}");
                }
            }
        }
    }

    #[test]
    fn the_key_has_the_line_and_the_mark_of_every_curve() {
        use octoscope_core::measure::{Row, Site};
        let row = |way, depth: u8| Row { way, times: vec![f64::from(depth)], ..Row::default() };
        let site = |depth: u8| Site {
            scene: "cloud".to_owned(),
            depth,
            rows: Way::all().into_iter().map(|way| row(way, depth)).collect(),
            ..Site::default()
        };
        let results = Results { sites: vec![site(5), site(6)], ..Results::default() };
        let of = Growth { scene: "cloud", size: Quantity::Cells, cost: Quantity::Time };
        let language = octoscope_core::text::Language::English;
        let texts = Texts::new(language, &[crate::views::figure_texts(language)]);
        let drawn = growth_chart(&results, of, &texts, [760.0, 460.0]).drawn;
        for way in Way::all() {
            let n = |part: Part| {
                let of_way = drawn.iter().filter(|drawn| drawn.role == role_of(way));
                of_way.filter(|drawn| drawn.part == part).count()
            };
            let pieces = marker(number_of(way), [0.0; 2], MARK).len();
            assert_eq!([n(Part::Edge), n(Part::Head)], [2, 3 * pieces], "{way}");
        }
    }

    #[test]
    fn curves_that_coincide_are_drawn_side_by_side() {
        let series = |points: &[[f64; 2]]| Series {
            way: Way::Batch(Kernel::Plain),
            points: points.to_vec(),
            law: None,
        };
        let (one, other) = ([[1.0, 2.0], [2.0, 4.0]], [[1.0, 2.0], [2.0, 5.0]]);
        let found = shifts(&[series(&one), series(&other), series(&one), series(&one)]);
        assert_eq!(found[..2], [0.0, 0.0]);
        assert!(found[2] > 0.0 && found[3] > found[2], "{found:?}");
    }

    #[test]
    fn labels_keep_apart_and_within_their_limits() {
        let places = spread(&[10.0, 12.0, 50.0, 99.0, 98.0], 10.0, [5.0, 100.0]);
        let mut sorted = places.clone();
        sorted.sort_by(f64::total_cmp);
        assert!(sorted.windows(2).all(|pair| pair[1] - pair[0] >= 10.0 - 1e-9), "{places:?}");
        assert!(sorted[0] >= 5.0 && sorted[4] <= 100.0);
        assert!(places[0] < places[1] && places[4] < places[3]);
    }

    #[test]
    fn axes_have_round_ticks() {
        let of = |from: f64, to: f64| Axis { from: from.ln(), to: to.ln() }.ticks();
        assert_eq!(of(0.9, 21.0), [1.0, 2.0, 5.0, 10.0, 20.0]);
        assert_eq!(of(30.0, 40.0), [32.0, 40.0]);
        assert_eq!(of(1.0, 1e6).len(), 7);
    }
}
