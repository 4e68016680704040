//! What lies below the marks of an octree: the lines of its empty leaves, the
//! surface of its full leaves, and the solids in them; only what can be seen.

mod ball;

use crate::camera::corners;
use crate::depth_map::DepthMap;
use crate::painter::{Half, Painted, back_to_front};
use crate::sides::sides_to_eye;
use crate::{Camera, Drawn, Form, Mark, Page, Part, Projected, Role, Shape};
use octoscope_core::geometry::Aabb;
use octoscope_core::tree::NodeId;
use std::collections::{BTreeMap, HashSet};

/// Whether a mark of an octree belongs to the ground.
pub(crate) fn is_ground<const D: usize>(mark: &Mark<D>) -> bool {
    let is_cell = matches!(
        mark.role,
        Role::EmptyLeaf | Role::FullLeaf | Role::Pixel(_) | Role::InnerNode | Role::FaintNode
    );
    let is_in_it = matches!(mark.role, Role::Solid | Role::EmptySection | Role::FullSection)
        || mark.role == Role::FaintNode && matches!(mark.shape, Shape::Plane { .. });
    D == 3 && (is_cell && matches!(mark.shape, Shape::Box(_)) || is_in_it)
}

/// Draws the marks of the ground in a tree over `root`, the lowest first:
/// lines, leaves, solids, sections. Full leaves and solids are opaque; solids are
/// drawn over the leaves that hold them, and sections over all that is behind them.
pub(crate) fn ground<const D: usize>(
    marks: &[&Mark<D>],
    root: &Aabb<D>,
    camera: &Camera<D>,
    page: Page,
) -> Vec<Drawn> {
    // A depth map is as large as the page.
    if marks.is_empty() {
        return Vec::new();
    }
    let view = View { camera, page, root };
    let of = |role: Role| marks.iter().filter(move |mark| mark.role == role).copied();
    let boxes = |role: Role| {
        of(role).filter_map(|mark| match mark.shape {
            Shape::Box(bounds) => Some((bounds, mark.node)),
            _ => None,
        })
    };
    let mut drawn = Vec::new();
    for role in [Role::FaintNode, Role::InnerNode, Role::EmptyLeaf] {
        drawn.extend(view.lines(&boxes(role).map(|(b, _)| b).collect::<Vec<_>>(), role));
    }
    let solids: Vec<Area<D>> = of(Role::Solid).flat_map(|mark| view.solid(mark)).collect();
    let mut map = DepthMap::of(root, camera, page);
    solids.iter().for_each(|area| map.add(&area.polygon));
    drawn.extend(view.leaves(&boxes(Role::FullLeaf).collect::<Vec<_>>(), &map));
    drawn.extend(
        view.painted(solids, Role::Solid, |area| {
            !area.round.is_empty() || map.shows(&area.polygon)
        }),
    );
    drawn.extend(
        [Role::FaintNode, Role::EmptySection, Role::FullSection]
            .into_iter()
            .flat_map(of)
            .filter_map(|mark| view.section(mark)),
    );
    drawn
}

/// A flat area that hides what is behind it, or something round.
struct Area<const D: usize> {
    bounds: Aabb<D>,
    polygon: Vec<Projected>,
    light: u8,
    /// What is drawn of something round, instead of a polygon, and its light.
    round: Vec<(Form, u8)>,
    node: Option<NodeId>,
}

struct View<'a, const D: usize> {
    camera: &'a Camera<D>,
    page: Page,
    root: &'a Aabb<D>,
}

