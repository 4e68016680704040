//! Marks of what is in the tree, and of its axes.

use crate::{Cut, Mark, Role, Shape, Show};
use octoscope_core::explain::distinct;
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::scene::Content;
use octoscope_core::tree::Domain;

/// Marks of points and primitives. O(contents), and the same as long as these
/// are; none of cells and pictures, which are seen in their leaves. Behind a cut, what
/// is left of them.
pub fn content<const D: usize>(content: &Content<D>, cut: Option<&Cut>) -> Vec<Mark<D>> {
    let marks = whole(content);
    match cut {
        Some(cut) => marks.into_iter().flat_map(|mark| cut.parts(mark)).collect(),
        None => marks,
    }
}

fn whole<const D: usize>(content: &Content<D>) -> Vec<Mark<D>> {
    let solid = |shape| Mark::new(shape, Role::Solid);
    match content {
        Content::Points(points) => {
            points.iter().map(|&p| Mark::new(Shape::Point(p), Role::Content)).collect()
        }
        Content::Spheres(spheres) => spheres
            .iter()
            .map(|s| solid(Shape::Sphere { centre: s.centre, radius: s.radius }))
            .collect(),
        Content::Boxes(boxes) => boxes.iter().map(|&b| solid(Shape::Box(b))).collect(),
        Content::Triangles(triangles) => {
            triangles.iter().map(|&t| solid(Shape::Triangle(t))).collect()
        }
        Content::Cells(_) | Content::Image(_) => Vec::new(),
    }
}

/// Marks of the axes: numbers along the sides of a plane domain, names at the edges of
/// a space domain. The numbers are coordinates, as those of the ray are; where codes
/// are shown, they are codes.
pub fn axes<const D: usize>(domain: &Domain<D>, show: &Show) -> Vec<Mark<D>> {
    let bounds = domain.root_box();
    let gap = 0.03 * domain.side();
    let label = |axis: usize, at: [f64; D], text: String| {
        Mark::new(Shape::Label(at), Role::AxisLabel(axis)).with_text(text)
    };
    // A place along `axis`, on the edge at the smallest other coordinates.
    let beside = |axis: usize, along: f64| -> [f64; D] {
        std::array::from_fn(|e| if e == axis { along } else { bounds.min[e] })
    };
    let mut marks = Vec::new();
    for axis in 0..D {
        if D == 2 {
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
                marks.push(label(axis, beside(axis, place), text));
            }
        } else {
            let edge = [bounds.min[axis], bounds.max[axis]].map(|x| beside(axis, x));
            marks.push(Mark::new(Shape::Segment(edge), Role::AxisLabel(axis)));
            let at = beside(axis, bounds.max[axis] + 2.0 * gap);
            marks.push(label(axis, at, AXIS_NAMES[axis].to_string()));
        }
    }
    marks
}

/// Names of the axes of a plane domain, as far beyond their last numbers: for figures
/// on paper, which may be without colours. In space the names are among [`axes`].
pub fn axis_names<const D: usize>(domain: &Domain<D>, beyond: f64) -> Vec<Mark<D>> {
    let bounds = domain.root_box();
    let name = |axis: usize| {
        let mut at = bounds.min;
        at[axis] = bounds.max[axis] + beyond;
        Mark::new(Shape::Label(at), Role::AxisLabel(axis)).with_text(AXIS_NAMES[axis].to_string())
    };
    (0..D).filter(|_| D == 2).map(name).collect()
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
