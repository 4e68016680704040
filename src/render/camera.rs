//! From where a picture is seen.

use glam::{Mat4, Vec3, Vec4};

/// A point in world units, z 0 in the plane.
pub(super) type World = [f64; 3];

/// View of a picture, in space or in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum View {
    /// Space, in perspective or parallel.
    Space(Space),
    /// A piece of the plane, y up.
    Plane(Plane),
}

/// A view of space. Positions are taken from its origin, so that they can be
/// single-precision numbers wherever the scene lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Space {
    /// World point near the middle of the picture.
    pub origin: World,
    /// Clip space of wgpu (y up, z from 0 near to 1 far) from world units relative to
    /// the origin.
    pub clip_from_offset: Mat4,
}

impl Space {
    /// A world point relative to the origin.
    pub(super) fn offset(&self, point: World) -> Vec3 {
        Vec3::from(std::array::from_fn(|e| (point[e] - self.origin[e]) as f32))
    }

    /// The plane whose dot product with (x, y, z, 1) is the same, for offsets.
    pub(super) fn plane(&self, [x, y, z, w]: [f64; 4]) -> [f32; 4] {
        let [ox, oy, oz] = self.origin;
        [x, y, z, w + x * ox + y * oy + z * oz].map(|v| v as f32)
    }

    /// The eye, homogeneous, see [`eye`].
    pub(super) fn eye(&self) -> Vec4 {
        eye(self.clip_from_offset)
    }
}

/// Place and scale of a view of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// World point in the middle of the picture.
    pub centre: [f64; 2],
    /// Points of the interface per world unit, above 0.
    pub scale: f64,
}

/// Homogeneous position of the eye where the projection comes from: w = 0 and the direction
/// towards it for a parallel projection, w > 0 otherwise.
fn eye(clip_from_offset: Mat4) -> Vec4 {
    // The eye is what the projection sends to (0, 0, z, 0).
    let eye = clip_from_offset.inverse() * Vec4::new(0.0, 0.0, -1.0, 0.0);
    let parallel = eye.w.abs() < 1e-6 * eye.truncate().length();
    if parallel { eye.truncate().normalize().extend(0.0) } else { eye / eye.w }
}

/// Plane whose dot product with (x, y, z, 1) is 0 where a ball is nearest to
/// the eye and 1 where it is farthest.
pub(super) fn fade(eye: Vec4, centre: Vec3, radius: f32) -> Vec4 {
    let away = -(eye.truncate() - centre * eye.w).normalize_or_zero();
    let slope = away / (2.0 * radius.max(f32::MIN_POSITIVE));
    slope.extend(0.5 - slope.dot(centre))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::camera::rh::{proj::directx, view};

    #[test]
    fn eye_of_a_perspective_is_its_position() {
        let from = Vec3::new(3.0, 2.0, 5.0);
        let seen = view::look_at_mat4(from, Vec3::ZERO, Vec3::Z);
        let found = eye(directx::perspective(0.8, 1.5, 0.1, 100.0) * seen);
        assert!(found.abs_diff_eq(from.extend(1.0), 1e-3), "{found}");
    }

    #[test]
    fn eye_of_a_parallel_projection_is_a_direction() {
        let from = Vec3::new(0.0, -4.0, 3.0);
        let seen = view::look_at_mat4(from, Vec3::ZERO, Vec3::Z);
        let found = eye(directx::orthographic(-1.0, 1.0, -1.0, 1.0, 0.1, 10.0) * seen);
        assert!(found.abs_diff_eq((from / 5.0).extend(0.0), 1e-4), "{found}");
    }

    #[test]
    fn a_plane_is_the_same_for_points_and_offsets() {
        let space = Space { origin: [1e6, -2e6, 0.5], clip_from_offset: Mat4::IDENTITY };
        let plane = [1.0, -2.0, 3.0, -5e6 - 2.5];
        let point = [1e6 + 0.25, -2e6 + 0.5, 0.75];
        let expected = (0..3).map(|e| plane[e] * point[e]).sum::<f64>() + plane[3];
        let found = Vec4::from(space.plane(plane)).dot(space.offset(point).extend(1.0));
        assert_eq!((f64::from(found), expected), (-1.0, -1.0));
    }

    #[test]
    fn fade_runs_from_the_near_to_the_far_end() {
        let plane = fade(Vec4::new(0.0, 0.0, 10.0, 1.0), Vec3::ZERO, 2.0);
        assert!((plane.dot(Vec4::new(0.0, 0.0, 2.0, 1.0))).abs() < 1e-6);
        assert!((plane.dot(Vec4::new(0.0, 0.0, -2.0, 1.0)) - 1.0).abs() < 1e-6);
    }
}
