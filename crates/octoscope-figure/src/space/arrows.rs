//! Arrows of a scene.

use super::{Canvas, above_space, distance};
use crate::camera::clipped;
use crate::handle::HEAD;
use crate::parts::Arrow;
use crate::{Drawn, Form, Mark, Page, Part, Role};

impl<const D: usize> Canvas<'_, D> {
    /// The part of an arrow to `end` that lies on the page; where that leads beyond the
    /// page, its head keeps off the border.
    pub(super) fn off_border(&self, end: [f64; D], [from, to]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
        const ROOM: f64 = 8.0;
        let Page { width, height } = self.page;
        let end = self.camera.project(self.page, end);
        if end.is_some_and(|end| self.is_near(end.at, 0.0)) {
            return [from, to];
        }
        let inner = [[ROOM; 2], [width - ROOM, height - ROOM]];
        clipped([from, to], inner).map_or([from, to], |[_, to]| [from, to])
    }

    /// Draws an arrow between two places, which lie on the page here.
    pub(super) fn draw_arrow(
        &mut self,
        mark: &Mark<D>,
        ends: [[f64; D]; 2],
        [from, to]: [[f64; 2]; 2],
    ) {
        const HALF_WIDTH: f64 = 5.0;
        /// Of the arrow the head takes no more than this share.
        const MOST: f64 = 0.3;
        let length = distance(from, to);
        if length < least_length(mark.role) {
            return;
        }
        let head = HEAD.min(MOST * length);
        let half_width = HALF_WIDTH * head / HEAD;
        let [from, to] = beside(mark.role, [from, to]);
        self.spared.push([from, to]);
        self.keep_line(mark.role, [from, to]);
        let along: [f64; 2] = std::array::from_fn(|e| (to[e] - from[e]) / length);
        let across = [-along[1], along[0]];
        let neck: [f64; 2] = std::array::from_fn(|e| to[e] - head * along[e]);
        let wing = |side: f64| std::array::from_fn(|e| neck[e] + side * half_width * across[e]);
        let drawn = |part, form| Drawn { form, role: mark.role, part, node: mark.node };
        let line = drawn(Part::Edge, Form::Polyline(vec![from, neck]));
        let head = drawn(Part::Head, Form::Polygon(vec![to, wing(1.0), wing(-1.0)]));
        if D == 3 && mark.role == Role::Ray && !self.is_apart {
            self.arrows.push(Arrow { ends, shaft: [from, neck], line, head });
        } else {
            let order = above_space(mark.role);
            if mark.role.has_casing() {
                let casing = Drawn { part: Part::Casing, ..line.clone() };
                self.drawn.push((order, casing));
            }
            self.drawn.extend([(order, line), (order, head)]);
        }
    }
}

/// Whether a role's arrow goes from node to node: there are many, and some lie on others.
fn is_way(role: Role) -> bool {
    matches!(role, Role::WayUp | Role::WayDown | Role::Link)
}

/// Length on the page below which an arrow is not drawn.
fn least_length(role: Role) -> f64 {
    const LEGIBLE: f64 = 6.0;
    if is_way(role) { LEGIBLE } else { 1e-9 }
}

/// The ends of an arrow, to its right where it may lie on one that leads back, or on the
/// direction that is asked for.
fn beside(role: Role, [from, to]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    const APART: f64 = 5.5;
    if !is_way(role) {
        return [from, to];
    }
    let length = distance(from, to);
    let right = [-(to[1] - from[1]) / length, (to[0] - from[0]) / length];
    [from, to].map(|end| std::array::from_fn(|e| end[e] + APART * right[e]))
}
