//! Draws a random octree with a marked path, light and dark, into PPM files in
//! the folder named, and prints the time a picture takes.

use anyhow::Context;
use eframe::egui::{Color32, ColorImage};
use glam::Vec3;
use glam::camera::rh::{proj::directx, view};
use octoscope::render::{
    BoxMark, BoxStyle, Cell, Gpu, Grid, Layer, Line, Picture, Space, View, render_to_image,
};
use std::path::PathBuf;
use std::time::Instant;

const SIZE: [u32; 2] = [1000, 800];

fn main() -> anyhow::Result<()> {
    let folder = PathBuf::from(std::env::args().nth(1).context("name a folder for the pictures")?);
    let mut gpu = Gpu::new()?;
    for (name, background, grid, edge, fill) in [
        ("light", 0xFFFFFF, 0xC9D1D9, 0xB87A00, (0xE69F00, 0.3)),
        ("dark", 0x12161B, 0x36414D, 0xFFC145, (0xFFC145, 0.25)),
    ] {
        let layers = vec![
            Layer::spheres(&[[5.0, 5.0, 4.5, 2.6]], rgb(0x8A96A3)),
            Layer::boxes(GRID, &shell(4, 3), &[line(rgb(grid))]),
            Layer::marks(path(rgb(edge), rgb(fill.0).gamma_multiply(fill.1))),
        ];
        let picture =
            Picture { view: camera(0.6), slice: [0.0; 4], layers, background: rgb(background) };
        let image = render_to_image(&mut gpu, &picture, SIZE, 1.0)?;
        std::fs::write(folder.join(format!("{name}.ppm")), ppm(&image))?;
    }
    for level in [4, 5] {
        let cells = shell(level, 0);
        let layer = Layer::boxes(
            Grid { root_level: level, cell: 16.0 / 2f64.powi(i32::from(level)), ..GRID },
            &cells,
            &[line(rgb(0xC9D1D9))],
        );
        let mut times = Vec::new();
        for turn in 0..4u8 {
            let view = camera(0.6 + 0.1 * f32::from(turn));
            let picture = Picture {
                view,
                slice: [0.0; 4],
                layers: vec![layer.clone()],
                background: Color32::WHITE,
            };
            let start = Instant::now();
            render_to_image(&mut gpu, &picture, SIZE, 1.0)?;
            times.push(start.elapsed().as_millis());
        }
        println!("{} boxes: {times:?} ms", cells.len());
    }
    Ok(())
}

const GRID: Grid = Grid { min: [0.0; 3], cell: 1.0, root_level: 4 };

/// Leaves of an octree of `root_level`, split down to level 0 near a sphere;
/// those below `coarsest` everywhere.
fn shell(root_level: u8, coarsest: u8) -> Vec<Cell> {
    let mut leaves = Vec::new();
    let mut open = vec![(root_level, [0u32; 3])];
    let scale = f32::from(1u16 << root_level) / 16.0;
    while let Some((level, code)) = open.pop() {
        let side = (1u32 << level) as f32;
        let middle = Vec3::from(code.map(|c| c as f32 + 0.5 * side));
        let away = middle.distance(Vec3::new(5.0, 5.0, 4.5) * scale) - 2.6 * scale;
        if level > coarsest || level > 0 && away.abs() < 0.9 * side {
            let half = 1 << (level - 1);
            open.extend((0..8u32).map(|child| {
                (level - 1, std::array::from_fn(|axis| code[axis] + (child >> axis & 1) * half))
            }));
        } else {
            leaves.push(Cell { level, style: 0, code });
        }
    }
    leaves
}

/// The current node, its ancestors, visited leaves and a rejected one.
fn path(edge: Color32, fill: Color32) -> Vec<BoxMark> {
    let cube = |min: [f64; 3], side: f64, edge: Color32, fill: Color32, width, line| BoxMark {
        min,
        max: min.map(|x| x + side),
        fill,
        edge,
        width,
        line,
        layer: 0,
        is_crossed: false,
    };
    let none = Color32::TRANSPARENT;
    let quiet = edge.gamma_multiply(0.55);
    let violet = rgb(0x7A3E9D);
    let mut marks = vec![
        cube([0.0; 3], 16.0, quiet, none, 1.25, Line::Solid),
        cube([8.0, 0.0, 8.0], 8.0, quiet, none, 1.5, Line::Solid),
        cube([8.0, 4.0, 8.0], 4.0, edge, none, 1.75, Line::Solid),
        cube([10.0, 6.0, 8.0], 2.0, edge, fill, 2.5, Line::Solid),
        cube([8.0, 8.0, 12.0], 4.0, violet, none, 1.75, Line::Dashed),
    ];
    for (i, colour) in (0u8..).zip([0x00204C, 0x31446B, 0x666970, 0x958F78, 0xCAB969]) {
        let x = f64::from(i) * 2.0;
        let colour = rgb(colour);
        marks.push(cube(
            [x, 4.0, 10.0],
            2.0,
            colour,
            colour.gamma_multiply(0.45),
            1.5,
            Line::Solid,
        ));
    }
    marks
}

fn camera(yaw: f32) -> View {
    let from = Vec3::new(8.0, 8.0, 8.0) + 32.0 * Vec3::new(yaw.sin(), 0.5, yaw.cos());
    let seen = view::look_at_mat4(from, Vec3::new(8.0, 7.5, 8.0), Vec3::Y);
    let frustum = directx::perspective(0.6, SIZE[0] as f32 / SIZE[1] as f32, 1.0, 100.0);
    View::Space(Space { origin: [0.0; 3], clip_from_offset: frustum * seen })
}

fn line(edge: Color32) -> BoxStyle {
    BoxStyle { fill: Color32::TRANSPARENT, edge, width: 1.0 }
}

fn rgb(hex: u32) -> Color32 {
    let [_, r, g, b] = hex.to_be_bytes();
    Color32::from_rgb(r, g, b)
}

fn ppm(image: &ColorImage) -> Vec<u8> {
    let mut bytes = format!("P6 {} {} 255\n", image.size[0], image.size[1]).into_bytes();
    bytes.extend(image.pixels.iter().flat_map(|p| [p.r(), p.g(), p.b()]));
    bytes
}
