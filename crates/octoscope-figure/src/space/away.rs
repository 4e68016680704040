//! Where a ray begins beyond the page: its line is broken there, and the number beside
//! it tells how far its origin is from the root, whatever part of the ray is seen.

use super::{Canvas, above_space, distance};
use crate::figure::text_reach;
use crate::marks::interval;
use crate::{Anchor, Form, Mark, Part, Role, Shape};
use octoscope_core::explain::number;
use octoscope_core::geometry::{Aabb, Ray};

/// From the border of the page to the break, in page units.
const INSET: f64 = 16.0;
/// Shorter pieces of a ray are not broken.
const LEAST: f64 = 3.0 * INSET;

impl<const D: usize> Canvas<'_, D> {
    /// Breaks the ray where it comes from beyond the page, and writes how far
    /// from the root its origin is, in world units; not inside the root, where it is looked
    /// at from near.
    pub(super) fn write_away(&mut self, marks: &[Mark<D>], root: Option<&Aabb<D>>) {
        let arrow = marks.iter().find_map(|mark| match (mark.role, mark.shape) {
            (Role::Ray, Shape::Arrow(ends)) => Some((mark, ends)),
            _ => None,
        });
        let Some((mark, [from, to])) = arrow else { return };
        if self.camera.project(self.page, from).is_some_and(|p| self.is_near(p.at, 0.0)) {
            return;
        }
        let Some([border, end]) = self.camera.visible_segment(self.page, [from, to]) else {
            return;
        };
        let length = distance(border, end);
        if length < LEAST {
            return;
        }
        let along: [f64; 2] = std::array::from_fn(|e| (end[e] - border[e]) / length);
        let at = |share: f64| std::array::from_fn(|e| from[e] + share * (to[e] - from[e]));
        let before = self.share_before(border, along, at);
        let enter = root.and_then(|root| {
            let ray = Ray::new(from, std::array::from_fn(|e| to[e] - from[e])).ok()?;
            interval(&ray, root).map(|[enter, _]| enter)
        });
        if enter.is_some_and(|enter| enter < before) {
            return;
        }

        let role = Role::RayAway;
        let mark = Mark { shape: mark.shape, role, node: None, text: None };
        let moved = |by: f64, aside: f64| -> [f64; 2] {
            std::array::from_fn(|e| border[e] + by * along[e] + aside * [-along[1], along[0]][e])
        };
        // Two strokes across, as where a drawing leaves something out.
        const HALF: f64 = 6.5;
        for by in [INSET, INSET + 5.0] {
            let stroke = Form::Polyline(vec![moved(by - 2.5, HALF), moved(by + 2.5, -HALF)]);
            self.push_at(above_space(role), &mark, Part::Edge, stroke);
        }
        let Some(root) = root else { return };
        let text = short(distance_to_box(from, root));
        let reach = text_reach(role, &text);
        let [ring, gap] = [4.0, 5.0];
        let reach = [reach[0] + ring + 0.5 * gap, reach[1]];
        // Beside the ray, so far that it is not touched.
        let aside = HALF + 2.0 + (0..2).map(|e| reach[e] * along[1 - e].abs()).sum::<f64>();
        let places = [1.0, -1.0]
            .into_iter()
            .flat_map(|side| [0.0, 12.0, 24.0, 40.0].map(|by| moved(INSET + by, side * aside)));
        let on_page: Vec<_> = places.filter(|at| self.is_on_page(*at, reach)).collect();
        let Some(at) = self.clearest(on_page, reach) else { return };
        // A ring as at the origin, then the distance.
        let left = at[0] - reach[0];
        let centre = [left + ring, at[1]];
        let disc = Form::Circle { centre, radius: ring };
        self.push_at(above_space(role), &mark, Part::Whole, disc);
        let at = [left + 2.0 * ring + gap, at[1]];
        let text = Form::Text { at, anchor: Anchor::Start, text: text.into() };
        self.push_at(above_space(role), &mark, Part::Whole, text);
    }

    /// Share of a line in the world that lies before the border of the page, where it
    /// goes `along` the page.
    fn share_before(&self, border: [f64; 2], along: [f64; 2], at: impl Fn(f64) -> [f64; D]) -> f64 {
        let is_before = |share: f64| {
            self.camera.project(self.page, at(share)).is_none_or(|projected| {
                (0..2).map(|e| (projected.at[e] - border[e]) * along[e]).sum::<f64>() < 0.0
            })
        };
        let (mut outside, mut inside) = (0.0, 1.0);
        for _ in 0..64 {
            let middle = 0.5 * (outside + inside);
            *(if is_before(middle) { &mut outside } else { &mut inside }) = middle;
        }
        inside
    }
}

/// Distance of a point from the nearest point of a box.
fn distance_to_box<const D: usize>(point: [f64; D], bounds: &Aabb<D>) -> f64 {
    let beyond = |e: usize| (bounds.min[e] - point[e]).max(point[e] - bounds.max[e]).max(0.0);
    (0..D).map(beyond).fold(0.0, f64::hypot)
}

/// Two digits of a length.
fn short(length: f64) -> String {
    number(format!("{length:.1e}").parse().unwrap_or(length))
}
