//! Boxes that are drawn within their own cell.

use crate::Role;
use octoscope_core::geometry::Aabb;

/// The box of a mark as it is drawn: that of a child which is not taken lies a little
/// within its cell, so that its line is told from those of its parent and its neighbours.
/// `unit` is a page unit in world units.
pub fn drawn_box<const D: usize>(role: Role, bounds: &Aabb<D>, unit: f64) -> Aabb<D> {
    const INSET: f64 = 3.0;
    const MOST: f64 = 0.1;
    if role != Role::Rejected {
        return *bounds;
    }
    let size = bounds.size();
    let by: [f64; D] = std::array::from_fn(|e| (INSET * unit).min(MOST * size[e]));
    Aabb {
        min: std::array::from_fn(|e| bounds.min[e] + by[e]),
        max: std::array::from_fn(|e| bounds.max[e] - by[e]),
    }
}
