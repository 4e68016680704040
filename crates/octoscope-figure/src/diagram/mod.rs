//! The tree as a diagram: the root on top, branches down to the children, what is
//! off the path folded.
//!
//! Only the path to the current node, what has been visited last and what the
//! user unfolds are laid out, so that the tree may have millions of nodes.

mod below;
mod branches;
mod draw;
mod layout;
mod state;
mod unfold;

use crate::{Figure, Page};
use layout::{LEVEL, SPACING, layout, width};
use octoscope_core::event::Event;
use octoscope_core::geometry::Ray;
use octoscope_core::query::Query;
use octoscope_core::trace::Moment;
use octoscope_core::tree::{NodeId, Tree};
use state::states;

/// What a diagram is of.
#[derive(Clone, Copy, Debug)]
pub struct DiagramOf<'a, const D: usize> {
    /// The tree.
    pub tree: &'a Tree<D>,
    /// The ray, which counts where the query is about one.
    pub ray: &'a Ray<D>,
    /// What is asked.
    pub query: &'a Query<D>,
    /// State of the algorithm.
    pub moment: &'a Moment<D>,
    /// The event that has just happened.
    pub event: Option<&'a Event<D>>,
    /// The nodes that the run reports though they are not right, in the order of their
    /// numbers, as far as that is known.
    pub strayed: &'a [NodeId],
}

impl<const D: usize> DiagramOf<'_, D> {
    /// Parameters between which the ray is in the root, for the ramp.
    fn root_interval(&self) -> [f64; 2] {
        let root = self.tree.domain().root_box();
        let [enter, exit] = crate::marks::interval(self.ray, &root).unwrap_or([0.0, 1.0]);
        [enter.max(0.0), exit]
    }
}

/// How a diagram is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiagramLens {
    /// How much larger than what fits the page it is.
    pub zoom: f64,
    /// The place of the layout in the middle of the page; `None` shows all, or
    /// what is around the current node where all has no room.
    pub centre: Option<[f64; 2]>,
}

impl Default for DiagramLens {
    fn default() -> Self {
        Self { zoom: 1.0, centre: None }
    }
}

/// A diagram on a page.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagram {
    /// What is drawn.
    pub figure: Figure,
    /// The nodes on the page, parents first.
    pub nodes: Vec<DiagramNode>,
    /// The place of the layout in the middle of the page.
    pub centre: [f64; 2],
    /// Page units per unit of the layout, across and down.
    pub scale: [f64; 2],
    /// The page that it fills at this scale.
    pub natural: Page,
}

/// A node of a diagram.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiagramNode {
    /// The node.
    pub node: NodeId,
    /// Where it is on the page.
    pub at: [f64; 2],
    /// Half the side of what is drawn of it, in page units.
    pub half: f64,
    /// What is shown below it.
    pub kind: NodeKind,
    /// Whether the algorithm is, or has been, in it, or decides about it now.
    pub matters: bool,
}

/// What a diagram shows below a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NodeKind {
    /// There is nothing below it.
    Leaf,
    /// Its children.
    Unfolded,
    /// Nothing of its leaves but their number.
    Folded {
        /// Number of leaves.
        n_leaves: usize,
    },
}

/// Room for the numbers of levels, left of the nodes.
const GUTTER: f64 = 24.0;
/// Room above the root, below the lowest level and to the right.
const MARGIN: [f64; 3] = [14.0, 22.0, 6.0];
/// Less than this, across and down, is not readable: what has no room even so
/// is cut off by the page.
const LEAST_SCALE: [f64; 2] = [0.72, 0.74];
/// More than this would take nodes apart that belong together.
const LARGEST_SCALE: [f64; 2] = [1.6, 1.6];

/// Diagram on `page`; the nodes `unfolded` show their children wherever they are,
/// and the node under the pointer, or what it lies in, is lit. O(path).
pub fn tree_diagram<const D: usize>(
    of: &DiagramOf<D>,
    unfolded: &[NodeId],
    hovered: Option<NodeId>,
    page: Page,
    lens: DiagramLens,
) -> Diagram {
    let [above, below, right] = MARGIN;
    let area = [page.width - GUTTER - right, page.height - above - below].map(|x| x.max(1.0));
    let open = unfold::unfolded(of, unfolded, area[0] / LEAST_SCALE[0]);
    let items = layout(of.tree, &open);
    let states = states(of, &items);

    // Fitted to the page, but never so small that it cannot be read.
    let sides = width(&items);
    let depth = items.iter().map(|item| item.depth).max().unwrap_or(0) as f64;
    let extent = [sides[1] - sides[0], (depth * LEVEL).max(1.0)];
    let scale: [f64; 2] = std::array::from_fn(|e| {
        lens.zoom * (area[e] / extent[e]).clamp(LEAST_SCALE[e], LARGEST_SCALE[e])
    });
    let focus = states.focus.map_or([0.0; 2], |n| [items[n].x, items[n].depth as f64 * LEVEL]);
    let ends = [sides, [0.0, depth * LEVEL]];
    let centre = lens.centre.unwrap_or_else(|| {
        std::array::from_fn(|e| {
            let half = 0.5 * area[e] / scale[e];
            let [first, last] = [ends[e][0] + half, ends[e][1] - half];
            match (first <= last, e) {
                (true, _) => focus[e].clamp(first, last),
                // What has room is in the middle, and hangs from the top.
                (false, 0) => 0.5 * (ends[e][0] + ends[e][1]),
                (false, _) => first,
            }
        })
    });
    let middle = [GUTTER + 0.5 * area[0], above + 0.5 * area[1]];
    let place = |[x, y]: [f64; 2]| -> [f64; 2] {
        [middle[0] + (x - centre[0]) * scale[0], middle[1] + (y - centre[1]) * scale[1]]
    };
    let placed: Vec<[f64; 2]> =
        items.iter().map(|item| place([item.x, item.depth as f64 * LEVEL])).collect();
    let drawing = draw::Drawing {
        of,
        items: &items,
        states: &states,
        placed: &placed,
        spacing: SPACING * scale[0],
        levels: LEVEL * scale[1],
        page,
        gutter: GUTTER,
    };
    let nodes = drawing.nodes();
    let figure = drawing.figure(&nodes, hovered);
    let natural = Page {
        width: GUTTER + extent[0] * scale[0] + right,
        height: above + depth * LEVEL * scale[1] + below,
    };
    Diagram {
        figure,
        nodes: nodes.into_iter().map(|(_, node)| node).collect(),
        centre,
        scale,
        natural,
    }
}
