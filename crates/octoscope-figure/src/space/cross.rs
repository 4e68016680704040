//! Areas that are wrong, crossed out.

use crate::sides::{is_around_eye, sides_around_eye, sides_to_eye};
use crate::{Camera, Form, Page, Role};
use octoscope_core::geometry::Aabb;

/// Lines that cross out what is seen of a box in space that is wrong; none of any other
/// role.
pub(super) fn cross_out_box<const D: usize>(
    role: Role,
    bounds: &Aabb<D>,
    camera: &Camera<D>,
    page: Page,
) -> Vec<Form> {
    if role != Role::Strayed {
        return Vec::new();
    }
    // From inside, all sides are seen.
    let sides = match is_around_eye(camera, bounds) {
        true => sides_around_eye(camera, page, bounds),
        false => sides_to_eye(camera, page, bounds),
    };
    let areas = sides.into_iter().map(|side| side.polygon.iter().map(|p| p.at).collect::<Vec<_>>());
    areas.flat_map(|area| cross_out(role, &area, page)).collect()
}

/// Lines that cross an area out which is wrong, however many corners it has; none of any
/// other role. Where they would meet beside the page, what is seen of the area is crossed
/// out.
pub(super) fn cross_out(role: Role, area: &[[f64; 2]], page: Page) -> Vec<Form> {
    if role != Role::Strayed || area.len() < 3 {
        return Vec::new();
    }
    let lines = diagonals(area);
    let seen = part_on_page(area, page);
    let meet_on_page = meeting(lines).is_some_and(|at| is_on(at, page));
    let lines = if meet_on_page || seen.len() < 3 { lines } else { diagonals(&seen) };
    lines.map(|line| Form::Polyline(line.to_vec())).to_vec()
}

/// Two lines across a convex area.
fn diagonals(area: &[[f64; 2]]) -> [[[f64; 2]; 2]; 2] {
    let n = area.len();
    // Opposite a corner is another, or the middle of an edge where the corners are odd.
    let across = |corner: usize| {
        let ends = [n / 2, n.div_ceil(2)].map(|far| area[(corner + far) % n]);
        let middle = std::array::from_fn(|e| 0.5 * (ends[0][e] + ends[1][e]));
        [area[corner], middle]
    };
    // A quarter around, so that the lines are far from parallel.
    [0, (n + 2) / 4].map(across)
}

/// Where two lines meet; `None` of parallel ones.
fn meeting([[a, b], [c, d]]: [[[f64; 2]; 2]; 2]) -> Option<[f64; 2]> {
    let [u, v, w] = [[a, b], [c, d], [a, c]].map(|[p, q]| [q[0] - p[0], q[1] - p[1]]);
    let cross = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
    let t = cross(w, v) / cross(u, v);
    t.is_finite().then(|| [a[0] + t * u[0], a[1] + t * u[1]])
}

fn is_on([x, y]: [f64; 2], page: Page) -> bool {
    (0.0..=page.width).contains(&x) && (0.0..=page.height).contains(&y)
}

