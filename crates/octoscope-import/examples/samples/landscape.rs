//! A mountain lake in the evening: smooth sky and water, sharp ridges and
//! firs, single stars. Made to be looked at as a quadtree.

use super::picture::{Colour, blend, paint};
use image::RgbImage;
use octoscope_core::random::Random;

/// Edge length in pixels.
const SIZE: u32 = 256;
/// Height of the shore, as part of the picture.
const SHORE: f64 = 0.25;
const SUN: [f64; 2] = [0.4, 0.6];
const SUN_RADIUS: f64 = 0.07;
const MIST: Colour = [255.0, 214.0, 170.0];
const NIGHT: Colour = [12.0, 20.0, 34.0];

/// One chain of mountains.
struct Ridge {
    /// Heights of the crest from left to right.
    crest: Vec<f64>,
    colour: Colour,
    /// How much of the mist lies at its foot, 0 … 1.
    mist: f64,
}

struct Scene {
    stars: Vec<[f64; 2]>,
    /// From far to near.
    ridges: Vec<Ridge>,
    bank: Vec<f64>,
    firs: Vec<Fir>,
}

/// A fir: three triangles, one above the other.
struct Fir {
    foot: [f64; 2],
    height: f64,
}

/// The picture, [`SIZE`] × [`SIZE`].
pub fn landscape() -> RgbImage {
    let scene = Scene::new(&mut Random::new(20));
    paint(SIZE, SIZE, |x, y| scene.colour(x, y))
}

impl Scene {
    fn new(random: &mut Random) -> Self {
        let pixel = 1.0 / f64::from(SIZE);
        let star = |random: &mut Random| {
            [random.below(256), 176 + random.below(76)].map(|n| (n as f64 + 0.5) * pixel)
        };
        let stars = (0..16).map(|_| star(random)).collect();
        let mut ridge =
            |ends, rough, colour, mist| Ridge { crest: crest(random, ends, rough), colour, mist };
        let ridges = vec![
            ridge([0.60, 0.52], 0.22, [150.0, 132.0, 168.0], 0.75),
            ridge([0.42, 0.50], 0.20, [96.0, 92.0, 142.0], 0.6),
            ridge([0.45, 0.34], 0.15, [54.0, 62.0, 108.0], 0.45),
            ridge([0.29, 0.32], 0.06, [26.0, 40.0, 68.0], 0.25),
        ];
        let bank = crest(random, [0.17, 0.02], 0.04);
        let mut firs: Vec<_> = (0..9)
            .map(|i| {
                let x = 0.02 + 0.055 * f64::from(i) + random.between(-0.012, 0.012);
                let height = random.between(0.10, 0.22) * (1.1 - x);
                Fir { foot: [x, height_at(&bank, x) - 0.01], height }
            })
            .collect();
        firs.push(Fir { foot: [0.93, height_at(&bank, 0.93) - 0.02], height: 0.3 });
        firs.push(Fir { foot: [0.985, height_at(&bank, 0.985) - 0.02], height: 0.2 });
        Self { stars, ridges, bank, firs }
    }

    fn colour(&self, x: f64, y: f64) -> Colour {
        if y < height_at(&self.bank, x) || self.firs.iter().any(|fir| fir.covers(x, y)) {
            return NIGHT;
        }
        if y >= SHORE {
            return self.above_water(x, y);
        }
        // The lake mirrors what is above it, darker towards the viewer.
        let depth = (SHORE - y) / SHORE;
        let ripple = 0.004 * f64::from(u8::from((depth * 14.0).fract() < 0.35)) * depth;
        let mirrored = self.above_water(x + ripple, SHORE + 1.9 * (SHORE - y));
        blend(mirrored, [22.0, 44.0, 84.0], 0.35 + 0.45 * depth)
    }

    fn above_water(&self, x: f64, y: f64) -> Colour {
        for ridge in self.ridges.iter().rev() {
            let top = height_at(&ridge.crest, x);
            if y < top {
                let foot = ((top - y) / 0.3).min(1.0) * ridge.mist;
                return blend(ridge.colour, MIST, foot);
            }
        }
        self.sky(x, y)
    }

    fn sky(&self, x: f64, y: f64) -> Colour {
        const PALE: Colour = [255.0, 206.0, 138.0];
        const ROSE: Colour = [226.0, 120.0, 120.0];
        const VIOLET: Colour = [92.0, 74.0, 140.0];
        const BLUE: Colour = [22.0, 32.0, 84.0];
        let near = |star: &[f64; 2]| (x - star[0]).abs().max((y - star[1]).abs()) < 0.5 / 256.0;
        if self.stars.iter().any(near) {
            return [255.0, 250.0, 235.0];
        }
        let sky = match y {
            ..0.62 => blend(PALE, ROSE, (y - 0.40) / 0.22),
            0.62..0.78 => blend(ROSE, VIOLET, (y - 0.62) / 0.16),
            _ => blend(VIOLET, BLUE, (y - 0.78) / 0.22),
        };
        let distance = ((x - SUN[0]).powi(2) + (y - SUN[1]).powi(2)).sqrt();
        if distance < SUN_RADIUS {
            return [255.0, 244.0, 204.0];
        }
        let glow = 1.0 - (distance - SUN_RADIUS) / 0.3;
        blend(sky, PALE, 0.7 * glow.max(0.0).powi(2))
    }
}

impl Fir {
    fn covers(&self, x: f64, y: f64) -> bool {
        let up = (y - self.foot[1]) / self.height;
        let aside = (x - self.foot[0]).abs() / self.height;
        let tier = |base: f64, top: f64, half_width: f64| {
            (base..top).contains(&up) && aside < half_width * (top - up) / (top - base)
        };
        let trunk = (0.0..0.2).contains(&up) && aside < 0.025;
        trunk || tier(0.12, 0.6, 0.24) || tier(0.38, 0.8, 0.18) || tier(0.62, 1.0, 0.12)
    }
}

/// Crest between two `ends` by midpoint displacement [Fournier, Fussell,
/// Carpenter 1982], 129 heights; `rough` is the first displacement at most.
fn crest(random: &mut Random, ends: [f64; 2], rough: f64) -> Vec<f64> {
    let mut heights = ends.to_vec();
    let mut rough = rough;
    while heights.len() < 129 {
        let mut finer = vec![heights[0]];
        for pair in heights.windows(2) {
            let middle = (pair[0] + pair[1]) / 2.0 + random.between(-rough, rough);
            finer.extend([middle, pair[1]]);
        }
        heights = finer;
        rough *= 0.52;
    }
    heights
}

/// Height of a crest at `x`, which is brought into 0 … 1.
fn height_at(crest: &[f64], x: f64) -> f64 {
    let place = x.clamp(0.0, 1.0) * (crest.len() - 1) as f64;
    let left = (place as usize).min(crest.len() - 2);
    crest[left] + (crest[left + 1] - crest[left]) * (place - left as f64)
}
