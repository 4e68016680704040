//! From the bytes of a file to the content of a scene.

use crate::error::ImportError;
use crate::kind::Kind;
use crate::shape::Shape;
use crate::{cloud, obj, picture, ply, stl};
use image::ImageFormat;
use octoscope_core::geometry::Aabb;
use octoscope_core::progress::Progress;
use octoscope_core::scene::{Content, Image};

/// What a file holds, with the box around it.
#[derive(Clone, Debug, PartialEq)]
pub enum Imported {
    /// Material for a quadtree.
    Plane {
        /// A picture or points.
        content: Content<2>,
        /// Smallest box around the points; 0 to width and height in pixels for
        /// a picture.
        bounds: Aabb<2>,
    },
    /// Material for an octree.
    Space {
        /// Triangles or points.
        content: Content<3>,
        /// Smallest box around all of them.
        bounds: Aabb<3>,
    },
}

/// Reads the file `name` that holds `bytes`: PNG, JPEG, OBJ, STL, PLY, XYZ or
/// CSV, told apart by their first bytes and by the ending of the name.
///
/// # Errors
/// Says what is wrong, where, and what would be right.
pub fn import(name: &str, bytes: &[u8], progress: &Progress) -> Result<Imported, ImportError> {
    match Kind::of(name, bytes)? {
        Kind::Png => picture::read(bytes, ImageFormat::Png, progress).map(of_picture),
        Kind::Jpeg => picture::read(bytes, ImageFormat::Jpeg, progress).map(of_picture),
        Kind::Obj => obj::read(bytes, progress).and_then(of_shape),
        Kind::Stl => stl::read(bytes, progress).and_then(of_shape),
        Kind::Ply => ply::read(bytes, progress).and_then(of_shape),
        Kind::Xyz => cloud::read_xyz(bytes, progress).and_then(of_shape),
        Kind::Csv => cloud::read_csv(bytes, progress).and_then(of_shape),
    }
}

fn of_picture(image: Image) -> Imported {
    let max = [f64::from(image.width), f64::from(image.height)];
    Imported::Plane { content: Content::Image(image), bounds: Aabb { min: [0.0; 2], max } }
}

fn of_shape(shape: Shape) -> Result<Imported, ImportError> {
    match shape {
        Shape::Triangles(triangles) => {
            let corners = triangles.as_flattened().iter().copied();
            let bounds = Aabb::around(corners).ok_or(ImportError::NoPoints)?;
            Ok(Imported::Space { content: Content::Triangles(triangles), bounds })
        }
        Shape::Points(points) => {
            let bounds = Aabb::around(points.iter().copied()).ok_or(ImportError::NoPoints)?;
            Ok(Imported::Space { content: Content::Points(points), bounds })
        }
        Shape::PlanePoints(points) => {
            let bounds = Aabb::around(points.iter().copied()).ok_or(ImportError::NoPoints)?;
            Ok(Imported::Plane { content: Content::Points(points), bounds })
        }
    }
}