impl<const D: usize> View<'_, D> {
    /// Edges of boxes, each piece of a line once.
    fn lines(&self, boxes: &[Aabb<D>], role: Role) -> Vec<Drawn> {
        let grid = Grid::finest(self.root);
        let mut lines: BTreeMap<(usize, [i64; D]), Vec<[i64; 2]>> = BTreeMap::new();
        for bounds in boxes {
            let [min, max] = [bounds.min, bounds.max].map(|p| grid.place(p));
            for axis in 0..D {
                for corner in (0..1usize << D).filter(|corner| corner >> axis & 1 == 0) {
                    let line = std::array::from_fn(|e| match (e == axis, corner >> e & 1) {
                        (true, _) => 0,
                        (false, 0) => min[e],
                        (false, _) => max[e],
                    });
                    lines.entry((axis, line)).or_default().push([min[axis], max[axis]]);
                }
            }
        }
        let mut drawn = Vec::new();
        for ((axis, line), pieces) in lines {
            for ends in joined(pieces) {
                let ends = ends.map(|end| {
                    let place = std::array::from_fn(|e| if e == axis { end } else { line[e] });
                    grid.world(place)
                });
                if let Some(line) = self.camera.project_segment(self.page, ends) {
                    let form = Form::Polyline(line.map(|p| p.at).to_vec());
                    drawn.push(Drawn { form, role, part: Part::Edge, node: None });
                }
            }
        }
        drawn
    }

    /// Sides of full leaves that are neither turned away, nor covered by a
    /// neighbour, nor behind other leaves or `solids`.
    fn leaves(&self, leaves: &[(Aabb<D>, Option<NodeId>)], solids: &DepthMap) -> Vec<Drawn> {
        // What a slice has left of a leaf is no cube; whether it is covered is not asked.
        let is_cube = |bounds: &Aabb<D>| {
            let size = bounds.size();
            size.iter().all(|side| (side / size[0] - 1.0).abs() < 1e-9)
        };
        let boxes = leaves.iter().map(|(bounds, _)| *bounds).filter(is_cube);
        let boxes: Vec<Aabb<D>> = boxes.collect();
        let grid = Grid::of(&boxes, self.root).unwrap_or_else(|| Grid::finest(self.root));
        let full: HashSet<_> = boxes.iter().map(|bounds| grid.cell(bounds)).collect();
        let mut areas = Vec::new();
        for (bounds, node) in leaves {
            for side in sides_to_eye(self.camera, self.page, bounds) {
                let (level, mut beyond) = grid.cell(bounds);
                beyond[side.axis] += if side.is_upper { 1 << level } else { -1 };
                let is_covered = is_cube(bounds)
                    && (level..64)
                        .map(|level| (level, beyond.map(|c| c >> level << level)))
                        .take(grid.n_levels)
                        .any(|cell| full.contains(&cell));
                if !is_covered {
                    let light = self.light(side.normal());
                    let polygon = side.polygon;
                    let (bounds, node, round) = (*bounds, *node, Vec::new());
                    areas.push(Area { bounds, polygon, light, round, node });
                }
            }
        }
        let mut map = DepthMap::of(self.root, self.camera, self.page);
        areas.iter().for_each(|area| map.add(&area.polygon));
        let is_seen = |area: &Area<D>| map.shows(&area.polygon) && solids.is_bare(&area.polygon);
        self.painted(areas, Role::FullLeaf, is_seen)
    }

    /// Where a slice meets a cell.
    fn section(&self, mark: &Mark<D>) -> Option<Drawn> {
        let Shape::Plane { axis, bounds } = mark.shape else { return None };
        let corners: Vec<[f64; D]> = corners(&bounds).collect();
        let upper = 1usize << (D - 1 - axis);
        let own = (0..1 << D).filter(|corner| corner & upper == 0).map(|corner| corners[corner]);
        let project = |p| Some(self.camera.project(self.page, p)?.at);
        let at: Option<Vec<_>> = own.map(project).collect();
        let at = at?;
        let turn = [0, 1, 3, 2].iter().filter_map(|&i| at.get(i).copied()).collect();
        let form = Form::Polygon(turn);
        Some(Drawn { form, role: mark.role, part: Part::Whole, node: mark.node })
    }

    /// Areas of a solid that may be seen.
    fn solid(&self, mark: &Mark<D>) -> Vec<Area<D>> {
        let project = |p| self.camera.project(self.page, p);
        let node = mark.node;
        match mark.shape {
            Shape::Box(bounds) => {
                let sides = sides_to_eye(self.camera, self.page, &bounds).into_iter();
                sides
                    .map(|side| {
                        let light = self.light(side.normal());
                        Area { bounds, polygon: side.polygon, light, round: Vec::new(), node }
                    })
                    .collect()
            }
            Shape::Triangle(points) => {
                let polygon: Option<Vec<_>> = points.into_iter().map(project).collect();
                let bounds = Aabb::around(points);
                let (Some(polygon), Some(bounds)) = (polygon, bounds) else { return Vec::new() };
                let light = self.light(normal(points));
                vec![Area { bounds, polygon, light, round: Vec::new(), node }]
            }
            Shape::Sphere { centre, radius } => {
                let round = self.ball(centre, radius).unwrap_or_default();
                vec![area_of(round, centre, node)]
            }
            Shape::CutSphere { centre, radius, cut } => {
                let round = self.cut_ball(centre, radius, &cut).unwrap_or_default();
                // It lies behind the plane, where its middle may not.
                let mut place = centre;
                if !cut.keeps(&place) {
                    place[cut.axis] = cut.at;
                }
                vec![area_of(round, place, node)]
            }
            Shape::Segment(_)
            | Shape::Arrow(_)
            | Shape::Point(_)
            | Shape::Tip(_)
            | Shape::Plane { .. }
            | Shape::Label(_)
            | Shape::LabelIn { .. }
            | Shape::LabelAlong(_) => Vec::new(),
        }
    }

    /// The areas that are seen, the farthest first.
    fn painted(
        &self,
        areas: Vec<Area<D>>,
        role: Role,
        is_seen: impl Fn(&Area<D>) -> bool,
    ) -> Vec<Drawn> {
        let areas: Vec<Area<D>> = areas.into_iter().filter(is_seen).collect();
        let boxes: Vec<Aabb<D>> = areas.iter().map(|area| area.bounds).collect();
        let mut drawn = Vec::new();
        for next in back_to_front(self.root, &boxes, &[], self.camera) {
            let index = match next {
                Painted::Half(index, Half::Front) => index,
                // A flat one is drawn whole, in the place of its middle.
                Painted::Flat(index, part) if holds(&part, boxes[index].centre()) => index,
                Painted::Half(_, Half::Behind) | Painted::Flat(..) | Painted::Piece(..) => continue,
            };
            let Area { polygon, round, light, node, .. } = &areas[index];
            let mut draw = |form, light| {
                drawn.push(Drawn { form, role, part: Part::Lit(light), node: *node });
            };
            if round.is_empty() {
                draw(Form::Polygon(polygon.iter().map(|p| p.at).collect()), *light);
            }
            round.iter().for_each(|(form, light)| draw(form.clone(), *light));
        }
        drawn
    }

    /// How much light falls on an area with this normal, from either side:
    /// 0 … [`Part::MOST_LIGHT`].
    fn light(&self, normal: [f64; D]) -> u8 {
        let [right, up, back] = self.camera.basis();
        let (mut along, mut square, mut light_square) = (0.0, 0.0, 0.0);
        for e in 0..D {
            let light = -0.45 * right[e] + 0.75 * up[e] + 0.6 * back[e];
            along += normal[e] * light;
            square += normal[e] * normal[e];
            light_square += light * light;
        }
        let share = (along.abs() / (square * light_square).sqrt().max(f64::MIN_POSITIVE)).min(1.0);
        (share * f64::from(Part::MOST_LIGHT)).round() as u8
    }
}

