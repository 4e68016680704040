//! What the mouse can take hold of.

use crate::document::Document;
use crate::widgets::PageInWindow;
use eframe::egui::Pos2;
use octoscope_core::query::Query;
use octoscope_figure::{Camera, Page, RayArrow, arrow_end, last_point};

/// The picture, and what it is of.
pub(super) struct Grasp<'a, const D: usize> {
    /// Where the picture lies in the window.
    pub frame: PageInWindow,
    /// From where it is seen.
    pub camera: &'a mut Camera<D>,
    /// Whose ray and query it shows.
    pub document: &'a mut Document<D>,
}

/// What is being dragged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Grip<const D: usize> {
    /// The ray's origin.
    Origin,
    /// Its tip.
    Tip,
    /// The head of the arrow of a ray whose direction has this length.
    Head {
        /// Length of the direction.
        length: f64,
    },
    /// The ray as a whole.
    Shaft,
    /// The point that is asked about.
    Point,
    /// A corner of the region that is asked about.
    Corner {
        /// Where it was when it was taken.
        held: [f64; D],
        /// The one that stays.
        opposite: [f64; D],
    },
    /// The picture.
    Camera,
    /// The corner of a new region where its drawing began.
    Region(Pos2),
}

impl<const D: usize> Grip<D> {
    /// Whether it is a part of what is asked, and not the picture with it.
    pub(super) fn is_handle(self) -> bool {
        !matches!(self, Self::Camera | Self::Region(_))
    }
}

/// The nearest of handles, if it is within reach of a place in the window.
pub(super) fn nearest<const D: usize>(
    handles: impl Iterator<Item = (Grip<D>, Pos2)>,
    at: Pos2,
) -> Option<Grip<D>> {
    /// They are easier to hit than they look, in points.
    const REACH: f32 = 14.0;
    let distances = handles.map(|(grip, place)| (grip, place.distance(at)));
    let nearest = distances.min_by(|a, b| a.1.total_cmp(&b.1));
    nearest.filter(|(_, distance)| *distance < REACH).map(|(grip, _)| grip)
}

/// The arrow of the ray, as it is drawn.
pub(super) fn drawn_arrow<const D: usize>(
    document: &Document<D>,
    camera: &Camera<D>,
    page: Page,
) -> Option<RayArrow<D>> {
    let (tree, ray) = (&document.tree, &document.scenario.ray);
    let end = match document.scenario.query {
        Query::Ray { options, .. } => options.end(),
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => None,
    };
    let last = last_point([ray.origin(), ray.at(1.0)], Some(&tree.domain().root_box()));
    camera.ray_arrow(page, [ray.origin(), arrow_end(tree, ray, end)], last)
}
