//! From the world to a page and back, for quadtrees and octrees alike.

mod gestures;

use octoscope_core::geometry::Aabb;
use serde::{Deserialize, Serialize};

/// Extent of a page or a view, in its own units (points, logical pixels);
/// x to the right, y down, (0, 0) in the upper left corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Page {
    /// Width, above 0.
    pub width: f64,
    /// Height, above 0.
    pub height: f64,
}

/// Where the world is looked at from. In 2-D the page is parallel to the world
/// and `yaw`, `pitch` and `lens` mean nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera<const D: usize> {
    /// World point in the middle of the page.
    pub target: [f64; D],
    /// World length that the height of the page shows, at the target.
    pub height: f64,
    /// Turn of the eye about the z axis, in radians; 0 looks from +x, π/2 from +y.
    pub yaw: f64,
    /// Height of the eye above the xy plane, in radians, −π/2 … π/2.
    pub pitch: f64,
    /// How depth looks.
    pub lens: Lens,
}

/// How depth looks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Lens {
    /// Far things are smaller.
    #[default]
    Perspective,
    /// Parallel lines stay parallel.
    Orthographic,
}

impl Lens {
    /// All lenses.
    pub const ALL: [Self; 2] = [Self::Perspective, Self::Orthographic];
}

/// A world point on the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projected {
    /// Position on the page.
    pub at: [f64; 2],
    /// Distance from the eye along its line of sight, in world units; in
    /// orthographic views from the plane of the target.
    pub depth: f64,
}

/// Factor by which a page is larger than what is framed on it.
pub(crate) const MARGIN: f64 = 1.12;
/// Half of the perspective's vertical angle of view, as a tangent.
const HALF_ANGLE: f64 = 0.27;
/// Nearest and farthest distance that is seen, as shares of the target's.
const NEAR: f64 = 1.0 / 64.0;
const FAR: f64 = 1024.0;
/// Depth that an orthographic view shows before and behind the target, in heights.
const SLAB: f64 = 256.0;

impl<const D: usize> Camera<D> {
    /// Camera that shows the whole of `bounds` on `page` with a margin, from
    /// the usual side: x to the right, y to the back, z up.
    pub fn framing(bounds: &Aabb<D>, page: Page) -> Self {
        let (yaw, pitch) = (-62f64.to_radians(), 24f64.to_radians());
        let mut camera =
            Self { target: bounds.centre(), height: 1.0, yaw, pitch, lens: Lens::default() };
        camera.frame(bounds, page);
        camera
    }

    /// Moves to where all of `bounds` is seen on `page`, with a margin.
    pub fn frame(&mut self, bounds: &Aabb<D>, page: Page) {
        self.target = bounds.centre();
        let size = bounds.size().into_iter().fold(f64::MIN_POSITIVE, f64::max);
        self.height = if D == 2 {
            let [width, height] = [bounds.size()[0], bounds.size()[1]];
            // Room for what is written beside the axes, which is not scaled.
            const ROOM: f64 = 28.0;
            let margin = |side: f64| MARGIN.max(side / (side - 2.0 * ROOM).max(0.5 * side));
            let by_width = width * page.height / page.width * margin(page.width);
            (height * margin(page.height)).max(by_width).max(size * 1e-9)
        } else {
            // A first guess, made exact by what it shows.
            let mut height = 2.0 * size;
            for _ in 0..8 {
                let trial = Self { height, ..*self };
                let reach = corners(bounds).filter_map(|c| trial.project(page, c)).map(|p| {
                    let across = (2.0 * p.at[0] / page.width - 1.0).abs();
                    let along = (2.0 * p.at[1] / page.height - 1.0).abs();
                    across.max(along)
                });
                height *= reach.fold(0.0, f64::max) * MARGIN;
            }
            height
        };
    }

    /// Where a world point lies on the page; `None` if it is not before the eye.
    pub fn project(&self, page: Page, world: [f64; D]) -> Option<Projected> {
        let [x, y, w] = self.eye(world);
        let scale = self.scale(page);
        let (shrink, depth) = match self.effective_lens() {
            Lens::Orthographic => (1.0, w - self.distance()),
            Lens::Perspective => (self.distance() / w, w),
        };
        let before = self.effective_lens() == Lens::Orthographic || w > NEAR * self.distance();
        let at = [0.5 * page.width + scale * shrink * x, 0.5 * page.height - scale * shrink * y];
        before.then_some(Projected { at, depth })
    }

