//! Tags with the numbers of children: in the outer corner of each, off the ray and off
//! all points; in space where the child is seen, not one that lies before it. That of a
//! small child through which ray and ways lead stands outside, at its frame, and points into
//! it. Tags are square, so that none is taken for an order number.

use super::at_frame::{POINT, Seen, pointer};
use super::labels::rectangle;
use super::{Canvas, above_space};
use crate::camera::clipped;
use crate::figure::text_reach;
use crate::marks::interval;
use crate::numbers::do_cross;
use crate::{Anchor, Form, Mark, Part, Role, Shape};
use octoscope_core::geometry::Aabb;
use octoscope_core::tree::NodeId;

/// Children with sides of less than this, in page units, bear no tag unless chosen.
const ROOMY: f64 = 36.0;
/// Room between a tag and the sides of its child.
const INSET: f64 = 4.0;
/// Room between a tag and what is written beside it, across and down.
const BESIDE: [f64; 2] = [5.0, 2.0];

/// The number of a child that is to be written.
struct Tag<'a, const D: usize> {
    mark: &'a Mark<D>,
    text: &'a str,
    /// Towards which corner of the child.
    at: [f64; D],
    bounds: Aabb<D>,
    /// Half its side, and the shorter side of the child on the page.
    half: f64,
    side: f64,
}

/// Where a tag stands, and where it points if that is outside of its child.
struct Place {
    at: [f64; 2],
    tip: Option<[f64; 2]>,
}

impl Place {
    fn inside(at: [f64; 2]) -> Self {
        Self { at, tip: None }
    }
}