/// The part of a convex area that is seen on a page, cut at one border after the other.
fn part_on_page(area: &[[f64; 2]], page: Page) -> Vec<[f64; 2]> {
    let sides = [(0, 0.0, 1.0), (0, page.width, -1.0), (1, 0.0, 1.0), (1, page.height, -1.0)];
    sides.into_iter().fold(area.to_vec(), |area, (axis, border, inwards)| {
        let inside = |point: [f64; 2]| (point[axis] - border) * inwards;
        let next = area.iter().cycle().skip(1);
        let kept = area.iter().zip(next).flat_map(|(&from, &to)| {
            let [before, after] = [from, to].map(inside);
            let share = before / (before - after);
            let cut = std::array::from_fn(|e| from[e] + share * (to[e] - from[e]));
            let crosses = (before < 0.0) != (after < 0.0);
            [(before >= 0.0).then_some(from), crosses.then_some(cut)]
        });
        kept.flatten().collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::camera::clipped;
    use crate::{Lens, Mark, Shape, space_figure};
    use octoscope_core::random::Random;

    const PAGE: Page = Page { width: 3.0, height: 3.0 };

    /// How many lines and how many areas of a box are seen.
    fn seen<const D: usize>(role: Role, bounds: Aabb<D>, camera: &Camera<D>) -> [usize; 2] {
        let figure = space_figure(&[Mark::new(Shape::Box(bounds), role)], camera, PAGE);
        let forms = || figure.drawn.iter().map(|drawn| &drawn.form);
        let is_seen = |line| clipped(line, [[0.0; 2], [PAGE.width, PAGE.height]]).is_some();
        let is_line = |form: &&Form| matches!(form, Form::Polyline(p) if is_seen([p[0], p[1]]));
        let is_area =
            |form: &&Form| matches!(form, Form::Polygon(p) if part_on_page(p, PAGE).len() > 2);
        [forms().filter(is_line).count(), forms().filter(is_area).count()]
    }

    #[test]
    fn wherever_the_eye_is_what_is_seen_of_a_strayed_box_is_crossed_out() {
        let mut random = Random::new(7);
        let (mut n_behind, mut n_around) = (0, 0);
        for _ in 0..2000 {
            let mut between = |low: f64, high: f64| low + (high - low) * random.unit();
            let target = [0; 3].map(|_| between(-0.5, 1.5));
            let (height, yaw, pitch) = (between(0.05, 1.0), between(-3.0, 3.0), between(-1.5, 1.5));
            let camera = Camera { target, height, yaw, pitch, lens: Lens::Perspective };
            let bounds = Aabb { min: [0.0; 3], max: [1.0; 3] };
            let [edges, _] = seen(Role::Visited { share: 0.0 }, bounds, &camera);
            let [lines, areas] = seen(Role::Strayed, bounds, &camera);
            let is_around = is_around_eye(&camera, &bounds);
            let wanted = if is_around { 2 } else { 2 * areas };
            assert!(lines >= edges + wanted, "{camera:?}: {lines}, {edges}, {areas}");
            let ends = crate::camera::corners(&bounds).map(|end| camera.project(PAGE, end));
            n_behind += usize::from(areas > 0 && ends.into_iter().any(|end| end.is_none()));
            n_around += usize::from(is_around);
        }
        assert!(n_behind > 100 && n_around > 100, "{n_behind}, {n_around}");
    }

    #[test]
    fn a_corner_of_a_large_cell_is_crossed_out_too() {
        let bounds = Aabb { min: [0.0; 2], max: [1.0; 2] };
        for target in [[0.1, 0.05], [0.97, 0.4]] {
            let camera =
                Camera { target, height: 0.2, yaw: 0.0, pitch: 0.0, lens: Lens::default() };
            assert_eq!(seen(Role::Strayed, bounds, &camera), [2, 1]);
        }
    }

    #[test]
    fn an_area_of_any_number_of_corners_is_crossed_out_by_two_lines_that_meet() {
        for n in 3..=8_u32 {
            let turn = |k: u32| std::f64::consts::TAU * f64::from(k) / f64::from(n);
            let corner = |k| [turn(k).cos(), turn(k).sin()].map(|x| 1.5 + x);
            let area: Vec<[f64; 2]> = (0..n).map(corner).collect();
            let lines = cross_out(Role::Strayed, &area, PAGE);
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
            assert!(cross_out(Role::Current, &area, PAGE).is_empty());
        }
    }

    #[test]
    fn a_square_is_crossed_out_by_its_diagonals() {
        let [a, b, c, d] = [[0.1, 0.0], [1.0, 0.0], [1.0, 0.7], [0.1, 0.7]];
        let lines = [[a, c], [b, d]].map(|line| Form::Polyline(line.to_vec()));
        assert_eq!(cross_out(Role::Strayed, &[a, b, c, d], PAGE), lines);
    }
}
