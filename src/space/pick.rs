//! The leaf under the pointer, and its side.

use super::gesture::SIDE_REACH;
use crate::widgets::PageInWindow;
use eframe::egui::Pos2;
use octoscope_core::geometry::Ray;
use octoscope_core::locate::{Direction, locate_by_codes};
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::trace::record;
use octoscope_core::traverse::{Algorithm, Options, StopAt};
use octoscope_core::tree::{NodeId, Tree};
use octoscope_figure::Camera;

/// Leaf under the pointer with a point of it: in the plane the one that owns
/// the point, in space the first full one on the line of sight, else the first.
pub(super) fn leaf_at<const D: usize>(
    frame: PageInWindow,
    camera: &Camera<D>,
    tree: &Tree<D>,
    at: Pos2,
) -> Option<(NodeId, [f64; D])> {
    if D == 2 {
        let point = frame.world(camera, at, camera.target);
        let leaf = locate_by_codes(tree, point, &mut ()).node?;
        return Some((leaf, point));
    }
    let sight = line_of_sight(frame, camera, at)?;
    let query = Query::Ray {
        algorithm: Algorithm::Parametric,
        options: Options { stop_at: StopAt::FirstFull, ..Options::default() },
        arithmetic: Arithmetic::Doubles,
    };
    let leaves: Vec<_> = record(tree, &sight, &query).leaves().collect();
    let full = leaves.last().filter(|(leaf, _)| tree.node(*leaf).is_full());
    let (leaf, [enter, exit]) = full.or_else(|| leaves.first())?;
    Some((*leaf, sight.at(0.5 * (enter + exit))))
}

/// Ray from the eye through a place in the window.
fn line_of_sight<const D: usize>(
    frame: PageInWindow,
    camera: &Camera<D>,
    at: Pos2,
) -> Option<Ray<D>> {
    camera.sight(frame.page, frame.on_page(at))
}

/// Leaf and outward direction of the side that the pointer is near.
pub(super) fn side_at<const D: usize>(
    frame: PageInWindow,
    camera: &Camera<D>,
    tree: &Tree<D>,
    at: Pos2,
) -> Option<(NodeId, Direction<D>)> {
    let (leaf, point) = leaf_at(frame, camera, tree, at)?;
    let bounds = tree.node_box(leaf);
    if D == 2 {
        // Small cells keep a middle that is near none of their sides.
        let reach = (camera.unit(frame.page) * f64::from(SIDE_REACH)).min(0.25 * bounds.size()[0]);
        let distances = (0..D).flat_map(|e| {
            [(e, -1i8, point[e] - bounds.min[e]), (e, 1i8, bounds.max[e] - point[e])]
        });
        let (axis, sign, distance) = distances.min_by(|a, b| a.2.total_cmp(&b.2))?;
        let towards = Direction::new(std::array::from_fn(|e| if e == axis { sign } else { 0 }));
        return towards.ok().filter(|_| distance < reach).map(|direction| (leaf, direction));
    }
    // In space the face through which the line of sight enters the leaf.
    let sight = line_of_sight(frame, camera, at)?;
    let (origin, along) = (sight.origin(), sight.direction());
    let entries = (0..D).filter(|&e| along[e] != 0.0).map(|e| {
        let near = if along[e] > 0.0 { bounds.min[e] } else { bounds.max[e] };
        (e, (near - origin[e]) / along[e])
    });
    let (axis, _) = entries.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let sign = if along[axis] > 0.0 { -1 } else { 1 };
    let towards = Direction::new(std::array::from_fn(|e| if e == axis { sign } else { 0 }));
    towards.ok().map(|direction| (leaf, direction))
}
