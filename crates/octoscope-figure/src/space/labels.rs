//! Where the letters and numbers of a scene stand.

use super::{Canvas, LEGIBLE, SMALL, above_space, distance};
use crate::camera::{clipped, corners};
use crate::figure::text_reach;
use crate::numbers::distance_to_segment;
use crate::{Anchor, Drawn, Extent, Form, Mark, Part, Role, Shape};
use octoscope_core::geometry::Aabb;

impl<const D: usize> Canvas<'_, D> {
    pub(super) fn write(&mut self, mark: &Mark<D>) {
        let Some(text) = &mark.text else {
            return;
        };
        let place = |world| self.camera.project(self.page, world).map(|p| p.at);
        match mark.shape {
            Shape::Label(at) => {
                let reach = text_reach(mark.role, text);
                let candidates = place(at).into_iter().flat_map(|[x, y]| {
                    [[0.0, 0.0], [0.0, -1.0], [0.0, 1.0], [1.0, 0.0], [-1.0, 0.0]]
                        .map(|[i, j]| [x + 1.6 * i * reach[0], y + 1.6 * j * reach[1]])
                });
                if let Some(at) = self.room(candidates, reach) {
                    self.text(mark, at, text);
                }
            }
            Shape::LabelIn { bounds, .. } if mark.role != Role::ChildIndex => {
                self.write_code(mark, &bounds, text);
            }
            Shape::Plane { axis, bounds } => {
                // A letter beside a small plane would hide what it names.
                let [width, height] = self.extent(&bounds);
                if width.max(height) < if D == 2 { SMALL } else { LEGIBLE } {
                    return;
                }
                let bounds = self.overhanging(mark.role, &bounds, axis);
                // Beyond a corner of the plane, the lowest on the page first, or as far
                // beyond one of its sides.
                let reach = text_reach(mark.role, text);
                let Some(middle) = place(bounds.centre()) else {
                    return;
                };
                let mut ends: Vec<_> = corners(&bounds).filter_map(place).collect();
                ends.sort_by(|a, b| b[1].total_cmp(&a[1]).then(b[0].total_cmp(&a[0])));
                ends.dedup();
                let candidates = [5.0, 16.0].into_iter().flat_map(|gap| {
                    ends.iter().map(move |end| {
                        let length = distance(*end, middle).max(1e-9);
                        std::array::from_fn(|e| {
                            end[e] + (end[e] - middle[e]) / length * (reach[e] + gap)
                        })
                    })
                });
                let candidates: Vec<[f64; 2]> = candidates.collect();
                if let Some(at) = self.clearest(candidates, reach) {
                    self.text(mark, at, text);
                }
            }
            Shape::Segment(ends) => self.write_beside(mark, ends, text),
            Shape::Box(_)
            | Shape::Arrow(_)
            | Shape::Point(_)
            | Shape::Tip(_)
            | Shape::Sphere { .. }
            | Shape::CutSphere { .. }
            | Shape::Triangle(_)
            | Shape::LabelIn { .. }
            | Shape::LabelAlong(_) => {}
        }
    }

    /// The place with room where a label covers the fewest lines, the first of such.
    pub(super) fn clearest(
        &mut self,
        places: impl IntoIterator<Item = [f64; 2]>,
        reach: [f64; 2],
    ) -> Option<[f64; 2]> {
        let mut places: Vec<_> = places.into_iter().collect();
        places.sort_by_cached_key(|at| self.n_covered(*at, reach));
        self.room(places, reach)
    }

    /// Writes beside a line on the rim of the scene, outside and near its end, or
    /// as far before it as there is room.
    fn write_beside(&mut self, mark: &Mark<D>, ends: [[f64; D]; 2], text: &str) {
        const GAP: f64 = 5.0;
        const LEAST: f64 = 16.0;
        let Some([from, to]) = self.camera.visible_segment(self.page, ends) else { return };
        let length = distance(from, to);
        if length < LEAST {
            return;
        }
        let along: [f64; 2] = std::array::from_fn(|e| (to[e] - from[e]) / length);
        let across = [-along[1], along[0]];
        let outwards: f64 = (0..2).map(|e| across[e] * (from[e] - self.middle[e])).sum();
        let across = across.map(|x| x * outwards.signum());
        let reach = text_reach(mark.role, text);
        let away = GAP + (0..2).map(|e| across[e].abs() * reach[e]).sum::<f64>();
        let places = [0.0, 0.12, 0.25, 0.4, 0.55].map(|before| {
            let before = reach[0].max(before * length);
            std::array::from_fn(|e| to[e] - before * along[e] + away * across[e])
        });
        let on_page = places.into_iter().filter(|at| self.is_on_page(*at, reach));
        // Where two axes end in one corner, their names would be taken for each other's.
        let (beside_others, apart): (Vec<_>, Vec<_>) =
            on_page.partition(|at| self.is_at_another_axis(mark.role, *at));
        let at = self.clearest(apart, reach).or_else(|| self.clearest(beside_others, reach));
        if let Some(at) = at {
            self.text(mark, at, text);
        }
    }

    /// Whether a name stands so near to another axis that it could be taken for that one's.
    fn is_at_another_axis(&self, role: Role, at: [f64; 2]) -> bool {
        const NEAR: f64 = 20.0;
        let others = self.axes.iter().filter(|(axis, _)| role != Role::AxisLabel(*axis));
        others.into_iter().any(|(_, line)| distance_to_segment(at, *line) < NEAR)
    }

    pub(super) fn is_on_page(&self, at: [f64; 2], reach: [f64; 2]) -> bool {
        let page = [self.page.width, self.page.height];
        (0..2).all(|e| (reach[e]..=page[e] - reach[e]).contains(&at[e]))
    }

    /// Whether a label would cover a line that has to be seen.
    pub(super) fn strikes(&self, at: [f64; 2], reach: [f64; 2]) -> bool {
        let area = [-1.0, 1.0].map(|sign| std::array::from_fn(|e| at[e] + sign * reach[e]));
        self.kept.iter().any(|line| clipped(*line, area).is_some())
    }

    /// Number of lines and points that a label would cover.
    pub(super) fn n_covered(&self, at: [f64; 2], reach: [f64; 2]) -> usize {
        const ROOM: f64 = 1.5;
        let corner = |sign: f64| std::array::from_fn(|e| at[e] + sign * (reach[e] + ROOM));
        let area = [corner(-1.0), corner(1.0)];
        self.spared.iter().filter(|line| clipped(**line, area).is_some()).count()
    }

    /// Width and height of a box on the page.
    pub(super) fn extent(&self, bounds: &Aabb<D>) -> [f64; 2] {
        let on_page = corners(bounds).filter_map(|c| Some(self.camera.project(self.page, c)?.at));
        Extent::around(on_page).map_or([0.0; 2], Extent::size)
    }

    /// Letters of planes lie on lines and points, on ground of their own.
    pub(super) fn text(&mut self, mark: &Mark<D>, at: [f64; 2], text: &str) {
        if matches!(mark.role, Role::MidPlane(_) | Role::ExitPlane(_)) {
            let [half_width, half_height] = text_reach(mark.role, text);
            let form = rectangle(at, [half_width + 2.0, half_height]);
            let (role, part) = (Role::Ground, Part::Face(0));
            let halo = Drawn { form, role, part, node: mark.node };
            self.drawn.push((above_space(mark.role), halo));
        }
        let form = Form::Text { at, anchor: Anchor::Middle, text: text.into() };
        self.push_at(above_space(mark.role), mark, Part::Whole, form);
    }

    /// The first of some places where a label covers nothing; from then on it
    /// is taken.
    pub(super) fn room(
        &mut self,
        places: impl IntoIterator<Item = [f64; 2]>,
        reach: [f64; 2],
    ) -> Option<[f64; 2]> {
        let at = places.into_iter().find(|at| self.is_free(*at, reach))?;
        self.taken.push([at, reach]);
        Some(at)
    }

    /// Whether a label would cover nothing that it may not cover.
    pub(super) fn is_free(&self, at: [f64; 2], reach: [f64; 2]) -> bool {
        !self
            .taken
            .iter()
            .any(|[other, extent]| (0..2).all(|e| (at[e] - other[e]).abs() < reach[e] + extent[e]))
    }
}

/// A rectangle around a place.
pub(super) fn rectangle([x, y]: [f64; 2], [wide, high]: [f64; 2]) -> Form {
    let corners = [[-wide, -high], [wide, -high], [wide, high], [-wide, high]];
    Form::Polygon(corners.map(|[dx, dy]| [x + dx, y + dy]).to_vec())
}