impl<const D: usize> Canvas<'_, D> {
    /// Writes the numbers of children. The one that is taken has its own wherever it is
    /// large enough for it; of the others all have, or none has: a gap among them would
    /// be taken for a meaning.
    pub(super) fn write_indices(&mut self, marks: &[Mark<D>]) {
        let tags: Vec<_> = marks.iter().filter_map(|mark| self.tag(mark)).collect();
        let siblings: Vec<Aabb<D>> = tags.iter().map(|tag| tag.bounds).collect();
        let is_chosen =
            |tag: &Tag<'_, D>| tag.mark.node.is_some_and(|node| self.chosen.contains(&node));
        let (chosen, others): (Vec<_>, Vec<_>) = tags.into_iter().partition(is_chosen);
        for tag in chosen.iter().filter(|tag| tag.side >= 2.0 * tag.half + INSET) {
            if let Some(place) = self.place_chosen(tag, &siblings) {
                self.taken.push([place.at, BESIDE.map(|room| tag.half + room)]);
                self.draw_tag(tag, place);
            }
        }
        // In space, children lie behind each other.
        let roomy = if D == 2 { ROOMY } else { 1.6 * ROOMY };
        if others.iter().any(|tag| tag.side < roomy) {
            return;
        }
        // One that is hidden by others has no place.
        let n_taken = self.taken.len();
        let places: Option<Vec<_>> =
            others.iter().map(|tag| self.place_other(tag, &siblings)).collect();
        let Some(places) = places else { return self.taken.truncate(n_taken) };
        others.iter().zip(places).for_each(|(tag, at)| self.draw_tag(tag, Place::inside(at)));
    }

    fn tag<'m>(&self, mark: &'m Mark<D>) -> Option<Tag<'m, D>> {
        let (Role::ChildIndex, Shape::LabelIn { at, bounds }, Some(text)) =
            (mark.role, mark.shape, &mark.text)
        else {
            return None;
        };
        let [wide, high] = text_reach(mark.role, text);
        let [width, height] = self.extent(&bounds);
        Some(Tag { mark, text, at, bounds, half: wide.max(high), side: width.min(height) })
    }

    /// A place that is clear, in the corner of the child or anywhere in it.
    fn place_other(&mut self, tag: &Tag<'_, D>, siblings: &[Aabb<D>]) -> Option<[f64; 2]> {
        let reach = BESIDE.map(|room| tag.half + room);
        [tag.near(), tag.all_over()].into_iter().find_map(|places| {
            let clear = self.clear(self.seen(tag, places, siblings), tag.half);
            self.room(clear, reach)
        })
    }

    /// The same or, where none is clear, closer to what is beside it, then at the frame of the
    /// child, outside of its parent, then on the ray, then on what it covers least. A child
    /// that is hidden has its number there all the same.
    fn place_chosen(&mut self, tag: &Tag<'_, D>, siblings: &[Aabb<D>]) -> Option<Place> {
        let all = || tag.near().into_iter().chain(tag.all_over());
        let mut on_page = self.seen(tag, all().collect(), siblings);
        if on_page.is_empty() {
            on_page = all().filter_map(|place| self.on_page(place)).collect();
        }
        let clear = self.clear(on_page.clone(), tag.half);
        self.room(clear.iter().copied(), BESIDE.map(|room| tag.half + room))
            .or_else(|| self.room(clear, [tag.half + 1.0; 2]))
            .map(Place::inside)
            .or_else(|| self.place_at_frame(tag, siblings))
            .or_else(|| if D == 3 { self.place_at_frame(tag, &[]) } else { None })
            .or_else(|| {
                let clearest = self.clearest(on_page.iter().copied(), [tag.half; 2]);
                let at = clearest.or_else(|| self.least_taken(&on_page, [tag.half; 2]));
                at.map(Place::inside)
            })
    }

    /// A clear place that touches the frame of the child, outside of it and of others; first
    /// where what points into the child from there covers nothing.
    fn place_at_frame(&mut self, tag: &Tag<'_, D>, others: &[Aabb<D>]) -> Option<Place> {
        let child = self.seen_of(&tag.bounds)?;
        let clear = self.clear(self.at_frame(&tag.bounds, others, tag.half), tag.half);
        let places = clear.into_iter().map(|at| Place { at, tip: self.tip(&child, at) });
        let mut places: Vec<Place> = places.collect();
        places.sort_by_key(|place| place.tip.is_none());
        let is_free = |place: &Place| self.is_free(place.at, [tag.half; 2]);
        let place = places.into_iter().find(is_free)?;
        self.taken.push([place.at, [tag.half; 2]]);
        self.taken.extend(place.tip.map(|tip| [tip, [POINT; 2]]));
        Some(place)
    }

    /// Where a tag that stands outside of its child points, as far in as nothing is covered;
    /// nowhere if a line lies at the frame itself.
    fn tip(&self, child: &Seen, at: [f64; 2]) -> Option<[f64; 2]> {
        const WITHIN: [f64; 3] = [7.0, 4.5, 2.5];
        let tips = child.pointed_at(at, WITHIN)?;
        tips.into_iter().find(|tip| !self.covers([at, *tip]))
    }

    /// Whether what points from a tag covers a line or anything else that has to be seen.
    fn covers(&self, [at, tip]: [[f64; 2]; 2]) -> bool {
        const ROOM: f64 = 1.0;
        let strikes = |[middle, reach]: &[[f64; 2]; 2]| {
            let area = [-1.0, 1.0]
                .map(|sign| std::array::from_fn(|e| middle[e] + sign * (reach[e] + ROOM)));
            clipped([at, tip], area).is_some()
        };
        let [left, _, right] = pointer(at, tip);
        let is_cut =
            |line: &[[f64; 2]; 2]| do_cross([left, tip], *line) || do_cross([right, tip], *line);
        self.kept.iter().any(is_cut) || self.taken.iter().any(strikes)
    }

    /// Where places lie on the page at which a tag lies on its own child.
    fn seen(&self, tag: &Tag<'_, D>, places: Vec<[f64; D]>, siblings: &[Aabb<D>]) -> Vec<[f64; 2]> {
        let is_own = |[x, y]: &[f64; 2]| {
            let corners = [[0.0, 0.0], [-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
            let corners = corners.map(|[i, j]| [x + i * tag.half, y + j * tag.half]);
            corners.into_iter().all(|at| self.nearest(at, siblings) == Some(tag.bounds))
        };
        let on_page = places.into_iter().filter_map(|place| self.on_page(place));
        on_page.filter(|at| D == 2 || is_own(at)).collect()
    }

    /// The box that is seen at a place on the page.
    pub(super) fn nearest(&self, at: [f64; 2], boxes: &[Aabb<D>]) -> Option<Aabb<D>> {
        let sight = self.camera.sight(self.page, at)?;
        let met = boxes.iter().filter_map(|bounds| Some((interval(&sight, bounds)?[0], *bounds)));
        met.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, bounds)| bounds)
    }

    fn on_page(&self, place: [f64; D]) -> Option<[f64; 2]> {
        Some(self.camera.project(self.page, place)?.at)
    }

    /// Those places that strike no line which has to be seen, first where the fewest of the
    /// others are covered.
    fn clear(&self, mut clear: Vec<[f64; 2]>, half: f64) -> Vec<[f64; 2]> {
        clear.retain(|at| !self.strikes(*at, [half + 1.0; 2]));
        clear.sort_by_cached_key(|at| self.n_covered(*at, [half; 2]));
        clear
    }

    fn draw_tag(&mut self, tag: &Tag<'_, D>, Place { at, tip }: Place) {
        let order = above_space(tag.mark.role);
        if let Some(tip) = tip {
            let corners = pointer(at, tip).to_vec();
            self.push_at(order, tag.mark, Part::Whole, Form::Polygon(corners));
        }
        self.push_at(order, tag.mark, Part::Whole, rectangle(at, [tag.half; 2]));
        let form = Form::Text { at, anchor: Anchor::Middle, text: tag.text.into() };
        self.push_at(order, tag.mark, Part::Whole, form);
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

impl<const D: usize> Tag<'_, D> {
    /// Share of the sides of the child that it keeps from its corner.
    fn inset(&self) -> f64 {
        ((self.half + INSET) / self.side).min(0.5)
    }

    /// Places in and near the corner of the child.
    fn near(&self) -> Vec<[f64; D]> {
        places(self.at, &self.bounds, self.inset())
    }

    /// Places all over the child.
    fn all_over(&self) -> Vec<[f64; D]> {
        all_over(self.at, &self.bounds, self.inset())
    }
}

/// Places all over a part of the page.
pub(super) fn all_over_page([min, max]: [[f64; 2]; 2]) -> Vec<[f64; 2]> {
    const ROW: u32 = 20;
    let share = |n: u32| (f64::from(n) + 0.5) / f64::from(ROW);
    let at = |e: usize, share: f64| min[e] + share * (max[e] - min[e]);
    let places = (0..ROW * ROW).map(|n| [at(0, share(n % ROW)), at(1, share(n / ROW))]);
    places.collect()
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
