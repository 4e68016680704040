//! Marked boxes: few, translucent, drawn in the right order.

use super::camera::{Space, World};
use eframe::egui::Color32;
use glam::{Vec3, Vec4};

/// A box that stands out: current node, ancestor, visited or rejected leaf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxMark {
    /// Minimum corner in world units.
    pub min: World,
    /// Maximum corner in world units.
    pub max: World,
    /// Colour of the faces; transparent for none.
    pub fill: Color32,
    /// Colour of the edges; transparent for none.
    pub edge: Color32,
    /// Width of the edges in points.
    pub width: f32,
    /// How the edges are drawn.
    pub line: Line,
    /// Edges of a higher layer lie above those of lower ones, and above all faces.
    pub layer: usize,
    /// Whether the sides that face the eye are crossed out, by lines as of the edges.
    pub is_crossed: bool,
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// Without gaps.
    Solid,
    /// In dashes of four line widths.
    Dashed,
    /// In dots.
    Dotted,
}

/// Kind of an [`Item`] that is an edge; below: the axis across a face.
const EDGE: u32 = 3;

/// Face or edge of a mark as the GPU reads it.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(super) struct Item {
    pub a: [f32; 3],
    pub b: [f32; 3],
    pub colour: [u8; 4],
    pub kind: u32,
    pub pen: [f32; 3],
}

/// Faces and edges of all marks as offsets, the farthest from the eye first, so that
/// each is blended over what lies behind it. O(n log n).
///
/// Boxes are nested or apart, hence the order of the middles is the order of
/// the faces, and an edge comes after the faces that meet in it. Where two
/// are equally far, later marks cover earlier ones. Edges of layers above 0 come last.
pub(super) fn sorted(marks: &[BoxMark], space: &Space, pixels_per_point: f32) -> Vec<Item> {
    let mut items = Vec::with_capacity(marks.len() * 18);
    for mark in marks {
        add(mark, pixels_per_point, space, &mut items);
    }
    items.sort_by(|((a, far), _), ((b, near), _)| a.cmp(b).then(near.total_cmp(far)));
    items.into_iter().map(|(_, item)| item).collect()
}

fn add(
    mark: &BoxMark,
    pixels_per_point: f32,
    space: &Space,
    items: &mut Vec<((usize, f32), Item)>,
) {
    let eye = space.eye();
    let corners = [mark.min, mark.max].map(|corner| space.offset(corner).to_array());
    let width = mark.width * pixels_per_point;
    let unit = width.max(pixels_per_point);
    let [dash, gap] = match mark.line {
        Line::Solid => [0.0, 0.0],
        Line::Dashed => [4.0 * unit, 3.0 * unit],
        Line::Dotted => [unit, 2.0 * unit],
    };
    let faces_eye = |axis: usize, end: usize| {
        let to_eye = eye[axis] - corners[end][axis] * eye.w;
        if end == 1 { to_eye > 0.0 } else { to_eye < 0.0 }
    };
    // From inside, all sides are seen.
    let is_inside = (0..3).all(|axis| !faces_eye(axis, 0) && !faces_eye(axis, 1));
    for axis in 0..3 {
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        if mark.fill != Color32::TRANSPARENT {
            for side in corners {
                let [mut a, mut b] = corners;
                (a[axis], b[axis]) = (side[axis], side[axis]);
                let colour = mark.fill.to_array();
                let face = Item { a, b, colour, kind: axis as u32, pen: [0.0; 3] };
                items.push(((0, distance(&face, eye)), face));
            }
        }
        if mark.is_crossed && mark.edge != Color32::TRANSPARENT {
            let ends = [0, 1].into_iter().filter(|&end| is_inside || faces_eye(axis, end));
            for side in ends.map(|end: usize| corners[end][axis]) {
                for [from, to] in [[0, 1], [1, 0]] {
                    let [mut a, mut b] = corners;
                    (a[axis], b[axis]) = (side, side);
                    (a[v], b[v]) = (corners[from][v], corners[to][v]);
                    let (colour, pen) = (mark.edge.to_array(), [width, dash, dash + gap]);
                    let line = Item { a, b, colour, kind: EDGE, pen };
                    items.push(((mark.layer, distance(&line, eye)), line));
                }
            }
        }
        if mark.edge != Color32::TRANSPARENT && mark.width > 0.0 {
            for [low, high] in [[0, 0], [0, 1], [1, 0], [1, 1]] {
                let [mut a, mut b] = corners;
                (a[u], b[u]) = (corners[low][u], corners[low][u]);
                (a[v], b[v]) = (corners[high][v], corners[high][v]);
                let (colour, pen) = (mark.edge.to_array(), [width, dash, dash + gap]);
                let edge = Item { a, b, colour, kind: EDGE, pen };
                // After the faces on either side, which are its equals.
                items.push(((mark.layer, distance(&edge, eye)), edge));
            }
        }
    }
}

