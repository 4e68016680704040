//! Children that are moved apart: above everything else, the nearest last, each with its
//! number where it is seen or, where what is seen of it has no room for that, beside all
//! of them, with a line to it.

use super::at_frame::Seen;
use super::indices::all_over_page;
use super::labels::rectangle;
use super::{Canvas, above_space, distance};
use crate::figure::text_reach;
use crate::{Anchor, Form, Mark, Part, Role, Shape};
use octoscope_core::geometry::Aabb;

/// A child that is moved apart, and what is written on its tag.
struct Child<'a, const D: usize> {
    mark: &'a Mark<D>,
    text: &'a str,
    bounds: Aabb<D>,
    /// Half the height and width of its tag.
    half: [f64; 2],
    /// Points on the page at which it is seen.
    seen: Vec<[f64; 2]>,
}

impl<const D: usize> Canvas<'_, D> {
    /// Place in the drawing order of a child in space.
    pub(super) fn order_apart(&self, bounds: &Aabb<D>) -> f64 {
        let [lowest, next] = [Role::Apart, Role::MirroredRay].map(above_space);
        let depth = self.camera.depth(bounds.centre()) / self.camera.height;
        lowest + 0.5 * (next - lowest) * (1.0 - depth / (1.0 + depth.abs()))
    }

    /// Writes the numbers of the children, those first that have room on what is seen of them.
    pub(super) fn write_apart(&mut self, marks: &[Mark<D>]) {
        let boxes: Vec<Aabb<D>> = marks.iter().filter_map(apart_box).collect();
        if boxes.is_empty() {
            return;
        }
        let children: Vec<_> = marks.iter().filter_map(|mark| self.child(mark, &boxes)).collect();
        let mut others = Vec::new();
        for child in &children {
            match self.place_on(child, &boxes) {
                Some(at) => self.draw_apart(child, at),
                None => others.push(child),
            }
        }
        let areas: Vec<Seen> = boxes.iter().filter_map(|bounds| self.seen_of(bounds)).collect();
        for child in others {
            self.lead_to(child, &areas);
        }
    }

    /// Whether a point on the page lies under a child that is moved apart.
    pub(super) fn is_under(&self, at: [f64; 2], areas: &[Seen]) -> bool {
        areas.iter().any(|area| area.meets(at, 0.0))
    }

    /// What is seen of the children, whoever draws them.
    pub(super) fn areas_apart<'m>(&self, all: impl Iterator<Item = &'m Mark<D>>) -> Vec<Seen> {
        all.filter_map(apart_box).filter_map(|bounds| self.seen_of(&bounds)).collect()
    }

    fn child<'m>(&self, mark: &'m Mark<D>, boxes: &[Aabb<D>]) -> Option<Child<'m, D>> {
        let (bounds, text) = (apart_box(mark)?, mark.text.as_deref()?);
        let [wide, high] = text_reach(Role::ChildIndex, text);
        let half = [wide.max(high), high];
        let at = all_over_page(self.seen_of(&bounds)?.extent());
        let is_seen = |at: &[f64; 2]| match D {
            2 => true,
            _ => self.nearest(*at, boxes) == Some(bounds),
        };
        Some(Child { mark, text, bounds, half, seen: at.into_iter().filter(is_seen).collect() })
    }

    /// A place in the middle of what is seen of a child, off the ray.
    fn place_on(&mut self, child: &Child<'_, D>, boxes: &[Aabb<D>]) -> Option<[f64; 2]> {
        const ROOM: f64 = 2.5;
        let reach = child.half.map(|half| half + ROOM);
        let middle = middle(&child.seen)?;
        let area = self.seen_of(&child.bounds)?;
        let is_whole = |at: [f64; 2]| {
            let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
            corners.into_iter().all(|[i, j]| {
                let at = [at[0] + i * reach[0], at[1] + j * reach[1]];
                match D {
                    2 => area.holds(at),
                    _ => self.nearest(at, boxes) == Some(child.bounds),
                }
            })
        };
        let mut places: Vec<[f64; 2]> =
            child.seen.iter().copied().filter(|at| is_whole(*at)).collect();
        places.retain(|at| !self.strikes(*at, child.half));
        places.sort_by(|a, b| distance(*a, middle).total_cmp(&distance(*b, middle)));
        self.room(places, child.half)
    }

    /// Writes a number outside of all children, with a line to what is seen of its own; to
    /// its middle where nothing is.
    fn lead_to(&mut self, child: &Child<'_, D>, areas: &[Seen]) {
        const GAP: f64 = 3.0;
        const STEP: f64 = 3.0;
        const ROWS: u32 = 60;
        let Some(own) = self.seen_of(&child.bounds) else { return };
        let foot = most_inner(&child.seen).unwrap_or(own.middle);
        let all: Vec<[f64; 2]> = areas.iter().map(|area| area.middle).collect();
        let Some(centre) = middle(&all) else { return };
        let (up, length) = ([0.0, -1.0], distance(own.middle, centre));
        let outwards = if length < 1e-6 {
            up
        } else {
            std::array::from_fn(|e| (own.middle[e] - centre[e]) / length)
        };
        let reach = child.half.map(|half| half + GAP);
        let half = reach[0].max(reach[1]);
        let places = (1..ROWS).flat_map(|row| {
            [0.0_f64, 15.0, -15.0, 30.0, -30.0, 50.0, -50.0].map(|turn| {
                let (sin, cos) = turn.to_radians().sin_cos();
                let away = STEP * f64::from(row);
                let [x, y] = outwards;
                [foot[0] + away * (cos * x - sin * y), foot[1] + away * (sin * x + cos * y)]
            })
        });
        let is_clear = |at: &[f64; 2]| {
            self.is_on_page(*at, child.half)
                && !self.strikes(*at, child.half)
                && self.is_free(*at, child.half)
                && !areas.iter().any(|area| area.meets(*at, half))
        };
        let Some(at) = places.into_iter().find(is_clear) else { return };
        self.taken.push([at, child.half]);
        let line = Form::Polyline(vec![foot, at]);
        self.push_at(above_space(Role::ChildIndex), &tag_of(child.mark), Part::Edge, line);
        self.draw_apart(child, at);
    }

    fn draw_apart(&mut self, child: &Child<'_, D>, at: [f64; 2]) {
        let (mark, order) = (tag_of(child.mark), above_space(Role::ChildIndex));
        self.push_at(order, &mark, Part::Whole, rectangle(at, child.half));
        let form = Form::Text { at, anchor: Anchor::Middle, text: child.text.into() };
        self.push_at(order, &mark, Part::Whole, form);
    }
}

