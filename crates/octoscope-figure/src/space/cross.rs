//! Areas that are wrong, crossed out.

use crate::{Form, Role};

/// Lines that cross an area out which is wrong, however many corners it has; none of any
/// other role.
pub(super) fn cross_out(role: Role, area: &[[f64; 2]]) -> Vec<Form> {
    let n = area.len();
    if role != Role::Strayed || n < 3 {
        return Vec::new();
    }
    // Opposite a corner is another, or the middle of an edge where the corners are odd.
    let across = |corner: usize| {
        let ends = [n / 2, n.div_ceil(2)].map(|far| area[(corner + far) % n]);
        let middle = std::array::from_fn(|e| 0.5 * (ends[0][e] + ends[1][e]));
        Form::Polyline(vec![area[corner], middle])
    };
    // A quarter around, so that the lines are far from parallel.
    [0, (n + 2) / 4].map(across).to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_area_of_any_number_of_corners_is_crossed_out_by_two_lines_that_meet() {
        for n in 3..=8_u32 {
            let turn = |k: u32| std::f64::consts::TAU * f64::from(k) / f64::from(n);
            let area: Vec<[f64; 2]> = (0..n).map(|k| [turn(k).cos(), turn(k).sin()]).collect();
            let lines = cross_out(Role::Strayed, &area);
            let [Form::Polyline(one), Form::Polyline(other)] = lines.as_slice() else {
                panic!("{n}: {lines:?}")
            };
            // The ends of each lie on both sides of the other.
            for [line, ends] in [[one, other], [other, one]] {
                let [a, b] = line[..] else { panic!("{line:?}") };
                let side =
                    |p: &[f64; 2]| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
                let [from, to] = ends[..] else { panic!("{ends:?}") };
                assert!(side(&from) * side(&to) < 0.0, "{n}: {one:?} {other:?}");
            }
            assert!(cross_out(Role::Current, &area).is_empty());
        }
    }

    #[test]
    fn a_square_is_crossed_out_by_its_diagonals() {
        let [a, b, c, d] = [[0.1, 0.0], [1.0, 0.0], [1.0, 0.7], [0.1, 0.7]];
        let lines = [[a, c], [b, d]].map(|line| Form::Polyline(line.to_vec()));
        assert_eq!(cross_out(Role::Strayed, &[a, b, c, d]), lines);
    }
}
