//! Boxes in the plane.

use super::cross::cross_out;
use super::{Canvas, FINE, GROUND, above_space, has_ground};
use crate::camera::corners;
use crate::{Form, Mark, Part, Role, Style, Theme};
use octoscope_core::geometry::Aabb;

impl<const D: usize> Canvas<'_, D> {
    /// A box of the plane: its area and its outline.
    pub(super) fn draw_cell(&mut self, mark: &Mark<D>, bounds: &Aabb<D>) {
        let points = self.outline(bounds);
        self.keep_box(mark.role, &points);
        if has_ground(mark.role) {
            self.draw_ground(mark, bounds, points);
        } else {
            self.draw_outline(mark, bounds, points);
        }
    }

    /// The area below everything, the outline in its place.
    fn draw_ground(&mut self, mark: &Mark<D>, bounds: &Aabb<D>, points: Vec<[f64; 2]>) {
        self.spare(&points);
        let area = Form::Polygon(points.clone());
        self.push_at(GROUND, mark, Part::Face(0), area);
        let part = self.edge_part(mark, bounds);
        self.push_at(above_space(mark.role), mark, part, Form::Polygon(points));
    }

    fn draw_outline(&mut self, mark: &Mark<D>, bounds: &Aabb<D>, points: Vec<[f64; 2]>) {
        let side = bounds.size()[0] / self.camera.unit(self.page);
        let is_leaf = is_leaf(mark.role);
        let is_line = Style::of(Theme::Light, mark.role).fill.is_none();
        let part = match self.edge_part(mark, bounds) {
            _ if is_leaf && side < FINE => Part::Fine,
            Part::FineEdge if is_line => Part::FineEdge,
            _ => Part::Whole,
        };
        if !is_leaf {
            self.spare(&points);
        }
        let cross = cross_out(mark.role, &points, self.page);
        self.push_cased(mark, *bounds, part, Form::Polygon(points));
        let part = if part == Part::Fine { part } else { Part::Edge };
        for line in cross {
            self.push(mark, *bounds, part, line);
        }
    }

    /// Corners of a plane box on the page, in turn.
    pub(super) fn outline(&self, bounds: &Aabb<D>) -> Vec<[f64; 2]> {
        let corners: Vec<_> =
            corners(bounds).filter_map(|c| self.camera.project(self.page, c)).collect();
        [0, 2, 3, 1].into_iter().filter_map(|i| corners.get(i)).map(|p| p.at).collect()
    }
}

fn is_leaf(role: Role) -> bool {
    matches!(
        role,
        Role::EmptyLeaf
            | Role::FullLeaf
            | Role::FaintNode
            | Role::Pixel(_)
            | Role::Visited { .. }
            | Role::Strayed
    )
}
