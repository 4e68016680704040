//! The figure of the whole tree.

use crate::document::Document;
use octoscope_figure::{Diagram, DiagramLens, DiagramOf, Figure, Page, tree_diagram};

/// Page of figures of which no size is asked for.
const PAGE: Page = Page { width: 960.0, height: 720.0 };

/// Diagram of the tree of `document` after `step` events, on a page that is no wider
/// than what is drawn, nor than `most`; what is off the path is folded.
pub fn whole_tree<const D: usize>(
    document: &Document<D>,
    step: usize,
    most: Option<f64>,
) -> Figure {
    let moment = document.moment(step);
    let of = DiagramOf {
        tree: &document.tree,
        ray: &document.scenario.ray,
        query: &document.scenario.query,
        moment: &moment,
        event: step.checked_sub(1).and_then(|index| document.trace.events.get(index)),
        strayed: document.strayed_nodes(),
    };
    let on = |page| -> Diagram { tree_diagram(&of, &[], None, page, DiagramLens::default()) };
    let most = most.unwrap_or(PAGE.width);
    let width = on(PAGE).natural.width.min(most);
    on(Page { width, ..PAGE }).figure
}
