//! Points, and what content looks like: spheres and triangles.

use super::{Canvas, diamond, distance, point_box};
use crate::{Form, Mark, Part, Projected, Role, Style, Theme};

impl<const D: usize> Canvas<'_, D> {
    pub(super) fn draw_point(&mut self, mark: &Mark<D>, point: [f64; D]) {
        let radius = self.radius(mark);
        let projected = self.camera.project(self.page, point);
        let Some(Projected { at, .. }) = projected.filter(|p| self.is_near(p.at, radius)) else {
            return;
        };
        if mark.role == Role::Content {
            self.spared.push([at; 2]);
        } else {
            self.taken.push([at, [radius + 1.0; 2]]);
        }
        self.push(mark, point_box(point), Part::Whole, Form::Circle { centre: at, radius });
    }

    /// The handle at the tip of an arrow.
    pub(super) fn draw_tip(&mut self, mark: &Mark<D>, ends: [[f64; D]; 2]) {
        let Some(at) = self.camera.tip_handle(self.page, ends) else { return };
        let radius = Style::of(Theme::Light, mark.role).radius;
        self.taken.push([at, [radius + 1.0; 2]]);
        self.push(mark, point_box(ends[1]), Part::Whole, diamond(at, radius));
    }

    pub(super) fn draw_sphere(&mut self, mark: &Mark<D>, centre: [f64; D], radius: f64) {
        let [_, up, _] = self.camera.basis();
        let rim = std::array::from_fn(|e| centre[e] + radius * up[e]);
        let ends = [centre, rim].map(|p| self.camera.project(self.page, p));
        if let [Some(middle), Some(rim)] = ends {
            let radius = distance(middle.at, rim.at);
            let form = Form::Circle { centre: middle.at, radius };
            self.push(mark, point_box(centre), Part::Whole, form);
        }
    }

    pub(super) fn draw_triangle(&mut self, mark: &Mark<D>, points: &[[f64; D]; 3]) {
        let on_page = |point: &[f64; D]| Some(self.camera.project(self.page, *point)?.at);
        let corners: Option<Vec<[f64; 2]>> = points.iter().map(on_page).collect();
        let Some(corners) = corners else { return };
        let middle = std::array::from_fn(|e| points.iter().map(|p| p[e] / 3.0).sum());
        self.push(mark, point_box(middle), Part::Whole, Form::Polygon(corners));
    }

    /// Radius of a point. Those of a small node are small, so that they do not hide it.
    fn radius(&self, mark: &Mark<D>) -> f64 {
        let Style { radius, width, .. } = Style::of(Theme::Light, mark.role);
        match mark.role {
            Role::Content if D == 3 => Style::POINT_IN_SPACE - 0.5 * width,
            Role::EntryPoint | Role::ExitPoint => radius.min(self.dot - 0.5 * width),
            _ => radius,
        }
    }
}
