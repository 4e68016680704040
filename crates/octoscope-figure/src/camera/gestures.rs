//! Where a camera looks, and how it is turned and moved by hand.

use super::{Camera, Lens, Page};
use octoscope_core::geometry::Ray;

impl<const D: usize> Camera<D> {
    /// Line of sight through a place on the page, away from the eye.
    pub fn sight(&self, page: Page, at: [f64; 2]) -> Option<Ray<D>> {
        let [_, _, back] = self.basis();
        let on_page = self.unproject(page, at, self.target);
        let direction = match self.lens {
            Lens::Orthographic => back.map(|b| -b * self.height),
            Lens::Perspective => {
                std::array::from_fn(|e| on_page[e] - (self.target[e] + self.distance() * back[e]))
            }
        };
        Ray::new(std::array::from_fn(|e| on_page[e] - direction[e]), direction).ok()
    }

    /// The point of the line through `ends` that is seen at a place on the page, on this line.
    pub fn point_at(&self, page: Page, ends: [[f64; D]; 2], at: [f64; 2]) -> [f64; D] {
        let scale = self.scale(page);
        let on_page = [at[0] - 0.5 * page.width, 0.5 * page.height - at[1]];
        let [from, to] = ends.map(|end| self.eye(end));
        // In a perspective what lies farther from the eye is smaller.
        let size = |eye: [f64; 3]| match self.effective_lens() {
            Lens::Orthographic => 1.0,
            Lens::Perspective => eye[2] / self.distance(),
        };
        let share = |e: usize| {
            let way = |eye: [f64; 3]| scale * eye[e] - on_page[e] * size(eye);
            [-way(from), way(to) - way(from)]
        };
        let [x, y] = [share(0), share(1)];
        let [above, below] = if x[1].abs() > y[1].abs() { x } else { y };
        let share = if below == 0.0 { 0.0 } else { above / below };
        std::array::from_fn(|e| ends[0][e] + share * (ends[1][e] - ends[0][e]))
    }

    /// Turns by a drag of (`dx`, `dy`) page units: the world follows the hand.
    pub fn orbit(&mut self, page: Page, dx: f64, dy: f64) {
        use std::f64::consts::{FRAC_PI_2, PI};
        self.yaw = (self.yaw - dx / page.height * PI).rem_euclid(2.0 * PI);
        self.pitch = (self.pitch + dy / page.height * PI).clamp(-FRAC_PI_2, FRAC_PI_2);
    }

    /// Moves along the page by a drag of (`dx`, `dy`) page units.
    pub fn pan(&mut self, page: Page, dx: f64, dy: f64) {
        let unit = self.unit(page);
        let [right, up, _] = self.basis();
        for e in 0..D {
            self.target[e] += unit * (dy * up[e] - dx * right[e]);
        }
    }

    /// Comes nearer by `factor` (above 1) or goes away, so that what is under
    /// `at` stays there.
    pub fn zoom(&mut self, page: Page, at: [f64; 2], factor: f64) {
        let before = self.unproject(page, at, self.target);
        self.height /= factor;
        let after = self.unproject(page, at, self.target);
        for e in 0..D {
            self.target[e] += before[e] - after[e];
        }
    }
}