/// The box of a child that is moved apart.
fn apart_box<const D: usize>(mark: &Mark<D>) -> Option<Aabb<D>> {
    match mark.shape {
        Shape::Box(bounds) if is_apart(mark.role) => Some(bounds),
        _ => None,
    }
}

/// The mark of the tag of a child.
fn tag_of<const D: usize>(mark: &Mark<D>) -> Mark<D> {
    Mark { role: Role::ChildIndex, ..mark.clone() }
}

/// The point that is farthest from the rim of what is seen: with the most others around it.
fn most_inner(seen: &[[f64; 2]]) -> Option<[f64; 2]> {
    const NEAR: f64 = 9.0;
    let n_near = |at: &[f64; 2]| seen.iter().filter(|other| distance(*at, **other) < NEAR).count();
    seen.iter().copied().max_by_key(n_near)
}

/// Whether a role is of a child that is moved apart.
pub(super) fn is_apart(role: Role) -> bool {
    matches!(role, Role::Apart | Role::ApartTaken)
}

fn middle(points: &[[f64; 2]]) -> Option<[f64; 2]> {
    let n = points.len() as f64;
    let middle = |e: usize| points.iter().map(|point| point[e]).sum::<f64>() / n;
    (!points.is_empty()).then(|| [0, 1].map(middle))
}
