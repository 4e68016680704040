//! The sides of a box that are turned to the eye.

use crate::camera::corners;
use crate::{Camera, Page, Projected};
use octoscope_core::geometry::Aabb;

/// A side of a box.
pub(crate) struct Side<const D: usize> {
    /// The axis across which it lies.
    pub axis: usize,
    /// Whether it has the larger coordinate.
    pub is_upper: bool,
    /// Its corners, in turn.
    pub polygon: Vec<Projected>,
}

impl<const D: usize> Side<D> {
    /// Unit vector out of the box.
    pub fn normal(&self) -> [f64; D] {
        let sign = if self.is_upper { 1.0 } else { -1.0 };
        std::array::from_fn(|e| if e == self.axis { sign } else { 0.0 })
    }
}

/// The sides of a box in space whose outside is seen, one an axis at most;
/// none of a box that reaches behind the eye.
pub(crate) fn sides_to_eye<const D: usize>(
    camera: &Camera<D>,
    page: Page,
    bounds: &Aabb<D>,
) -> Vec<Side<D>> {
    let on_page: Option<Vec<Projected>> =
        corners(bounds).map(|c| camera.project(page, c)).collect();
    let Some(on_page) = on_page else { return Vec::new() };
    let faces_eye = |axis: usize, is_upper: bool| {
        let to_eye = camera.towards_eye(if is_upper { bounds.max } else { bounds.min })[axis];
        if is_upper { to_eye > 0.0 } else { to_eye < 0.0 }
    };
    let candidates = (0..D).flat_map(|axis| [(axis, false), (axis, true)]);
    let seen = candidates.filter(|&(axis, is_upper)| faces_eye(axis, is_upper));
    seen.map(|(axis, is_upper)| {
        let bit = |axis: usize| 1usize << (D - 1 - axis);
        let start = if is_upper { bit(axis) } else { 0 };
        let [a, b] = [1, 2].map(|next| bit((axis + next) % D));
        let ring = [start, start | a, start | a | b, start | b];
        Side { axis, is_upper, polygon: ring.map(|corner| on_page[corner]).to_vec() }
    })
    .collect()
}
