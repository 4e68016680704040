//! What a picture is made of: immutable, uploaded once.

use super::camera::World;
use super::{BoxMark, Cell, Grid, instance, mesh};
use eframe::egui::Color32;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Part of a picture. Clones are cheap and count as the same layer; a layer
/// made anew is a new one, even of the same parts.
#[derive(Clone, Debug)]
pub struct Layer {
    id: u64,
    data: Arc<Data>,
}

/// How the cells of one style look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxStyle {
    /// Colour of the faces; transparent for none. Opaque faces hide what is
    /// behind them.
    pub fill: Color32,
    /// Colour of the edges; transparent for none.
    pub edge: Color32,
    /// Width of the edges in points.
    pub width: f32,
}

/// Layers as they are drawn.
#[derive(Debug)]
pub(super) enum Data {
    /// Cells of an octree.
    Boxes { grid: Grid, styles: Vec<BoxStyle>, edges: Instances, faces: Instances },
    /// Cells of a quadtree, each with a colour.
    Cells { grid: Grid, edge: Color32, width: f32, cells: Instances, colours: Vec<Color32> },
    /// Boxes that stand out; in space only.
    Marks(Vec<BoxMark>),
    /// Round dots of one radius in points, relative to an origin.
    Points { origin: World, points: Vec<[f32; 3]>, colour: Color32, radius: f32 },
    /// Corners of triangles, relative to an origin, with their normals.
    Triangles { origin: World, corners: Vec<mesh::Corner>, colour: Color32 },
    /// Centres, relative to an origin, and radii.
    Spheres { origin: World, spheres: Vec<[f32; 4]>, colour: Color32 },
}

/// Packed codes in groups.
#[derive(Debug, Default)]
pub(super) struct Instances {
    pub packed: Vec<instance::Packed>,
    pub groups: Vec<instance::Group>,
}

impl From<(Vec<instance::Packed>, Vec<instance::Group>)> for Instances {
    fn from((packed, groups): (Vec<instance::Packed>, Vec<instance::Group>)) -> Self {
        Self { packed, groups }
    }
}

impl Layer {
    /// Cells of an octree; `style` of a cell is an index into `styles`.
    /// Edges fade with the distance and where they shrink to a few pixels.
    ///
    /// # Panics
    /// Panics if a cell has no style.
    pub fn boxes(grid: Grid, cells: &[Cell], styles: &[BoxStyle]) -> Self {
        let with = |wanted: fn(&BoxStyle) -> bool| -> Vec<Cell> {
            cells.iter().filter(|cell| wanted(&styles[usize::from(cell.style)])).copied().collect()
        };
        let outlined = with(|style| style.edge != Color32::TRANSPARENT && style.width > 0.0);
        let filled = with(|style| style.fill != Color32::TRANSPARENT);
        Self::new(Data::Boxes {
            grid,
            styles: styles.to_vec(),
            edges: instance::edges(&outlined).into(),
            faces: instance::cells(&filled).into(),
        })
    }

    /// The outlines of the faces of cells at their lower ends on an axis.
    pub fn faces_across(grid: Grid, axis: usize, cells: &[Cell], styles: &[BoxStyle]) -> Self {
        Self::new(Data::Boxes {
            grid,
            styles: styles.to_vec(),
            edges: instance::face_edges(cells, axis).into(),
            faces: Instances::default(),
        })
    }

    /// Cells of a quadtree, each with the colour of its area; `width` in points
    /// and `edge` are the lines between them, none if the width is 0. The style
    /// of a cell is not asked for.
    pub fn cells(grid: Grid, cells: &[(Cell, Color32)], edge: Color32, width: f32) -> Self {
        let mut sorted: Vec<_> =
            cells.iter().map(|&(cell, colour)| (Cell { style: 0, ..cell }, colour)).collect();
        // Coarse levels first, as the groups are.
        sorted.sort_unstable_by_key(|&(cell, _)| (u8::MAX - cell.level, cell.code));
        sorted.dedup_by_key(|(cell, _)| *cell);
        let (cells, colours): (Vec<_>, Vec<_>) = sorted.into_iter().unzip();
        let cells = instance::cells(&cells).into();
        Self::new(Data::Cells { grid, edge, width, cells, colours })
    }

    /// Boxes that stand out, translucent and in the right order from any side.
    pub fn marks(marks: Vec<BoxMark>) -> Self {
        Self::new(Data::Marks(marks))
    }