/// Grows with the distance of an item's middle from the eye.
fn distance(item: &Item, eye: Vec4) -> f32 {
    let middle = 0.5 * (Vec3::from(item.a) + Vec3::from(item.b));
    if eye.w == 0.0 { -eye.truncate().dot(middle) } else { eye.truncate().distance(middle) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::camera::rh::{proj::directx, view};

    fn mark(min: f64, max: f64) -> BoxMark {
        BoxMark {
            min: [min; 3],
            max: [max; 3],
            fill: Color32::RED,
            edge: Color32::BLUE,
            width: 2.0,
            line: Line::Solid,
            layer: 0,
            is_crossed: false,
        }
    }

    /// Seen from (2, 2, 50).
    fn from_above() -> Space {
        let seen = view::look_at_mat4(Vec3::new(2.0, 2.0, 50.0), Vec3::new(2.0, 2.0, 0.0), Vec3::Y);
        let clip_from_offset = directx::perspective(0.8, 1.0, 0.1, 100.0) * seen;
        Space { origin: [0.0; 3], clip_from_offset }
    }

    #[test]
    fn nested_boxes_are_sorted_face_by_face() {
        let outer = mark(0.0, 4.0);
        let inner = mark(1.0, 3.0);
        let items = sorted(&[inner, outer], &from_above(), 1.0);
        let across_z: Vec<_> =
            items.iter().filter(|item| item.kind == 2).map(|item| item.a[2]).collect();
        assert_eq!(across_z, [0.0, 1.0, 3.0, 4.0]);
    }

    #[test]
    fn edges_of_a_higher_layer_come_last_however_far_they_are() {
        let far = BoxMark { layer: 1, edge: Color32::GREEN, ..mark(0.0, 1.0) };
        let items = sorted(&[far, mark(0.0, 4.0)], &from_above(), 1.0);
        let is_last = |item: &Item| item.kind == EDGE && item.colour == far.edge.to_array();
        assert!(items[items.len() - 12..].iter().all(is_last));
    }

    #[test]
    fn a_box_without_fill_has_only_edges() {
        let empty = BoxMark { fill: Color32::TRANSPARENT, ..mark(0.0, 1.0) };
        assert_eq!(sorted(&[empty], &from_above(), 1.0).len(), 12);
    }

    #[test]
    fn what_is_seen_of_a_wrong_box_is_crossed_out_by_two_lines_a_side() {
        let plain = mark(3.0, 4.0);
        let crossed = BoxMark { is_crossed: true, ..plain };
        let [plain, crossed] = [plain, crossed].map(|mark| sorted(&[mark], &from_above(), 1.0));
        // The upper side, and those towards the middle of the picture.
        assert_eq!(crossed.len(), plain.len() + 3 * 2);
        let is_diagonal = |item: &&Item| {
            item.kind == EDGE && (0..3).filter(|&e| item.a[e] != item.b[e]).count() == 2
        };
        assert_eq!(crossed.iter().filter(is_diagonal).count(), 6);
    }
}
