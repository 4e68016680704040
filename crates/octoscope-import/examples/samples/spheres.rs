//! Shaded spheres on a chequered floor, made by tracing rays.

use super::picture::{Colour, blend, paint};
use image::RgbImage;

const WIDTH: u32 = 320;
const HEIGHT: u32 = 200;
const EYE: Vector = [0.0, -6.0, 1.9];
/// Towards the light; of length 1.
const LIGHT: Vector = [-2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0];

type Vector = [f64; 3];

struct Ball {
    centre: Vector,
    radius: f64,
    colour: Colour,
}

const BALLS: [Ball; 4] = [
    Ball { centre: [-1.55, 0.5, 1.0], radius: 1.0, colour: [214.0, 60.0, 52.0] },
    Ball { centre: [0.75, 1.6, 1.35], radius: 1.35, colour: [242.0, 180.0, 48.0] },
    Ball { centre: [0.45, -1.2, 0.6], radius: 0.6, colour: [44.0, 138.0, 112.0] },
    Ball { centre: [2.15, -0.3, 0.8], radius: 0.8, colour: [58.0, 92.0, 190.0] },
];

/// The picture, 320 × 200.
pub fn spheres() -> RgbImage {
    paint(WIDTH, HEIGHT, |x, y| {
        let direction = [x - 0.8, 1.4, y - 0.66];
        seen(unit(direction))
    })
}

fn seen(direction: Vector) -> Colour {
    let Some((ball, t)) = nearest(EYE, direction) else {
        return floor_or_wall(direction);
    };
    let at = along(EYE, t, direction);
    let normal: Vector = std::array::from_fn(|e| (at[e] - ball.centre[e]) / ball.radius);
    let facing = dot(normal, LIGHT);
    let lit = if shaded(along(at, 1e-6, normal)) { 0.0 } else { facing.max(0.0) };
    let body = ball.colour.map(|c| c * (0.28 + 0.72 * lit));
    let mirrored = along(direction, -2.0 * dot(normal, direction), normal);
    let shine = if lit > 0.0 { dot(mirrored, LIGHT).max(0.0).powi(48) } else { 0.0 };
    blend(body, [255.0; 3], shine)
}

fn floor_or_wall(direction: Vector) -> Colour {
    const WALL: Colour = [206.0, 216.0, 226.0];
    if direction[2] >= 0.0 {
        return blend(WALL, [120.0, 148.0, 182.0], direction[2] * 3.0);
    }
    let t = -EYE[2] / direction[2];
    let at = along(EYE, t, direction);
    let is_dark = (at[0].floor() + at[1].floor()).rem_euclid(2.0) == 1.0;
    let tile = if is_dark { [124.0, 116.0, 112.0] } else { [238.0, 232.0, 220.0] };
    let lit = if shaded(along(at, 1e-6, LIGHT)) { tile.map(|c| 0.42 * c) } else { tile };
    blend(lit, WALL, (t - 6.0) / 18.0)
}

fn shaded(at: Vector) -> bool {
    nearest(at, LIGHT).is_some()
}

/// First ball along a ray with a direction of length 1, and its distance.
fn nearest(origin: Vector, direction: Vector) -> Option<(&'static Ball, f64)> {
    let hit = |ball: &'static Ball| {
        let from: Vector = std::array::from_fn(|e| origin[e] - ball.centre[e]);
        let b = dot(from, direction);
        let root = b * b - dot(from, from) + ball.radius * ball.radius;
        let t = -b - root.max(0.0).sqrt();
        (root > 0.0 && t > 0.0).then_some((ball, t))
    };
    BALLS.iter().filter_map(hit).min_by(|a, b| a.1.total_cmp(&b.1))
}

fn along(origin: Vector, t: f64, direction: Vector) -> Vector {
    std::array::from_fn(|e| origin[e] + t * direction[e])
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    v.map(|x| x / length)
}
