//! Marks of what algorithms have beside a current node: parts that wait, cells
//! of the grid, ways to neighbours, cuts of the ray.

use crate::{Mark, Role, Shape};
use octoscope_core::event::Event;
use octoscope_core::geometry::Ray;
use octoscope_core::trace::Moment;
use octoscope_core::tree::{NodeId, Tree};

/// Marks of the present ways, parts and cells. O(their number).
pub(crate) fn ways<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    moment: &Moment<D>,
    event: Option<&Event<D>>,
) -> Vec<Mark<D>> {
    let mut marks = Vec::new();
    for (part, _) in &moment.pending {
        let bounds = Shape::Box(part.bounds(tree));
        marks.push(Mark::new(bounds, Role::Pending).of_node(part.node));
    }
    if let Some(cell) = moment.grid.and_then(|grid| grid.cell) {
        marks.push(Mark::new(Shape::Box(tree.domain().cell_box(0, cell)), Role::GridCell));
    }
    detour(tree, moment, &mut marks);
    if let Some([from, to]) = moment.pushed {
        marks.push(Mark::new(Shape::Arrow([from, to]), Role::Push));
        marks.push(Mark::new(Shape::Point(to), Role::QueryPoint));
    }
    cuts(ray, moment, event, &mut marks);
    marks
}

/// Arrows from node to node: up to the common ancestor, mirrored down again, and
/// along links.
fn detour<const D: usize>(tree: &Tree<D>, moment: &Moment<D>, marks: &mut Vec<Mark<D>>) {
    let centre = |node: NodeId| tree.node_box(node).centre();
    let mut arrow = |from: NodeId, to: NodeId, role: Role| {
        marks.push(Mark::new(Shape::Arrow([centre(from), centre(to)]), role).of_node(to));
    };
    let detour = &moment.detour;
    let start = moment.leaves.last().map(|leaf| leaf.node).or(moment.start);
    let way_up: Vec<NodeId> = start.into_iter().chain(detour.up.iter().copied()).collect();
    for pair in way_up.windows(2) {
        arrow(pair[0], pair[1], Role::WayUp);
    }
    let top = way_up.last().copied();
    let way_down: Vec<NodeId> = top.into_iter().chain(detour.down.iter().copied()).collect();
    for pair in way_down.windows(2) {
        arrow(pair[0], pair[1], Role::WayDown);
    }
    for &[from, to] in &detour.links {
        arrow(from, to, Role::Link);
    }
}

/// Points on the ray where it crosses the mid planes of the node at work, while
/// they are sorted, classified and flipped.
fn cuts<const D: usize>(
    ray: &Ray<D>,
    moment: &Moment<D>,
    event: Option<&Event<D>>,
    marks: &mut Vec<Mark<D>>,
) {
    let at_work =
        matches!(event, Some(Event::Cuts { .. } | Event::Classify { .. } | Event::Flip { .. }));
    let Some(frame) = moment.frame().filter(|_| at_work) else { return };
    let (Some(mid), Some(cuts)) = (frame.mid, frame.cuts) else { return };
    for axis in cuts.inside.iter() {
        marks.push(Mark::new(Shape::Point(ray.at(mid[axis])), Role::Cut(axis)));
    }
    if let Some(Event::Classify { at, .. }) = event {
        marks.push(Mark::new(Shape::Point(ray.at(*at)), Role::ExitPoint));
    }
}
