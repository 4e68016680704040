//! Parts of what is cut in space: pieces of arrows, parts of planes.

use crate::camera::corners;
use crate::space::distance;
use crate::{Camera, Drawn, Form, Page, Part};
use octoscope_core::geometry::Aabb;

/// A part of a plane, which is `whole`, and those of its edges that are edges of
/// the whole.
pub(crate) fn part_of_plane<const D: usize>(
    camera: &Camera<D>,
    page: Page,
    whole: &Drawn,
    bounds: &Aabb<D>,
    part: &Aabb<D>,
) -> Vec<Drawn> {
    let ring = ring(part);
    let on_page: Option<Vec<[f64; 2]>> =
        ring.iter().map(|&corner| camera.project(page, corner).map(|p| p.at)).collect();
    let Some(on_page) = on_page else { return Vec::new() };
    let is_outer = |a: [f64; D], b: [f64; D]| {
        let on = |x: f64, side: f64| (x - side).abs() < 1e-9 * (1.0 + side.abs());
        (0..D).any(|e| {
            bounds.max[e] > bounds.min[e]
                && [bounds.min[e], bounds.max[e]]
                    .iter()
                    .any(|&side| on(a[e], side) && on(b[e], side))
        })
    };
    let of_whole = |part, form| Drawn { form, part, ..whole.clone() };
    let edges = (0..ring.len()).filter_map(|index| {
        let next = (index + 1) % ring.len();
        let line = vec![on_page[index], on_page[next]];
        is_outer(ring[index], ring[next]).then_some(Form::Polyline(line))
    });
    let edges: Vec<Form> = edges.collect();
    let is_fine = whole.part == Part::FineEdge;
    let edge_part = if is_fine { Part::FineEdge } else { Part::Edge };
    let has_casing = !is_fine && whole.role.has_casing();
    let casings = edges.iter().filter(|_| has_casing);
    let casings = casings.map(|edge| of_whole(Part::Casing, edge.clone()));
    let area = of_whole(Part::Face(0), Form::Polygon(on_page.clone()));
    let casings: Vec<Drawn> = casings.collect();
    let edges = edges.into_iter().map(|edge| of_whole(edge_part, edge));
    casings.into_iter().chain([area]).chain(edges).collect()
}

/// The corners of a flat box, in turn; of any other, those of its lower side.
fn ring<const D: usize>(bounds: &Aabb<D>) -> Vec<[f64; D]> {
    let size = bounds.size();
    let axis = (0..D).min_by(|&a, &b| size[a].total_cmp(&size[b])).unwrap_or(0);
    let all: Vec<[f64; D]> = corners(bounds).collect();
    let upper = 1usize << (D - 1 - axis);
    let own: Vec<[f64; D]> =
        (0..1 << D).filter(|corner| corner & upper == 0).map(|corner| all[corner]).collect();
    match own[..] {
        [a, b, c, d] => vec![a, b, d, c],
        _ => own,
    }
}

/// An arrow in space, which is drawn in pieces.
pub(crate) struct Arrow<const D: usize> {
    /// Where it begins and ends.
    pub ends: [[f64; D]; 2],
    /// Where its line begins and ends on the page, before its head.
    pub shaft: [[f64; 2]; 2],
    /// The line, whole.
    pub line: Drawn,
    /// The head.
    pub head: Drawn,
}

impl<const D: usize> Arrow<D> {
    /// Part of the line, and the head if it ends at that; `piece` is that part of
    /// the whole arrow on the page.
    pub fn piece(&self, piece: Option<[[f64; 2]; 2]>) -> Vec<Drawn> {
        // Pieces overlap a little: otherwise light would shine through the seams.
        const OVERLAP: f64 = 0.35;
        let Some(piece) = piece else { return Vec::new() };
        let [start, neck] = self.shaft;
        let length = distance(start, neck);
        let along: [f64; 2] = std::array::from_fn(|e| (neck[e] - start[e]) / length.max(1e-9));
        let place = |p: [f64; 2]| (0..2).map(|e| (p[e] - start[e]) * along[e]).sum::<f64>();
        let [from, to] = piece.map(place);
        let mut drawn = Vec::new();
        let [from, end] = [(from - OVERLAP).max(0.0), (to + OVERLAP).min(length)];
        if from < end {
            let point = |by: f64| std::array::from_fn(|e| start[e] + by * along[e]);
            let form = Form::Polyline(vec![point(from), point(end)]);
            drawn.push(Drawn { form, ..self.line.clone() });
        }
        if to > length {
            drawn.push(self.head.clone());
        }
        drawn
    }
}
