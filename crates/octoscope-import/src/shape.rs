//! What meshes and clouds are read into.

use crate::error::ImportError;

/// Most points that are accepted.
pub const MAX_POINTS: usize = 50_000_000;

/// Most triangles that are accepted: they then take 1.2 GB.
pub const MAX_TRIANGLES: usize = 1 << 24;

/// Triangles of a mesh or points of a cloud, in the units of the file.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Triangles, degenerate ones included.
    Triangles(Vec<[[f64; 3]; 3]>),
    /// Points in space.
    Points(Vec<[f64; 3]>),
    /// Points in the plane.
    PlanePoints(Vec<[f64; 2]>),
}

impl Shape {
    /// The triangles if there are any, otherwise the vertices as points.
    ///
    /// # Errors
    /// Refuses nothing at all, and too much.
    pub fn of(triangles: Vec<[[f64; 3]; 3]>, vertices: Vec<[f64; 3]>) -> Result<Self, ImportError> {
        check_points(vertices.len())?;
        match (triangles.is_empty(), vertices.is_empty()) {
            (false, _) => Ok(Self::Triangles(triangles)),
            (true, false) => Ok(Self::Points(vertices)),
            (true, true) => Err(ImportError::NoPoints),
        }
    }
}

/// Adds the polygon with these `corners` to `triangles`, as a fan around its
/// first corner.
///
/// # Errors
/// Refuses more than [`MAX_TRIANGLES`].
pub fn push_fan(
    corners: &[[f64; 3]],
    triangles: &mut Vec<[[f64; 3]; 3]>,
) -> Result<(), ImportError> {
    for pair in corners.windows(2).skip(1) {
        triangles.push([corners[0], pair[0], pair[1]]);
    }
    check_triangles(triangles.len())
}

/// Refuses more than [`MAX_TRIANGLES`].
pub fn check_triangles(count: usize) -> Result<(), ImportError> {
    check("triangles", count, MAX_TRIANGLES)
}

/// Refuses more than [`MAX_POINTS`].
pub fn check_points(count: usize) -> Result<(), ImportError> {
    check("points", count, MAX_POINTS)
}

fn check(what: &'static str, found: usize, limit: usize) -> Result<(), ImportError> {
    if found <= limit {
        return Ok(());
    }
    Err(ImportError::TooLarge { what, found: found as u64, limit: limit as u64 })
}
