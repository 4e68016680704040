//! The figure of the space view.

use crate::document::Document;
use octoscope_core::scene::Content;
use octoscope_core::text::Texts;
use octoscope_figure::{
    Camera, Figure, Mark, Page, Rest, Role, Shape, Show, axes, axis_names, cells, content,
    cross_out, marks, node_mark, space_figure,
};

/// Figure of the space view of `document` after `step` events, on the whole of
/// `page`. Without a camera, the tree and the ray fill it. Where a misprint is followed,
/// with what would be right, if `document` has found that out.
pub fn space<const D: usize>(
    document: &Document<D>,
    camera: Option<Camera<D>>,
    page: Page,
    show: &Show,
    step: usize,
) -> Figure {
    let camera = camera.unwrap_or_else(|| document.framed(page));
    let scenario = &document.scenario;
    let moment = document.moment(step);
    let event = step.checked_sub(1).and_then(|index| document.trace.events.get(index));
    let mut all = Vec::new();
    let cut = show.slice.and_then(|slice| slice.cut(document.tree.domain(), &camera));
    if n_leaves_shown(document, show) <= MOST_DRAWN {
        all.extend(cells(&document.tree, show, cut.as_ref()));
        all.extend(pixels(document, show));
    }
    if show.content && n_primitives_shown(document, show) <= MOST_PRIMITIVES {
        all.extend(content(&document.content, cut.as_ref()));
    }
    all.extend(cut.and_then(|cut| cut.outline(document.tree.domain())));
    all.extend(axes(document.tree.domain(), show, &camera));
    all.extend(axis_names(document.tree.domain(), &camera, page));
    all.extend(marks(&document.tree, &scenario.ray, &scenario.query, &moment, event, show));
    cross_out(&mut all, document.strayed_nodes());
    let right = document.right_nodes().iter();
    all.extend(right.map(|&node| node_mark(&document.tree, node, Role::Expected)));
    all.sort_by_key(|mark| mark.role.layer());
    space_figure(&all, &camera, page)
}

/// Leaves of a picture in their mean colours.
fn pixels<const D: usize>(document: &Document<D>, show: &Show) -> Vec<Mark<D>> {
    let is_shown = show.content && show.rest == Rest::Plain;
    let colours = document.leaf_colours().filter(|_| is_shown).unwrap_or_default();
    let tree = &document.tree;
    let coloured = tree.leaves().filter(|&leaf| show.shows(tree, leaf)).filter_map(|leaf| {
        let colour = *colours.get(leaf.id.index())?;
        Some(Mark::new(Shape::Box(tree.node_box(leaf.id)), Role::Pixel(colour?)))
    });
    coloured.collect()
}

/// More points or solids than this, and more leaves, are left out of figures:
/// nobody could tell them apart, and the files would be huge.
const MOST_PRIMITIVES: usize = 200_000;
const MOST_DRAWN: usize = 200_000;

fn n_leaves_shown<const D: usize>(document: &Document<D>, show: &Show) -> usize {
    show.nodes(&document.tree).count()
}

fn n_primitives_shown<const D: usize>(document: &Document<D>, show: &Show) -> usize {
    match &*document.content {
        Content::Cells(_) | Content::Image(_) => 0,
        Content::Points(_) | Content::Spheres(_) | Content::Boxes(_) | Content::Triangles(_) => {
            if show.content {
                document.content.len()
            } else {
                0
            }
        }
    }
}

/// What the figure of the space view leaves out, in words.
pub fn left_out<const D: usize>(document: &Document<D>, show: &Show, texts: &Texts) -> Vec<String> {
    let too_many = |n: usize, most: usize, key: &str| {
        (n > most).then(|| texts.format(key, &[("n", n.into()), ("most", most.into())]))
    };
    let left_out = [
        too_many(n_leaves_shown(document, show), MOST_DRAWN, "left-out-leaves"),
        too_many(n_primitives_shown(document, show), MOST_PRIMITIVES, "left-out-solids"),
    ];
    left_out.into_iter().flatten().collect()
}
