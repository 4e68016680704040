//! Dashes that fit into the lines that they are of.

use crate::camera::clipped;
use crate::space::distance;
use crate::{Form, Page, Paint};

/// Pattern of a line.
#[derive(Clone, Debug, PartialEq)]
pub struct Dashes {
    /// Lengths of dash, gap, dash, gap… in page units; the line repeats them.
    pub lengths: Vec<f64>,
    /// How much of them lies before the line begins.
    pub offset: f64,
}

impl Paint {
    /// Pattern of the line of `form`; `None` if it is unbroken. The sides of an area and a
    /// straight line hold whole dashes, with one at every corner and end; where one of them
    /// has no room for that, the line is unbroken.
    pub fn dashes(&self, form: &Form) -> Option<Dashes> {
        let pattern: Vec<f64> = self.dash.pattern().iter().map(|l| l * self.width).collect();
        if pattern.is_empty() || self.width <= 0.0 {
            return None;
        }
        let sides: Vec<f64> = match form {
            Form::Polygon(points) => {
                let next = points.iter().cycle().skip(1);
                points.iter().zip(next).map(|(a, b)| distance(*a, *b)).collect()
            }
            Form::Polyline(points) if points.len() == 2 => vec![distance(points[0], points[1])],
            Form::Polyline(_) | Form::Circle { .. } | Form::Text { .. } | Form::Formula { .. } => {
                vec![]
            }
        };
        match pattern[..] {
            [dash, gap] if !sides.is_empty() => fitted(&sides, [dash, gap]),
            _ => Some(Dashes { lengths: pattern, offset: 0.0 }),
        }
    }
}

impl Dashes {
    /// The dashes of a line through these points that may be seen on `page`, each a line of
    /// its own. O(points + dashes on the page) where few lengths are repeated.
    pub fn along(&self, points: &[[f64; 2]], page: Page) -> Vec<Vec<[f64; 2]>> {
        let period: f64 = self.lengths.iter().sum();
        let seen = [[-period; 2], [page.width + period, page.height + period]];
        let mut dashes = Vec::new();
        let (mut part, mut left) = (0, self.lengths[0] - self.offset);
        let mut dash: Vec<[f64; 2]> = points.first().copied().into_iter().collect();
        for ends in points.windows(2) {
            let [from, to] = [ends[0], ends[1]];
            let length = distance(from, to);
            let mut at = 0.0;
            let place =
                |at: f64| std::array::from_fn(|e| from[e] + at / length * (to[e] - from[e]));
            let [enter, exit] = clipped([from, to], seen)
                .map_or([length; 2], |ends| ends.map(|end| distance(from, end)));
            // A rest too short to be seen belongs to the corner.
            while left < length - at - 1e-9 * length {
                // Before the page and behind it nothing is seen of whole repetitions.
                let next = if at < enter { enter } else { length };
                let n_unseen = ((next - at) / period).floor() - 1.0;
                if n_unseen > 0.0 && !(enter..=exit).contains(&at) {
                    at += n_unseen * period;
                    dash = vec![place(at)];
                }
                at += left;
                if part % 2 == 0 {
                    dash.push(place(at));
                    dashes.push(std::mem::take(&mut dash));
                } else {
                    dash = vec![place(at)];
                }
                part = (part + 1) % self.lengths.len();
                left = self.lengths[part];
            }
            left -= length - at;
            if part % 2 == 0 {
                dash.push(to);
            }
        }
        if part % 2 == 0 && dash.len() > 1 {
            dashes.push(dash);
        }
        dashes
    }
}

