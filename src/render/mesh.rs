//! Triangles as the GPU reads them.

use glam::Vec3;

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_have_unit_length() {
        let triangle = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0]];
        assert_eq!(corners(&[triangle])[0][1], [0.0, 0.0, 1.0]);
    }
}
