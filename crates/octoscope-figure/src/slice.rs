//! A plane that cuts the tree open, so that one sees into it.

use crate::{Camera, Mark, Role, Shape};
use octoscope_core::geometry::Aabb;
use octoscope_core::tree::{Domain, Node, Tree};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

/// A plane across an axis. What lies on the side of the eye is not drawn.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Slice {
    /// The axis, 0 = x.
    #[serde(deserialize_with = "an_axis")]
    pub axis: u8,
    /// Where the plane lies, as a share of the root's side.
    #[serde(deserialize_with = "a_share")]
    pub at: f64,
}

/// A slice of one tree, seen from one side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// The axis across which the plane lies.
    pub axis: usize,
    /// Where on it, in world units.
    pub at: f64,
    /// Whether what lies below is drawn, or what lies above.
    pub keeps_lower: bool,
}

/// An axis of space.
fn an_axis<'de, S: Deserializer<'de>>(from: S) -> Result<u8, S::Error> {
    let axis = u8::deserialize(from)?;
    if axis < 3 { Ok(axis) } else { Err(S::Error::custom(format!("{axis} is no axis: 0 to 2"))) }
}

/// A number from 0 to 1.
fn a_share<'de, S: Deserializer<'de>>(from: S) -> Result<f64, S::Error> {
    let share = f64::deserialize(from)?;
    let is_share = (0.0..=1.0).contains(&share);
    if is_share { Ok(share) } else { Err(S::Error::custom(format!("{share} is not in 0 to 1"))) }
}

impl Slice {
    /// The middle of the tree across the y axis, which faces the usual eye.
    pub const MIDDLE: Self = Self { axis: 1, at: 0.5 };

    /// The cut in a tree over `domain` as `camera` sees it; none in the plane.
    pub fn cut<const D: usize>(&self, domain: &Domain<D>, camera: &Camera<D>) -> Option<Cut> {
        let axis = usize::from(self.axis);
        if D != 3 || axis >= D {
            return None;
        }
        let at = domain.min()[axis] + self.at.clamp(0.0, 1.0) * domain.side();
        let mut middle = domain.root_box().centre();
        middle[axis] = at;
        Some(Cut { axis, at, keeps_lower: camera.towards_eye(middle)[axis] > 0.0 })
    }
}

impl Cut {
    /// The part of a box behind the plane, if any.
    pub fn rest_of<const D: usize>(&self, bounds: &Aabb<D>) -> Option<Aabb<D>> {
        let mut rest = *bounds;
        if self.keeps_lower {
            rest.max[self.axis] = rest.max[self.axis].min(self.at);
        } else {
            rest.min[self.axis] = rest.min[self.axis].max(self.at);
        }
        (rest.min[self.axis] < rest.max[self.axis]).then_some(rest)
    }

    /// Whether a point lies behind the plane, or in it.
    pub fn keeps<const D: usize>(&self, point: &[f64; D]) -> bool {
        if self.keeps_lower { point[self.axis] <= self.at } else { point[self.axis] >= self.at }
    }

    /// Where the plane meets a box or its near side.
    pub fn section_of<const D: usize>(&self, bounds: &Aabb<D>) -> Option<Aabb<D>> {
        let rest = self.rest_of(bounds)?;
        let meets = if self.keeps_lower { rest.max } else { rest.min }[self.axis] == self.at;
        let mut section = rest;
        (section.min[self.axis], section.max[self.axis]) = (self.at, self.at);
        meets.then_some(section)
    }

    /// Where the plane lies in the root.
    pub fn outline<const D: usize>(&self, domain: &Domain<D>) -> Option<Mark<D>> {
        Some(Mark::new(Shape::Box(self.section_of(&domain.root_box())?), Role::Root))
    }

