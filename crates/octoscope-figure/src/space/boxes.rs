//! Boxes and planes in space.

use super::cross::cross_out_box;
use super::inset::longest_side;
use super::overlaid::uncovered;
use super::rejected::is_shared;
use super::{Canvas, HINT, InSpace, LEGIBLE, SMALL, above_space, is_above, is_apart, is_hint};
use crate::camera::corners;
use crate::sides::{Side, sides_to_eye};
use crate::{Drawn, Form, Mark, Part, Role, Shape, Style, Theme};
use octoscope_core::geometry::Aabb;

/// Boxes of less than this side, in page units, are specks.
const SPECK: f64 = 16.0;

impl<const D: usize> Canvas<'_, D> {
    /// Edges behind, sides that face the eye, and their edges.
    pub(super) fn draw_box(&mut self, mark: &Mark<D>, bounds: &Aabb<D>) {
        let seen = sides_to_eye(self.camera, self.page, bounds);
        let (mut behind, mut front) = (Vec::new(), Vec::new());
        if Style::of(Theme::Light, mark.role).fill.is_some() {
            for side in &seen {
                let polygon: Vec<_> = side.polygon.iter().map(|p| p.at).collect();
                front.push((Part::Face(side.axis), Form::Polygon(polygon)));
            }
        }
        let edges = self.edges(mark, bounds, &seen);
        let (in_sight, hidden): (Vec<_>, Vec<_>) = edges.into_iter().partition(|(_, seen)| *seen);
        let form = |(line, _): &([[f64; 2]; 2], bool)| Form::Polyline(line.to_vec());
        behind.extend(hidden.iter().map(|edge| (Part::HiddenEdge, form(edge))));
        let part = self.edge_part(mark, bounds);
        let side = longest_side(bounds, self.camera.unit(self.page));
        // What parts an edge from what lies below it cuts none of the box's other edges. That
        // of a fine one would hide more than it, but for a speck, which it lifts out.
        if mark.role.has_casing() && (part != Part::FineEdge || side < SPECK) {
            front.extend(in_sight.iter().map(|edge| (Part::Casing, form(edge))));
        }
        let cross = cross_out_box(mark.role, bounds, self.camera, self.page);
        front.extend(cross.into_iter().map(|line| (Part::Edge, line)));
        front.extend(in_sight.iter().map(|edge| (part, form(edge))));
        self.spared.extend(in_sight.iter().map(|(line, _)| *line));
        self.keep_sides(mark.role, &seen);
        let drawn = |(part, form)| Drawn { form, role: mark.role, part, node: mark.node };
        let [behind, front] =
            [behind, front].map(|parts| parts.into_iter().map(drawn).collect::<Vec<_>>());
        if is_apart(mark.role) {
            let order = self.order_apart(bounds);
            self.drawn.extend(behind.into_iter().chain(front).map(|drawn| (order, drawn)));
        } else if is_hint(mark.role) {
            let hint = behind.into_iter().chain(front).map(|drawn| (HINT, drawn));
            self.drawn.extend(hint);
        } else if is_above(mark.role) || self.is_small_cell(mark.role, bounds) {
            let order = above_space(mark.role);
            self.drawn.extend(behind.into_iter().chain(front).map(|drawn| (order, drawn)));
        } else {
            self.in_space.push(InSpace { bounds: *bounds, behind, front });
        }
    }

    /// Whether it is a cell of the grid, or one that is looked for, of which planes and
    /// outlines in front of it would leave nothing to be seen.
    fn is_small_cell(&self, role: Role, bounds: &Aabb<D>) -> bool {
        /// The least that is seen among them, in page units.
        const LEAST: f64 = 48.0;
        let [width, height] = self.extent(bounds);
        matches!(role, Role::GridCell | Role::Target) && width.max(height) < LEAST
    }

    /// The edges of a box that are drawn, and whether each bounds a side that is seen.
    pub(super) fn edges(
        &self,
        mark: &Mark<D>,
        bounds: &Aabb<D>,
        seen: &[Side<D>],
    ) -> Vec<([[f64; 2]; 2], bool)> {
        let role = mark.role;
        let ends: Vec<[f64; D]> = corners(bounds).collect();
        let bit = |axis: usize| 1usize << (D - 1 - axis);
        let in_sight = |corner: usize, axis: usize| {
            seen.iter().any(|s| s.axis != axis && (corner & bit(s.axis) != 0) == s.is_upper)
        };
        let yields = matches!(role, Role::Root | Role::Ancestor { .. });
        let strong = if yields { self.strong.as_slice() } else { &[] };
        let cell: Vec<[f64; D]> = match mark.shape {
            Shape::Box(cell) => corners(&cell).collect(),
            _ => ends.clone(),
        };
        // Of what is ruled out the outline that is seen, of all such children together.
        let is_left_out = |[from, to]: [usize; 2], axis: usize| {
            let is_inner = || is_shared([cell[from], cell[to]], &self.rejected);
            role == Role::Rejected && (!in_sight(from, axis) || is_inner())
        };
        let mut edges = Vec::new();
        for axis in 0..D {
            for corner in (0..1 << D).filter(|corner| corner & bit(axis) == 0) {
                let far = corner | bit(axis);
                if is_left_out([corner, far], axis) {
                    continue;
                }
                let edge = [ends[corner], ends[far]];
                let parts = uncovered(edge, axis, strong).into_iter();
                let lines = parts.filter_map(|part| self.camera.project_segment(self.page, part));
                let is_in_sight = in_sight(corner, axis);
                edges.extend(lines.map(|line| (line.map(|p| p.at), is_in_sight)));
            }
        }
        edges
    }

    /// A side of a box, or a plane through it.
    pub(super) fn draw_plane(&mut self, mark: &Mark<D>, axis: usize, bounds: &Aabb<D>) {
        let beside = self.beside_node(mark.role, bounds, axis);
        let bounds = &self.overhanging(mark.role, &beside, axis);
        let corners: Vec<[f64; D]> = corners(bounds).collect();
        let upper = 1usize << (D - 1 - axis);
        let own: Vec<[f64; D]> = (0..1 << D)
            .filter(|corner| corner & upper == 0)
            .map(|corner| corners[corner])
            .collect();
        if let [from, to] = own[..] {
            if let Some(line) = self.camera.project_segment(self.page, [from, to]) {
                let line = Form::Polyline(line.map(|p| p.at).to_vec());
                self.push_cased(mark, *bounds, Part::Edge, line);
            }
        } else if let [a, b, c, d] = own[..] {
            let polygon: Vec<_> = [a, b, d, c]
                .into_iter()
                .filter_map(|p| self.camera.project(self.page, p))
                .map(|p| p.at)
                .collect();
            self.push_sheet(mark, *bounds, polygon);
        }
    }

    /// A plane in space; one through a small node is finer, which it would hide.
    fn push_sheet(&mut self, mark: &Mark<D>, bounds: Aabb<D>, polygon: Vec<[f64; 2]>) {
        if longest_side(&bounds, self.camera.unit(self.page)) >= LEGIBLE {
            return self.push_cased(mark, bounds, Part::Whole, Form::Polygon(polygon));
        }
        let outline = polygon.iter().chain(polygon.first()).copied().collect();
        let area = (Part::Face(0), Form::Polygon(polygon));
        self.push_parts(mark, bounds, vec![area, (Part::FineEdge, Form::Polyline(outline))]);
    }

    /// A side that a cell of the plane owns, or not, beside the outline of that, which it
    /// would hide.
    fn beside_node(&self, role: Role, bounds: &Aabb<D>, axis: usize) -> Aabb<D> {
        const AWAY: f64 = 4.0;
        let away = AWAY * self.camera.unit(self.page);
        let by = if role == Role::OwnedSide { -away } else { away };
        if !matches!(role, Role::OwnedSide | Role::OpenSide) {
            return *bounds;
        }
        let mut beside = *bounds;
        (beside.min[axis], beside.max[axis]) = (bounds.min[axis] + by, bounds.max[axis] + by);
        beside
    }

    /// Whether a plane is a side that faces the eye of what is at work.
    fn is_on_side(&self, plane: &Aabb<D>, axis: usize) -> bool {
        self.strong.iter().any(|bounds| {
            let is_side = |side: &Side<D>| {
                let at = if side.is_upper { bounds.max } else { bounds.min };
                side.axis == axis && at[axis] == plane.min[axis]
            };
            let is_as_large = (0..D).all(|e| {
                e == axis || (bounds.min[e], bounds.max[e]) == (plane.min[e], plane.max[e])
            });
            is_as_large && sides_to_eye(self.camera, self.page, bounds).iter().any(is_side)
        })
    }

    /// A plane a little beyond its node, so that it is told from the sides of that; one that
    /// is compared farther beyond a small node, whose frame would hide it; none on a side that
    /// is seen of what is at work: it lies above that.
    pub(super) fn overhanging(&self, role: Role, bounds: &Aabb<D>, axis: usize) -> Aabb<D> {
        const BEYOND: f64 = 7.0;
        const MOST: f64 = 0.06;
        const BEYOND_SMALL: f64 = 10.0;
        let (size, unit) = (bounds.size(), self.camera.unit(self.page));
        let is_compared = matches!(role, Role::MidPlane(_) | Role::ExitPlane(_));
        let is_small = |side: &f64| (SMALL..LEGIBLE).contains(&(side / unit));
        let is_hidden = D == 2 && is_compared && size.iter().any(is_small);
        let is_on_side = D == 3 && self.is_on_side(bounds, axis);
        let by: [f64; D] = std::array::from_fn(|e| match () {
            () if e == axis || is_on_side => 0.0,
            () if is_hidden => BEYOND_SMALL * unit,
            () => (BEYOND * unit).min(MOST * size[e]),
        });
        Aabb {
            min: std::array::from_fn(|e| bounds.min[e] - by[e]),
            max: std::array::from_fn(|e| bounds.max[e] + by[e]),
        }
    }
}
