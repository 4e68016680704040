//! Children that are moved apart: above everything else, the nearest last, each with
//! its number on the side that is seen best.

use super::{Canvas, above_space};
use crate::figure::text_reach;
use crate::sides::Side;
use crate::{Anchor, Form, Mark, Part, Role, Shape};
use octoscope_core::geometry::Aabb;

impl<const D: usize> Canvas<'_, D> {
    /// Place in the drawing order of a child in space.
    pub(super) fn order_apart(&self, bounds: &Aabb<D>) -> f64 {
        let [lowest, next] = [Role::Apart, Role::MirroredRay].map(above_space);
        let depth = self.camera.depth(bounds.centre()) / self.camera.height;
        lowest + 0.5 * (next - lowest) * (1.0 - depth / (1.0 + depth.abs()))
    }

    /// Writes the number of a child on the largest of its sides that are `seen`, if
    /// there is room; in the plane, into its middle. What lies before it hides it.
    pub(super) fn name_apart(&mut self, mark: &Mark<D>, order: f64, seen: &[Side<D>]) {
        let (Some(text), Shape::Box(bounds)) = (&mark.text, mark.shape) else {
            return;
        };
        let areas = seen.iter().map(|side| {
            let points: Vec<[f64; 2]> = side.polygon.iter().map(|p| p.at).collect();
            (area(&points), middle(&points))
        });
        let best = areas.max_by(|a, b| a.0.total_cmp(&b.0));
        let whole = || {
            let points = self.outline(&bounds);
            Some((area(&points), middle(&points))).filter(|_| D == 2)
        };
        let Some((area, at)) = best.or_else(whole) else { return };
        let [width, height] = text_reach(mark.role, text);
        if area.sqrt() > 2.0 * width.max(height) {
            let form = Form::Text { at, anchor: Anchor::Middle, text: text.as_str().into() };
            self.push_at(order, mark, Part::Whole, form);
        }
    }
}

/// Whether a role is of a child that is moved apart.
pub(super) fn is_apart(role: Role) -> bool {
    matches!(role, Role::Apart | Role::ApartTaken)
}

fn middle(points: &[[f64; 2]]) -> [f64; 2] {
    let n = points.len().max(1) as f64;
    std::array::from_fn(|e| points.iter().map(|point| point[e]).sum::<f64>() / n)
}

fn area(points: &[[f64; 2]]) -> f64 {
    let next = points.iter().cycle().skip(1);
    let twice = points.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]);
    0.5 * twice.sum::<f64>().abs()
}
