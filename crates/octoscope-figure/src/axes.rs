//! Marks of the axes.

use crate::camera::corners;
use crate::sides::sides_to_eye;
use crate::{Camera, Mark, Page, Role, Shape, Show};
use octoscope_core::explain::distinct;
use octoscope_core::geometry::{AXIS_NAMES, Aabb};
use octoscope_core::tree::Domain;

/// Marks of the axes: numbers along the sides of a plane domain; in space a line along
/// an edge each, with its name. The numbers are coordinates, as those of the ray are;
/// where codes are shown, they are codes.
pub fn axes<const D: usize>(domain: &Domain<D>, show: &Show, camera: &Camera<D>) -> Vec<Mark<D>> {
    if D == 2 { numbers(domain, show) } else { edges(&domain.root_box(), camera) }
}

fn numbers<const D: usize>(domain: &Domain<D>, show: &Show) -> Vec<Mark<D>> {
    let bounds = domain.root_box();
    let mut marks = Vec::new();
    for axis in 0..D {
        let n_ticks = domain.grid_size().min(4);
        let codes: Vec<u32> =
            (0..=n_ticks).map(|tick| domain.grid_size() / n_ticks * tick).collect();
        let places: Vec<f64> = codes.iter().map(|&code| domain.plane(axis, code)).collect();
        let texts = if show.codes {
            codes.iter().map(|&code| short(code)).collect()
        } else {
            distinct(&places)
        };
        for (place, text) in places.into_iter().zip(texts) {
            // On the edge at the smallest other coordinates.
            let mut at = bounds.min;
            at[axis] = place;
            marks.push(Mark::new(Shape::Label(at), Role::AxisLabel(axis)).with_text(text));
        }
    }
    marks
}

/// Of every axis the edge of the domain at the rim of what is seen of it: the lowest on
/// the page, or the leftmost of the axis that stands upright. An axis that points at the
/// eye has none.
fn edges<const D: usize>(bounds: &Aabb<D>, camera: &Camera<D>) -> Vec<Mark<D>> {
    // Which is the lowest does not depend on the page.
    const PAGE: Page = Page { width: 1.0, height: 1.0 };
    let ends: Vec<[f64; D]> = corners(bounds).collect();
    let edge = |corner: usize, axis: usize| [ends[corner], ends[corner | bit::<D>(axis)]];
    let rank = |corner: usize, axis: usize| {
        let places = edge(corner, axis).map(|end| camera.project(PAGE, end));
        let along = |e: usize| places.iter().flatten().map(|place| place.at[e]).sum::<f64>();
        if axis + 1 == D { -along(0) } else { along(1) }
    };
    let seen = sides_to_eye(camera, PAGE, bounds);
    // Of the two sides that meet at the rim, one is seen.
    let is_at_rim = |corner: usize, axis: usize| {
        let beside = seen.iter().filter(|side| side.axis != axis);
        beside.filter(|side| (corner & bit::<D>(side.axis) != 0) == side.is_upper).count() == 1
    };
    let chosen = |axis: usize| {
        let own = (0..1usize << D).filter(|corner| corner & bit::<D>(axis) == 0);
        let mut at_rim = own.filter(|&corner| is_at_rim(corner, axis));
        // From inside there is no rim.
        let any = if seen.is_empty() { Some(0) } else { at_rim.next() };
        let lowest = at_rim.fold(any?, |a, b| if rank(b, axis) > rank(a, axis) { b } else { a });
        Some(edge(lowest, axis))
    };
    let marks = (0..D).filter_map(|axis| {
        let mark = Mark::new(Shape::Segment(chosen(axis)?), Role::AxisLabel(axis));
        Some(mark.with_text(AXIS_NAMES[axis]))
    });
    marks.collect()
}

/// What tells the upper from the lower corners along an axis, in their order.
fn bit<const D: usize>(axis: usize) -> usize {
    1 << (D - 1 - axis)
}

/// Names of the axes of a plane domain, beyond their last numbers, on a page that has room
/// for them: colours alone do not tell them. In space the names are among [`axes`].
pub fn axis_names<const D: usize>(
    domain: &Domain<D>,
    camera: &Camera<D>,
    page: Page,
) -> Vec<Mark<D>> {
    /// From the end of an axis to its name, in page units.
    const BEYOND: f64 = 20.0;
    /// Smaller pages have no room for names.
    const LEAST: f64 = 200.0;
    let bounds = domain.root_box();
    let name = |axis: usize| {
        let mut at = bounds.min;
        at[axis] = bounds.max[axis] + BEYOND * camera.unit(page);
        Mark::new(Shape::Label(at), Role::AxisLabel(axis)).with_text(AXIS_NAMES[axis])
    };
    let has_room = D == 2 && page.width.min(page.height) >= LEAST;
    (0..D).filter(|_| has_room).map(name).collect()
}

/// A code; one that is too long to stand beside the tree as a multiple of a power
/// of two, which the codes of ticks are.
fn short(code: u32) -> String {
    const LONG: u32 = 10_000;
    if code < LONG {
        return code.to_string();
    }
    let exponent = code.trailing_zeros();
    let factor = match code >> exponent {
        1 => String::new(),
        odd => format!("{odd}·"),
    };
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digits = exponent.to_string();
    let digits = digits.chars().filter_map(|digit| digit.to_digit(10));
    let raised: String = digits.map(|digit| RAISED[digit as usize]).collect();
    format!("{factor}2{raised}")
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn long_codes_are_written_as_powers() {
        let codes = [0, 256, 4096, 1 << 18, 3 << 18, 1 << 20].map(short);
        assert_eq!(codes, ["0", "256", "4096", "2¹⁸", "3·2¹⁸", "2²⁰"]);
    }
}
