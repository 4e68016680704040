//! What is written above and below the bars of the rail, and where.

use super::Drawing;
use crate::views::words::parameter;
use crate::{Role, metrics};
use octoscope_core::explain::RichText;

/// How the rows of a rail are set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RailRows {
    /// As the rest of a panel.
    Small,
    /// In larger type, with thicker bars.
    Large,
}

/// How labels stand beside their bar.
#[derive(Clone, Copy)]
pub(super) struct Off {
    /// From the bar to the middle of their height.
    middle: f64,
    /// From there back to where letters end.
    reach: f64,
}

/// Sizes of a row: names stand above its bar and values below it.
#[derive(Clone, Copy)]
pub(super) struct Sizes {
    /// What names and values are set as.
    role: Role,
    /// Its height.
    pub row: f64,
    /// From its top to its bar.
    pub bar: f64,
    /// Half the height of the mark of a plane on its bar.
    pub tick: f64,
    /// Half the height that a label takes.
    half_line: f64,
    names: Off,
    values: Off,
}

impl RailRows {
    pub(super) fn sizes(self) -> Sizes {
        match self {
            Self::Small => Sizes {
                role: Role::Words,
                row: 56.0,
                bar: 28.0,
                tick: 6.0,
                half_line: 8.0,
                names: Off { middle: 20.0, reach: 8.0 },
                values: Off { middle: 18.0, reach: 6.0 },
            },
            Self::Large => Sizes {
                role: Role::Formula(0),
                row: 72.0,
                bar: 38.0,
                tick: 8.0,
                half_line: 10.0,
                names: Off { middle: 26.0, reach: 11.0 },
                values: Off { middle: 23.0, reach: 8.0 },
            },
        }
    }
}

/// Between an odd number and the frame around it.
pub(super) const BADGE: f64 = 4.0;

/// Text above or below a bar.
pub(super) struct Label {
    pub role: Role,
    /// Where its line begins: at its mark on the bar; `None` of what is nowhere.
    pub mark: Option<[f64; 2]>,
    /// Its left end and its middle height.
    pub at: [f64; 2],
    /// With the frame, if it has one.
    pub width: f64,
    pub text: RichText,
    /// Whether it is a number that has to be looked at twice: ±∞ or NaN.
    pub is_framed: bool,
    /// Where its letters end towards the bar.
    edge: f64,
}

/// On which side of a bar labels stand.
#[derive(Clone, Copy)]
enum Side {
    Above,
    Below,
}

