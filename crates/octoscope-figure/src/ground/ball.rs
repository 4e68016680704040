//! Balls on the page, whole and cut open. They are seen as discs, as from far away.

use super::View;
use crate::{Cut, Form};
use std::f64::consts::TAU;

/// Radius, shift to the upper left, both in radii of the ball, and light of the discs
/// that it is drawn as: it is lit from there, as everything.
const DISCS: [(f64, f64, u8); 3] = [(1.0, 0.0, 1), (0.8, 0.13, 4), (0.5, 0.26, 6)];
/// Corners of a circle that is drawn as a polygon.
const CORNERS: usize = 60;

impl<const D: usize> View<'_, D> {
    /// A ball and the light on it, lowest first; `None` of one behind the eye.
    pub(super) fn ball(&self, centre: [f64; D], radius: f64) -> Option<Vec<(Form, u8)>> {
        let (middle, on_page) = self.disc(centre, radius)?;
        let discs = DISCS.into_iter().map(|(share, shift, light)| {
            let centre = middle.map(|x| x - shift * on_page);
            (Form::Circle { centre, radius: share * on_page }, light)
        });
        Some(discs.collect())
    }

    /// What `cut` leaves of a ball that it meets, and the disc in which it does.
    pub(super) fn cut_ball(
        &self,
        centre: [f64; D],
        radius: f64,
        cut: &Cut,
    ) -> Option<Vec<(Form, u8)>> {
        let (middle, on_page) = self.disc(centre, radius)?;
        let [right, up, _] = self.camera.basis();

        // The circle in which the plane meets the ball.
        let away = cut.at - centre[cut.axis];
        let section_radius = (radius * radius - away * away).max(0.0).sqrt();
        let [a, b] = [(cut.axis + 1) % D, (cut.axis + 2) % D];
        let section: Option<Vec<[f64; 2]>> = turns()
            .map(|[cos, sin]| {
                let mut at = centre;
                at[cut.axis] = cut.at;
                at[a] += section_radius * cos;
                at[b] += section_radius * sin;
                Some(self.camera.project(self.page, at)?.at)
            })
            .collect();
        let section = section?;

        // With the part of the rim behind the plane, it bounds what is seen.
        let rim = turns().filter(|[cos, sin]| {
            cut.keeps(&std::array::from_fn::<f64, D, _>(|e| {
                centre[e] + radius * (cos * right[e] - sin * up[e])
            }))
        });
        let rim = rim.map(|turn| on_circle(middle, on_page, turn));
        let outline = hull(rim.chain(section.iter().copied()).collect());

        let discs = DISCS.into_iter().map(|(share, shift, light)| {
            let centre = middle.map(|x| x - shift * on_page);
            let disc = turns().map(|turn| on_circle(centre, share * on_page, turn)).collect();
            (clipped(disc, &outline), light)
        });
        let across: [f64; D] = std::array::from_fn(|e| if e == cut.axis { 1.0 } else { 0.0 });
        let all = discs.chain([(section, self.light(across))]);
        let drawn = all.filter(|(polygon, _)| polygon.len() > 2);
        Some(drawn.map(|(polygon, light)| (Form::Polygon(polygon), light)).collect())
    }

    /// Middle and radius on the page.
    fn disc(&self, centre: [f64; D], radius: f64) -> Option<([f64; 2], f64)> {
        let [_, up, _] = self.camera.basis();
        let rim = std::array::from_fn(|e| centre[e] + radius * up[e]);
        let [middle, rim] = [centre, rim].map(|p| self.camera.project(self.page, p));
        let (middle, rim) = (middle?.at, rim?.at);
        Some((middle, (middle[0] - rim[0]).hypot(middle[1] - rim[1])))
    }
}

/// Cosine and sine of even turns.
fn turns() -> impl Iterator<Item = [f64; 2]> {
    (0..CORNERS).map(|n| {
        let (sin, cos) = (TAU * n as f64 / CORNERS as f64).sin_cos();
        [cos, sin]
    })
}

