//! The sides that a cell owns: a cell is half-open, its lower sides belong to it,
//! its upper ones to its neighbours.

use super::{Scene, side};
use crate::camera::corners;
use crate::{Mark, Role, Shape};
use octoscope_core::geometry::Aabb;
use octoscope_core::tree::NodeId;

impl<const D: usize> Scene<'_, D> {
    /// Owned sides solid, the others dashed. In space, those of the edges that
    /// belong to the cell, and its own faces.
    pub(super) fn sides(&self, node: NodeId, bounds: &Aabb<D>, marks: &mut Vec<Mark<D>>) {
        if !self.show.half_open_sides {
            return;
        }
        let mut push = |shape, role: Role| marks.push(Mark::new(shape, role).of_node(node));
        for axis in 0..D {
            let [lower, upper] = [bounds.min, bounds.max].map(|end| side(bounds, axis, end[axis]));
            if D == 2 {
                push(lower, Role::OwnedSide);
                push(upper, Role::OpenSide);
            } else {
                push(lower, Role::OwnedFace);
            }
        }
        if D == 3 {
            for ends in edges(bounds) {
                // What two owned faces share is owned.
                let is_lower = (0..D).all(|e| ends[0][e] == bounds.min[e]);
                let role = if is_lower { Role::OwnedSide } else { Role::OpenSide };
                push(Shape::Segment(ends), role);
            }
        }
    }
}

/// The edges of a box, each from its lower to its upper end.
fn edges<const D: usize>(bounds: &Aabb<D>) -> Vec<[[f64; D]; 2]> {
    let mut edges = Vec::new();
    for from in corners(bounds) {
        for axis in (0..D).filter(|&axis| from[axis] == bounds.min[axis]) {
            let mut to = from;
            to[axis] = bounds.max[axis];
            edges.push([from, to]);
        }
    }
    edges
}
