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
        let mut places = places(at, bounds, inset);
        if is_chosen {
            places.extend(all_over(at, bounds, inset));
        }
        let places: Vec<[f64; 2]> = places
            .into_iter()
            .filter_map(|place| Some(self.camera.project(self.page, place)?.at))
            .collect();
        let reach = BESIDE.map(|room| half + room);
        let clear = places.iter().copied().filter(|at| !self.strikes(*at, [half + 1.0; 2]));
        let mut clear: Vec<_> = clear.collect();
        clear.sort_by_cached_key(|at| self.n_covered(*at, [half; 2]));
        let mut at = self.room(clear.iter().copied(), reach);
        if at.is_none() && is_chosen {
            // Closer to what is beside it, then on the ray, then on what it covers least.
            at = self.room(clear, [half + 1.0; 2]);
            at = at.or_else(|| self.clearest(places.iter().copied(), [half; 2]));
            at = at.or_else(|| self.least_taken(&places, [half; 2]).filter(|_| D == 2));
        }
        if let Some(at) = at {
            self.push_at(above_space(mark.role), mark, Part::Whole, rectangle(at, [half; 2]));
            let form = Form::Text { at, anchor: Anchor::Middle, text: text.into() };
            self.push_at(above_space(mark.role), mark, Part::Whole, form);
        }
    }

    /// The place where a label covers the least of what is taken.
    fn least_taken(&mut self, places: &[[f64; 2]], reach: [f64; 2]) -> Option<[f64; 2]> {
        let covered = |at: &[f64; 2]| -> f64 {
            let areas = self.taken.iter().map(|[other, extent]| {
                let both = [0, 1].map(|e| reach[e] + extent[e] - (at[e] - other[e]).abs());
                both[0].max(0.0) * both[1].max(0.0)
            });
            areas.sum()
        };
        let at = *places.iter().min_by(|a, b| covered(a).total_cmp(&covered(b)))?;
        self.taken.push([at, reach]);
        Some(at)
    }
}

/// Places all over a box, such a share of its sides within them, those nearest to `at`
/// first.
fn all_over<const D: usize>(at: [f64; D], bounds: &Aabb<D>, inset: f64) -> Vec<[f64; D]> {
    const ROW: usize = 7;
    let size = bounds.size();
    let place = |n: usize| {
        std::array::from_fn(|e| {
            let step = (n / ROW.pow(e as u32)) % ROW;
            let share = inset + (1.0 - 2.0 * inset) * step as f64 / (ROW - 1) as f64;
            bounds.min[e] + share * size[e]
        })
    };
    let away = |place: &[f64; D]| (0..D).map(|e| (place[e] - at[e]).powi(2)).sum::<f64>();
    let mut places: Vec<[f64; D]> = (0..ROW.pow(D as u32)).map(place).collect();
    places.sort_by(|a, b| away(a).total_cmp(&away(b)));
    places
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
