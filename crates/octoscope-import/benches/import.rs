//! What opening a large file costs: reading its bytes and building the tree.
//! Medians of a few runs; run it with `cargo bench -p octoscope-import`.

use image::{ExtendedColorType, ImageEncoder, codecs::png::PngEncoder};
use octoscope_core::progress::Progress;
use octoscope_core::random::Random;
use octoscope_core::scene::Content;
use octoscope_core::tree::{Recipe, build};
use octoscope_import::{Imported, import};
use std::fmt::Write;
use std::time::Instant;

const N_RUNS: usize = 3;
const N_POINTS: usize = 1_000_000;
/// Squares along each side of a surface of two triangles a square.
const N_SQUARES: usize = 224;
const N_PIXELS: u32 = 2048;

fn main() {
    println!(
        "{:<30} {:>8} {:>9} {:>9} {:>9} {:>6} {:>9} {:>9}",
        "file, medians in ms", "MB", "items", "read", "MB/s", "depth", "build", "leaves"
    );
    let points = points();
    measure("1M points, text", "a.xyz", &xyz(&points), 8);
    measure("1M points, table", "a.csv", &csv(&points), 8);
    measure("1M points, PLY as text", "a.ply", &text_ply(&points), 8);
    measure("1M points, PLY as bytes", "b.ply", &binary_ply(&points), 8);
    let triangles = triangles();
    measure("100k triangles, OBJ", "a.obj", &obj(&triangles), 8);
    measure("100k triangles, STL as text", "a.stl", &text_stl(&triangles), 8);
    measure("100k triangles, STL as bytes", "b.stl", &binary_stl(&triangles), 8);
    measure("2048 × 2048 pixels, PNG", "a.png", &png(), 11);
}

/// Prints one row of the table.
fn measure(title: &str, name: &str, bytes: &[u8], depth: u8) {
    let progress = Progress::default();
    let [mut reading, mut building] = [Vec::new(), Vec::new()];
    let (mut n_items, mut n_leaves) = (0, 0);
    for _ in 0..N_RUNS {
        let start = Instant::now();
        let imported = import(name, bytes, &progress).expect("the file is sound");
        reading.push(millis(start));
        let start = Instant::now();
        [n_items, n_leaves] = match imported {
            Imported::Plane { content, .. } => sizes(&content, depth),
            Imported::Space { content, .. } => sizes(&content, depth),
        };
        building.push(millis(start));
    }
    let [read, built] = [reading, building].map(median);
    let megabytes = bytes.len() as f64 / 1e6;
    let rate = megabytes / read * 1e3;
    println!(
        "{title:<30} {megabytes:>8.1} {n_items:>9} {read:>9.1} {rate:>9.1} {depth:>6} {built:>9.1} {n_leaves:>9}"
    );
}

/// Number of items, and of the leaves of their tree.
fn sizes<const D: usize>(content: &Content<D>, depth: u8) -> [usize; 2] {
    let domain = content.fit().cut(depth).expect("the domain is sound");
    let recipe = Recipe { depth, ..Recipe::default() };
    let tree = build(content, domain, &recipe, &Progress::default()).expect("the tree is built");
    [content.len(), tree.n_leaves()]
}

/// Points around a ball, the denser the nearer.
fn points() -> Vec<[f32; 3]> {
    let mut random = Random::new(1);
    let mut near = || (0..3).map(|_| random.between(-1.0, 1.0)).product::<f64>() as f32;
    (0..N_POINTS).map(|_| [near(), near(), near()]).collect()
}

/// A wavy surface.
fn triangles() -> Vec<[[f32; 3]; 3]> {
    let corner = |i: usize, j: usize| {
        let [x, y] = [i, j].map(|k| k as f32 / N_SQUARES as f32);
        [x, y, 0.5 + 0.2 * (9.0 * x).sin() * (7.0 * y).cos()]
    };
    let squares = (0..N_SQUARES).flat_map(|i| (0..N_SQUARES).map(move |j| (i, j)));
    squares
        .flat_map(|(i, j)| {
            let [a, b] = [corner(i, j), corner(i + 1, j)];
            let [c, d] = [corner(i + 1, j + 1), corner(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect()
}

fn lines<T>(head: &str, rows: &[T], mut row: impl FnMut(&mut String, &T)) -> Vec<u8> {
    let mut text = head.to_owned();
    for item in rows {
        row(&mut text, item);
        text.push('\n');
    }
    text.into_bytes()
}

fn point(text: &mut String, [x, y, z]: &[f32; 3], separator: char) {
    write!(text, "{x}{separator}{y}{separator}{z}").expect("a string takes everything");
}

fn xyz(points: &[[f32; 3]]) -> Vec<u8> {
    lines("", points, |text, p| point(text, p, ' '))
}

fn csv(points: &[[f32; 3]]) -> Vec<u8> {
    lines("x,y,z\n", points, |text, p| point(text, p, ','))
}

fn ply_header(format: &str) -> String {
    format!(
        "ply\nformat {format} 1.0\nelement vertex {N_POINTS}\nproperty float x\nproperty float y\n\
         property float z\nend_header\n"
    )
}

fn text_ply(points: &[[f32; 3]]) -> Vec<u8> {
    lines(&ply_header("ascii"), points, |text, p| point(text, p, ' '))
}

fn binary_ply(points: &[[f32; 3]]) -> Vec<u8> {
    let mut bytes = ply_header("binary_little_endian").into_bytes();
    bytes.extend(points.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
    bytes
}

fn obj(triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
    lines("", triangles, |text, corners| {
        for corner in corners {
            text.push_str("v ");
            point(text, corner, ' ');
            text.push('\n');
        }
        text.push_str("f -3 -2 -1");
    })
}

fn text_stl(triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
    let mut bytes = lines("solid a\n", triangles, |text, corners| {
        text.push_str("facet normal 0 0 0\nouter loop\n");
        for corner in corners {
            text.push_str("vertex ");
            point(text, corner, ' ');
            text.push('\n');
        }
        text.push_str("endloop\nendfacet");
    });
    bytes.extend(b"endsolid a\n");
    bytes
}

fn binary_stl(triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for corners in triangles {
        bytes.extend([0; 12]);
        bytes.extend(corners.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

/// Noise whose strength grows from left to right.
fn png() -> Vec<u8> {
    let mut random = Random::new(2);
    let pixels: Vec<u8> = (0..N_PIXELS * N_PIXELS)
        .flat_map(|i| {
            let strength = u64::from(i % N_PIXELS / 16) + 1;
            [100 + random.below(strength) as u8; 3]
        })
        .collect();
    let mut bytes = Vec::new();
    PngEncoder::new(&mut bytes)
        .write_image(&pixels, N_PIXELS, N_PIXELS, ExtendedColorType::Rgb8)
        .expect("a picture can be packed");
    bytes
}

fn millis(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
