//! What is written beside the bars of the rail, and where.

use super::{Drawing, TICK};
use crate::views::words::{joined, parameter};
use crate::{Role, metrics};
use octoscope_core::explain::RichText;

/// How far labels stand from their bar.
struct Off {
    /// To the middle of their height.
    middle: f64,
    /// To their letters.
    letters: f64,
}

/// Of labels below a bar.
const DOWN: Off = Off { middle: 17.0, letters: 12.0 };
/// In rows of at least this height names stand above the bars and values below them, both
/// in larger type.
pub(super) const HIGH: f64 = 60.0;
/// Of names and values there.
const APART: Off = Off { middle: 21.0, letters: 13.0 };
/// What names and values are set as there.
const LARGE: Role = Role::Formula(0);

/// Between an odd number and the frame around it.
pub(super) const BADGE: f64 = 4.0;

/// Text beside a bar.
pub(super) struct Label {
    pub role: Role,
    /// Whether it stands above the bar.
    pub is_above: bool,
    /// Where its mark stands on the bar.
    pub tick: f64,
    /// Its left end and its middle height.
    pub at: [f64; 2],
    /// With the frame, if it has one.
    pub width: f64,
    pub text: RichText,
    /// Whether the number has to be looked at twice: ±∞ or NaN.
    pub is_odd: bool,
}

impl<const D: usize> Drawing<'_, D> {
    /// t with its subscript at each mark, and the value where there is room.
    pub(super) fn labels(&self, axis: usize) -> Vec<Label> {
        let y = self.bar_y(axis);
        let stops = self.rail.stops(axis);
        if self.is_high() {
            let name =
                |&(t, plane): &(f64, &str)| self.label(t, parameter(axis, plane), LARGE, true);
            let names = self.in_line(stops.iter().map(name).collect(), y - APART.middle);
            let values = self.first_that_fits(|shown| {
                let stops = stops.iter().filter(|(_, plane)| shown(plane));
                let value = |&(t, _): &(f64, &str)| {
                    self.label(t, self.rail.value(axis, t).into(), LARGE, false)
                };
                stops.map(value).collect()
            });
            return names.into_iter().chain(self.in_line(values, y + APART.middle)).collect();
        }
        let labels = self.first_that_fits(|shown| {
            let label = |&(t, plane): &(f64, &str)| {
                let value = if shown(plane) {
                    format!(" {}", self.rail.value(axis, t))
                } else {
                    String::new()
                };
                let text = joined([parameter(axis, plane), value.into()]);
                self.label(t, text, Role::Words, false)
            };
            stops.iter().map(label).collect()
        });
        self.in_line(labels, y + DOWN.middle)
    }

    /// The labels in the first way in which all have room side by side: with all values,
    /// with those of the planes of sides, with none.
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

    /// The labels with their middles at this height, none over another.
    fn in_line(&self, mut labels: Vec<Label>, y: f64) -> Vec<Label> {
        let wanted: Vec<[f64; 2]> = labels.iter().map(|label| [label.at[0], label.width]).collect();
        for (label, start) in labels.iter_mut().zip(spread(&wanted, LABEL_GAP, self.room())) {
            label.at = [start, y];
        }
        labels
    }

    /// Text of a parameter, wished with its middle at the mark.
    fn label(&self, t: f64, text: RichText, role: Role, is_above: bool) -> Label {
        let is_odd = !t.is_finite();
        let x = if t.is_nan() { 0.5 * (self.track[0] + self.track[1]) } else { self.x_of(t) };
        let around = if is_odd && !is_above { 2.0 * BADGE } else { 0.0 };
        let width = metrics::width_of_least(role, &text, self.least) + around;
        Label { role, is_above, tick: x, at: [x - 0.5 * width, 0.0], width, text, is_odd }
    }

    /// The line from a mark to its label, where that could not stand in its middle; none
    /// where there is no place to be marked.
    pub(super) fn leader(&self, axis: usize, label: &Label) -> Option<[[f64; 2]; 2]> {
        const OFF: f64 = 4.0;
        let [left, right] = [label.at[0], label.at[0] + label.width];
        let is_off = (0.5 * (left + right) - label.tick).abs() > OFF;
        let foot = label.tick.max(left + OFF).min(right - OFF);
        let y = self.bar_y(axis);
        let down = if self.is_high() { APART.letters } else { DOWN.letters };
        let [tick, letters] =
            [TICK, down].map(|down| if label.is_above { y - down } else { y + down });
        (is_off && !label.is_odd).then_some([[label.tick, tick], [foot, letters]])
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
