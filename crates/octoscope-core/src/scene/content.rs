//! Points, cells, pictures and solids.

use super::{Cube, fit_domain};
use crate::geometry::Aabb;
use crate::tree::Code;

/// What a tree is built from; coordinates in world units.
#[derive(Clone, Debug, PartialEq)]
pub enum Content<const D: usize> {
    /// Points, kept in buckets.
    Points(Vec<[f64; D]>),
    /// Occupied cells of level 0, by their codes.
    Cells(Vec<Code<D>>),
    /// A picture; only in the plane.
    Image(Image),
    /// Circles or spheres.
    Spheres(Vec<Sphere<D>>),
    /// Axis-parallel boxes.
    Boxes(Vec<Aabb<D>>),
    /// Triangles by their corners; in the plane they are areas.
    Triangles(Vec<[[f64; D]; 3]>),
}

/// Picture of 8-bit colours.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Image {
    /// Pixels per row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Red, green and blue, row after row from the left; row 0 is on top, at
    /// the largest y. `width · height` of them.
    pub pixels: Vec<[u8; 3]>,
}

/// Circle (D = 2) or sphere (D = 3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<const D: usize> {
    /// Middle, in world units.
    pub centre: [f64; D],
    /// Radius, in world units, not negative.
    pub radius: f64,
}

impl Image {
    /// Colour of the pixel in `column`, counted from the left, of `row`,
    /// counted from the bottom of the picture.
    ///
    /// # Panics
    /// Panics outside the picture.
    #[inline]
    pub fn pixel_from_below(&self, column: u32, row: u32) -> [u8; 3] {
        let row_from_top = (self.height - 1 - row) as usize;
        self.pixels[row_from_top * self.width as usize + column as usize]
    }

    /// Smallest k for which the picture fits into 2^k × 2^k pixels.
    pub fn grid_level(&self) -> u8 {
        let longest = self.width.max(self.height).max(1);
        (u32::BITS - (longest - 1).leading_zeros()) as u8
    }
}

impl<const D: usize> Content<D> {
    /// Number of points, cells, pixels or primitives.
    pub fn len(&self) -> usize {
        match self {
            Self::Points(points) => points.len(),
            Self::Cells(cells) => cells.len(),
            Self::Image(image) => image.pixels.len(),
            Self::Spheres(spheres) => spheres.len(),
            Self::Boxes(boxes) => boxes.len(),
            Self::Triangles(triangles) => triangles.len(),
        }
    }

    /// Whether there is nothing to build from.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Smallest box around everything, in world units. `None` when there is
    /// nothing, and for cells and pictures, which have no place of their own:
    /// they lie on the grid of whatever domain they are built in.
    pub fn bounds(&self) -> Option<Aabb<D>> {
        match self {
            Self::Points(points) => Aabb::around(points.iter().copied()),
            Self::Cells(_) | Self::Image(_) => None,
            Self::Spheres(spheres) => {
                let corner = |s: &Sphere<D>, sign: f64| s.centre.map(|c| c + sign * s.radius);
                Aabb::around(spheres.iter().flat_map(|s| [corner(s, -1.0), corner(s, 1.0)]))
            }
            Self::Boxes(boxes) => Aabb::around(boxes.iter().flat_map(|b| [b.min, b.max])),
            Self::Triangles(triangles) => Aabb::around(triangles.iter().flatten().copied()),
        }
    }

    /// A domain that suits the content: the cube of [`fit_domain`] around its
    /// bounds; for a picture 2^k with a side of 1 for each pixel; for cells,
    /// and when there is nothing, the unit cube.
    pub fn fit(&self) -> Cube<D> {
        match self {
            Self::Image(image) => {
                Cube { min: [0.0; D], side: f64::from(image.grid_level()).exp2() }
            }
            Self::Points(_)
            | Self::Cells(_)
            | Self::Spheres(_)
            | Self::Boxes(_)
            | Self::Triangles(_) => self.bounds().map_or(Cube::UNIT, |b| fit_domain(&b)),
        }
    }

    /// Number of the first item with a coordinate that is not finite or, of a
    /// sphere, with a negative radius.
    pub fn first_unusable(&self) -> Option<usize> {
        let bad = |p: &[f64; D]| !p.iter().all(|x| x.is_finite());
        match self {
            Self::Points(points) => points.iter().position(bad),
            Self::Cells(_) | Self::Image(_) => None,
            Self::Spheres(spheres) => spheres
                .iter()
                .position(|s| bad(&s.centre) || !(s.radius.is_finite() && s.radius >= 0.0)),
            Self::Boxes(boxes) => boxes
                .iter()
                .position(|b| bad(&b.min) || bad(&b.max) || (0..D).any(|e| b.min[e] > b.max[e])),
            Self::Triangles(triangles) => triangles.iter().position(|t| t.iter().any(bad)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_fits_into_the_next_power_of_two() {
        for (width, height, level) in [(1, 1, 0), (2, 1, 1), (3, 2, 2), (256, 3, 8), (5, 257, 9)] {
            let image = Image { width, height, pixels: Vec::new() };
            assert_eq!(image.grid_level(), level, "{width} × {height}");
        }
    }

    #[test]
    fn a_sphere_with_a_negative_radius_is_unusable() {
        let spheres = [1.0, -1.0].map(|radius| Sphere { centre: [0.0, 0.0], radius });
        assert_eq!(Content::Spheres(spheres.to_vec()).first_unusable(), Some(1));
    }
}