    /// Round dots of `radius` points at these places in world units.
    pub fn points(points: &[World], colour: Color32, radius: f32) -> Self {
        let origin = middle(bounds(points.iter().copied()));
        let points = points.iter().map(|&point| offset(point, origin)).collect();
        Self::new(Data::Points { origin, points, colour, radius })
    }

    /// Triangles, lit from both sides; flat, without common normals.
    pub fn triangles(triangles: &[[World; 3]], colour: Color32) -> Self {
        let origin = middle(bounds(triangles.iter().flatten().copied()));
        let offsets = |triangle: &[World; 3]| triangle.map(|corner| offset(corner, origin));
        let triangles: Vec<_> = triangles.iter().map(offsets).collect();
        Self::new(Data::Triangles { origin, corners: mesh::corners(&triangles), colour })
    }

    /// Spheres: x, y, z of the centre and the radius, in world units.
    pub fn spheres(spheres: &[[f64; 4]], colour: Color32) -> Self {
        let reach = |&[x, y, z, radius]: &[f64; 4]| {
            [-radius, radius].map(|away| [x + away, y + away, z + away])
        };
        let origin = middle(bounds(spheres.iter().flat_map(reach)));
        let spheres: Vec<[f32; 4]> = spheres
            .iter()
            .map(|&[x, y, z, radius]| {
                let [x, y, z] = offset([x, y, z], origin);
                [x, y, z, radius as f32]
            })
            .collect();
        Self::new(Data::Spheres { origin, spheres, colour })
    }

    /// The same or a coarser layer that takes no more than about so many vertices: of
    /// many points, triangles and spheres an even choice. Layers of cells stay as they
    /// are.
    pub fn within(&self, most_vertices: usize) -> Self {
        match &*self.data {
            Data::Points { origin, points, colour, radius } if points.len() * 6 > most_vertices => {
                let points = one_in(points, most_vertices / 6);
                let (origin, colour, radius) = (*origin, *colour, *radius);
                Self::new(Data::Points { origin, points, colour, radius })
            }
            Data::Triangles { origin, corners, colour } if corners.len() > most_vertices => {
                let triangles: Vec<&[mesh::Corner]> = corners.chunks_exact(3).collect();
                let corners = one_in(&triangles, most_vertices / 3).concat();
                Self::new(Data::Triangles { origin: *origin, corners, colour: *colour })
            }
            Data::Spheres { origin, spheres, colour } if spheres.len() * 6 > most_vertices => {
                let spheres = one_in(spheres, most_vertices / 6);
                Self::new(Data::Spheres { origin: *origin, spheres, colour: *colour })
            }
            Data::Points { .. }
            | Data::Triangles { .. }
            | Data::Spheres { .. }
            | Data::Boxes { .. }
            | Data::Cells { .. }
            | Data::Marks(_) => self.clone(),
        }
    }

    /// Number that no other layer has.
    pub(super) fn id(&self) -> u64 {
        self.id
    }

    pub(super) fn data(&self) -> &Data {
        &self.data
    }

    fn new(data: Data) -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        Self { id: NEXT.fetch_add(1, Ordering::Relaxed), data: Arc::new(data) }
    }
}

/// Lowest and highest corner of a box around points; all 0 around none.
fn bounds(points: impl Iterator<Item = World>) -> [World; 2] {
    let around = |[min, max]: [World; 2], point: World| {
        let corner =
            |of: World, pick: fn(f64, f64) -> f64| std::array::from_fn(|e| pick(of[e], point[e]));
        [corner(min, f64::min), corner(max, f64::max)]
    };
    points.map(|point| [point; 2]).reduce(|all, [point, _]| around(all, point)).unwrap_or_default()
}

fn middle([min, max]: [World; 2]) -> World {
    std::array::from_fn(|e| min[e] + 0.5 * (max[e] - min[e]))
}

fn offset(point: World, origin: World) -> [f32; 3] {
    std::array::from_fn(|e| (point[e] - origin[e]) as f32)
}

/// At most `most` of the items, evenly chosen.
fn one_in<T: Clone>(items: &[T], most: usize) -> Vec<T> {
    items.iter().step_by(items.len().div_ceil(most.max(1)).max(1)).cloned().collect()
}

impl PartialEq for Layer {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}
