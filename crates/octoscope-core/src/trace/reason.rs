//! Which comparison rules a node out.
//!
//! The reasons follow from the ray and the cell alone, not from the algorithm: in
//! a cell the ray is between its latest near and its earliest far plane, not
//! before its origin, and not beyond the end of the segment. What is empty of
//! this is ruled out by the two ends that leave no room between them. They are
//! compared exactly; a run that decides otherwise is told so.

use crate::geometry::{Exact, Parameter, Ray};
use crate::traverse::slabs;
use crate::tree::{NodeId, Tree};

/// Why a node is not visited.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reason {
    /// The ray does not move along an axis, and its origin is not between the
    /// sides of the node there.
    Beside {
        /// The axis.
        axis: usize,
        /// Coordinate of the origin, in world units.
        origin: f64,
        /// The sides of the node, the lower one its own.
        sides: [f64; 2],
    },
    /// The line would enter the node only after it has left it.
    Missed {
        /// The latest near plane.
        enter: Crossing,
        /// The earliest far plane, which is met first.
        exit: Crossing,
    },
    /// The ray enters and leaves it in the same point.
    Touched {
        /// The latest near plane; `None` if that is the origin of the ray.
        enter: Option<Crossing>,
        /// The earliest far plane, which is met at the same time.
        exit: Crossing,
    },
    /// The line leaves it before the ray begins.
    Behind {
        /// The earliest far plane.
        exit: Crossing,
    },
    /// The ray ends before it.
    BeyondEnd {
        /// The latest near plane; `None` if that is the origin of the ray.
        enter: Option<Crossing>,
        /// Parameter of the end.
        end: f64,
    },
    /// The search has ended at the first full leaf, before it.
    AfterFull {
        /// Where the ray would enter it.
        enter: f64,
        /// Where the ray has entered the full leaf.
        full: f64,
    },
    /// The place that is searched lies in the other half of the parent, or
    /// outside of the root.
    Elsewhere {
        /// The axis.
        axis: usize,
        /// Coordinate of the place, in world units.
        place: f64,
        /// The side of the node that lies between.
        side: f64,
        /// Whether the place lies above the side, or on it, rather than below.
        above: bool,
    },
}

/// Where the ray crosses a side of a node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The axis across which the side lies.
    pub axis: usize,
    /// Which plane of the parent that is.
    pub plane: ParentPlane,
    /// The nearest double to its parameter.
    pub t: f64,
}

/// Plane of a parent in which a side of a child lies; of the root, its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ParentPlane {
    /// The plane that the ray meets first.
    Near,
    /// The plane in the middle.
    Mid,
    /// The plane that the ray meets last.
    Far,
}

/// Parameters between which the ray is in a node.
///
/// # Errors
///
/// Why it is not in it: [`Reason::Beside`], [`Reason::Missed`], [`Reason::Behind`],
/// [`Reason::BeyondEnd`] or [`Reason::Touched`], whichever comes first.
pub fn met<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    end: Option<f64>,
    node: NodeId,
) -> Result<[f64; 2], Reason> {
    // An axis without motion decides by itself.
    let bounds = tree.node_box(node);
    for axis in (0..D).filter(|&axis| ray.direction()[axis] == 0.0) {
        let (origin, sides) = (ray.origin()[axis], [bounds.min[axis], bounds.max[axis]]);
        if !(sides[0] <= origin && origin < sides[1]) {
            return Err(Reason::Beside { axis, origin, sides });
        }
    }

    // The others leave room, or do not, between two planes.
    let [(latest, near), (earliest, far)] = planes(tree, ray, node);
    let crossing = |axis: usize, is_near: bool, t: Exact| Crossing {
        axis,
        plane: parent_plane(tree, ray, node, axis, is_near),
        t: t.value(),
    };
    let exit = crossing(earliest, false, far);
    let enter = crossing(latest, true, near);
    if far.before(near) {
        return Err(Reason::Missed { enter, exit });
    }
    if far.before(Exact::ORIGIN) {
        return Err(Reason::Behind { exit });
    }
    let (first, enter) =
        if near.before(Exact::ORIGIN) { (Exact::ORIGIN, None) } else { (near, Some(enter)) };
    if let Some(end) = end.filter(|&end| !first.before(Exact::given(end))) {
        return Err(Reason::BeyondEnd { enter, end });
    }
    if !first.before(far) {
        return Err(Reason::Touched { enter, exit });
    }
    let last = end.map_or(far, |end| far.earlier(Exact::given(end)));
    Ok([first.value(), last.value()])
}

/// Why a node does not own a point, if it does not.
pub(super) fn elsewhere<const D: usize>(
    tree: &Tree<D>,
    at: &[f64; D],
    node: NodeId,
) -> Option<Reason> {
    let bounds = tree.node_box(node);
    (0..D).find_map(|axis| {
        let place = at[axis];
        let (low, high) = (bounds.min[axis], bounds.max[axis]);
        let above = place >= high;
        let outside = above || place < low;
        let side = if above { high } else { low };
        outside.then_some(Reason::Elsewhere { axis, place, side, above })
    })
}

/// The latest near and the earliest far plane of a node, among the axes along
/// which the ray moves: axis and parameter.
pub(super) fn planes<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    node: NodeId,
) -> [(usize, Exact); 2] {
    let (near, far) = slabs::<D, Exact>(tree.domain(), ray, tree.level(node), tree.code(node));
    let moving = || (0..D).filter(|&axis| ray.direction()[axis] != 0.0);
    let latest = moving().reduce(|a, b| if near[a].before(near[b]) { b } else { a });
    let earliest = moving().reduce(|a, b| if far[b].before(far[a]) { b } else { a });
    // No ray is without motion.
    let [latest, earliest] = [latest, earliest].map(Option::unwrap_or_default);
    [(latest, near[latest]), (earliest, far[earliest])]
}

fn parent_plane<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    node: NodeId,
    axis: usize,
    is_near: bool,
) -> ParentPlane {
    let mirrored = ray.direction()[axis] < 0.0;
    // Whether the node lies in the half of its parent that the ray meets last.
    match tree.child_index(node).map(|child| child.is_upper(axis) != mirrored) {
        Some(true) if is_near => ParentPlane::Mid,
        Some(false) if !is_near => ParentPlane::Mid,
        Some(_) | None if is_near => ParentPlane::Near,
        Some(_) | None => ParentPlane::Far,
    }
}
