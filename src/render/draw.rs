//! From a picture to draw calls: what is drawn, in which order, with which
//! numbers.

use super::camera::{self, Plane, Space, View, World};
use super::instance::{Grid, Group};
use super::layer::{Data, Layer};
use eframe::egui::Color32;
use glam::{Mat4, Vec4};
use std::ops::Range;

/// Share of a line's colour that is lost from the near to the far end.
const FADING: f32 = 0.6;

/// Cells that project smaller than this many pixels have no lines.
const SMALLEST: f32 = 2.0;

/// What a draw call knows; laid out as `Draw` in `draw.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(super) struct Uniform {
    pub clip_from_offset: [[f32; 4]; 4],
    pub eye: [f32; 4],
    pub fade: [f32; 4],
    pub viewport: [f32; 4],
    pub grid: [f32; 4],
    pub fill: [f32; 4],
    pub edge: [f32; 4],
    pub shape: [f32; 4],
    pub reference: [i32; 4],
    pub slice: [f32; 4],
}

/// Which pipeline draws a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    Cells,
    OpaqueFaces,
    ClearFaces,
    Edges,
    Points,
    Triangles,
    Spheres,
    Marks,
}

/// One draw call on the buffers of a layer.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Call {
    /// Number of the layer in the picture.
    pub layer: usize,
    pub kind: Kind,
    pub uniform: Uniform,
    /// Instances, or triangles; what marks there are is one.
    pub instances: Range<u32>,
}

impl Call {
    /// Vertices of an instance or triangle; of marks, as if there were one.
    pub fn vertices(&self) -> u32 {
        match self.kind {
            Kind::Cells | Kind::Edges | Kind::Points | Kind::Spheres | Kind::Marks => 6,
            Kind::OpaqueFaces | Kind::ClearFaces => 18,
            Kind::Triangles => 3,
        }
    }
}

/// Vertices of all calls: what a picture costs where a processor draws it.
pub(super) fn n_vertices(calls: &[Call]) -> u64 {
    calls.iter().map(|call| call.instances.len() as u64 * u64::from(call.vertices())).sum()
}

/// The draw calls of a picture: what hides first, then what shines through,
/// marks last. Layers for the other kind of view are left out. Of all but the
/// marks, what lies before the `slice` is left out.
pub(super) fn calls(
    view: &View,
    slice: [f64; 4],
    layers: &[Layer],
    size: [u32; 2],
    pixels_per_point: f32,
) -> Vec<Call> {
    let mut calls = Vec::new();
    for (index, layer) in layers.iter().enumerate() {
        let mut push = |kind, uniform, instances| {
            calls.push(Call { layer: index, kind, uniform, instances });
        };
        match (view, layer.data()) {
            (View::Plane(plane), Data::Cells { grid, edge, width, cells, .. }) => {
                let (origin, reference, cell) = plane_grid(plane, grid, size, pixels_per_point);
                for group in &cells.groups {
                    let mut uniform = blank(&NOWHERE, size, pixels_per_point);
                    uniform.grid = [origin[0], origin[1], 0.0, cell];
                    uniform.reference = [reference[0], reference[1], 0, 0];
                    uniform.edge = colour(*edge);
                    uniform.shape = [side(group), (width * pixels_per_point).ceil(), 0.0, 0.0];
                    push(Kind::Cells, uniform, group.range.clone());
                }
            }
            (View::Space(space), Data::Boxes { grid, styles, edges, faces }) => {
                let base = in_space(space, grid, size, pixels_per_point);
                for group in &faces.groups {
                    let fill = styles[usize::from(group.style)].fill;
                    // Finer levels lie a little deeper inside their box.
                    let inset =
                        0.002 * f32::from(grid.root_level - group.level.min(grid.root_level));
                    let shape = [side(group), 0.0, 0.0, inset];
                    let kind = if fill.is_opaque() { Kind::OpaqueFaces } else { Kind::ClearFaces };
                    push(kind, Uniform { fill: colour(fill), shape, ..base }, group.range.clone());
                }
                let pixels = pixels_per_unit(space, grid.bounds(), size);
                for group in &edges.groups {
                    if side(group) * grid.cell as f32 * pixels < SMALLEST {
                        continue;
                    }
                    let style = styles[usize::from(group.style)];
                    let width = style.width * pixels_per_point;
                    let shape = [side(group), width, f32::from(group.axis), 0.0];
                    let uniform = Uniform { edge: colour(style.edge), shape, ..base };
                    push(Kind::Edges, uniform, group.range.clone());
                }
            }
            (View::Space(space), Data::Marks(marks)) if !marks.is_empty() => {
                push(Kind::Marks, blank(space, size, pixels_per_point), 0..1);
            }
            (View::Space(space), Data::Points { origin, points, colour: fill, radius })
                if !points.is_empty() =>
            {
                let mut uniform = content(space, *origin, size, pixels_per_point);
                uniform.fill = colour(*fill);
                uniform.shape[1] = radius * pixels_per_point;
                push(Kind::Points, uniform, 0..points.len() as u32);
            }
            (View::Space(space), Data::Triangles { origin, corners, colour: fill })
                if !corners.is_empty() =>
            {
                let mut uniform = content(space, *origin, size, pixels_per_point);
                uniform.fill = colour(*fill);
                push(Kind::Triangles, uniform, 0..(corners.len() / 3) as u32);
            }
            (View::Space(space), Data::Spheres { origin, spheres, colour: fill })
                if !spheres.is_empty() =>
            {
                let mut uniform = content(space, *origin, size, pixels_per_point);
                uniform.fill = colour(*fill);
                push(Kind::Spheres, uniform, 0..spheres.len() as u32);
            }
            (View::Plane(_) | View::Space(_), _) => {}
        }
    }
    calls.sort_by_key(|call| order(call.kind));
    if let View::Space(space) = view {
        for call in calls.iter_mut().filter(|call| call.kind != Kind::Marks) {
            call.uniform.slice = space.plane(slice);
        }
    }
    calls
}

