//! The ray itself.

use super::Scene;
use crate::{Mark, Role, Shape};
use octoscope_core::geometry::{Aabb, Ray};
use octoscope_core::query::Query;
use octoscope_core::tree::Tree;

impl<const D: usize> Scene<'_, D> {
    /// Its arrow as far as it is asked about, what lies beyond, and its handles.
    pub(super) fn ray(&self, marks: &mut Vec<Mark<D>>) {
        let Query::Ray { options, .. } = self.query else {
            return;
        };
        let (from, to) = (self.ray.origin(), self.ray.at(1.0));
        let far = far_parameter(self.tree, self.ray);
        let end = arrow_end(self.tree, self.ray, options.end());
        let far = self.ray.at(far);
        marks.push(Mark::new(Shape::Arrow([from, end]), Role::Ray));
        if end != far {
            marks.push(Mark::new(Shape::Segment([end, far]), Role::RayBeyond));
        }
        marks.push(Mark::new(Shape::Point(from), Role::RayOrigin));
        marks.push(Mark::new(Shape::Tip([from, to]), Role::RayTip));
    }
}

/// Where the arrow of a ray ends that is asked about up to the parameter `end`, if that is
/// not beyond its far end.
pub fn arrow_end<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, end: Option<f64>) -> [f64; D] {
    let far = far_parameter(tree, ray);
    ray.at(end.unwrap_or(far).clamp(0.0, far))
}

/// Where the arrow of a ray without an end of its own ends: a little beyond the root and
/// its handle; of a ray that misses the root, beyond the place where it is nearest to it.
pub fn far_end<const D: usize>(tree: &Tree<D>, ray: &Ray<D>) -> [f64; D] {
    ray.at(far_parameter(tree, ray))
}

fn far_parameter<const D: usize>(tree: &Tree<D>, ray: &Ray<D>) -> f64 {
    const BEYOND: f64 = 0.06;
    let root = tree.domain().root_box();
    let beyond = stretch(BEYOND, &root, ray);
    let past = nearest(root.centre(), ray) + stretch(STRETCH, &root, ray);
    let exit = interval(ray, &root).map_or(past, |[_, exit]| exit + beyond);
    exit.max(1.0 + beyond).min(f64::MAX)
}

/// Length of the stretch of a ray that tells where it comes from and goes, in sides of the
/// root.
pub(crate) const STRETCH: f64 = 0.35;

/// How much t changes along a stretch of a ray of so many sides of the root.
pub(crate) fn stretch<const D: usize>(sides: f64, root: &Aabb<D>, ray: &Ray<D>) -> f64 {
    let side = root.size().into_iter().fold(0.0, f64::max);
    // Squares of small components would vanish; an infinite t times 0 is no place.
    let length = ray.direction().into_iter().fold(0.0, f64::hypot);
    (sides * side / length).min(f64::MAX)
}

/// Parameter at which a ray is nearest to a point, 0 or more.
pub(crate) fn nearest<const D: usize>(point: [f64; D], ray: &Ray<D>) -> f64 {
    let largest = ray.direction().into_iter().fold(0.0, |most: f64, d| most.max(d.abs()));
    let along = ray.direction().map(|d| d / largest);
    let dot = |v: [f64; D]| (0..D).map(|e| v[e] * along[e]).sum::<f64>();
    let way = std::array::from_fn(|e| point[e] - ray.origin()[e]);
    (dot(way) / dot(along) / largest).clamp(0.0, f64::MAX)
}

/// Parameters at which the ray's line enters and leaves a box, for showing;
/// `None` if it misses the box.
pub(crate) fn interval<const D: usize>(ray: &Ray<D>, bounds: &Aabb<D>) -> Option<[f64; 2]> {
    let (origin, direction) = (ray.origin(), ray.direction());
    let (mut enter, mut exit) = (f64::NEG_INFINITY, f64::INFINITY);
    for e in 0..D {
        if direction[e] == 0.0 {
            if origin[e] < bounds.min[e] || origin[e] > bounds.max[e] {
                return None;
            }
        } else {
            let [a, b] = [bounds.min[e], bounds.max[e]].map(|x| (x - origin[e]) / direction[e]);
            enter = enter.max(a.min(b));
            exit = exit.min(a.max(b));
        }
    }
    (enter <= exit).then_some([enter, exit])
}
