//! Where the numbers of the visited leaves stand: each in its leaf, beside the part of
//! the ray that lies in it, or outside it with a line to it, and none on another or on
//! a handle. Of many that have no room together evenly spaced ones are left, so that the
//! sequence can still be read, and the last one, which tells where the algorithm is.

mod area;
mod crowd;
mod few;
mod grid;
mod many;
mod places;
#[cfg(test)]
mod tests;

pub(crate) use area::{Area, Convex};

/// Number that looks for a place.
#[derive(Clone, Debug)]
pub(crate) struct Number {
    /// Its place in the order, from 1.
    pub order: usize,
    /// The part of the ray in its leaf, on the page.
    pub chord: [[f64; 2]; 2],
    /// Radius of its disc, the line around it included.
    pub radius: f64,
    /// The same of a smaller one, where that finds room in the leaf.
    pub tight: f64,
    /// What is seen of its leaf.
    pub leaf: Area,
}

/// Where a number stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stand {
    /// Middle of its disc.
    pub at: [f64; 2],
    /// Radius of that, the line around it included.
    pub radius: f64,
    /// Line from the leaf to the disc, if it was pulled aside.
    pub leader: Option<[[f64; 2]; 2]>,
}

/// Middle and half extents of what numbers may not cover.
pub(crate) type Taken = [[f64; 2]; 2];

/// What numbers may not cover.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kept<'a> {
    /// What neither discs nor lines may cover.
    pub taken: &'a [Taken],
    /// Lines that discs may not cover.
    pub lines: &'a [[[f64; 2]; 2]],
    /// Width and height of the page, which they may not leave.
    pub page: [f64; 2],
}

/// Where `numbers`, in their order, stand, one entry each. Each of at most `few` has a
/// place, near or far; more are thinned.
pub(crate) fn stands(numbers: &[Number], kept: Kept, few: usize) -> Vec<Option<Stand>> {
    if numbers.len() <= few { few::settled(numbers, kept) } else { many::thinned(numbers, kept) }
}

pub(crate) fn between([from, to]: [[f64; 2]; 2], share: f64) -> [f64; 2] {
    std::array::from_fn(|e| from[e] + share * (to[e] - from[e]))
}

fn square([x, y]: [f64; 2]) -> f64 {
    x * x + y * y
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    square_between(a, b).sqrt()
}

fn square_between(a: [f64; 2], b: [f64; 2]) -> f64 {
    square([a[0] - b[0], a[1] - b[1]])
}

/// Distance of a point from a line between two points.
pub(crate) fn distance_to_segment(at: [f64; 2], segment: [[f64; 2]; 2]) -> f64 {
    square_to_segment(at, segment).sqrt()
}

/// The square of that distance: most are only compared, and a root takes its time.
fn square_to_segment(at: [f64; 2], segment: [[f64; 2]; 2]) -> f64 {
    let [from, to] = segment;
    let length = square_between(from, to);
    if length < 1e-18 {
        return square_between(at, from);
    }
    let along = (0..2).map(|e| (at[e] - from[e]) * (to[e] - from[e])).sum::<f64>();
    square_between(at, between(segment, (along / length).clamp(0.0, 1.0)))
}

/// Whether two segments cross each other.
pub(crate) fn do_cross([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let side = |[from, to]: [[f64; 2]; 2], at: [f64; 2]| {
        (to[0] - from[0]) * (at[1] - from[1]) - (to[1] - from[1]) * (at[0] - from[0])
    };
    side([a, b], c) * side([a, b], d) < 0.0 && side([c, d], a) * side([c, d], b) < 0.0
}
