//! What is seen of a leaf on the page.

use super::{distance, square};

/// What is seen of a leaf on the page, in convex parts; nothing of one that is hidden.
#[derive(Clone, Debug, Default)]
pub(crate) struct Area {
    /// Its sides that are turned to the eye; in the plane the leaf itself.
    pub own: Vec<Convex>,
    /// Parts of other leaves that lie before it.
    pub before: Vec<Convex>,
}

/// A convex polygon.
#[derive(Clone, Debug)]
pub(crate) struct Convex {
    /// In the turn from x to y.
    corners: Vec<[f64; 2]>,
    /// Least and largest corner of what it lies in.
    pub extent: [[f64; 2]; 2],
}

impl Area {
    /// Whether it is what is seen at a point.
    pub fn holds(&self, at: [f64; 2]) -> bool {
        let is_in = |parts: &[Convex]| parts.iter().any(|part| part.holds(at));
        is_in(&self.own) && !is_in(&self.before)
    }

    /// Share of a disc that lies on it.
    pub fn share_of(&self, at: [f64; 2], radius: f64) -> f64 {
        let is_near = self.own.iter().any(|part| part.is_near(at, radius));
        if !is_near {
            return 0.0;
        }
        // Rings of as large parts of the disc, seen from their middles.
        const RINGS: [(f64, u32); 4] = [(0.0, 1), (0.45, 6), (0.75, 12), (0.97, 18)];
        let points = RINGS.into_iter().flat_map(|(share, n)| {
            (0..n).map(move |index| {
                let (sin, cos) =
                    (std::f64::consts::TAU * f64::from(index) / f64::from(n)).sin_cos();
                [at[0] + share * radius * cos, at[1] + share * radius * sin]
            })
        });
        let n_points = RINGS.map(|(_, n)| n).into_iter().sum::<u32>();
        points.filter(|point| self.holds(*point)).count() as f64 / f64::from(n_points)
    }

    /// Length of what of a line lies on the leaf, whatever lies before that.
    pub fn length_on(&self, line: [[f64; 2]; 2]) -> f64 {
        self.own.iter().map(|part| part.length_of(line)).sum()
    }

    /// Places in the corners of its parts, so far from the sides of those.
    pub fn corners(&self, inset: f64) -> Vec<[f64; 2]> {
        self.own.iter().flat_map(|part| part.inner_corners(inset)).collect()
    }

    /// Whether any of it lies between two corners.
    pub fn reaches(&self, [min, max]: [[f64; 2]; 2]) -> bool {
        let is_near = |part: &Convex| {
            (0..2).all(|e| part.extent[0][e] < max[e] && min[e] < part.extent[1][e])
        };
        self.own.iter().any(is_near)
    }

    /// Its middle.
    pub fn middle(&self) -> Option<[f64; 2]> {
        let all: Vec<[f64; 2]> = self.own.iter().flat_map(|part| part.corners.clone()).collect();
        let n = all.len() as f64;
        (!all.is_empty()).then(|| [0, 1].map(|e| all.iter().map(|at| at[e]).sum::<f64>() / n))
    }
}

impl Convex {
    /// The polygon with these corners in turn, if it has an area.
    pub fn new(mut corners: Vec<[f64; 2]>) -> Option<Self> {
        let area: f64 = edges(&corners).map(|[a, b]| a[0] * b[1] - a[1] * b[0]).sum();
        if area.is_nan() || area.abs() < 1e-9 {
            return None;
        }
        if area < 0.0 {
            corners.reverse();
        }
        let reach = |farther: fn(f64, f64) -> f64| {
            let farthest = |e: usize| corners.iter().map(|at| at[e]).reduce(farther);
            [0, 1].map(|e| farthest(e).unwrap_or_default())
        };
        let extent = [reach(f64::min), reach(f64::max)];
        Some(Self { corners, extent })
    }

    /// Whether it comes into a rectangle around `at`.
    fn is_near(&self, at: [f64; 2], reach: f64) -> bool {
        let [min, max] = self.extent;
        (0..2).all(|e| min[e] <= at[e] + reach && at[e] - reach <= max[e])
    }

    fn holds(&self, at: [f64; 2]) -> bool {
        self.is_near(at, 0.0) && edges(&self.corners).all(|edge| inwards(edge, at) >= 0.0)
    }

