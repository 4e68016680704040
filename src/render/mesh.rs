//! Triangles as the GPU reads them.

use glam::Vec3;
use std::f32::consts::FRAC_PI_4;

/// Corner of a triangle: position in world units and unit normal.
pub(super) type Corner = [[f32; 3]; 2];

/// Corners of flat triangles; one without an area has the normal 0.
pub(super) fn corners(triangles: &[[[f32; 3]; 3]]) -> Vec<Corner> {
    let mut corners = Vec::with_capacity(triangles.len() * 3);
    for triangle in triangles {
        let [a, b, c] = triangle.map(Vec3::from);
        let normal = (b - a).cross(c - a).normalize_or_zero().to_array();
        corners.extend(triangle.map(|corner| [corner, normal]));
    }
    corners
}

/// The finest sphere has 8 · 4³ triangles.
pub(super) const MOST_ROUNDS: u32 = 3;

/// Number of corners of [`sphere`].
pub(super) const fn sphere_corners(rounds: u32) -> u32 {
    3 * 8 * 4u32.pow(rounds)
}

/// How finely a sphere of a radius in pixels is cut so that its faces lie a quarter of
/// a pixel inside it, or as finely as there is.
pub(super) fn rounds_for(radius: f32) -> u32 {
    // Half the angle of an edge, seen from the middle of the sphere.
    let half = |rounds: u32| FRAC_PI_4 / (1 << rounds) as f32;
    (0..MOST_ROUNDS).find(|&n| radius * (1.0 - half(n).cos()) < 0.25).unwrap_or(MOST_ROUNDS)
}

/// Corners of the triangles of a unit sphere: an octahedron whose faces are cut
/// into four `rounds` times, 8 · 4^rounds triangles.
pub(super) fn sphere(rounds: u32) -> Vec<[f32; 3]> {
    let mut triangles = Vec::new();
    for octant in 0..8u32 {
        let sign = |axis: u32| if octant >> axis & 1 == 1 { -1.0 } else { 1.0 };
        triangles.push([Vec3::X * sign(0), Vec3::Y * sign(1), Vec3::Z * sign(2)]);
    }
    for _ in 0..rounds {
        triangles = triangles.into_iter().flat_map(quarters).collect();
    }
    triangles.into_iter().flatten().map(|corner| corner.to_array()).collect()
}

/// The four triangles between the corners and the middles, all on the sphere.
fn quarters([a, b, c]: [Vec3; 3]) -> [[Vec3; 3]; 4] {
    let middle = |p: Vec3, q: Vec3| (p + q).normalize();
    let [d, e, f] = [middle(a, b), middle(b, c), middle(c, a)];
    [[a, d, f], [d, b, e], [f, e, c], [d, e, f]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_corners_of_the_sphere_lie_on_it() {
        let sphere = sphere(2);
        assert_eq!(sphere.len(), sphere_corners(2) as usize);
        assert!(sphere.iter().all(|&corner| (Vec3::from(corner).length() - 1.0).abs() < 1e-6));
    }

    #[test]
    fn small_spheres_have_few_faces() {
        assert_eq!([0.5, 3.0, 10.0, 50.0].map(rounds_for), [0, 1, 2, MOST_ROUNDS]);
    }

    #[test]
    fn normals_have_unit_length() {
        let triangle = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0]];
        assert_eq!(corners(&[triangle])[0][1], [0.0, 0.0, 1.0]);
    }
}
