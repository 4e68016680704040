//! What a map is to show.

use crate::short_number::rounded;
use octoscope_core::family::Family;
use octoscope_core::geometry::Ray;
use octoscope_core::query::Query;
use octoscope_core::tree::Tree;
use octoscope_figure::{Camera, Page};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// The rays of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rays<const D: usize> {
    /// A family of the plane or from one point.
    Family(Family<D>),
    /// The lines of sight through a page.
    Picture(Camera<D>, Page),
}

impl<const D: usize> Rays<D> {
    /// The ray at a place (u to the right, v upwards, 0 … 1).
    pub fn ray(&self, [u, v]: [f64; 2]) -> Option<Ray<D>> {
        match self {
            Self::Family(family) => family.ray([u, v]),
            Self::Picture(camera, page) => {
                camera.sight(*page, [u * page.width, (1.0 - v) * page.height])
            }
        }
    }

    /// The place of `ray`, if it is one of them or lies on the line of one.
    pub fn place(&self, ray: &Ray<D>) -> Option<[f64; 2]> {
        let place = match self {
            Self::Family(family) => family.place(ray),
            Self::Picture(camera, page) => {
                let [x, y] = camera.project(*page, ray.at(1.0))?.at;
                let place = [x / page.width, 1.0 - y / page.height];
                if !is_along(ray, &self.ray(place)?) {
                    return None;
                }
                place
            }
        };
        place.iter().all(|share| (0.0..=1.0).contains(share)).then_some(place)
    }

    /// The places of the ends of a segment, as far as it is seen between the sides; `None`
    /// where it is not, and where the places are those of no picture.
    pub fn seen(&self, segment: [[f64; D]; 2]) -> Option<[[f64; 2]; 2]> {
        match self {
            Self::Family(_) => None,
            Self::Picture(camera, page) => {
                let ends = camera.visible_segment(*page, segment)?;
                Some(ends.map(|[x, y]| [x / page.width, 1.0 - y / page.height]))
            }
        }
    }
}

/// Whether both have the same direction, but for the few digits of one that was dragged.
fn is_along<const D: usize>(a: &Ray<D>, b: &Ray<D>) -> bool {
    let dot = |a: [f64; D], b: [f64; D]| (0..D).map(|e| a[e] * b[e]).sum::<f64>();
    let (a, b) = (a.direction(), b.direction());
    dot(a, b) > (1.0 - 1e-5) * (dot(a, a) * dot(b, b)).sqrt()
}

/// What tells rays apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Colouring {
    /// Which leaves they visit, in which order.
    #[default]
    Sequence,
    /// How many leaves they visit.
    Leaves,
    /// How many steps the algorithm makes.
    Steps,
    /// How many comparisons it makes.
    Comparisons,
    /// Whether it visits the leaves that it should.
    Differences,
}

impl Colouring {
    /// All of them, in the order of the choice.
    pub const ALL: [Self; 5] =
        [Self::Sequence, Self::Leaves, Self::Steps, Self::Comparisons, Self::Differences];

    /// Key of its name in the language files.
    pub fn id(self) -> &'static str {
        match self {
            Self::Sequence => "map-sequence",
            Self::Leaves => "map-leaves",
            Self::Steps => "map-steps",
            Self::Comparisons => "map-comparisons",
            Self::Differences => "map-differences",
        }
    }

    /// Whether the kernel for many rays tells it, whatever the algorithm.
    fn is_of_batch(self) -> bool {
        match self {
            Self::Sequence | Self::Leaves => true,
            Self::Steps | Self::Comparisons | Self::Differences => false,
        }
    }
}

/// One map: a value for every ray of a grid of places.
#[derive(Clone, Debug)]
pub struct Asked<const D: usize> {
    /// The tree.
    pub tree: Arc<Tree<D>>,
    /// The rays.
    pub rays: Rays<D>,
    /// What is asked of them.
    pub colouring: Colouring,
    /// The search whose steps are counted and whose leaves are checked.
    pub query: Query<D>,
    /// Columns and rows.
    pub size: [usize; 2],
}

impl<const D: usize> Asked<D> {
    /// The ray in the middle of a cell of the grid; row 0 is on top. Its numbers are as
    /// short as those of a ray that is dragged.
    pub fn ray_of(&self, column: usize, row: usize) -> Option<Ray<D>> {
        let [columns, rows] = self.size.map(|n| n as f64);
        let place = [(column as f64 + 0.5) / columns, 1.0 - (row as f64 + 0.5) / rows];
        let ray = self.rays.ray(place)?;
        let resolution = self.tree.domain().side() / columns.max(rows).max(500.0);
        let short = |p: [f64; D]| p.map(|x| rounded(x, resolution));
        // What is shorter than that stays as it is.
        Ray::new(short(ray.origin()), short(ray.direction())).ok().or(Some(ray))
    }

    /// The same with a `factor` times coarser grid.
    pub fn coarser(&self, factor: usize) -> Self {
        Self { size: self.size.map(|n| n.div_ceil(factor)), ..self.clone() }
    }

    /// Whether both show the same, be it on another grid.
    pub fn shows_the_same(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.tree, &other.tree)
            && self.rays == other.rays
            && self.colouring == other.colouring
            // What the kernel for many rays tells is the same for all of them.
            && (self.colouring.is_of_batch() || self.query == other.query)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::geometry::Aabb;

    #[test]
    fn the_rays_of_a_picture_are_found_where_they_are_seen() {
        let page = Page { width: 320.0, height: 240.0 };
        let camera = Camera::<3>::framing(&Aabb { min: [0.0; 3], max: [1.0; 3] }, page);
        let rays = Rays::Picture(camera, page);
        for place in [[0.5, 0.5], [0.1, 0.8], [0.9, 0.3]] {
            let found = rays.place(&rays.ray(place).unwrap()).unwrap();
            assert!((0..2).all(|e| (found[e] - place[e]).abs() < 1e-9), "{place:?} {found:?}");
        }
        let other = Ray::new([0.2; 3], [1.0, 0.0, 0.0]).unwrap();
        assert_eq!(rays.place(&other), None);
        let seen = rays.seen([other.origin(), other.at(0.5)]).unwrap();
        assert!(seen.iter().flatten().all(|share| (0.0..=1.0).contains(share)), "{seen:?}");
        let [x, y] = camera.project(page, other.origin()).unwrap().at;
        assert_eq!(seen[0], [x / page.width, 1.0 - y / page.height]);
    }
}