/// Whole dashes on every side, the first and the last of them half, around the corner to
/// the next; `None` if one side is too short.
fn fitted(sides: &[f64], [dash, gap]: [f64; 2]) -> Option<Dashes> {
    /// What of a dash with its gap there must be room for.
    const LEAST: f64 = 0.75;
    /// Sides count as equal if a dash of one is no farther off on another than this share
    /// of a gap.
    const OFF: f64 = 0.1;
    /// Of more dashes than this no page shows two corners: they are those of one side.
    const MOST: usize = 4000;
    let period = dash + gap;
    if !sides.iter().all(|side| *side >= LEAST * period && side.is_finite()) {
        return None;
    }
    // Of each side, how many there are, and how long dash and gap.
    let fit = |side: &f64| {
        let number = (side / period).round().max(1.0);
        let by = side / (number * period);
        (number as usize, by * dash, by * gap)
    };
    let fits: Vec<_> = sides.iter().map(fit).collect();
    let last = fits[fits.len() - 1].1;
    let offset = 0.5 * last;
    let (_, dash, gap) = fits[0];
    let n_dashes = fits.iter().map(|fit| fit.0).fold(0, usize::saturating_add);
    let are_equal = sides.iter().all(|side| (side - sides[0]).abs() < OFF * gap);
    if are_equal || n_dashes > MOST {
        return Some(Dashes { lengths: vec![dash, gap], offset });
    }
    let before = std::iter::once(last).chain(fits.iter().map(|fit| fit.1));
    let lengths = before.zip(&fits).flat_map(|(before, &(number, dash, gap))| {
        let corner = [0.5 * (before + dash), gap];
        std::iter::once(corner).chain(std::iter::repeat_n([dash, gap], number - 1)).flatten()
    });
    Some(Dashes { lengths: lengths.collect(), offset })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Dash, Drawn, Part, Role, Theme};

    fn paint(role: Role, form: &Form) -> Paint {
        let drawn = Drawn { form: form.clone(), role, part: Part::Whole, node: None };
        Paint::of(Theme::Light, &drawn)
    }

    const PAGE: Page = Page { width: 1200.0, height: 1200.0 };

    fn rectangle([width, height]: [f64; 2]) -> Vec<[f64; 2]> {
        vec![[5.0, 5.0], [5.0 + width, 5.0], [5.0 + width, 5.0 + height], [5.0, 5.0 + height]]
    }

    #[test]
    fn every_corner_has_a_dash_around_it_and_every_side_whole_dashes() {
        for size in [
            [16.0, 16.0],
            [20.5, 20.5],
            [31.0, 62.0],
            [100.0, 37.7],
            [40.0, 333.0],
            [1000.0, 1009.0],
        ] {
            for role in [Role::Target, Role::Rejected, Role::Pending, Role::Expected] {
                let points = rectangle(size);
                let form = Form::Polygon(points.clone());
                let dashes = paint(role, &form).dashes(&form).unwrap();
                let ring: Vec<_> = points.iter().chain(points.first()).copied().collect();
                let drawn = dashes.along(&ring, PAGE);
                let ends = |corner: [f64; 2]| {
                    // Lengths of the dashes on both sides of the corner.
                    let reach = |far: [f64; 2], near: [f64; 2]| {
                        (distance(near, corner) < 1e-6).then(|| distance(far, near))
                    };
                    let starts = drawn.iter().filter_map(|d| reach(d[1], d[0]));
                    let ends = drawn.iter().filter_map(|d| reach(d[d.len() - 2], d[d.len() - 1]));
                    let inner = drawn.iter().filter(|d| d.len() == 3);
                    let inner = inner.flat_map(|d| [reach(d[0], d[1]), reach(d[2], d[1])]);
                    starts.chain(ends).chain(inner.flatten()).collect::<Vec<_>>()
                };
                for corner in points {
                    let ends = ends(corner);
                    assert_eq!(ends.len(), 2, "{role:?} {size:?} {corner:?}: {drawn:?}");
                    assert!(ends.iter().all(|end| *end > 0.2), "{role:?} {size:?}: {ends:?}");
                }
                let total: f64 = dashes.lengths.iter().sum();
                let repeats = 2.0 * (size[0] + size[1]) / total;
                assert!((repeats - repeats.round()).abs() < 1e-9, "{role:?} {size:?}");
            }
        }
    }

    #[test]
    fn of_a_large_outline_only_the_dashes_on_the_page_are_made() {
        let small = Page { width: 90.0, height: 60.0 };
        let on_page = |dash: &Vec<[f64; 2]>| {
            dash.iter()
                .any(|&[x, y]| (0.0..small.width).contains(&x) && (0.0..small.height).contains(&y))
        };
        let seen = |side: f64, page: Page| {
            let points = rectangle([side; 2]);
            let form = Form::Polygon(points.clone());
            let ring: Vec<_> = points.iter().chain(points.first()).copied().collect();
            let dashes = paint(Role::Target, &form).dashes(&form).unwrap().along(&ring, page);
            let n = dashes.len();
            (dashes.into_iter().filter(on_page).collect::<Vec<_>>(), n)
        };
        let ((few, n_few), (all, n_all)) = (seen(1000.0, small), seen(1000.0, PAGE));
        assert!(n_few < n_all / 4 && few.len() == all.len(), "{n_few} of {n_all}");
        for (a, b) in few.iter().zip(&all) {
            assert!(a.len() == b.len() && a.iter().zip(b).all(|(a, b)| distance(*a, *b) < 1e-6));
        }
        let (few, n) = seen(1e9, small);
        assert!(!few.is_empty() && n < 100, "{n}");
        let form = Form::Polygon(rectangle([1e9, 5e8]));
        assert!(paint(Role::Target, &form).dashes(&form).unwrap().lengths.len() < 10);
    }

    #[test]
    fn what_is_too_short_for_dashes_is_unbroken() {
        let form = Form::Polygon(rectangle([7.0; 2]));
        assert_eq!(paint(Role::Target, &form).dashes(&form), None);
        let form = Form::Polyline(vec![[0.0; 2], [300.0, 0.0]]);
        let paint = paint(Role::Target, &form);
        assert_eq!(paint.dash, Dash::Dashed);
        let dashes = paint.dashes(&form).unwrap();
        assert!((300.0 / dashes.lengths.iter().sum::<f64>()).fract() < 1e-9);
        assert_eq!(dashes.offset, 0.5 * dashes.lengths[0]);
    }
}