impl<const D: usize> Drawing<'_, D> {
    /// t with its subscript above each mark, and below the value where there is room.
    pub(super) fn labels(&self, axis: usize) -> Vec<Label> {
        let mut stops = self.rail.stops(axis);
        stops.sort_by(|(a, _), (b, _)| self.x_of(*a).total_cmp(&self.x_of(*b)));
        let name =
            |&(t, plane): &(f64, &str)| self.label(axis, t, parameter(axis, plane), Side::Above);
        let names = self.spread_out(stops.iter().map(name).collect());
        let value = |&(t, _): &(f64, &str)| {
            self.label(axis, t, self.rail.value(axis, t).into(), Side::Below)
        };
        let values = self.first_that_fits(|shown| {
            stops.iter().filter(|(_, plane)| shown(plane)).map(value).collect()
        });
        names.into_iter().chain(self.spread_out(values)).collect()
    }

    /// Half the height that a label takes.
    pub(super) fn half_line(&self) -> f64 {
        (0.6 * self.least).max(self.sizes.half_line)
    }

    /// The labels in the first way in which all have room side by side: of all planes,
    /// of those of sides, of none.
    fn first_that_fits(&self, labels: impl Fn(fn(&str) -> bool) -> Vec<Label>) -> Vec<Label> {
        let room = self.room();
        let fits = |labels: &[Label]| {
            let wide: f64 = labels.iter().map(|label| label.width + LABEL_GAP).sum();
            wide - LABEL_GAP <= room[1] - room[0]
        };
        let ways: [fn(&str) -> bool; 2] = [|_| true, |plane| plane != "m"];
        let shown = ways.into_iter().map(&labels).find(|labels| fits(labels));
        shown.unwrap_or_else(|| labels(|_| false))
    }

    /// Where labels may stand.
    fn room(&self) -> [f64; 2] {
        [18.0, self.track[1] + 6.0]
    }

    /// The labels in their order, none over another.
    fn spread_out(&self, mut labels: Vec<Label>) -> Vec<Label> {
        let wanted: Vec<[f64; 2]> = labels.iter().map(|label| [label.at[0], label.width]).collect();
        for (label, start) in labels.iter_mut().zip(spread(&wanted, LABEL_GAP, self.room())) {
            label.at[0] = start;
        }
        labels
    }

    /// Text of a parameter of an axis, wished with its middle at the mark.
    fn label(&self, axis: usize, t: f64, text: RichText, side: Side) -> Label {
        let (role, bar) = (self.sizes.role, self.bar_y(axis));
        let (off, way) = match side {
            Side::Above => (self.sizes.names, -1.0),
            Side::Below => (self.sizes.values, 1.0),
        };
        let is_framed = matches!(side, Side::Below) && !t.is_finite();
        let around = if is_framed { 2.0 * BADGE } else { 0.0 };
        let reach = if is_framed { self.half_line() } else { off.reach };
        let width = metrics::width_of_least(role, &text, self.least) + around;
        let x = if t.is_nan() { 0.5 * (self.track[0] + self.track[1]) } else { self.x_of(t) };
        // Beyond the end it is the tip of a head that is its mark.
        let [low, high] = self.range;
        let tick = if (low..=high).contains(&t) { self.sizes.tick } else { 0.0 };
        Label {
            role,
            mark: (!t.is_nan()).then_some([x, bar + way * tick]),
            at: [x - 0.5 * width, bar + way * off.middle],
            width,
            text,
            is_framed,
            edge: bar + way * (off.middle - reach),
        }
    }
}

impl Label {
    /// The line from its mark to its middle, where it could not stand at the mark.
    pub(super) fn leader(&self) -> Option<[[f64; 2]; 2]> {
        const OFF: f64 = 2.0;
        let mark = self.mark?;
        let middle = self.at[0] + 0.5 * self.width;
        ((middle - mark[0]).abs() > OFF).then_some([mark, [middle, self.edge]])
    }
}

/// Room between two labels of a bar.
const LABEL_GAP: f64 = 9.0;

/// Where labels begin that want to begin at a place and have a width: in their
/// order, apart from each other, and between two ends if they fit.
pub(super) fn spread(wanted: &[[f64; 2]], gap: f64, [left, right]: [f64; 2]) -> Vec<f64> {
    // Groups of labels that touch each other, with the middle that they want.
    struct Group {
        start: f64,
        width: f64,
        n: usize,
    }
    let mut groups: Vec<Group> = Vec::new();
    for &[start, width] in wanted {
        groups.push(Group { start: start.min(right - width), width, n: 1 });
        while let [.., before, last] = &mut groups[..]
            && before.start + before.width + gap > last.start
        {
            let n = before.n + last.n;
            let middle = |group: &Group| group.start + 0.5 * group.width;
            let wish = (before.n as f64 * middle(before) + last.n as f64 * middle(last)) / n as f64;
            before.width += gap + last.width;
            before.start = (wish - 0.5 * before.width).min(right - before.width).max(left);
            before.n = n;
            groups.pop();
        }
        if let [only] = &mut groups[..] {
            only.start = only.start.max(left);
        }
    }
    let mut starts = Vec::with_capacity(wanted.len());
    let mut widths = wanted.iter().map(|[_, width]| width);
    for Group { start, n, .. } in groups {
        let mut x = start;
        for width in widths.by_ref().take(n) {
            starts.push(x);
            x += width + gap;
        }
    }
    starts
}
