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

/// The sides of a box in space whose outside is seen, one an axis at most, as far as they
/// lie before the eye; none of a box around the eye.
pub(crate) fn sides_to_eye<const D: usize>(
    camera: &Camera<D>,
    page: Page,
    bounds: &Aabb<D>,
) -> Vec<Side<D>> {
    let faces_eye = |axis: usize, is_upper: bool| {
        let to_eye = camera.towards_eye(if is_upper { bounds.max } else { bounds.min })[axis];
        if is_upper { to_eye > 0.0 } else { to_eye < 0.0 }
    };
    sides(camera, page, bounds, faces_eye)
}

/// The sides of a box in space around the eye, all of them, as far as they lie before it.
pub(crate) fn sides_around_eye<const D: usize>(
    camera: &Camera<D>,
    page: Page,
    bounds: &Aabb<D>,
) -> Vec<Side<D>> {
    sides(camera, page, bounds, |_, _| true)
}

/// Those sides of a box, by their axes and whether they are the upper ones, that are
/// wanted, as far as they lie before the eye.
fn sides<const D: usize>(
    camera: &Camera<D>,
    page: Page,
    bounds: &Aabb<D>,
    is_wanted: impl Fn(usize, bool) -> bool,
) -> Vec<Side<D>> {
    let ends: Vec<[f64; D]> = corners(bounds).collect();
    let on_page: Vec<_> = ends.iter().map(|&corner| camera.project(page, corner)).collect();
    let candidates = (0..D).flat_map(|axis| [(axis, false), (axis, true)]);
    let wanted = candidates.filter(|&(axis, is_upper)| is_wanted(axis, is_upper));
    let sides = wanted.map(|(axis, is_upper)| {
        let bit = |axis: usize| 1usize << (D - 1 - axis);
        let start = if is_upper { bit(axis) } else { 0 };
        let [a, b] = [1, 2].map(|next| bit((axis + next) % D));
        let ring = [start, start | a, start | a | b, start | b];
        let whole: Option<Vec<_>> = ring.iter().map(|&corner| on_page[corner]).collect();
        let before_eye = || part_before_eye(camera, page, ring.map(|corner| ends[corner]));
        Side { axis, is_upper, polygon: whole.unwrap_or_else(before_eye) }
    });
    sides.filter(|side| !side.polygon.is_empty()).collect()
}

/// The part of a plane polygon that lies before the eye.
fn part_before_eye<const D: usize>(
    camera: &Camera<D>,
    page: Page,
    ring: [[f64; D]; 4],
) -> Vec<Projected> {
    let edges = (0..4).map(|corner| [ring[corner], ring[(corner + 1) % 4]]);
    let points = edges.flat_map(|edge| {
        let seen = camera.project_segment(page, edge);
        // The end of an edge is where the next begins, unless it is cut off there.
        let is_cut = camera.project(page, edge[1]).is_none();
        [seen.map(|[begin, _]| begin), seen.filter(|_| is_cut).map(|[_, end]| end)]
    });
    points.flatten().collect()
}

/// Whether the eye is in a box.
pub(crate) fn is_around_eye<const D: usize>(camera: &Camera<D>, bounds: &Aabb<D>) -> bool {
    let [from_min, from_max] = [bounds.min, bounds.max].map(|end| camera.towards_eye(end));
    (0..D).all(|e| from_min[e] > 0.0 && from_max[e] < 0.0)
}
