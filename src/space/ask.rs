//! What the mouse asks of the tree: a point, a region, a neighbour.

use super::gesture::{Click, Under, under};
use super::grasp::Grasp;
use super::pick::leaf_at;
use crate::document::Document;
use crate::short_number::rounded;
use eframe::egui::Pos2;
use octoscope_core::geometry::Aabb;
use octoscope_core::locate::{Direction, NeighbourMethod, Reach};
use octoscope_core::query::{PointMethod, Query};
use octoscope_core::traverse::Variants;
use octoscope_core::tree::{Domain, NodeId};

/// Asks what a click at `at` asks for.
pub(super) fn click<const D: usize>(grasp: &mut Grasp<'_, D>, at: Pos2) {
    let Some(Under { leaf, click, .. }) = under(grasp, at) else { return };
    match click {
        None => {}
        Some(Click::Point) => ask_point(grasp, at),
        Some(Click::Neighbour(direction)) => {
            let document = &mut *grasp.document;
            let reach = match document.scenario.query {
                Query::Neighbour { reach, .. } => reach,
                Query::Ray { .. } | Query::Point { .. } | Query::Region { .. } => Reach::default(),
            };
            ask_neighbour(document, leaf, direction, reach);
        }
    }
}

fn ask_neighbour<const D: usize>(
    document: &mut Document<D>,
    leaf: NodeId,
    direction: Direction<D>,
    reach: Reach,
) {
    let (level, code) = (document.tree.level(leaf), document.tree.code(leaf));
    let (method, variants) = method_of(&document.scenario.query);
    document.scenario.query = Query::Neighbour { level, code, direction, reach, method, variants };
}

/// How neighbours are looked for already, or by codes and right rules.
fn method_of<const D: usize>(query: &Query<D>) -> (NeighbourMethod, Variants) {
    match *query {
        Query::Neighbour { method, variants, .. } => (method, variants),
        Query::Ray { .. } | Query::Point { .. } | Query::Region { .. } => {
            (NeighbourMethod::default(), Variants::NONE)
        }
    }
}

/// Asks for the leaf that owns the point at a place of the view.
pub(super) fn ask_point<const D: usize>(grasp: &mut Grasp<'_, D>, at: Pos2) {
    let Grasp { frame, camera, document } = grasp;
    let Some((_, point)) = leaf_at(*frame, camera, &document.tree, at) else { return };
    let (method, variants) = match document.scenario.query {
        Query::Point { method, variants, .. } => (method, variants),
        Query::Ray { .. } | Query::Region { .. } | Query::Neighbour { .. } => {
            (PointMethod::default(), Variants::NONE)
        }
    };
    let resolution = camera.unit(frame.page);
    let at = point.map(|x| rounded(x, resolution));
    document.scenario.query = Query::Point { at, method, variants };
}

/// Asks for the smallest node that holds the box between two places of the view.
pub(super) fn ask_region<const D: usize>(grasp: &mut Grasp<'_, D>, from: Pos2, to: Pos2) {
    let Grasp { frame, camera, document } = grasp;
    let corners = if D == 2 {
        Some([from, to].map(|place| frame.world(camera, place, camera.target)))
    } else {
        let picked = [from, to].map(|place| leaf_at(*frame, camera, &document.tree, place));
        if let [Some((_, a)), Some((_, b))] = picked { Some([a, b]) } else { None }
    };
    let Some(corners) = corners else { return };
    let Some(bounds) = Aabb::around(corners) else { return };
    let resolution = camera.unit(frame.page);
    let inside = |corner| inside_root(document.tree.domain(), corner, resolution);
    let variants = match document.scenario.query {
        Query::Region { variants, .. } => variants,
        Query::Ray { .. } | Query::Point { .. } | Query::Neighbour { .. } => Variants::NONE,
    };
    let (min, max) = (inside(bounds.min), inside(bounds.max));
    document.scenario.query = Query::Region { min, max, variants };
}

/// A corner of a region, in numbers of this resolution: what reaches beyond the root is
/// cut there, just inside its upper faces.
pub(super) fn inside_root<const D: usize>(
    domain: &Domain<D>,
    corner: [f64; D],
    resolution: f64,
) -> [f64; D] {
    let (root, smallest) = (domain.root_box(), domain.cell_side(0));
    std::array::from_fn(|e| {
        rounded(corner[e], resolution).clamp(root.min[e], root.max[e] - 0.5 * smallest)
    })
}
