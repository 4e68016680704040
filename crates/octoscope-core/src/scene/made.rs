//! Content made by rules and seeded random numbers.
//!
//! Spheres and points are multiples of 2^-20 in the unit cube, so that they
//! are exact in single precision as well.

use super::solids::{cuboid, cylinder, rounded, sphere, unit};
use super::{Content, Image, Sphere};
use crate::random::Random;
use crate::tree::Code;

/// 2^-20.
const UNIT: f64 = 1.0 / (1 << 20) as f64;

/// `n` spheres with radii of 4096 … 20480 · 2^-20 inside the unit cube.
pub fn cloud<const D: usize>(seed: u64, n: u32) -> Content<D> {
    let mut random = Random::new(seed);
    let sphere = |_| {
        let radius = 4096 + random.below(16385);
        let mut coordinate = || radius + random.below((1 << 20) - 2 * radius + 1);
        let centre = [(); D].map(|()| coordinate() as f64 * UNIT);
        Sphere { centre, radius: radius as f64 * UNIT }
    };
    Content::Spheres((0..n).map(sphere).collect())
}

/// 2^(D·n) spheres in a regular grid, each with 0.3 of the grid's spacing as
/// radius, rounded to a multiple of 2^-20; `n` is at most 10.
pub fn sphere_grid<const D: usize>(n: u32) -> Content<D> {
    let spacing = (1 << 20) >> n;
    let radius = (0.3 * f64::from(spacing)).round() * UNIT;
    let sphere = |number: u32| {
        let centre = std::array::from_fn(|e| {
            let index = number >> (n * (D - 1 - e) as u32) & ((1 << n) - 1);
            (f64::from(index) + 0.5) * f64::from(spacing) * UNIT
        });
        Sphere { centre, radius }
    };
    Content::Spheres((0..1 << (n * D as u32)).map(sphere).collect())
}

/// Surfaces of `n` cylinders and spheres in turn, anywhere in the unit cube.
pub fn cylinders_and_spheres(seed: u64, n: u32) -> Content<3> {
    let mut random = Random::new(seed);
    let mut triangles = Vec::new();
    for number in 0..n {
        let size = random.between(0.004, 0.016);
        let place = [(); 3].map(|()| random.between(0.05, 0.95));
        triangles.extend(match number % 2 {
            0 => cylinder(rod(&mut random, place, 2.0 * size), 0.5 * size),
            _ => sphere(rounded(place), size),
        });
    }
    Content::Triangles(triangles)
}

/// Surfaces of `n` objects in the unit cube, cylinders, spheres and boxes in turn;
/// every other one near one of five places.
pub fn objects(seed: u64, n: u32) -> Content<3> {
    let mut random = Random::new(seed);
    let places: [[f64; 3]; 5] = [(); 5].map(|()| [(); 3].map(|()| random.between(0.3, 0.7)));
    let mut triangles = Vec::new();
    for number in 0..n {
        let size = random.between(0.003, 0.02);
        let place = match places.get(random.below(10) as usize) {
            Some(near) => near.map(|x| x + random.between(-0.1, 0.1) + random.between(-0.1, 0.1)),
            None => [(); 3].map(|()| random.between(0.05, 0.95)),
        };
        triangles.extend(match number % 3 {
            0 => cylinder(rod(&mut random, place, 2.0 * size), 0.5 * size),
            1 => sphere(rounded(place), size),
            _ => {
                let half = [(); 3].map(|()| size * random.between(0.4, 1.0));
                let corner = |sign: f64| std::array::from_fn(|e| place[e] + sign * half[e]);
                cuboid(corner(-1.0), corner(1.0))
            }
        });
    }
    Content::Triangles(triangles)
}

/// Ends of a line of twice this length around a place, in any direction.
fn rod(random: &mut Random, place: [f64; 3], half: f64) -> [[f64; 3]; 2] {
    let way = loop {
        let way = [(); 3].map(|()| random.between(-1.0, 1.0));
        let squared = way.iter().map(|x| x * x).sum::<f64>();
        if (0.01..=1.0).contains(&squared) {
            break unit(way);
        }
    };
    [-half, half].map(|length| rounded(std::array::from_fn(|e| place[e] + length * way[e])))
}

