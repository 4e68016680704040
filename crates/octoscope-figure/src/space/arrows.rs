//! Arrows of a scene.

use super::{Canvas, above_space, distance};
use crate::camera::clipped;
use crate::handle::HEAD;
use crate::parts::Arrow;
use crate::{Camera, Drawn, Form, Mark, Page, Part, Role, Shape};

/// Shorter ways have finer lines without dashes, of which they would hold but two or three.
const FINE: f64 = 34.0;

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
        let length = distance(from, to);
        if length < least_length(mark.role) {
            return;
        }
        let OnPage { shaft, head } =
            if is_way(mark.role) { bow([from, to], self.bend) } else { straight([from, to]) };
        let [start, neck] = [shaft[0], shaft[shaft.len() - 1]];
        self.spare_line(&shaft);
        self.spared.push([neck, head[0]]);
        self.keep_arrow(mark.role, &shaft, head);
        let drawn = |part, form| Drawn { form, role: mark.role, part, node: mark.node };
        let part = if length < FINE && is_way(mark.role) { Part::FineEdge } else { Part::Edge };
        let line = drawn(part, Form::Polyline(shaft));
        let head = drawn(Part::Head, Form::Polygon(head.to_vec()));
        if D == 3 && mark.role == Role::Ray && !self.is_apart {
            self.arrows.push(Arrow { ends, shaft: [start, neck], line, head });
        } else {
            let order = above_space(mark.role);
            if mark.role.has_casing() && line.part == Part::Edge {
                let casing = Drawn { part: Part::Casing, ..line.clone() };
                self.drawn.push((order, casing));
            }
            self.drawn.extend([(order, line), (order, head)]);
        }
    }
}

/// To which side of their straight lines ways bend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bend {
    Left,
    Right,
}

impl Bend {
    /// Away from the direction that is asked for, by the first way.
    pub(super) fn of<'a, const D: usize>(
        marks: impl Iterator<Item = &'a Mark<D>> + Clone,
        camera: &Camera<D>,
        page: Page,
    ) -> Self {
        let first = |is_meant: fn(Role) -> bool| {
            let ends = marks.clone().find_map(|mark| match mark.shape {
                Shape::Arrow(ends) if is_meant(mark.role) => Some(ends),
                _ => None,
            });
            ends.and_then(|ends| camera.project_segment(page, ends))
        };
        let arrows = first(|role| role == Role::Direction).zip(first(is_way));
        let Some((asked, way)) = arrows else { return Self::Right };
        let [asked, way] = [asked, way].map(|ends| ends.map(|end| end.at));
        let right = right_of(way);
        let off = (0..2).map(|e| right[e] * (asked[1][e] - asked[0][e])).sum::<f64>();
        let least = 1e-6 * distance(way[0], way[1]) * distance(asked[0], asked[1]);
        if off > least { Self::Left } else { Self::Right }
    }
}

/// Across a line, to its right and as long.
fn right_of([from, to]: [[f64; 2]; 2]) -> [f64; 2] {
    [from[1] - to[1], to[0] - from[0]]
}

/// An arrow on the page: its line and, beyond that, its head, the tip first.
struct OnPage {
    shaft: Vec<[f64; 2]>,
    head: [[f64; 2]; 3],
}

fn straight([from, to]: [[f64; 2]; 2]) -> OnPage {
    let length = distance(from, to);
    let neck = between([to, from], head_of(length) / length);
    OnPage { shaft: vec![from, neck], head: head([neck, to]) }
}

/// An arrow that bends away from the straight line: one that leads back, and the direction
/// that is asked for, lie beside it.
fn bow([from, to]: [[f64; 2]; 2], bend: Bend) -> OnPage {
    const PIECES: u32 = 8;
    let length = distance(from, to);
    let by = match bend {
        Bend::Right => 2.0 * bend_of(length) / length,
        Bend::Left => -2.0 * bend_of(length) / length,
    };
    let (middle, right) = (between([from, to], 0.5), right_of([from, to]));
    let pole: [f64; 2] = std::array::from_fn(|e| middle[e] + by * right[e]);
    let at =
        |share: f64| between([between([from, pole], share), between([pole, to], share)], share);
    let neck = 1.0 - 0.5 * head_of(length) / distance(pole, to);
    let shaft = (0..=PIECES).map(|n| at(neck * f64::from(n) / f64::from(PIECES)));
    OnPage { shaft: shaft.collect(), head: head([at(neck), to]) }
}

/// How far the middle of a way lies from the straight line: a short one more, in shares of
/// its length, so that two lines have room.
fn bend_of(length: f64) -> f64 {
    const LEAST: f64 = 7.0;
    const MOST: f64 = 24.0;
    (0.17 * length).clamp(LEAST.min(0.27 * length), MOST)
}

/// Length of the head of an arrow.
fn head_of(length: f64) -> f64 {
    /// The head takes no more than this share.
    const MOST: f64 = 0.3;
    HEAD.min(MOST * length)
}

/// The head on a neck, the tip first.
fn head([neck, tip]: [[f64; 2]; 2]) -> [[f64; 2]; 3] {
    /// Half its width, of its length: a short one is wider, as its line is not shorter.
    const HALF_WIDTH: f64 = 5.0 / HEAD;
    const OF_SHORT: f64 = 0.5;
    let length = distance(neck, tip);
    let half_width = (HALF_WIDTH * length).max(3.0_f64.min(OF_SHORT * length)) / length;
    let wing = |side: f64| {
        let across = [neck[1] - tip[1], tip[0] - neck[0]];
        std::array::from_fn(|e| neck[e] + side * half_width * across[e])
    };
    [tip, wing(1.0), wing(-1.0)]
}

fn between([from, to]: [[f64; 2]; 2], share: f64) -> [f64; 2] {
    std::array::from_fn(|e| from[e] + share * (to[e] - from[e]))
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
