//! The point and the corners of the region that are asked about, as something to take hold
//! of.

use super::ask::inside_root;
use super::grasp::{Grasp, Grip, nearest};
use crate::short_number::rounded;
use eframe::egui::Pos2;
use octoscope_core::geometry::Aabb;
use octoscope_core::query::Query;

/// What of the question is at a place in the window.
pub(super) fn grip_at<const D: usize>(grasp: &Grasp<'_, D>, at: Pos2) -> Option<Grip<D>> {
    let Grasp { frame, camera, document } = grasp;
    let handles = match document.scenario.query {
        Query::Ray { .. } | Query::Neighbour { .. } => Vec::new(),
        Query::Point { at, .. } => vec![(Grip::Point, at)],
        Query::Region { min, max, .. } => {
            let corner = |upper: usize| {
                std::array::from_fn(|e| if upper >> e & 1 == 1 { max[e] } else { min[e] })
            };
            let corners = (0..1 << D).map(|upper| {
                let [held, opposite] = [corner(upper), corner(!upper)];
                (Grip::Corner { held, opposite }, held)
            });
            corners.collect()
        }
    };
    let placed = handles.into_iter().filter_map(|(grip, place)| {
        let place = frame.place(camera, place)?;
        Some((grip, place))
    });
    nearest(placed, at)
}

/// Moves the point to a place in the window, as far from the eye as it is.
pub(super) fn move_point<const D: usize>(grasp: &mut Grasp<'_, D>, to: Pos2) {
    let Grasp { frame, camera, document } = grasp;
    if let Query::Point { at, .. } = &mut document.scenario.query {
        let resolution = camera.unit(frame.page);
        *at = frame.world(camera, to, *at).map(|x| rounded(x, resolution));
    }
}

/// Moves the corner that was at the first place to one in the window, as far from the eye
/// as that was; the opposite one stays.
pub(super) fn move_corner<const D: usize>(
    grasp: &mut Grasp<'_, D>,
    [held, opposite]: [[f64; D]; 2],
    to: Pos2,
) {
    let Grasp { frame, camera, document } = grasp;
    let corner = frame.world(camera, to, held);
    let corner = inside_root(document.tree.domain(), corner, camera.unit(frame.page));
    let bounds = Aabb::around([opposite, corner]);
    if let (Query::Region { min, max, .. }, Some(bounds)) = (&mut document.scenario.query, bounds) {
        (*min, *max) = (bounds.min, bounds.max);
    }
}
