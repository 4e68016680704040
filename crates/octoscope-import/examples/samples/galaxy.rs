//! A tilted galaxy with two arms, as points in the unit cube.

use octoscope_core::random::Random;
use std::f64::consts::PI;

const N_POINTS: usize = 5000;

/// The points; multiples of 1/100 000, so that five decimals are exact.
pub fn galaxy() -> Vec<[f64; 3]> {
    let mut random = Random::new(1845);
    (0..N_POINTS).map(|_| star(&mut random)).collect()
}

/// One point a line.
pub fn xyz(points: &[[f64; 3]]) -> String {
    let rows: String = points.iter().map(|[x, y, z]| format!("{x} {y} {z}\n")).collect();
    format!("# Galaxy with two arms: x y z\n{rows}")
}

/// One point a line, below the names of the columns.
pub fn csv(points: &[[f64; 3]]) -> String {
    let row = |(number, [x, y, z]): (usize, &[f64; 3])| format!("{number},{x},{y},{z}\n");
    let rows: String = points.iter().enumerate().map(row).collect();
    format!("star,x,y,z\n{rows}")
}

/// As binary PLY in double precision.
pub fn ply(points: &[[f64; 3]]) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\ncomment Galaxy with two arms\n\
         element vertex {}\nproperty double x\nproperty double y\nproperty double z\nend_header\n",
        points.len()
    )
    .into_bytes();
    bytes.extend(points.iter().flatten().flat_map(|x| x.to_le_bytes()));
    bytes
}

fn star(random: &mut Random) -> [f64; 3] {
    let kind = random.unit();
    let in_disc = match kind {
        // The bulge in the middle.
        ..0.22 => [0.075, 0.075, 0.055].map(|width| bell(random, width)),
        // The arms, narrower and denser inwards.
        0.22..0.9 => {
            let r = 0.05 + 0.2 * (random.unit().powi(2) + random.unit());
            let arm = if random.below(2) == 0 { 0.0 } else { PI };
            let (sin, cos) = (arm + 10.0 * r.sqrt()).sin_cos();
            let width = 0.012 + 0.05 * r;
            [r * cos + bell(random, width), r * sin + bell(random, width), bell(random, 0.012)]
        }
        // The thin disc between them.
        _ => {
            let r = 0.45 * random.unit().sqrt();
            let (sin, cos) = random.between(-PI, PI).sin_cos();
            [r * cos, r * sin, bell(random, 0.01)]
        }
    };
    // Tilted by an angle with the cosine 0.8, so that it lies in no plane of the grid.
    let [x, y, z] = in_disc;
    [x, 0.8 * y - 0.6 * z, 0.6 * y + 0.8 * z].map(|c| ((c + 0.5) * 1e5).round() / 1e5)
}

/// Sum of three uniform numbers: a bell around 0, within ±1.5 `width`.
fn bell(random: &mut Random, width: f64) -> f64 {
    (0..3).map(|_| random.between(-0.5, 0.5)).sum::<f64>() * width
}
