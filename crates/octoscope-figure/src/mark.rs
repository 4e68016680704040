//! Marks: shapes in world space, with a role.

use crate::{Cut, Role};
use octoscope_core::geometry::Aabb;
use octoscope_core::tree::NodeId;

/// A shape to be seen, with its meaning.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark<const D: usize> {
    /// Where it is.
    pub shape: Shape<D>,
    /// What it means.
    pub role: Role,
    /// The node that it stands for.
    pub node: Option<NodeId>,
    /// What is written on it, or is to be read of it.
    pub text: Option<String>,
}

/// A shape in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape<const D: usize> {
    /// A box.
    Box(Aabb<D>),
    /// A straight line between two points.
    Segment([[f64; D]; 2]),
    /// A straight line that points from the first to the second point.
    Arrow([[f64; D]; 2]),
    /// A point.
    Point([f64; D]),
    /// The end of a line between two points, drawn apart from its beginning and
    /// on the page: see [`crate::Camera::tip_handle`].
    Tip([[f64; D]; 2]),
    /// A piece of a plane: a box that is flat across `axis`.
    Plane {
        /// The axis across which it lies.
        axis: usize,
        /// Its extent; `min` and `max` are equal on `axis`.
        bounds: Aabb<D>,
    },
    /// A circle or sphere.
    Sphere {
        /// Its middle.
        centre: [f64; D],
        /// Its radius, in world units.
        radius: f64,
    },
    /// What a plane leaves of a sphere.
    CutSphere {
        /// Middle of the whole sphere.
        centre: [f64; D],
        /// Its radius, in world units.
        radius: f64,
        /// The plane, which meets the sphere.
        cut: Cut,
    },
    /// A triangle.
    Triangle([[f64; D]; 3]),
    /// Text at a point.
    Label([f64; D]),
    /// Text at a point of a box, left out where the box is too small for it.
    LabelIn {
        /// Middle of the text.
        at: [f64; D],
        /// The box.
        bounds: Aabb<D>,
    },
    /// Number beside a line, left out where there is no room. The first of
    /// these marks is number 1, and so on.
    LabelAlong([[f64; D]; 2]),
}

impl<const D: usize> Mark<D> {
    /// Mark without node and text.
    pub fn new(shape: Shape<D>, role: Role) -> Self {
        Self { shape, role, node: None, text: None }
    }

    /// The same, standing for a node.
    pub fn of_node(mut self, node: NodeId) -> Self {
        self.node = Some(node);
        self
    }

    /// The same, with a text.
    pub fn with_text(mut self, text: impl Into<String>) -> Self {
        self.text = Some(text.into());
        self
    }
}
