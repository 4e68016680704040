//! How large boxes are drawn: some within their own cell, and the lines of small ones finer.

use crate::{Dash, Part, Role, Style};
use octoscope_core::geometry::Aabb;

/// The box of a mark as it is drawn: that of a child which is not taken lies a little
/// within its cell, so that its line is told from those of its parent and its neighbours;
/// that around what is at work or looked for is so large that it is seen as an outline.
/// `unit` is a page unit in world units.
pub fn drawn_box<const D: usize>(role: Role, bounds: &Aabb<D>, unit: f64) -> Aabb<D> {
    const INSET: f64 = 3.0;
    const MOST: f64 = 0.1;
    /// Least side of an outline.
    const LEAST: f64 = 12.0;
    /// How far a large one is inset, and from which side on.
    const WITHIN: f64 = 4.0;
    const LARGE: f64 = 30.0;
    let size = bounds.size();
    let is_at_work = matches!(role, Role::Current | Role::Missed | Role::Found | Role::GridCell);
    if is_at_work || role == Role::Target {
        // What is looked for lies within the frame around it.
        let is_inset = role == Role::Target && size.iter().all(|side| *side > LARGE * unit);
        let least = if is_inset { -WITHIN * unit } else { 0.0 };
        let by = size.map(|side| (0.5 * (LEAST * unit - side)).max(least));
        return Aabb {
            min: std::array::from_fn(|e| bounds.min[e] - by[e]),
            max: std::array::from_fn(|e| bounds.max[e] + by[e]),
        };
    }
    if role != Role::Rejected {
        return *bounds;
    }
    let by: [f64; D] = std::array::from_fn(|e| (INSET * unit).min(MOST * size[e]));
    Aabb {
        min: std::array::from_fn(|e| bounds.min[e] + by[e]),
        max: std::array::from_fn(|e| bounds.max[e] - by[e]),
    }
}

/// How the edges of a box are drawn: finer and unbroken where it is so small that lines of
/// this style would fill it, nine of them in space, or broken sides with their casing run
/// together. `unit` is a page unit in world units.
pub fn edge_part<const D: usize>(style: &Style, bounds: &Aabb<D>, unit: f64) -> Part {
    let is_cased = style.dash != Dash::Solid && style.casing > 0.0;
    let least = match D {
        _ if is_cased => 12.0,
        2 => 4.5,
        _ => 10.0,
    };
    if longest_side(bounds, unit) < least * style.width { Part::FineEdge } else { Part::Edge }
}

/// The longest side of a box, in page units; `unit` is one in world units.
pub(super) fn longest_side<const D: usize>(bounds: &Aabb<D>, unit: f64) -> f64 {
    bounds.size().into_iter().fold(0.0, f64::max) / unit
}
