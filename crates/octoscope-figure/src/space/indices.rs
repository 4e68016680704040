//! Tags with the numbers of children: in the outer corner of each, off the ray and off
//! all points. They are square, so that none is taken for an order number.

use super::labels::rectangle;
use super::{Canvas, above_space};
use crate::figure::text_reach;
use crate::{Anchor, Form, Mark, Part, Role};
use octoscope_core::geometry::Aabb;
use octoscope_core::tree::NodeId;

/// Children with sides of less than this, in page units, bear no tag unless chosen.
const ROOMY: f64 = 36.0;
/// Room between a tag and the sides of its child.
const INSET: f64 = 4.0;
/// Room between a tag and what is written beside it, across and down.
const BESIDE: [f64; 2] = [5.0, 2.0];

impl<const D: usize> Canvas<'_, D> {
    /// Writes the number of a child towards a corner `at` of it; left out where it has
    /// no room, unless the child is the one that is taken.
    pub(super) fn write_index(
        &mut self,
        mark: &Mark<D>,
        (at, bounds): ([f64; D], &Aabb<D>),
        text: &str,
    ) {
        let [wide, high] = text_reach(mark.role, text);
        let half = wide.max(high);
        let [width, height] = self.extent(bounds);
        let side = width.min(height);
        let is_chosen = mark.node.is_some_and(|node| self.chosen.contains(&node));
        // In space, children lie behind each other.
        let roomy = if D == 2 { ROOMY } else { 1.6 * ROOMY };
        if side < 2.0 * half + INSET || !is_chosen && side < roomy {
            return;
        }
        let inset = ((half + INSET) / side).min(0.5);
        let places: Vec<[f64; 2]> = places(at, bounds, inset)
            .into_iter()
            .filter_map(|place| Some(self.camera.project(self.page, place)?.at))
            .collect();
        let reach = BESIDE.map(|room| half + room);
        let clear = places.iter().copied().filter(|at| !self.strikes(*at, [half + 1.0; 2]));
        let mut clear: Vec<_> = clear.collect();
        clear.sort_by_cached_key(|at| self.n_covered(*at, [half; 2]));
        let mut at = self.room(clear, reach);
        if at.is_none() && is_chosen {
            at = self.clearest(places, [half; 2]);
        }
        if let Some(at) = at {
            self.push_at(above_space(mark.role), mark, Part::Whole, rectangle(at, [half; 2]));
            let form = Form::Text { at, anchor: Anchor::Middle, text: text.into() };
            self.push_at(above_space(mark.role), mark, Part::Whole, form);
        }
    }
}

/// Places in a box: in the corner in which `at` lies, at such a share of the sides from
/// it, then farther in, then along the sides to the next corners.
fn places<const D: usize>(at: [f64; D], bounds: &Aabb<D>, inset: f64) -> Vec<[f64; D]> {
    let (centre, size) = (bounds.centre(), bounds.size());
    // From -0.5 to 0.5 of a side off the middle.
    let outwards = |e: usize| if at[e] > centre[e] { 1.0 } else { -1.0 };
    let place = |off: [f64; D]| std::array::from_fn(|e| centre[e] + size[e] * outwards(e) * off[e]);
    let depths = [inset, 1.7 * inset, 2.4 * inset].map(|inset: f64| 0.5 - inset.min(0.5));
    let mut places: Vec<[f64; D]> = depths.iter().map(|&off| place([off; D])).collect();
    for share in [0.0, -1.0] {
        places.extend((0..D).map(|axis| {
            place(std::array::from_fn(|e| depths[0] * if e == axis { share } else { 1.0 }))
        }));
    }
    places
}

/// The nodes of the marks that say where the algorithm goes.
pub(super) fn chosen<'a, const D: usize>(marks: impl Iterator<Item = &'a Mark<D>>) -> Vec<NodeId> {
    let is_chosen =
        |mark: &&Mark<D>| matches!(mark.role, Role::Taken | Role::Current | Role::Found);
    marks.filter(is_chosen).filter_map(|mark| mark.node).collect()
}