    /// Length of what of a line lies in it.
    fn length_of(&self, line: [[f64; 2]; 2]) -> f64 {
        let [from, to] = line;
        let is_beside = |e: usize| {
            from[e].max(to[e]) < self.extent[0][e] || from[e].min(to[e]) > self.extent[1][e]
        };
        if is_beside(0) || is_beside(1) {
            return 0.0;
        }
        let (mut enter, mut exit) = (0f64, 1f64);
        for edge in edges(&self.corners) {
            let [a, b] = line.map(|at| inwards(edge, at));
            match (a < 0.0, b < 0.0) {
                (true, true) => return 0.0,
                (true, false) => enter = enter.max(a / (a - b)),
                (false, true) => exit = exit.min(a / (a - b)),
                (false, false) => {}
            }
        }
        (exit - enter).max(0.0) * distance(from, to)
    }

    /// Places in its corners, so far from its sides.
    fn inner_corners(&self, inset: f64) -> Vec<[f64; 2]> {
        let n = self.corners.len();
        let places = (0..n).filter_map(|index| {
            let at = self.corners[index];
            let along = |to: [f64; 2]| {
                let length = distance(at, to);
                (length > 1e-9).then(|| [0, 1].map(|e| (to[e] - at[e]) / length))
            };
            let (next, last) =
                (along(self.corners[(index + 1) % n])?, along(self.corners[(index + n - 1) % n])?);
            let sine = (next[0] * last[1] - next[1] * last[0]).abs();
            (sine > 0.05).then(|| [0, 1].map(|e| at[e] + inset / sine * (next[e] + last[e])))
        });
        places.filter(|place| self.is_inset(*place, inset)).collect()
    }

    /// Whether a point is as far from all sides.
    fn is_inset(&self, at: [f64; 2], inset: f64) -> bool {
        let is_off = |edge: [[f64; 2]; 2]| {
            let length = square([0, 1].map(|e| edge[1][e] - edge[0][e])).sqrt();
            inwards(edge, at) >= (inset - 1e-9) * length
        };
        edges(&self.corners).all(is_off)
    }
}

/// The sides of a polygon, in turn.
fn edges(corners: &[[f64; 2]]) -> impl Iterator<Item = [[f64; 2]; 2]> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(from, to)| [*from, *to])
}

/// How far a point lies to the inner side of an edge, in lengths of that.
fn inwards([from, to]: [[f64; 2]; 2], at: [f64; 2]) -> f64 {
    (to[0] - from[0]) * (at[1] - from[1]) - (to[1] - from[1]) * (at[0] - from[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square_from(low: f64, high: f64) -> Convex {
        Convex::new(vec![[low, low], [low, high], [high, high], [high, low]]).unwrap()
    }

    #[test]
    fn what_lies_before_a_leaf_is_not_seen_of_it() {
        let area =
            Area { own: vec![square_from(0.0, 40.0)], before: vec![square_from(20.0, 60.0)] };
        let whole = Area { own: vec![square_from(0.0, 40.0)], ..Area::default() };
        assert!(area.holds([5.0, 5.0]) && !area.holds([30.0, 30.0]) && !area.holds([-1.0, 5.0]));
        assert!(area.holds([30.0, 10.0]) && whole.holds([30.0, 30.0]));
        assert_eq!(
            [[10.0; 2], [30.0; 2], [60.0; 2]].map(|at| area.share_of(at, 9.0)),
            [1.0, 0.0, 0.0]
        );
        let half = whole.share_of([0.0, 20.0], 9.0);
        assert!((half - 0.5).abs() < 0.08, "{half}");
    }

    #[test]
    fn corners_keep_off_the_sides_and_lines_are_measured_within() {
        let area = Area { own: vec![square_from(0.0, 40.0)], ..Area::default() };
        let mut corners = area.corners(10.0);
        corners.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        assert_eq!(corners, [[10.0, 10.0], [10.0, 30.0], [30.0, 10.0], [30.0, 30.0]]);
        assert_eq!(area.corners(21.0), [[0.0; 2]; 0]);
        assert_eq!(area.length_on([[-10.0, 20.0], [10.0, 20.0]]), 10.0);
        assert_eq!(area.length_on([[-10.0, 20.0], [-5.0, 90.0]]), 0.0);
        assert_eq!(area.length_on([[20.0, -20.0], [20.0, 60.0]]), 40.0);
        assert_eq!(area.middle(), Some([20.0; 2]));
    }
}
