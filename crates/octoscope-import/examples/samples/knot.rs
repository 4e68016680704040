//! A trefoil: the torus knot that winds twice around the axis and three times
//! through the hole, as a tube of triangles.

use std::f64::consts::TAU;
use std::fmt::Write;

/// Rings along the knot.
const RINGS: usize = 192;
/// Corners of a ring.
const CORNERS: usize = 8;
const TUBE_RADIUS: f64 = 0.5;

/// Corners and faces, the latter anticlockwise from outside, counted from 0.
pub struct Mesh {
    /// Multiples of 1/64, exact in single precision.
    pub vertices: Vec<[f64; 3]>,
    /// Three vertices each.
    pub faces: Vec<[usize; 3]>,
}

impl Mesh {
    /// Corners of every triangle.
    pub fn triangles(&self) -> Vec<[[f64; 3]; 3]> {
        self.faces.iter().map(|face| face.map(|v| self.vertices[v])).collect()
    }
}

/// The knot, about 112 across.
pub fn knot() -> Mesh {
    let vertices = (0..RINGS).flat_map(ring).map(|v| v.map(|x| (x * 1024.0).round() / 64.0));
    let faces = (0..RINGS * CORNERS).flat_map(|i| {
        let (here, next) = (i / CORNERS, (i / CORNERS + 1) % RINGS);
        let (a, b) = (i % CORNERS, (i + 1) % CORNERS);
        let at = |ring: usize, corner: usize| ring * CORNERS + corner;
        let [p, q, r, s] = [at(here, a), at(next, a), at(next, b), at(here, b)];
        [[p, q, r], [p, r, s]]
    });
    Mesh { vertices: vertices.collect(), faces: faces.collect() }
}

/// As Wavefront OBJ.
pub fn obj(mesh: &Mesh) -> String {
    let mut text = "# Torus knot (2, 3) as a tube of triangles\no knot\n".to_owned();
    for [x, y, z] in &mesh.vertices {
        write(&mut text, format_args!("v {x} {y} {z}\n"));
    }
    for face in &mesh.faces {
        let [a, b, c] = face.map(|v| v + 1);
        write(&mut text, format_args!("f {a} {b} {c}\n"));
    }
    text
}

/// As binary STL.
pub fn stl(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = format!("{:80}", "Torus knot (2, 3) as a tube of triangles").into_bytes();
    bytes.extend((mesh.faces.len() as u32).to_le_bytes());
    for corners in mesh.triangles() {
        for vector in [normal(&corners)].iter().chain(&corners) {
            bytes.extend(vector.iter().flat_map(|&x| (x as f32).to_le_bytes()));
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// As binary PLY.
pub fn ply(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\ncomment Torus knot (2, 3)\n\
         element vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.vertices.len(),
        mesh.faces.len()
    )
    .into_bytes();
    bytes.extend(mesh.vertices.iter().flatten().flat_map(|&x| (x as f32).to_le_bytes()));
    for face in &mesh.faces {
        bytes.push(3);
        bytes.extend(face.iter().flat_map(|&v| (v as i32).to_le_bytes()));
    }
    bytes
}

fn ring(number: usize) -> [[f64; 3]; CORNERS] {
    let angle = TAU * number as f64 / RINGS as f64;
    let (centre, ahead) = (curve(angle), curve(angle + 1e-4));
    let tangent: [f64; 3] = std::array::from_fn(|e| ahead[e] - centre[e]);
    // Away from the middle of the torus, roughly; never along the tangent.
    let outward: [f64; 3] = std::array::from_fn(|e| ahead[e] + centre[e]);
    let side = unit(cross(tangent, outward));
    let up = unit(cross(side, tangent));
    std::array::from_fn(|corner| {
        let (sin, cos) = (TAU * corner as f64 / CORNERS as f64).sin_cos();
        std::array::from_fn(|e| centre[e] + TUBE_RADIUS * (cos * up[e] - sin * side[e]))
    })
}

fn curve(angle: f64) -> [f64; 3] {
    let r = 2.0 + (3.0 * angle).cos();
    [r * (2.0 * angle).cos(), r * (2.0 * angle).sin(), (3.0 * angle).sin()]
}

fn normal([a, b, c]: &[[f64; 3]; 3]) -> [f64; 3] {
    let edge = |p: &[f64; 3]| std::array::from_fn(|e| p[e] - a[e]);
    unit(cross(edge(b), edge(c)))
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    v.map(|x| x / length)
}

fn write(text: &mut String, line: std::fmt::Arguments<'_>) {
    text.write_fmt(line).expect("writing to a string cannot fail");
}