/// Point of a circle on the page, where y points down.
fn on_circle([x, y]: [f64; 2], radius: f64, [cos, sin]: [f64; 2]) -> [f64; 2] {
    [x + radius * cos, y + radius * sin]
}

/// Twice the area of a triangle, above 0 if it turns from x to y.
fn turn([a, b, c]: [[f64; 2]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Convex hull, turning from x to y (Andrew's monotone chain). O(n log n).
fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let half = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..]
                && turn([a, b, point]) <= 0.0
            {
                chain.pop();
            }
            chain.push(point);
        }
        // The last is the first of the other half.
        chain.pop();
        chain
    };
    let mut all = half(&mut points.iter().copied());
    all.extend(half(&mut points.iter().rev().copied()));
    all
}

/// The part of a polygon in a convex one that turns from x to y
/// (Sutherland and Hodgman).
fn clipped(mut polygon: Vec<[f64; 2]>, convex: &[[f64; 2]]) -> Vec<[f64; 2]> {
    for (index, &from) in convex.iter().enumerate() {
        let to = convex[(index + 1) % convex.len()];
        let side = |point: [f64; 2]| turn([from, to, point]);
        let mut kept = Vec::with_capacity(polygon.len() + 1);
        for (n, &point) in polygon.iter().enumerate() {
            let next = polygon[(n + 1) % polygon.len()];
            let [here, there] = [point, next].map(side);
            if here >= 0.0 {
                kept.push(point);
            }
            if (here >= 0.0) != (there >= 0.0) {
                let share = here / (here - there);
                kept.push(std::array::from_fn(|e| point[e] + share * (next[e] - point[e])));
            }
        }
        polygon = kept;
    }
    polygon
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Camera, Page};
    use octoscope_core::geometry::Aabb;

    fn area(polygon: &[[f64; 2]]) -> f64 {
        let corners = polygon.windows(2).map(|ends| turn([polygon[0], ends[0], ends[1]]));
        0.5 * corners.sum::<f64>()
    }

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];

    #[test]
    fn a_hull_holds_the_outermost_points_alone() {
        let inner = [[1.0, 1.0], [0.5, 1.5], [1.0, 0.0]];
        let found = hull(SQUARE.into_iter().chain(inner).collect());
        assert_eq!((found.len(), area(&found)), (4, 4.0));
    }

    #[test]
    fn a_polygon_is_clipped_to_what_both_cover() {
        let shifted = SQUARE.map(|[x, y]| [x + 1.0, y + 1.5]).to_vec();
        assert_eq!(area(&clipped(shifted, &SQUARE)), 0.5);
        assert_eq!(clipped(SQUARE.map(|[x, y]| [x + 5.0, y]).to_vec(), &SQUARE), [[0.0; 2]; 0]);
    }

    /// Area of what is drawn of a ball of radius 1 from the front, cut at `at` on an axis
    /// with its lower part kept.
    fn drawn_area(axis: usize, at: f64) -> f64 {
        let root = Aabb { min: [-2.0; 3], max: [2.0; 3] };
        let page = Page { width: 400.0, height: 400.0 };
        let mut camera = Camera::framing(&root, page);
        camera.lens = crate::Lens::Orthographic;
        (camera.yaw, camera.pitch) = (0.0, 0.0);
        let view = View { camera: &camera, page, root: &root };
        let cut = Cut { axis, at, keeps_lower: true };
        let drawn = view.cut_ball([0.0; 3], 1.0, &cut).unwrap();
        let Form::Polygon(outline) = &drawn[0].0 else { panic!("{drawn:?}") };
        area(outline).abs() * camera.unit(page).powi(2)
    }

    #[test]
    fn half_a_ball_is_half_a_disc_from_the_side_and_a_whole_one_from_the_front() {
        // As many corners do not make a circle: some thousandths are missing.
        let disc = 0.5 * CORNERS as f64 * (TAU / CORNERS as f64).sin();
        for (axis, at, expected) in [(0, 0.0, disc), (1, 0.0, 0.5 * disc), (2, 0.0, 0.5 * disc)] {
            let found = drawn_area(axis, at);
            assert!((found - expected).abs() < 0.01, "{axis}: {found} {expected}");
        }
    }
}