/// What hides comes first, then what shines through.
fn order(kind: Kind) -> u8 {
    match kind {
        Kind::OpaqueFaces | Kind::Points | Kind::Triangles | Kind::Spheres => 0,
        Kind::Cells | Kind::ClearFaces => 1,
        Kind::Edges => 2,
        Kind::Marks => 3,
    }
}

/// For views of the plane, which are not transformed.
const NOWHERE: Space = Space { origin: [0.0; 3], clip_from_offset: Mat4::IDENTITY };

fn blank(space: &Space, size: [u32; 2], pixels_per_point: f32) -> Uniform {
    Uniform {
        clip_from_offset: space.clip_from_offset.to_cols_array_2d(),
        eye: space.eye().to_array(),
        fade: [0.0; 4],
        viewport: [size[0] as f32, size[1] as f32, pixels_per_point, 0.0],
        grid: [0.0; 4],
        fill: [0.0; 4],
        edge: [0.0; 4],
        shape: [0.0; 4],
        reference: [0; 4],
        slice: [0.0; 4],
    }
}

/// For what is told relative to an origin of its own.
fn content(space: &Space, origin: World, size: [u32; 2], pixels_per_point: f32) -> Uniform {
    let [x, y, z] = space.offset(origin).to_array();
    Uniform { grid: [x, y, z, 0.0], ..blank(space, size, pixels_per_point) }
}

fn in_space(space: &Space, grid: &Grid, size: [u32; 2], pixels_per_point: f32) -> Uniform {
    let mut uniform = blank(space, size, pixels_per_point);
    let half = 0.5 * grid.side() as f32;
    let radius = half * 3f32.sqrt();
    let eye = Vec4::from(uniform.eye);
    uniform.fade = camera::fade(eye, space.offset(grid.min) + half, radius).to_array();
    uniform.viewport[3] = FADING;
    let reference = reference(space.origin, grid);
    let corner = |e: usize| grid.min[e] + reference[e] * grid.cell;
    let [x, y, z] = space.offset([corner(0), corner(1), corner(2)]).to_array();
    uniform.grid = [x, y, z, grid.cell as f32];
    let [i, j, k] = reference.map(|code| code as i32);
    uniform.reference = [i, j, k, 0];
    uniform
}

/// The code on the grid that is nearest to a point: differences to it are exact, so that
/// nothing near the point trembles.
fn reference(point: World, grid: &Grid) -> [f64; 3] {
    let last = f64::from(1u32 << grid.root_level);
    std::array::from_fn(|e| ((point[e] - grid.min[e]) / grid.cell).floor().clamp(0.0, last))
}

/// Pixels per world unit where a box from the first to the second corner is nearest to
/// the eye.
fn pixels_per_unit(space: &Space, [min, max]: [World; 2], size: [u32; 2]) -> f32 {
    let nearest = (0..8u8)
        .map(|corner| {
            let side = |e: usize| if corner >> e & 1 == 1 { max[e] } else { min[e] };
            let point = space.offset([side(0), side(1), side(2)]);
            (space.clip_from_offset * point.extend(1.0)).w
        })
        .fold(f32::INFINITY, f32::min);
    let up = space.clip_from_offset.row(1).truncate().length();
    0.5 * size[1] as f32 * up / nearest.max(1e-6)
}

/// Position in pixels of a reference code near the middle of the picture, that
/// code, and pixels per smallest cell.
fn plane_grid(
    plane: &Plane,
    grid: &Grid,
    size: [u32; 2],
    pixels_per_point: f32,
) -> ([f32; 2], [i32; 2], f32) {
    let scale = plane.scale * f64::from(pixels_per_point);
    let from_min = [0, 1].map(|axis| (plane.centre[axis] - grid.min[axis]) / grid.cell);
    let last = f64::from(1u32 << grid.root_level);
    let reference = from_min.map(|at| at.floor().clamp(0.0, last));
    let offset = [0, 1].map(|axis| (reference[axis] - from_min[axis]) * grid.cell * scale);
    let [width, height] = size.map(f64::from);
    let origin = [0.5 * width + offset[0], 0.5 * height - offset[1]].map(|x| x as f32);
    (origin, reference.map(|code| code as i32), (grid.cell * scale) as f32)
}

fn side(group: &Group) -> f32 {
    (1u32 << group.level) as f32
}

/// Premultiplied and gamma-encoded, as the bytes are.
fn colour(colour: Color32) -> [f32; 4] {
    colour.to_array().map(|byte| f32::from(byte) / 255.0)
}
