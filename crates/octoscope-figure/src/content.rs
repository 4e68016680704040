//! Marks of what is in the tree.

use crate::{Cut, Mark, Role, Shape};
use octoscope_core::scene::Content;

/// Marks of points and primitives. O(contents), and the same as long as these
/// are; none of cells and pictures, which are seen in their leaves. Behind a cut, what
/// is left of them.
pub fn content<const D: usize>(content: &Content<D>, cut: Option<&Cut>) -> Vec<Mark<D>> {
    let marks = whole(content);
    match cut {
        Some(cut) => marks.into_iter().flat_map(|mark| cut.parts(mark)).collect(),
        None => marks,
    }
}

fn whole<const D: usize>(content: &Content<D>) -> Vec<Mark<D>> {
    let solid = |shape| Mark::new(shape, Role::Solid);
    match content {
        Content::Points(points) => {
            points.iter().map(|&p| Mark::new(Shape::Point(p), Role::Content)).collect()
        }
        Content::Spheres(spheres) => spheres
            .iter()
            .map(|s| solid(Shape::Sphere { centre: s.centre, radius: s.radius }))
            .collect(),
        Content::Boxes(boxes) => boxes.iter().map(|&b| solid(Shape::Box(b))).collect(),
        Content::Triangles(triangles) => {
            triangles.iter().map(|&t| solid(Shape::Triangle(t))).collect()
        }
        Content::Cells(_) | Content::Image(_) => Vec::new(),
    }
}