    /// Both ends of a world segment on the page, cut where it passes the eye;
    /// `None` if no part of it lies before the eye.
    pub fn project_segment(&self, page: Page, ends: [[f64; D]; 2]) -> Option<[Projected; 2]> {
        let ends = self.within_reach(ends);
        if let [Some(a), Some(b)] = ends.map(|end| self.project(page, end)) {
            return Some([a, b]);
        }
        // Only a perspective leaves points out.
        let border = NEAR * self.distance() * (1.0 + 1e-9);
        let [w0, w1] = ends.map(|end| self.eye(end)[2]);
        let t = (border - w0) / (w1 - w0);
        let cut: [f64; D] = std::array::from_fn(|e| ends[0][e] + t * (ends[1][e] - ends[0][e]));
        match [w0 > border, w1 > border] {
            [true, _] => Some([self.project(page, ends[0])?, self.project(page, cut)?]),
            [_, true] => Some([self.project(page, cut)?, self.project(page, ends[1])?]),
            [false, false] => None,
        }
    }

    /// The segment with its second end moved along it so near that its place on
    /// the page is a number.
    fn within_reach(&self, [from, to]: [[f64; D]; 2]) -> [[f64; D]; 2] {
        const REACH: f64 = 1e9;
        let largest = (0..D).map(|e| (to[e] - from[e]).abs()).fold(0.0, f64::max);
        // The ends of usual segments stay as they are.
        if largest < f64::MAX / REACH || largest.is_infinite() {
            return [from, to];
        }
        let share = REACH * self.height / largest;
        [from, std::array::from_fn(|e| from[e] + share * (to[e] - from[e]))]
    }

    /// The part of a world segment that is seen on the page, if any.
    pub fn visible_segment(&self, page: Page, ends: [[f64; D]; 2]) -> Option<[[f64; 2]; 2]> {
        let line = self.project_segment(page, ends)?.map(|end| end.at);
        clipped(line, [[0.0; 2], [page.width, page.height]])
    }

    /// World point under `at` on the page, in the plane through `through` that
    /// is parallel to the page; in 2-D simply the point. For dragging.
    pub fn unproject(&self, page: Page, at: [f64; 2], through: [f64; D]) -> [f64; D] {
        let [_, _, w] = self.eye(through);
        let shrink = match self.effective_lens() {
            Lens::Orthographic => 1.0,
            Lens::Perspective => self.distance() / w,
        };
        let scale = self.scale(page) * shrink;
        let [x, y] = [(at[0] - 0.5 * page.width) / scale, (0.5 * page.height - at[1]) / scale];
        let [right, up, back] = self.basis();
        let z = self.distance() - w;
        std::array::from_fn(|e| self.target[e] + x * right[e] + y * up[e] + z * back[e])
    }

    /// World units of the page per page unit, at the target.
    pub fn unit(&self, page: Page) -> f64 {
        self.height / page.height
    }

    /// Matrix from world to clip space: columns, z from 0 at the nearest to 1
    /// at the farthest, y up. Agrees with [`Camera::project`].
    pub fn clip_from_world(&self, page: Page) -> [[f32; 4]; 4] {
        self.clip_from_offset(page, [0.0; D])
    }

    /// The same for positions relative to `origin`, so that they can be small
    /// single-precision numbers wherever the scene lies.
    pub fn clip_from_offset(&self, page: Page, origin: [f64; D]) -> [[f32; 4]; 4] {
        let basis = self.basis();
        let distance = self.distance();
        let half = [0.5 * self.height * page.width / page.height, 0.5 * self.height];
        // Rows of the affine map to x, y and the distance w before the eye.
        let to_target: [f64; D] = std::array::from_fn(|e| origin[e] - self.target[e]);
        let row = |axis: usize, sign: f64, shift: f64| -> [f64; 4] {
            let mut row: [f64; 4] =
                std::array::from_fn(|e| if e < D { sign * basis[axis][e] } else { 0.0 });
            row[3] = shift + sign * dot(basis[axis], to_target);
            row
        };
        let (x, y, w) = (row(0, 1.0, 0.0), row(1, 1.0, 0.0), row(2, -1.0, distance));
        const LAST: [f64; 4] = [0.0, 0.0, 0.0, 1.0];
        let rows = match self.effective_lens() {
            Lens::Perspective => {
                let (near, far) = (NEAR * distance, FAR * distance);
                let slope = far / (far - near);
                let z = std::array::from_fn(|i| slope * (w[i] - near * LAST[i]));
                [x.map(|v| v * distance / half[0]), y.map(|v| v * distance / half[1]), z, w]
            }
            Lens::Orthographic => {
                let reach = SLAB * self.height;
                let z =
                    std::array::from_fn(|i| (w[i] + (reach - distance) * LAST[i]) / (2.0 * reach));
                [x.map(|v| v / half[0]), y.map(|v| v / half[1]), z, LAST]
            }
        };
        std::array::from_fn(|column| std::array::from_fn(|r| rows[r][column] as f32))
    }

