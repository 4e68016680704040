//! What the mouse can take hold of.

use crate::document::Document;
use crate::widgets::PageInWindow;
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
