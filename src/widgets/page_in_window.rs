//! Where the page of a figure lies in the window.

use eframe::egui::{Pos2, Rect, vec2};
use octoscope_core::geometry::Aabb;
use octoscope_figure::{Camera, Extent, Figure, Page, Role, corners};

/// Where the page of a figure, or of a camera, lies in the window.
#[derive(Clone, Copy, Debug)]
pub struct PageInWindow {
    /// Size of the page, in points.
    pub page: Page,
    /// Its upper left corner in the window.
    pub corner: Pos2,
    /// Points of the window that one point of the page takes.
    pub scale: f32,
}

impl PageInWindow {
    /// Where the page is in the window.
    pub fn rect(&self) -> Rect {
        let size = vec2(self.page.width as f32, self.page.height as f32);
        Rect::from_min_size(self.corner, self.scale * size)
    }

    /// Place in the window of a world point, if it is before the eye.
    pub fn place<const D: usize>(&self, camera: &Camera<D>, world: [f64; D]) -> Option<Pos2> {
        let at = camera.project(self.page, world)?.at;
        Some(self.on_screen(at))
    }

    /// What a box covers in the window; none where a part of it is behind the eye.
    pub fn bounds_of<const D: usize>(&self, camera: &Camera<D>, of: &Aabb<D>) -> Option<Rect> {
        corners(of).try_fold(Rect::NOTHING, |covered, corner| {
            Some(covered.union(Rect::from_pos(self.place(camera, corner)?)))
        })
    }

    /// What the parts of a figure that are of these roles cover in the window.
    pub fn places_of(&self, figure: &Figure, is_wanted: impl Fn(Role) -> bool) -> Vec<Rect> {
        let extents = figure.extents_of(is_wanted).into_iter();
        let ends = |extent: Extent| [extent.min, extent.max].map(|at| self.on_screen(at));
        extents.map(ends).map(|[min, max]| Rect::from_min_max(min, max)).collect()
    }

    /// Place in the window of a point of the page.
    pub fn on_screen(&self, at: [f64; 2]) -> Pos2 {
        self.corner + self.scale * vec2(at[0] as f32, at[1] as f32)
    }

    /// Point of the page at a place in the window.
    pub fn on_page(&self, place: Pos2) -> [f64; 2] {
        let offset = (place - self.corner) / self.scale;
        [f64::from(offset.x), f64::from(offset.y)]
    }

    /// World point at a place in the window, as far from the eye as `through`.
    pub fn world<const D: usize>(
        &self,
        camera: &Camera<D>,
        place: Pos2,
        through: [f64; D],
    ) -> [f64; D] {
        camera.unproject(self.page, self.on_page(place), through)
    }
}
