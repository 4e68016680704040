//! The numbers of the visited leaves, in the order in which they are visited.

use super::{Canvas, above_space};
use crate::figure::{radius_around, text_reach};
use crate::numbers::{Area, Convex, Kept, Number, Stand, stands};
use crate::sides::sides_to_eye;
use crate::{Form, Mark, Part, Projected, Role, Shape, Style, Theme};
use octoscope_core::geometry::Aabb;
use octoscope_core::tree::NodeId;
use std::collections::HashMap;

/// At most so many numbers have a place each, near or far; more are thinned: in the plane,
/// and in space, where leaves hide each other.
const FEW: [usize; 2] = [40, 12];

/// The box of a leaf, or of a node at work.
struct Leaf<const D: usize> {
    /// The leaf.
    visited: Option<NodeId>,
    bounds: Aabb<D>,
    seen: Area,
}

impl<const D: usize> Canvas<'_, D> {
    /// Writes the labels along lines, as many as there is room for; `all` are what is
    /// drawn here, and by others.
    pub(super) fn number<'m>(&mut self, all: impl Iterator<Item = &'m Mark<D>> + Clone) {
        let page = [self.page.width, self.page.height];
        let (mut numbers, mut labels) = (Vec::new(), Vec::new());
        let mut areas = self.seen_of_leaves(all.clone());
        let apart = self.areas_apart(all.clone());
        let along = all.filter_map(|mark| match (mark.shape, &mark.text) {
            (Shape::LabelAlong(ends), Some(text)) => Some((mark, ends, text)),
            _ => None,
        });
        for (index, (mark, ends, text)) in along.enumerate() {
            let chord = self.camera.visible_segment(self.page, ends);
            // Those that lie under children which are moved apart are not seen.
            if let Some(chord) = chord.filter(|ends| !self.is_under(middle_of(*ends), &apart)) {
                let [radius, tight] = radii(mark.role, text);
                let leaf = mark.node.and_then(|node| areas.remove(&node)).unwrap_or_default();
                numbers.push(Number { order: index + 1, chord, radius, tight, leaf });
                labels.push((mark, text));
            }
        }
        let hidden = self.small.iter().chain(&self.looked_at);
        let taken: Vec<_> = self.taken.iter().chain(hidden).copied().collect();
        let kept = Kept { taken: &taken, lines: &self.kept, page };
        let stands = stands(&numbers, kept, FEW[usize::from(D == 3)]);
        let stands: Vec<_> = labels
            .into_iter()
            .zip(stands)
            .filter_map(|(label, stand)| Some((label, stand?)))
            .collect();
        for ((mark, _), Stand { leader, .. }) in &stands {
            if let Some(line) = leader {
                let line = Form::Polyline(line.to_vec());
                self.push_at(above_space(mark.role), mark, Part::Edge, line);
            }
        }
        for ((mark, text), Stand { at, radius, .. }) in stands {
            let radius = radius - 0.5 * Style::of(Theme::Light, mark.role).width;
            let disc = Form::Circle { centre: at, radius };
            self.push_at(above_space(mark.role), mark, Part::Whole, disc);
            self.text(mark, at, text);
        }
    }

    /// What is seen on the page of every leaf that has a number. In space, one may lie
    /// before another, or a node at work before both.
    fn seen_of_leaves<'m>(
        &self,
        all: impl Iterator<Item = &'m Mark<D>> + Clone,
    ) -> HashMap<NodeId, Area> {
        let leaves: Vec<Leaf<D>> = all.filter_map(|mark| self.leaf(mark)).collect();
        let seen = leaves.iter().filter_map(|leaf| {
            let before = leaves.iter().filter(|other| self.hides(other, leaf));
            let before = before.flat_map(|other| other.seen.own.clone()).collect();
            Some((leaf.visited?, Area { before, ..leaf.seen.clone() }))
        });
        seen.collect()
    }

    fn leaf(&self, mark: &Mark<D>) -> Option<Leaf<D>> {
        let is_at_work = matches!(mark.role, Role::Current | Role::Missed | Role::Found);
        let is_visited = matches!(mark.role, Role::Visited { .. } | Role::Strayed);
        let visited = mark.node.filter(|_| is_visited);
        let (Shape::Box(bounds), true) = (mark.shape, is_visited || is_at_work) else {
            return None;
        };
        let own = if D == 2 {
            Convex::new(self.outline(&bounds)).into_iter().collect()
        } else {
            let sides = sides_to_eye(self.camera, self.page, &bounds).into_iter();
            let places = |polygon: Vec<Projected>| polygon.iter().map(|p| p.at).collect();
            sides.filter_map(|side| Convex::new(places(side.polygon))).collect()
        };
        let seen = Area { own, before: Vec::new() };
        Some(Leaf { visited, bounds, seen })
    }

    /// Whether a box may hide a part of another one that is apart from it.
    fn hides(&self, near: &Leaf<D>, far: &Leaf<D>) -> bool {
        let (mut is_apart, mut is_before) = (false, true);
        for axis in 0..D {
            let is_upper = near.bounds.min[axis] >= far.bounds.max[axis];
            let is_lower = near.bounds.max[axis] <= far.bounds.min[axis];
            if is_upper || is_lower {
                let border = if is_upper { near.bounds.min } else { near.bounds.max };
                let to_eye = self.camera.towards_eye(border)[axis];
                is_apart = true;
                is_before &= if is_upper { to_eye > 0.0 } else { to_eye < 0.0 };
            }
        }
        is_apart && is_before && near.seen.own.iter().any(|part| far.seen.reaches(part.extent))
    }
}

fn middle_of([from, to]: [[f64; 2]; 2]) -> [f64; 2] {
    [0, 1].map(|e| 0.5 * (from[e] + to[e]))
}

/// Radius of the disc of a number with its line, and the least one: it reaches around the
/// digits.
fn radii(role: Role, text: &str) -> [f64; 2] {
    let style = Style::of(Theme::Light, role);
    let [half_width, _] = text_reach(role, text);
    let radius = style.radius.max(half_width + 2.0);
    [radius, radius_around(role, text).min(radius)].map(|radius| radius + 0.5 * style.width)
}