    /// Unit vectors in the world that point to the right and up on the page,
    /// and from the target to the eye (zero in 2-D).
    pub fn basis(&self) -> [[f64; D]; 3] {
        let [(sy, cy), (sp, cp)] = [self.yaw.sin_cos(), self.pitch.sin_cos()];
        let space = [[-sy, cy, 0.0], [-sp * cy, -sp * sy, cp], [cp * cy, cp * sy, sp]];
        let plane = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0; 3]];
        let basis = if D == 2 { plane } else { space };
        basis.map(|v| std::array::from_fn(|e| v[e]))
    }

    /// Vector from a world point towards the eye; its length means nothing.
    pub(crate) fn towards_eye(&self, world: [f64; D]) -> [f64; D] {
        let [_, _, back] = self.basis();
        match self.effective_lens() {
            Lens::Orthographic => back,
            Lens::Perspective => {
                std::array::from_fn(|e| self.target[e] + self.distance() * back[e] - world[e])
            }
        }
    }

    /// How far a world point lies before the eye.
    pub(crate) fn depth(&self, world: [f64; D]) -> f64 {
        self.eye(world)[2]
    }

    /// Coordinates to the right and up from the target, and before the eye.
    fn eye(&self, world: [f64; D]) -> [f64; 3] {
        let offset = std::array::from_fn(|e| world[e] - self.target[e]);
        let [right, up, back] = self.basis();
        [dot(right, offset), dot(up, offset), self.distance() - dot(back, offset)]
    }

    /// Page units per world unit, at the target.
    fn scale(&self, page: Page) -> f64 {
        page.height / self.height
    }

    /// From the eye to the target, in world units.
    fn distance(&self) -> f64 {
        0.5 * self.height / HALF_ANGLE
    }

    fn effective_lens(&self) -> Lens {
        if D == 2 { Lens::Orthographic } else { self.lens }
    }
}

/// The corners of a box, in the order of the child indices.
pub fn corners<const D: usize>(bounds: &Aabb<D>) -> impl Iterator<Item = [f64; D]> {
    let bounds = *bounds;
    (0..1usize << D).map(move |corner| {
        std::array::from_fn(|e| {
            if corner >> (D - 1 - e) & 1 == 1 { bounds.max[e] } else { bounds.min[e] }
        })
    })
}

/// The part of a segment on the page that lies in a rectangle from `min` to
/// `max`; finite ends, however far away.
pub(crate) fn clipped(
    [from, to]: [[f64; 2]; 2],
    [min, max]: [[f64; 2]; 2],
) -> Option<[[f64; 2]; 2]> {
    let (mut enter, mut exit) = (0f64, 1f64);
    for e in 0..2 {
        let along = to[e] - from[e];
        let ends = [min[e], max[e]].map(|border| (border - from[e]) / along);
        if along != 0.0 {
            enter = enter.max(ends[0].min(ends[1]));
            exit = exit.min(ends[0].max(ends[1]));
        } else if !(min[e]..=max[e]).contains(&from[e]) {
            return None;
        }
    }
    let at = |t: f64| std::array::from_fn(|e| from[e] + t * (to[e] - from[e]));
    (enter <= exit).then(|| [at(enter), at(exit)])
}

