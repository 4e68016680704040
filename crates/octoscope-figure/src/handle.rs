//! Where the handle on a ray's tip and the head of its arrow are drawn, and therefore
//! taken hold of.

use crate::camera::clipped;
use crate::marks::interval;
use crate::{Camera, Page};
use octoscope_core::geometry::{Aabb, Ray};

/// The arrow of a ray as it is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayArrow<const D: usize> {
    /// Where it begins and ends.
    pub ends: [[f64; D]; 2],
    /// Its part on the page.
    pub on_page: [[f64; 2]; 2],
}

/// Where a ray from the first point to a tip has its tip or leaves the root, whichever is
/// later.
pub fn last_point<const D: usize>(
    [from, tip]: [[f64; D]; 2],
    root: Option<&Aabb<D>>,
) -> Option<[f64; D]> {
    let ray = Ray::new(from, std::array::from_fn(|e| tip[e] - from[e])).ok()?;
    let exit = root.and_then(|root| interval(&ray, root)).map_or(1.0, |[_, exit]| exit);
    Some(ray.at(exit.clamp(1.0, f64::MAX)))
}

/// Length of the head of an arrow, in page units.
pub(crate) const HEAD: f64 = 14.0;

/// Least distance of the tip's handle from the origin, in page units: both can
/// be told apart and taken hold of.
pub const HANDLE_DISTANCE: f64 = 40.0;
/// Room between a handle and the border of the page.
const INSET: f64 = 28.0;

impl<const D: usize> Camera<D> {
    /// The arrow of a ray that ends at the second of `ends`: so long that its head lies beyond
    /// the `last` point on it, unless it is asked for up to a place before that point; what
    /// leads off the page is left out, so that its head is near the border. `None` if nothing
    /// of it is on the page.
    pub fn ray_arrow(
        &self,
        page: Page,
        ends: [[f64; D]; 2],
        last: Option<[f64; D]>,
    ) -> Option<RayArrow<D>> {
        let ends = last.map_or(ends, |last| self.past(page, ends, last));
        Some(RayArrow { ends, on_page: off_border(page, self.visible_segment(page, ends)?) })
    }

    /// The arrow, so long that its head lies beyond its `last` point.
    fn past(&self, page: Page, [from, to]: [[f64; D]; 2], last: [f64; D]) -> [[f64; D]; 2] {
        const ROOM: f64 = 8.0;
        const MOST: f64 = 8.0;
        let is_short = (0..D).map(|e| (to[e] - last[e]) * (last[e] - from[e])).sum::<f64>() < 0.0;
        if is_short {
            return [from, to];
        }
        let longer = |by: f64| std::array::from_fn(|e| last[e] + by * (to[e] - last[e]));
        let reach = |end: [f64; D]| {
            let [last, end] = [last, end].map(|place| Some(self.project(page, place)?.at));
            let [last, end] = [last?, end?];
            Some((end[0] - last[0]).hypot(end[1] - last[1]))
        };
        let mut by = 1.0;
        while by < MOST && reach(longer(by)).is_some_and(|reach| reach < HEAD + ROOM) {
            by *= 1.25;
        }
        [from, longer(by)]
    }

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

/// An arrow whose head keeps off the border of the page.
fn off_border(page: Page, [from, to]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    const ROOM: f64 = 6.0;
    let inner = [[ROOM; 2], [page.width - ROOM, page.height - ROOM]];
    clipped([from, to], inner).map_or([from, to], |[_, to]| [from, to])
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::geometry::Aabb;

    const PAGE: Page = Page { width: 800.0, height: 600.0 };

    fn camera<const D: usize>() -> Camera<D> {
        Camera::framing(&Aabb { min: [0.0; D], max: [1.0; D] }, PAGE)
    }

    #[test]
    fn heads_of_rays_keep_off_the_border() {
        let arrow = |ends| camera::<2>().ray_arrow(PAGE, ends, None).unwrap().on_page;
        let [_, to] = arrow([[0.5, 0.5], [30.0, 9.0]]);
        assert!((0..2).all(|e| (6.0..=[794.0, 594.0][e]).contains(&to[e])), "{to:?}");
        // One that ends before the border is drawn as far as that.
        let [from, to] = [[0.5, 0.5], [0.75, 0.25]].map(|p| camera().project(PAGE, p).unwrap().at);
        assert_eq!(arrow([[0.5, 0.5], [0.75, 0.25]]), [from, to]);
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

    #[track_caller]
    fn check_head<const D: usize>(camera: Camera<D>, ends: [[f64; D]; 2]) {
        let arrow = camera.ray_arrow(PAGE, ends, None).unwrap();
        let head = arrow.on_page[1];
        assert!((0.0..=800.0).contains(&head[0]) && (0.0..=600.0).contains(&head[1]));
        let point = camera.point_at(PAGE, arrow.ends, head);
        let seen = camera.project(PAGE, point).unwrap().at;
        assert!((0..2).all(|e| (seen[e] - head[e]).abs() < 1e-6), "{seen:?} {head:?}");
        // It lies on the ray.
        let along = |e: usize| (point[e] - ends[0][e]) / (ends[1][e] - ends[0][e]);
        assert!((1..D).all(|e| (along(e) - along(0)).abs() < 1e-9), "{point:?}");
    }

    #[test]
    fn the_head_is_a_point_of_the_ray_also_where_that_leads_off_the_page() {
        for far in [0.2, 1.5, 40.0] {
            check_head(camera(), [[0.25, 0.25], [0.25 + far, 0.25 - 0.6 * far]]);
            check_head(camera(), [[0.25; 3], [0.25 - far, 0.25 + 0.3 * far, 0.25 + 0.6 * far]]);
            let parallel = Camera { lens: crate::Lens::Orthographic, ..camera() };
            check_head(parallel, [[0.25; 3], [0.25 + far, 0.25 - far, 0.25 + 0.1 * far]]);
        }
    }

    #[test]
    fn a_ray_beside_the_page_has_no_handle() {
        assert_eq!(camera().tip_handle(PAGE, [[5.0, 5.0], [5.0, 6.0]]), None);
    }
}
