//! From where a picture is seen.

use glam::{Mat4, Vec3, Vec4};

/// View of a picture, in space or in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum View {
    /// Clip space of wgpu (y up, z from 0 near to 1 far) from world units;
    /// perspective or parallel.
    Space(Mat4),
    /// A piece of the plane, y up.
    Plane(Plane),
}

/// Place and scale of a view of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// World point in the middle of the picture.
    pub centre: [f64; 2],
    /// Points of the interface per world unit, above 0.
    pub scale: f64,
}

/// Homogeneous position of the eye in the world: w = 0 and the direction
/// towards it for a parallel projection, w > 0 otherwise.
pub(super) fn eye(clip_from_world: Mat4) -> Vec4 {
    // The eye is what the projection sends to (0, 0, z, 0).
    let eye = clip_from_world.inverse() * Vec4::new(0.0, 0.0, -1.0, 0.0);
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
    fn fade_runs_from_the_near_to_the_far_end() {
        let plane = fade(Vec4::new(0.0, 0.0, 10.0, 1.0), Vec3::ZERO, 2.0);
        assert!((plane.dot(Vec4::new(0.0, 0.0, 2.0, 1.0))).abs() < 1e-6);
        assert!((plane.dot(Vec4::new(0.0, 0.0, -2.0, 1.0)) - 1.0).abs() < 1e-6);
    }
}