fn dot<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    (0..D).map(|e| a[e] * b[e]).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::random::Random;

    const PAGE: Page = Page { width: 800.0, height: 600.0 };

    fn cube<const D: usize>() -> Aabb<D> {
        Aabb { min: [-1.0; D], max: [3.0; D] }
    }

    fn check_round_trip<const D: usize>(camera: Camera<D>) {
        let mut random = Random::new(1);
        for _ in 0..100 {
            let world: [f64; D] = std::array::from_fn(|_| random.between(-1.0, 3.0));
            let on_page = camera.project(PAGE, world).unwrap();
            let back = camera.unproject(PAGE, on_page.at, world);
            for e in 0..D {
                assert!((back[e] - world[e]).abs() < 1e-12, "{world:?} {back:?}");
            }
        }
    }

    #[test]
    fn unproject_finds_the_projected_point_again() {
        check_round_trip(Camera::<2>::framing(&cube(), PAGE));
        let camera = Camera::<3>::framing(&cube(), PAGE);
        check_round_trip(camera);
        check_round_trip(Camera { lens: Lens::Orthographic, ..camera });
    }

    fn check_matrix<const D: usize>(camera: Camera<D>) {
        let origin = [0.25; D];
        let matrix = camera.clip_from_offset(PAGE, origin);
        for corner in corners(&cube::<D>()) {
            let on_page = camera.project(PAGE, corner).unwrap();
            let point: [f32; 4] = std::array::from_fn(|e| match e {
                3 => 1.0,
                e if e < D => (corner[e] - origin[e]) as f32,
                _ => 0.0,
            });
            let clip: [f32; 4] =
                std::array::from_fn(|r| (0..4).map(|c| matrix[c][r] * point[c]).sum());
            let [x, y, z] = [clip[0] / clip[3], clip[1] / clip[3], clip[2] / clip[3]];
            assert!((400.0 * (1.0 + f64::from(x)) - on_page.at[0]).abs() < 1e-3);
            assert!((300.0 * (1.0 - f64::from(y)) - on_page.at[1]).abs() < 1e-3);
            assert!((0.0..=1.0).contains(&z));
        }
    }

    #[test]
    fn clip_space_agrees_with_the_page() {
        check_matrix(Camera::<2>::framing(&cube(), PAGE));
        let camera = Camera::<3>::framing(&cube(), PAGE);
        check_matrix(camera);
        check_matrix(Camera { lens: Lens::Orthographic, ..camera });
    }

    #[test]
    fn framing_shows_every_corner() {
        for page in [PAGE, Page { width: 300.0, height: 900.0 }] {
            let camera = Camera::<3>::framing(&cube(), page);
            for corner in corners(&cube::<3>()) {
                let [x, y] = camera.project(page, corner).unwrap().at;
                assert!(x > 0.0 && x < page.width && y > 0.0 && y < page.height);
            }
        }
    }

    #[test]
    fn a_line_of_sight_passes_through_what_is_seen_there() {
        let camera = Camera::<3>::framing(&cube(), PAGE);
        for lens in [Lens::Perspective, Lens::Orthographic] {
            let camera = Camera { lens, ..camera };
            let world = [0.5, -0.5, 2.0];
            let sight = camera.sight(PAGE, camera.project(PAGE, world).unwrap().at).unwrap();
            let (o, d) = (sight.origin(), sight.direction());
            let t = (0..3).map(|e| (world[e] - o[e]) * d[e]).sum::<f64>() / dot(d, d);
            assert!((0..3).all(|e| (sight.at(t)[e] - world[e]).abs() < 1e-12) && t > 0.0);
        }
    }

    #[test]
    fn a_segment_past_the_eye_is_cut() {
        let camera = Camera::<3>::framing(&cube(), PAGE);
        let [_, _, back] = camera.basis();
        let behind = std::array::from_fn(|e| camera.target[e] + 100.0 * back[e] + 0.1);
        assert_eq!(camera.project(PAGE, behind), None);
        assert!(camera.project_segment(PAGE, [camera.target, behind]).is_some());
        assert!(camera.project_segment(PAGE, [behind, behind]).is_none());
    }

    #[test]
    fn zooming_keeps_what_is_under_the_pointer() {
        let mut camera = Camera::<2>::framing(&cube(), PAGE);
        let before = camera.unproject(PAGE, [100.0, 50.0], [0.0; 2]);
        camera.zoom(PAGE, [100.0, 50.0], 3.0);
        let after = camera.unproject(PAGE, [100.0, 50.0], [0.0; 2]);
        assert!((0..2).all(|e| (before[e] - after[e]).abs() < 1e-12));
    }
}
