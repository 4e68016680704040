//! Edges in space that lie on those of a stronger box.

use crate::{Mark, Role, Shape};
use octoscope_core::geometry::Aabb;

/// The boxes whose edges are to be seen where those of the root and of ancestors lie on
/// them.
pub(super) fn strong_boxes<'a, const D: usize>(
    marks: impl Iterator<Item = &'a Mark<D>>,
) -> Vec<Aabb<D>> {
    let is_strong =
        |role: Role| matches!(role, Role::Current | Role::Missed | Role::Found | Role::Taken);
    let bounds = |mark: &Mark<D>| {
        let Shape::Box(bounds) = mark.shape else { return None };
        Some(bounds)
    };
    marks.filter(|mark| is_strong(mark.role)).filter_map(bounds).collect()
}

/// The parts of an edge along `axis` that lie on none of the edges of `strong` boxes.
pub(super) fn uncovered<const D: usize>(
    [from, to]: [[f64; D]; 2],
    axis: usize,
    strong: &[Aabb<D>],
) -> Vec<[[f64; D]; 2]> {
    let mut parts = vec![[from[axis], to[axis]]];
    let tolerance = 1e-9 * (to[axis] - from[axis]).abs();
    for bounds in strong {
        let is_side = |e: usize| {
            [bounds.min[e], bounds.max[e]].iter().any(|side| (side - from[e]).abs() <= tolerance)
        };
        if (0..D).any(|e| e != axis && !is_side(e)) {
            continue;
        }
        let [low, high] = [bounds.min[axis], bounds.max[axis]];
        parts = parts
            .into_iter()
            .flat_map(|[from, to]| [[from, to.min(low)], [from.max(high), to]])
            .filter(|[from, to]| to - from > tolerance)
            .collect();
    }
    let at = |place: f64| std::array::from_fn(|e| if e == axis { place } else { from[e] });
    parts.into_iter().map(|ends| ends.map(at)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_is_left_where_that_of_a_stronger_box_lies_on_it() {
        let bounds = |min: f64, max: f64| Aabb { min: [min, 0.0, 0.0], max: [max, 1.0, 1.0] };
        let edge = [[0.0, 1.0, 0.0], [4.0, 1.0, 0.0]];
        let along = |strong: &[Aabb<3>]| -> Vec<[f64; 2]> {
            uncovered(edge, 0, strong).iter().map(|ends| ends.map(|end| end[0])).collect()
        };
        assert_eq!(along(&[]), [[0.0, 4.0]]);
        assert_eq!(along(&[bounds(1.0, 2.0)]), [[0.0, 1.0], [2.0, 4.0]]);
        assert_eq!(along(&[bounds(0.0, 4.0)]), [[0.0; 2]; 0]);
        assert_eq!(along(&[bounds(0.0, 1.0), bounds(3.0, 4.0)]), [[1.0, 3.0]]);
        // Beside it, on one axis or on both.
        assert_eq!(along(&[Aabb { min: [0.0, 0.5, 0.0], max: [1.0, 0.8, 1.0] }]), [[0.0, 4.0]]);
    }
}