/// `n` points in the unit cube: three in four around one of three places, the
/// others anywhere.
pub fn clustered_points<const D: usize>(seed: u64, n: u32) -> Content<D> {
    const PLACES: [[f64; 3]; 3] = [[0.25, 0.29, 0.65], [0.72, 0.6, 0.4], [0.53, 0.72, 0.3]];
    let mut random = Random::new(seed);
    let point = |_| {
        let place = PLACES.get(random.below(4) as usize);
        std::array::from_fn(|e| {
            let x = match place {
                // Sums of three have their mean at 0 and lie within ±0.3.
                Some(centre) => {
                    centre[e % 3] + (0..3).map(|_| random.between(-0.1, 0.1)).sum::<f64>()
                }
                None => random.unit(),
            };
            (x.clamp(0.0, 1.0 - UNIT) / UNIT).floor() * UNIT
        })
    };
    Content::Points((0..n).map(point).collect())
}

/// Cells of a grid of 2^`depth` a side: a chequerboard, but for the upper
/// corner, an eighth (a quarter in the plane) that is wholly full.
pub fn chequered_cells<const D: usize>(depth: u32) -> Content<D> {
    let (size, half) = (1u32 << depth, 1u32 << depth >> 1);
    let cell = |number: u32| -> Code<D> {
        std::array::from_fn(|e| number >> (depth * (D - 1 - e) as u32) & (size - 1))
    };
    let occupied = |c: &Code<D>| c.iter().sum::<u32>() % 2 == 0 || c.iter().all(|&x| x >= half);
    Content::Cells((0..1 << (depth * D as u32)).map(cell).filter(occupied).collect())
}

/// Grey picture of `size` × `size` pixels: rings around a place beside its
/// middle, each of one grey, over a background that grows brighter upwards.
pub fn rings(size: u32) -> Image {
    const GREYS: [u8; 5] = [40, 205, 95, 235, 70];
    let unit = f64::from(size) / 256.0;
    let pixel = |number: u32| {
        let (column, row) = (f64::from(number % size), f64::from(number / size));
        let [x, y] = [column / unit - 140.0, row / unit - 112.0];
        let ring = ((x * x + y * y).sqrt() / 18.0) as usize;
        let background = 250 - (row / unit * 0.25) as u8;
        [GREYS.get(ring).copied().unwrap_or(background); 3]
    };
    Image { width: size, height: size, pixels: (0..size * size).map(pixel).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spheres_are_multiples_of_a_power_of_two_inside_the_unit_cube() {
        for content in [cloud::<3>(0xC10D, 1890), sphere_grid(3), sphere_grid(5)] {
            let Content::Spheres(spheres) = content else { panic!("spheres") };
            for Sphere { centre, radius } in spheres {
                for x in centre.into_iter().chain([radius]) {
                    assert_eq!((x / UNIT).fract(), 0.0);
                }
                assert!(centre.iter().all(|c| c - radius >= 0.0 && c + radius <= 1.0));
            }
        }
    }

    #[test]
    fn the_sphere_grids_have_512_4096_and_32768_spheres() {
        let counts = [3, 4, 5].map(|n| sphere_grid::<3>(n).len());
        assert_eq!(counts, [512, 4096, 32768]);
    }

    #[test]
    fn solids_have_corners_on_the_grid_inside_the_unit_cube() {
        for (content, n_triangles) in
            [(cylinders_and_spheres(1, 20), 10 * (44 + 32)), (objects(1, 30), 10 * (44 + 32 + 12))]
        {
            let Content::Triangles(triangles) = content else { panic!("triangles") };
            assert_eq!(triangles.len(), n_triangles);
            for x in triangles.into_iter().flatten().flatten() {
                assert!((0.0..=1.0).contains(&x) && (x / UNIT).fract() == 0.0, "{x}");
            }
        }
        assert_eq!(objects(5, 9), objects(5, 9));
        assert_ne!(objects(5, 9), objects(6, 9));
    }

    #[test]
    fn the_same_seed_makes_the_same_points() {
        assert_eq!(clustered_points::<2>(7, 50), clustered_points(7, 50));
        assert_ne!(clustered_points::<2>(7, 50), clustered_points(8, 50));
    }
}
