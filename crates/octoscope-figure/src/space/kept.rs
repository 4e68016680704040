//! What numbers and the tags of children may not cover: the ray, ways, and the boxes of what
//! is asked for and looked up.

use super::{Canvas, distance};
use crate::sides::{Side, sides_to_eye};
use crate::{Extent, Mark, Role, Shape};

/// Boxes with sides of less than this, in page units, are covered nowhere.
const SMALL: f64 = 40.0;

impl<const D: usize> Canvas<'_, D> {
    /// Heeds a box that is drawn by others.
    pub(super) fn heed(&mut self, mark: &Mark<D>) {
        if let Shape::Box(bounds) = mark.shape {
            let bounds = self.drawn_box(mark, &bounds);
            let seen = sides_to_eye(self.camera, self.page, &bounds);
            self.keep_sides(mark.role, &seen);
            let edges = self.edges(mark, &bounds, &seen).into_iter();
            self.spared.extend(edges.filter_map(|(line, is_in_sight)| is_in_sight.then_some(line)));
        }
    }

    pub(super) fn keep_line(&mut self, role: Role, line: [[f64; 2]; 2]) {
        let is_kept = matches!(
            role,
            Role::Ray
                | Role::RayBeyond
                | Role::Direction
                | Role::WayUp
                | Role::WayDown
                | Role::Link
        );
        if is_kept {
            self.kept.push(line);
        }
    }

    /// Keeps the line and the outline of the head of an arrow.
    pub(super) fn keep_arrow(&mut self, role: Role, shaft: &[[f64; 2]], head: [[f64; 2]; 3]) {
        shaft.windows(2).for_each(|ends| self.keep_line(role, [ends[0], ends[1]]));
        let next = head.iter().cycle().skip(1);
        self.kept.extend(head.iter().zip(next).map(|(a, b)| [*a, *b]));
    }

    /// Keeps the outline of a box in the plane, and all of a small one.
    pub(super) fn keep_box(&mut self, role: Role, outline: &[[f64; 2]]) {
        if !matches!(role, Role::GridCell | Role::Target | Role::Region) {
            return;
        }
        let next = outline.iter().cycle().skip(1);
        let lines: Vec<_> = outline.iter().zip(next).map(|(a, b)| [*a, *b]).collect();
        if lines.iter().all(|[from, to]| distance(*from, *to) < SMALL) {
            let extent = Extent::around(outline.iter().copied());
            let taken = extent.map(|all| [all.middle(), all.size().map(|side| 0.5 * side + 1.0)]);
            self.taken.extend(taken);
        }
        self.kept.extend(lines);
    }

    /// The same in space, by the sides that are seen.
    pub(super) fn keep_sides(&mut self, role: Role, seen: &[Side<D>]) {
        for side in seen {
            let outline: Vec<[f64; 2]> = side.polygon.iter().map(|p| p.at).collect();
            self.keep_box(role, &outline);
        }
    }
}
