//! Surfaces of solids as triangles, with corners on a fine grid.
//!
//! Only sums, products, quotients and square roots are used, which every machine
//! rounds alike: the same numbers give the same triangles everywhere.

/// Three corners, in world units.
type Triangle = [[f64; 3]; 3];

/// 2^-20, the spacing of the grid of corners.
const UNIT: f64 = 1.0 / (1 << 20) as f64;

/// Sphere as an octahedron whose faces are cut in four: 32 triangles.
pub(super) fn sphere(centre: [f64; 3], radius: f64) -> Vec<Triangle> {
    let on_sphere = |way: [f64; 3]| rounded(along(centre, unit(way), radius));
    let mut triangles = Vec::with_capacity(32);
    for octant in 0..8u8 {
        let sign = |bit: u8| if octant >> bit & 1 == 1 { 1.0 } else { -1.0 };
        let [x, y, z] = [[sign(0), 0.0, 0.0], [0.0, sign(1), 0.0], [0.0, 0.0, sign(2)]];
        let [xy, yz, zx] = [sum(x, y), sum(y, z), sum(z, x)];
        for corners in [[x, xy, zx], [y, yz, xy], [z, zx, yz], [xy, yz, zx]] {
            triangles.push(corners.map(on_sphere));
        }
    }
    triangles
}

/// Cylinder around the line between two points, as a prism of twelve sides: 44
/// triangles. The points differ.
pub(super) fn cylinder([from, to]: [[f64; 3]; 2], radius: f64) -> Vec<Triangle> {
    const SIDES: usize = 12;
    let axis = unit(difference(to, from));
    // The axis that is least along the cylinder's own gives the best first spoke.
    let least = (0..3).min_by(|&a, &b| axis[a].abs().total_cmp(&axis[b].abs())).unwrap_or(0);
    let first = unit(cross(axis, std::array::from_fn(|e| if e == least { 1.0 } else { 0.0 })));
    let second = cross(axis, first);
    let half_root = 3.0f64.sqrt() / 2.0;
    let cosines = [1.0, half_root, 0.5, 0.0, -0.5, -half_root, -1.0, -half_root, -0.5, 0.0, 0.5];
    let cosine = |n: usize| cosines.get(n % SIDES).copied().unwrap_or(half_root);
    let spoke = |n: usize| -> [f64; 3] {
        // The sine is the cosine a quarter before.
        let (cos, sin) = (cosine(n), cosine(n + SIDES - 3));
        std::array::from_fn(|e| cos * first[e] + sin * second[e])
    };
    let rim = |end: [f64; 3], n: usize| rounded(along(end, spoke(n), radius));
    let mut triangles = Vec::with_capacity(4 * SIDES - 4);
    for n in 0..SIDES {
        let [a, b, c, d] = [rim(from, n), rim(from, n + 1), rim(to, n), rim(to, n + 1)];
        triangles.extend([[a, b, c], [b, d, c]]);
        if (1..SIDES - 1).contains(&n) {
            triangles.extend([[rim(from, 0), a, b], [rim(to, 0), c, d]]);
        }
    }
    triangles
}

/// Box with sides across the axes: 12 triangles.
pub(super) fn cuboid(min: [f64; 3], max: [f64; 3]) -> Vec<Triangle> {
    let corner = |number: u8| {
        rounded(std::array::from_fn(|e| if number >> e & 1 == 1 { max[e] } else { min[e] }))
    };
    let mut triangles = Vec::with_capacity(12);
    for axis in 0..3 {
        let [u, v] = [1u8 << ((axis + 1) % 3), 1 << ((axis + 2) % 3)];
        for side in [0, 1u8 << axis] {
            let [a, b, c, d] = [side, side | u, side | v, side | u | v].map(corner);
            triangles.extend([[a, b, c], [b, d, c]]);
        }
    }
    triangles
}

/// The nearest point of the grid.
pub(super) fn rounded(point: [f64; 3]) -> [f64; 3] {
    point.map(|x| (x / UNIT).round() * UNIT)
}

fn along(from: [f64; 3], way: [f64; 3], length: f64) -> [f64; 3] {
    std::array::from_fn(|e| from[e] + length * way[e])
}

/// The vector with length 1; it is not 0.
pub(super) fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    v.map(|x| x / length)
}

fn sum(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|e| a[e] + b[e])
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|e| a[e] - b[e])
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    /// Corners by their whole numbers on the grid.
    fn key(corner: [f64; 3]) -> [i64; 3] {
        corner.map(|x| (x / UNIT) as i64)
    }

    /// A surface is closed if each of its edges belongs to two triangles.
    fn check_closed(triangles: &[Triangle], expected: usize) {
        assert_eq!(triangles.len(), expected);
        let mut edges: HashMap<[[i64; 3]; 2], usize> = HashMap::new();
        for t in triangles {
            for (from, to) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                let mut edge = [key(from), key(to)];
                edge.sort_unstable();
                assert_ne!(edge[0], edge[1]);
                *edges.entry(edge).or_default() += 1;
            }
        }
        assert!(edges.values().all(|&n| n == 2), "{edges:?}");
    }

    #[test]
    fn surfaces_are_closed() {
        check_closed(&sphere([0.5; 3], 0.1), 32);
        check_closed(&cylinder([[0.2, 0.3, 0.4], [0.6, 0.35, 0.5]], 0.05), 44);
        check_closed(&cylinder([[0.2, 0.3, 0.4], [0.2, 0.3, 0.9]], 0.05), 44);
        check_closed(&cuboid([0.25; 3], [0.5, 0.625, 0.75]), 12);
    }

    #[test]
    fn corners_lie_on_the_surface() {
        let (centre, radius) = ([0.5, 0.25, 0.75], 0.125);
        for corner in sphere(centre, radius).into_iter().flatten() {
            let d = difference(corner, centre);
            let distance = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
            assert!((distance - radius).abs() < 2.0 * UNIT, "{distance}");
        }
        let ends = [[0.5, 0.5, 0.25], [0.5, 0.5, 0.75]];
        for corner in cylinder(ends, radius).into_iter().flatten() {
            let distance = (corner[0] - 0.5).hypot(corner[1] - 0.5);
            assert!((distance - radius).abs() < 2.0 * UNIT, "{distance}");
            assert!(corner[2] == 0.25 || corner[2] == 0.75);
        }
    }
}
