//! Which of many areas can be seen.

use crate::{Lens, Page, Projected};

/// How near the nearest area is, at points spread evenly over a page.
pub(crate) struct DepthMap {
    size: [usize; 2],
    /// Samples per page unit.
    density: f64,
    nearest: Vec<f32>,
    lens: Lens,
}

/// Samples per page unit where a page is not huge, and most along one side.
const DENSITY: f64 = 2.0;
const MOST: f64 = 2048.0;

impl DepthMap {
    /// Map of an empty page.
    pub fn new(page: Page, lens: Lens) -> Self {
        let density = DENSITY.min(MOST / page.width.max(page.height));
        let size = [page.width, page.height].map(|side| (side * density).ceil() as usize);
        Self { size, density, nearest: vec![f32::NEG_INFINITY; size[0] * size[1]], lens }
    }

    /// Lays a flat convex polygon on the page.
    pub fn add(&mut self, polygon: &[Projected]) {
        let mut samples = Vec::new();
        self.scan(polygon, |index, nearness| samples.push((index, nearness)));
        for (index, nearness) in samples {
            self.nearest[index] = self.nearest[index].max(nearness);
        }
    }

    /// Whether something of a polygon, laid on the page before, is not hidden.
    /// What is too small to hold a sample is not seen.
    pub fn shows(&self, polygon: &[Projected]) -> bool {
        let mut is_seen = false;
        self.scan(polygon, |index, nearness| is_seen |= nearness >= self.nearest[index]);
        is_seen
    }

    /// Whether something of a polygon lies where nothing was laid.
    pub fn is_bare(&self, polygon: &[Projected]) -> bool {
        let mut is_bare = false;
        self.scan(polygon, |index, _| is_bare |= self.nearest[index] == f32::NEG_INFINITY);
        is_bare
    }

    /// Tells the samples in a polygon, and how near it is there.
    fn scan(&self, polygon: &[Projected], mut tell: impl FnMut(usize, f32)) {
        let points: Vec<[f64; 2]> =
            polygon.iter().map(|p| p.at.map(|x| x * self.density - 0.5)).collect();
        let Some([start, slope @ ..]) = nearness(&points, polygon, self.lens) else {
            return;
        };
        let (low, high) = points
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p[1]), h.max(p[1])));
        let rows = range(low, high, self.size[1]);
        for row in rows {
            let y = row as f64;
            let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
            for (index, a) in points.iter().enumerate() {
                let b = points[(index + 1) % points.len()];
                if (a[1] <= y) != (b[1] <= y) {
                    let x = a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
                    (left, right) = (left.min(x), right.max(x));
                }
            }
            for column in range(left, right, self.size[0]) {
                let near = start + slope[0] * column as f64 + slope[1] * y;
                tell(row * self.size[0] + column, near as f32);
            }
        }
    }
}

/// Whole numbers from `low` to `high` that are below `end`.
fn range(low: f64, high: f64, end: usize) -> std::ops::Range<usize> {
    if low > high || high < 0.0 || low.is_nan() {
        return 0..0;
    }
    let from = low.ceil().max(0.0) as usize;
    from..(high.floor() as usize + 1).min(end).max(from)
}

/// Nearness in the origin and its change along x and y. In a perspective it is
/// 1 / depth, which changes evenly on the page.
fn nearness(points: &[[f64; 2]], polygon: &[Projected], lens: Lens) -> Option<[f64; 3]> {
    let [a, b, c] = [0, 1, 2].map(|i| points.get(i).copied().unwrap_or_default());
    let [u, v] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1]]);
    let area = u[0] * v[1] - u[1] * v[0];
    if polygon.len() < 3 || area.abs() < 1e-12 {
        return None;
    }
    let near = |index: usize| match lens {
        Lens::Perspective => 1.0 / polygon[index].depth,
        Lens::Orthographic => -polygon[index].depth,
    };
    let [na, nb, nc] = [near(0), near(1) - near(0), near(2) - near(0)];
    let along_x = (nb * v[1] - nc * u[1]) / area;
    let along_y = (nc * u[0] - nb * v[0]) / area;
    Some([na - along_x * a[0] - along_y * a[1], along_x, along_y])
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: Page = Page { width: 100.0, height: 50.0 };

    fn square([x, y]: [f64; 2], side: f64, depth: f64) -> Vec<Projected> {
        [[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]]
            .map(|[i, j]| Projected { at: [x + i, y + j], depth })
            .to_vec()
    }

    #[test]
    fn what_is_nearer_hides_and_what_looks_out_is_seen() {
        for lens in [Lens::Perspective, Lens::Orthographic] {
            let mut map = DepthMap::new(PAGE, lens);
            let near = square([10.0, 10.0], 20.0, 1.0);
            let (hidden, half) = (square([12.0, 12.0], 9.0, 2.0), square([25.0, 15.0], 10.0, 3.0));
            [&near, &hidden, &half].into_iter().for_each(|polygon| map.add(polygon));
            assert!(map.shows(&near) && !map.shows(&hidden) && map.shows(&half));
            assert!(map.is_bare(&square([70.0, 5.0], 9.0, 5.0)) && !map.is_bare(&hidden));
        }
    }

    #[test]
    fn what_is_not_on_the_page_is_not_seen() {
        let mut map = DepthMap::new(PAGE, Lens::Perspective);
        for outside in [[-30.0, 5.0], [5.0, -30.0], [200.0, 5.0], [1e300, 1e300]] {
            let polygon = square(outside, 20.0, 1.0);
            map.add(&polygon);
            assert!(!map.shows(&polygon), "{outside:?}");
        }
    }
}
