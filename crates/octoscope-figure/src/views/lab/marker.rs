//! Marks of lines in charts, told apart by their shapes alone.

/// Number of shapes.
pub(super) const N_SHAPES: usize = 17;

/// A mark around `at`, which reaches `r` to its sides, as convex pieces.
pub(super) fn marker(number: usize, at: [f64; 2], r: f64) -> Vec<Vec<[f64; 2]>> {
    /// Half the width of a bar, and how far the tips of triangles reach.
    const THIN: f64 = 0.34;
    const TIP: f64 = 1.2;
    let bar = |x: f64, y: f64| vec![[-x, -y], [x, -y], [x, y], [-x, y]];
    let up = || vec![[0.0, -TIP], [1.1, 0.8], [-1.1, 0.8]];
    let down = || vec![[0.0, TIP], [-1.1, -0.8], [1.1, -0.8]];
    // A quarter turn.
    let turned = |points: Vec<[f64; 2]>| points.into_iter().map(|[x, y]| [-y, x]).collect();
    let eighth = |points: Vec<[f64; 2]>| -> Vec<[f64; 2]> {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        points.into_iter().map(|[x, y]| [half * (x - y), half * (x + y)]).collect()
    };
    let arc = |from: f64, to: f64| -> Vec<[f64; 2]> {
        let angle = |n: u32| (from + (to - from) * f64::from(n) / 16.0).to_radians();
        (0..=16).map(|n| [1.1 * angle(n).cos(), 1.1 * angle(n).sin()]).collect()
    };
    let meeting =
        || [vec![[0.0, 0.0], [1.1, 1.1], [-1.1, 1.1]], vec![[0.0, 0.0], [-1.1, -1.1], [1.1, -1.1]]];
    let pieces = match number % N_SHAPES {
        0 => vec![bar(1.0, 1.0)],
        1 => vec![arc(0.0, 360.0)],
        2 => vec![up()],
        3 => vec![eighth(bar(1.0, 1.0))],
        4 => vec![down()],
        5 => vec![bar(1.3, THIN), bar(THIN, 1.3)],
        6 => vec![turned(up())],
        7 => vec![eighth(bar(1.4, THIN)), eighth(bar(THIN, 1.4))],
        8 => vec![turned(down())],
        9 => meeting().to_vec(),
        10 => meeting().map(turned).to_vec(),
        11 => vec![up(), down()],
        12 => vec![arc(180.0, 360.0)],
        13 => vec![bar(THIN, 1.4)],
        14 => vec![arc(0.0, 180.0)],
        15 => vec![bar(1.4, THIN)],
        _ => vec![vec![[-1.3, -1.1], [1.3, -1.1], [1.3, -0.4], [-1.3, -0.4]], bar(THIN, 1.1)],
    };
    let place = |[x, y]: [f64; 2]| [at[0] + r * x, at[1] + r * y];
    pieces.into_iter().map(|piece| piece.into_iter().map(place).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of a grid that a mark covers.
    fn covered(number: usize) -> Vec<bool> {
        let pieces = marker(number, [0.0, 0.0], 10.0);
        let is_inside = |x: f64, y: f64, piece: &Vec<[f64; 2]>| {
            let sides = piece.iter().zip(piece.iter().cycle().skip(1));
            let turns = sides.map(|(a, b)| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]));
            let turns: Vec<f64> = turns.filter(|turn| turn.abs() > 1e-6).collect();
            turns.iter().all(|turn| *turn > 0.0) || turns.iter().all(|turn| *turn < 0.0)
        };
        let grid = || (-15..=15).map(|n| f64::from(n) + 0.25);
        let points = grid().flat_map(|y| grid().map(move |x| (x, y)));
        points.map(|(x, y)| pieces.iter().any(|piece| is_inside(x, y, piece))).collect()
    }

    #[test]
    fn every_mark_has_a_shape_of_its_own() {
        let shapes: Vec<Vec<bool>> = (0..N_SHAPES).map(covered).collect();
        for (n, shape) in shapes.iter().enumerate() {
            assert!(shape.iter().filter(|&&is_in| is_in).count() > 100, "{n} is too faint");
            for (other, of) in shapes.iter().enumerate().skip(n + 1) {
                let n_other = shape.iter().zip(of).filter(|(a, b)| a != b).count();
                assert!(n_other > 50, "{n} and {other} differ at {n_other} of 961 points");
            }
        }
    }
}