    /// The nodes that the plane meets, every parent before its children.
    /// O(nodes that it meets).
    pub fn nodes<'a, const D: usize>(&self, tree: &'a Tree<D>) -> impl Iterator<Item = Node> + 'a {
        let cut = *self;
        let mut waiting = vec![tree.root()];
        std::iter::from_fn(move || {
            let node = waiting.pop()?;
            let meets = |child: &Node| cut.section_of(&tree.node_box(child.id)).is_some();
            waiting.extend(tree.children(node).filter(meets));
            Some(node)
        })
    }

    /// The parts of marks behind the plane.
    pub(crate) fn parts<const D: usize>(&self, mark: Mark<D>) -> Vec<Mark<D>> {
        let with = |shape| Mark { shape, ..mark.clone() };
        match mark.shape {
            Shape::Box(bounds) => {
                self.rest_of(&bounds).map(|rest| with(Shape::Box(rest))).into_iter().collect()
            }
            Shape::Triangle(points) => {
                let polygon = self.polygon(&points);
                let Some((&first, others)) = polygon.split_first() else { return Vec::new() };
                let pairs = others.windows(2);
                pairs.map(|pair| with(Shape::Triangle([first, pair[0], pair[1]]))).collect()
            }
            Shape::Point(at) if !self.keeps(&at) => Vec::new(),
            Shape::Sphere { centre, radius } => {
                match ((centre[self.axis] - self.at).abs() < radius, self.keeps(&centre)) {
                    (true, _) => vec![with(Shape::CutSphere { centre, radius, cut: *self })],
                    (false, true) => vec![mark],
                    (false, false) => Vec::new(),
                }
            }
            Shape::Point(_)
            | Shape::CutSphere { .. }
            | Shape::Segment(_)
            | Shape::Arrow(_)
            | Shape::Tip(_)
            | Shape::Plane { .. }
            | Shape::Label(_)
            | Shape::LabelIn { .. }
            | Shape::LabelAlong(_) => vec![mark],
        }
    }

    /// The part of a triangle behind the plane, as a convex polygon.
    fn polygon<const D: usize>(&self, points: &[[f64; D]; 3]) -> Vec<[f64; D]> {
        let mut polygon = Vec::new();
        for (index, from) in points.iter().enumerate() {
            let to = &points[(index + 1) % 3];
            if self.keeps(from) {
                polygon.push(*from);
            }
            if self.keeps(from) != self.keeps(to) {
                let share = (self.at - from[self.axis]) / (to[self.axis] - from[self.axis]);
                let mut at: [f64; D] = std::array::from_fn(|e| from[e] + share * (to[e] - from[e]));
                at[self.axis] = self.at;
                polygon.push(at);
            }
        }
        polygon
    }

    /// Mark of where the plane meets a node.
    pub(crate) fn section<const D: usize>(
        &self,
        tree: &Tree<D>,
        node: Node,
        role: Role,
    ) -> Option<Mark<D>> {
        let bounds = self.section_of(&tree.node_box(node.id))?;
        Some(Mark::new(Shape::Plane { axis: self.axis, bounds }, role).of_node(node.id))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CUT: Cut = Cut { axis: 0, at: 0.5, keeps_lower: true };

    fn cube(x: f64) -> Aabb<3> {
        Aabb { min: [x, 0.0, 0.0], max: [x + 0.5, 0.5, 0.5] }
    }

    #[test]
    fn boxes_end_at_the_plane() {
        assert_eq!(CUT.rest_of(&cube(0.25)).unwrap().max, [0.5, 0.5, 0.5]);
        assert_eq!(CUT.rest_of(&cube(0.5)), None);
        assert_eq!(CUT.rest_of(&cube(-1.0)), Some(cube(-1.0)));
        let upper = Cut { keeps_lower: false, ..CUT };
        assert_eq!(upper.rest_of(&cube(0.25)).unwrap().min, [0.5, 0.0, 0.0]);
        assert_eq!(upper.rest_of(&cube(0.0)), None);
    }

    #[test]
    fn a_plane_between_cells_shows_those_behind_it() {
        assert!(CUT.section_of(&cube(0.0)).is_some());
        assert!(CUT.section_of(&cube(0.25)).is_some());
        assert!(CUT.section_of(&cube(0.5)).is_none());
        assert!(CUT.section_of(&cube(-0.5)).is_none());
    }

    #[test]
    fn triangles_keep_the_area_behind_the_plane() {
        let area = |[a, b, c]: [[f64; 3]; 3]| {
            0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs()
        };
        let whole = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let parts = CUT.parts(Mark::new(Shape::Triangle(whole), Role::Solid));
        let areas = parts.iter().map(|part| match part.shape {
            Shape::Triangle(points) => area(points),
            _ => panic!("{part:?}"),
        });
        assert!((areas.sum::<f64>() - 0.375).abs() < 1e-12);
    }

    #[test]
    fn spheres_are_cut_where_the_plane_meets_them_wherever_their_middle_lies() {
        let parts = |x: f64| {
            let shape = Shape::Sphere { centre: [x, 0.0, 0.0], radius: 0.25 };
            CUT.parts(Mark::new(shape, Role::Solid)).into_iter().map(|mark| mark.shape).next()
        };
        assert!(matches!(parts(0.0), Some(Shape::Sphere { .. })));
        for x in [0.3, 0.5, 0.7] {
            assert!(matches!(parts(x), Some(Shape::CutSphere { .. })), "{x}");
        }
        assert_eq!(parts(0.8), None);
    }

    #[test]
    fn the_part_before_the_eye_is_taken_away() {
        let domain = Domain::<3>::unit(3);
        let page = crate::Page { width: 100.0, height: 100.0 };
        let camera = Camera::framing(&domain.root_box(), page);
        let lower = |axis| Slice { axis, at: 0.5 }.cut(&domain, &camera).unwrap().keeps_lower;
        // The usual eye looks from the right, the front and above.
        assert_eq!([0, 1, 2].map(lower), [true, false, true]);
        let plane = Domain::<2>::unit(3);
        let camera = Camera::framing(&plane.root_box(), page);
        assert_eq!(Slice::MIDDLE.cut(&plane, &camera), None);
    }
}
