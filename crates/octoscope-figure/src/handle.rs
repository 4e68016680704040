//! Where the handle on a ray's tip is drawn, and therefore taken hold of.

use crate::camera::clipped;
use crate::{Camera, Page};

/// Least distance of the tip's handle from the origin, in page units: both can
/// be told apart and taken hold of.
pub const HANDLE_DISTANCE: f64 = 40.0;
/// Room between a handle and the border of the page.
const INSET: f64 = 16.0;

impl<const D: usize> Camera<D> {
    /// Place on the page of the handle for the tip of a ray from `origin` to
    /// `tip`: at the tip; or farther along the ray if the tip is too near to
    /// the origin; or where the ray leaves the page if the tip is not on it.
    /// `None` if nothing of the ray up to its tip is on the page.
    pub fn tip_handle(&self, page: Page, [origin, tip]: [[f64; D]; 2]) -> Option<[f64; 2]> {
        let [from, to] = self.project_segment(page, [origin, tip])?.map(|end| end.at);
        if !from.iter().chain(&to).all(|x| x.is_finite()) {
            return None;
        }
        let outer = [page.width, page.height];
        let inset = std::array::from_fn(|e| INSET.min(0.5 * outer[e]));
        let inner = [inset, std::array::from_fn(|e| outer[e] - inset[e])];
        let is_on = |at: [f64; 2]| (0..2).all(|e| (0.0..=outer[e]).contains(&at[e]));
        let end = if is_on(to) && self.project(page, tip).is_some() {
            to
        } else {
            clipped([from, to], inner).or_else(|| clipped([from, to], [[0.0; 2], outer]))?[1]
        };
        let way: [f64; 2] = std::array::from_fn(|e| end[e] - from[e]);
        let length = way[0].hypot(way[1]);
        if length >= HANDLE_DISTANCE {
            return Some(end);
        }
        // A ray towards the eye has no way on the page; any will do.
        let along = if length > 1e-9 { way.map(|x| x / length) } else { [1.0, 0.0] };
        Some(std::array::from_fn(|e| from[e] + HANDLE_DISTANCE * along[e]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::geometry::Aabb;

    const PAGE: Page = Page { width: 800.0, height: 600.0 };

    fn camera<const D: usize>() -> Camera<D> {
        Camera::framing(&Aabb { min: [0.0; D], max: [1.0; D] }, PAGE)
    }

    #[track_caller]
    fn check<const D: usize>(ends: [[f64; D]; 2]) -> [f64; 2] {
        let camera = camera::<D>();
        let handle = camera.tip_handle(PAGE, ends).unwrap();
        let origin = camera.project(PAGE, ends[0]).unwrap().at;
        let apart = (handle[0] - origin[0]).hypot(handle[1] - origin[1]);
        assert!(apart > HANDLE_DISTANCE - 1e-9, "{ends:?}: {apart}");
        assert!((0.0..=800.0).contains(&handle[0]) && (0.0..=600.0).contains(&handle[1]));
        handle
    }

    #[test]
    fn a_tip_in_sight_is_where_it_is() {
        let tip = [0.75, 0.5];
        assert_eq!(check([[0.25, 0.25], tip]), camera().project(PAGE, tip).unwrap().at);
    }

    #[test]
    fn short_and_long_rays_have_a_handle_that_can_be_reached() {
        for length in [0.0, 1e-300, 1e-6, 0.01, 0.05, 2.0, 1e6, 1e300, 1e308, f64::MAX] {
            check([[0.25, 0.25], [0.25 + length, 0.25 - 0.5 * length]]);
            check([[0.25; 3], [0.25 - length, 0.25, 0.25 + length]]);
            check([[0.25; 3], [0.25, 0.25 - length, 0.25]]);
        }
    }

    #[test]
    fn a_ray_beside_the_page_has_no_handle() {
        assert_eq!(camera().tip_handle(PAGE, [[5.0, 5.0], [5.0, 6.0]]), None);
    }
}