/// Something round at a place in space.
fn area_of<const D: usize>(
    round: Vec<(Form, u8)>,
    place: [f64; D],
    node: Option<NodeId>,
) -> Area<D> {
    let bounds = Aabb { min: place, max: place };
    Area { bounds, polygon: Vec::new(), light: 0, round, node }
}

/// Grid of the smallest of some boxes of a tree.
struct Grid<const D: usize> {
    min: [f64; D],
    cell: f64,
    n_levels: usize,
}

impl<const D: usize> Grid<D> {
    /// Finer than every tree.
    fn finest(root: &Aabb<D>) -> Self {
        const LEVELS: i32 = 24;
        let cell = root.size()[0] * 0.5f64.powi(LEVELS);
        Self { min: root.min, cell, n_levels: LEVELS as usize + 1 }
    }

    fn of(boxes: &[Aabb<D>], root: &Aabb<D>) -> Option<Self> {
        let cell = boxes.iter().map(|bounds| bounds.size()[0]).reduce(f64::min)?;
        let n_levels = (root.size()[0] / cell).log2().round().max(0.0) as usize + 1;
        Some(Self { min: root.min, cell, n_levels })
    }

    fn place(&self, point: [f64; D]) -> [i64; D] {
        std::array::from_fn(|e| ((point[e] - self.min[e]) / self.cell).round() as i64)
    }

    fn world(&self, place: [i64; D]) -> [f64; D] {
        std::array::from_fn(|e| self.min[e] + place[e] as f64 * self.cell)
    }

    /// Level of a box above the smallest, and its place.
    fn cell(&self, bounds: &Aabb<D>) -> (u32, [i64; D]) {
        let level = (bounds.size()[0] / self.cell).log2().round().clamp(0.0, 40.0);
        (level as u32, self.place(bounds.min))
    }
}

/// The same pieces of a line without overlaps, as few as possible.
fn joined(mut pieces: Vec<[i64; 2]>) -> Vec<[i64; 2]> {
    pieces.sort_unstable();
    let mut joined: Vec<[i64; 2]> = Vec::new();
    for [from, to] in pieces {
        match joined.last_mut() {
            Some(last) if from <= last[1] => last[1] = last[1].max(to),
            Some(_) | None => joined.push([from, to]),
        }
    }
    joined
}

fn normal<const D: usize>([a, b, c]: [[f64; D]; 3]) -> [f64; D] {
    let [u, v]: [[f64; D]; 2] = [b, c].map(|p| std::array::from_fn(|e| p[e] - a[e]));
    std::array::from_fn(|e| {
        let [f, g] = [(e + 1) % D, (e + 2) % D];
        u[f] * v[g] - u[g] * v[f]
    })
}

/// Whether a part of a flat box is the one that holds a point.
fn holds<const D: usize>(part: &Aabb<D>, point: [f64; D]) -> bool {
    (0..D).all(|e| point[e] >= part.min[e] && (point[e] < part.max[e] || point[e] == part.min[e]))
}

/// Box around some marks.
pub(crate) fn bounds_of<const D: usize>(marks: &[&Mark<D>]) -> Option<Aabb<D>> {
    let boxes = marks.iter().filter_map(|mark| match mark.shape {
        Shape::Box(bounds) => Some(bounds),
        _ => None,
    });
    Aabb::around(boxes.flat_map(|bounds| corners(&bounds).collect::<Vec<_>>()))
}
