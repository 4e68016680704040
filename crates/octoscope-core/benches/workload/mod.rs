//! The workload of the measurements: scenes, rays and queries, the same on every
//! machine.
//!
//! The world is the unit cube and every number a multiple of 2^-20, so that the
//! inputs are exact in single and in double precision.

use octoscope_core::geometry::{Aabb, Ray};
use octoscope_core::progress::Progress;
use octoscope_core::random::Random;
use octoscope_core::scene::{Content, Sphere, made};
use octoscope_core::tree::{Domain, Merge, Recipe, Tree, build};
use std::f64::consts::TAU;

const UNIT: f64 = 1.0 / (1 << 20) as f64;

/// What the tree is built from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scene {
    /// 8^n spheres on a regular grid.
    Grid(u32),
    /// 1890 random spheres.
    Cloud,
    /// The boxes around them, solid.
    Boxes,
    /// 4320 cylinders and spheres of triangles.
    Triangles,
}

/// Where the rays come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rays {
    /// 100 000 from outside.
    Outside,
    /// 100 000 from inside.
    Inside,
    /// A pinhole picture of 512 × 512 pixels.
    Camera,
}

impl Scene {
    /// Short name.
    pub fn name(self) -> String {
        match self {
            Self::Grid(n) => format!("S{n}"),
            Self::Cloud => "cloud".to_owned(),
            Self::Boxes => "boxes".to_owned(),
            Self::Triangles => "triangles".to_owned(),
        }
    }

    /// The spheres, boxes or triangles.
    pub fn content(self) -> Content<3> {
        match self {
            Self::Grid(n) => made::sphere_grid(n),
            Self::Cloud => made::cloud(0xC10D, 1890),
            Self::Boxes => Content::Boxes(boxes(&made::cloud(0xC10D, 1890))),
            Self::Triangles => made::cylinders_and_spheres(0xC1, 4320),
        }
    }

    /// The tree of the cells whose closed box meets a sphere's surface, a box or a
    /// triangle, each of them a leaf of level 0.
    pub fn tree(self, depth: u8) -> Tree<3> {
        let recipe = Recipe { depth, merge: Merge::Kept, ..Recipe::default() };
        build(&self.content(), Domain::unit(depth), &recipe, &Progress::default())
            .expect("nothing is wrong with the scene")
    }
}

impl Rays {
    /// Short name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Outside => "ext100k",
            Self::Inside => "int100k",
            Self::Camera => "cam512",
        }
    }

    /// The rays, in order.
    pub fn all(self) -> Vec<Ray<3>> {
        let mut random = Random::new(0x5EED);
        match self {
            Self::Outside => (0..100_000)
                .map(|_| {
                    let target = point(&mut random);
                    let direction = direction(&mut random);
                    let origin = std::array::from_fn(|e| target[e] - 2.0 * direction[e]);
                    ray(origin, direction)
                })
                .collect(),
            Self::Inside => {
                (0..100_000).map(|_| ray(point(&mut random), direction(&mut random))).collect()
            }
            Self::Camera => camera(),
        }
    }
}

/// The boxes around spheres.
fn boxes(content: &Content<3>) -> Vec<Aabb<3>> {
    let Content::Spheres(spheres) = content else { return Vec::new() };
    let corner = |s: &Sphere<3>, sign: f64| s.centre.map(|c| c + sign * s.radius);
    spheres.iter().map(|s| Aabb { min: corner(s, -1.0), max: corner(s, 1.0) }).collect()
}

/// From a point before one corner of the cube towards its middle.
fn camera() -> Vec<Ray<3>> {
    const SIDE: u32 = 512;
    let eye = [-0.75, -0.5, -0.625];
    let forward = [1.25, 1.0, 1.125];
    let right = [-0.5, 0.625, 0.0];
    let up = [-0.3125, -0.25, 0.5625];
    let pixel = |number: u32| {
        let [x, y] = [number % SIDE, number / SIDE]
            .map(|pixel| (f64::from(pixel) + 0.5) / f64::from(SIDE / 2) - 1.0);
        let direction = std::array::from_fn(|e| rounded(forward[e] + x * right[e] + y * up[e]));
        ray(eye, direction)
    };
    (0..SIDE * SIDE).map(pixel).collect()
}

fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray<3> {
    Ray::new(origin, direction).expect("finite and not zero")
}

fn point(random: &mut Random) -> [f64; 3] {
    std::array::from_fn(|_| random.below(1 << 20) as f64 * UNIT)
}

/// Uniform on the unit sphere [Archimedes], rounded.
fn direction(random: &mut Random) -> [f64; 3] {
    let height = random.between(-1.0, 1.0);
    let angle = TAU * random.unit();
    let radius = (1.0 - height * height).sqrt();
    [radius * angle.cos(), radius * angle.sin(), height].map(rounded)
}

fn rounded(x: f64) -> f64 {
    (x / UNIT).round() * UNIT
}
