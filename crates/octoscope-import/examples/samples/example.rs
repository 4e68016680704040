//! Cells and rays for the command line.

use octoscope_core::random::Random;

/// A flight of steps in the corner of a grid of 8 × 8 × 8: x + y + z ≤ 5.
pub fn cells() -> String {
    let mut text = "# x y z of the occupied cells; octoscope visit --depth 3\n".to_owned();
    for number in 0..512 {
        let [x, y, z] = [number >> 6, number >> 3 & 7, number & 7];
        if x + y + z <= 5 {
            text.push_str(&format!("{x} {y} {z}\n"));
        }
    }
    text
}

/// Rays with each peculiarity, then eight at random.
pub fn rays() -> String {
    const KNOWN: [(&str, &str); 8] = [
        ("parallel to x", "-0.25 0.3 0.3 1 0 0"),
        ("parallel to z, downwards", "0.2 0.1 1.5 0 0 -1"),
        ("in the mid plane y = 0.5", "-0.25 0.5 0.1 1 0 0.25"),
        ("along the diagonal", "0 0 0 1 1 1"),
        ("along the diagonal, from outside, downwards", "1.25 1.25 1.25 -1 -1 -1"),
        ("begins inside", "0.40625 0.21875 0.59375 -0.5 0.25 0.125"),
        ("hexadecimal, as C prints with %a", "-0x1p-2 0x1.8p-2 0x1.4p-3 0x1p+0 -0x1.8p-3 0x1p-4"),
        ("misses", "-0.25 1.5 0.5 1 0.25 0"),
    ];
    let mut text = "# ox oy oz dx dy dz\n".to_owned();
    for (comment, ray) in KNOWN {
        text.push_str(&format!("{ray} # {comment}\n"));
    }
    let mut random = Random::new(8);
    for _ in 0..8 {
        // From a point outside to a point inside, in sixty-fourths.
        let mut part = |low: f64, n: u64| low + random.below(n) as f64 / 64.0;
        let from = [-0.25, part(-0.25, 96), part(-0.25, 96)];
        let to = [(); 3].map(|()| part(1.0 / 64.0, 40));
        let [dx, dy, dz]: [f64; 3] = std::array::from_fn(|e| to[e] - from[e]);
        text.push_str(&format!("{} {} {} {dx} {dy} {dz}\n", from[0], from[1], from[2]));
    }
    text
}
