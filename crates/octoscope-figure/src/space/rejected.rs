//! Children in space that are ruled out, as one body: seven outlines would be a thicket.

use crate::{Mark, Role, Shape};
use octoscope_core::geometry::Aabb;

/// The boxes of the children that are ruled out.
pub(super) fn rejected_boxes<'a, const D: usize>(
    marks: impl Iterator<Item = &'a Mark<D>>,
) -> Vec<Aabb<D>> {
    let rejected = marks.filter(|mark| mark.role == Role::Rejected);
    let boxes = rejected.filter_map(|mark| match mark.shape {
        Shape::Box(bounds) => Some(bounds),
        _ => None,
    });
    boxes.collect()
}

/// Whether an edge belongs to more than one of these boxes, which lie side by side: it is
/// none of their common body, or one in which it is dented.
pub(super) fn is_shared<const D: usize>(edge: [[f64; D]; 2], boxes: &[Aabb<D>]) -> bool {
    let is_corner = |bounds: &Aabb<D>, end: [f64; D]| {
        (0..D).all(|e| end[e] == bounds.min[e] || end[e] == bounds.max[e])
    };
    let of = boxes.iter().filter(|bounds| edge.iter().all(|end| is_corner(bounds, *end)));
    of.count() > 1
}
