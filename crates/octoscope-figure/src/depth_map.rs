//! Which of many areas can be seen.

use crate::camera::corners;
use crate::{Camera, Lens, Page, Projected};
use octoscope_core::geometry::Aabb;

/// How near the nearest area is, at points spread evenly over a part of the plane
/// of the page.
pub(crate) struct DepthMap {
    /// Least corner of that part.
    from: [f64; 2],
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
    /// Empty map of what is seen of `root`. A figure may be larger than the page,
    /// as a near view shows more than fits on it; what lies farther beside the page
    /// than it is large is not seen.
    pub fn of<const D: usize>(root: &Aabb<D>, camera: &Camera<D>, page: Page) -> Self {
        let size = [page.width, page.height];
        let corners: Option<Vec<_>> = corners(root).map(|c| camera.project(page, c)).collect();
        let reach = |e: usize| match &corners {
            Some(corners) => corners.iter().fold([size[e], 0.0], |[low, high], corner| {
                [low.min(corner.at[e]), high.max(corner.at[e])]
            }),
            None => [f64::NEG_INFINITY, f64::INFINITY],
        };
        let between = [0, 1].map(|e| reach(e).map(|at| at.clamp(-size[e], 2.0 * size[e])));
        Self::between(between.map(|[low, _]| low), between.map(|[_, high]| high), camera.lens)
    }

    /// Empty map of what lies between two corners.
    fn between(from: [f64; 2], to: [f64; 2], lens: Lens) -> Self {
        let sides: [f64; 2] = std::array::from_fn(|e| to[e] - from[e]);
        let density = DENSITY.min(MOST / sides[0].max(sides[1]));
        let size = sides.map(|side| (side * density).ceil() as usize);
        Self { from, size, density, nearest: vec![f32::NEG_INFINITY; size[0] * size[1]], lens }
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
        let place =
            |at: [f64; 2]| std::array::from_fn(|e| (at[e] - self.from[e]) * self.density - 0.5);
        let points: Vec<[f64; 2]> = polygon.iter().map(|p| place(p.at)).collect();
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

    const SIZE: [f64; 2] = [100.0, 50.0];

    fn square([x, y]: [f64; 2], side: f64, depth: f64) -> Vec<Projected> {
        [[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]]
            .map(|[i, j]| Projected { at: [x + i, y + j], depth })
            .to_vec()
    }

    #[test]
    fn what_is_nearer_hides_and_what_looks_out_is_seen() {
        for lens in [Lens::Perspective, Lens::Orthographic] {
            let mut map = DepthMap::between([0.0; 2], SIZE, lens);
            let near = square([10.0, 10.0], 20.0, 1.0);
            let (hidden, half) = (square([12.0, 12.0], 9.0, 2.0), square([25.0, 15.0], 10.0, 3.0));
            [&near, &hidden, &half].into_iter().for_each(|polygon| map.add(polygon));
            assert!(map.shows(&near) && !map.shows(&hidden) && map.shows(&half));
            assert!(map.is_bare(&square([70.0, 5.0], 9.0, 5.0)) && !map.is_bare(&hidden));
        }
    }

    #[test]
    fn a_near_view_is_seen_beside_the_page() {
        let page = Page { width: 100.0, height: 50.0 };
        let root = Aabb { min: [0.0; 3], max: [1.0; 3] };
        let mut camera = Camera::framing(&root, page);
        camera.height /= 4.0;
        let mut map = DepthMap::of(&root, &camera, page);
        let beside = square([-30.0, -20.0], 9.0, 1.0);
        map.add(&beside);
        assert!(map.shows(&beside));
    }

    #[test]
    fn what_is_not_on_the_page_is_not_seen() {
        let mut map = DepthMap::between([0.0; 2], SIZE, Lens::Perspective);
        for outside in [[-30.0, 5.0], [5.0, -30.0], [200.0, 5.0], [1e300, 1e300]] {
            let polygon = square(outside, 20.0, 1.0);
            map.add(&polygon);
            assert!(!map.shows(&polygon), "{outside:?}");
        }
    }
}
