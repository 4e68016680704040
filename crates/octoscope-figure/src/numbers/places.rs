//! The places of one number.

use super::{Number, Stand, between, distance, distance_to_segment};

/// Room between a disc and the ray.
pub(super) const GAP: f64 = 4.0;
/// Least length of a line from a leaf to its number: less is not seen as a line.
const LINE: f64 = 9.0;
/// Share of a disc that lies in its leaf, at least, where no line tells whose it is.
const LEAST: f64 = 0.7;

/// Places without a line, the best first: those that touch the chord, in the leaf as a
/// whole, then with most of the disc; then in the corners of the leaf. Where
/// the leaf is no area of the page, all that touch the chord.
pub(super) fn beside(number: &Number) -> Vec<Stand> {
    let Number { chord, radius, leaf, .. } = *number;
    if leaf.is_some_and(|leaf| area(leaf) < LEAST * disc(radius)) {
        return Vec::new();
    }
    let across = upwards(chord);
    let away = radius + GAP;
    // At its middle, to the upper side, then the lower; then towards its ends.
    let mut places: Vec<[f64; 2]> = [0.5, 0.25, 0.75, 0.0, 1.0]
        .into_iter()
        .flat_map(|share| [away, -away].map(|away| moved(between(chord, share), across, away)))
        .collect();
    if let Some(leaf) = leaf {
        let share = |at: [f64; 2]| area_in(at, radius, leaf) / disc(radius);
        let mut shares: Vec<_> = places.into_iter().map(|at| (at, share(at))).collect();
        shares.retain(|(_, share)| *share >= LEAST);
        shares.sort_by_key(|(_, share)| *share < 1.0);
        places = shares.into_iter().map(|(at, _)| at).collect();
        let keeps_off = |at: &[f64; 2]| distance_to_segment(*at, chord) >= away;
        places.extend(corners_of(leaf, radius + 1.5).into_iter().filter(keeps_off));
    }
    places.into_iter().map(|at| Stand { at, leader: None }).collect()
}

/// Places in the corners of a leaf, so far from its sides; none in one too small.
fn corners_of([min, max]: [[f64; 2]; 2], inset: f64) -> Vec<[f64; 2]> {
    if (0..2).any(|e| max[e] - min[e] < 2.0 * inset) {
        return Vec::new();
    }
    let ends = [0, 1].map(|e| [min[e] + inset, max[e] - inset]);
    let [[left, right], [top, bottom]] = ends;
    vec![[left, top], [right, top], [left, bottom], [right, bottom]]
}

/// Places outside the leaf with a line from the middle of the chord, in so many rows,
/// the nearest first: not farther than a glance follows the line.
pub(super) fn aside(number: &Number, rows: usize) -> impl Iterator<Item = Stand> + use<> {
    let Number { chord, radius, .. } = *number;
    let across = upwards(chord);
    let along = [-across[1], across[0]];
    let foot = between(chord, 0.5);
    let near = radius + LINE;
    let places = (0..rows).flat_map(move |row| {
        let away = near + 0.9 * radius * row as f64;
        // The farther, the more to the side as well.
        let n_shifts = if row < 3 { 5 } else { 9 };
        let shifts = [0.0, -0.6, 0.6, -1.2, 1.2, -2.0, 2.0, -3.0, 3.0].into_iter().take(n_shifts);
        shifts.flat_map(move |shift| {
            [away, -away].map(|away| moved(moved(foot, across, away), along, shift * radius))
        })
    });
    places.map(move |at| {
        let rim = between([foot, at], 1.0 - radius / distance(foot, at));
        Stand { at, leader: Some([foot, rim]) }
    })
}

fn area([min, max]: [[f64; 2]; 2]) -> f64 {
    (max[0] - min[0]) * (max[1] - min[1])
}

fn disc(radius: f64) -> f64 {
    std::f64::consts::PI * radius * radius
}

/// Area of the part of a disc that lies between two corners, strip by strip.
pub(super) fn area_in(at: [f64; 2], radius: f64, [min, max]: [[f64; 2]; 2]) -> f64 {
    const STRIPS: usize = 24;
    if (0..2).all(|e| min[e] <= at[e] - radius && at[e] + radius <= max[e]) {
        return disc(radius);
    }
    let high = 2.0 * radius / STRIPS as f64;
    let strips = (0..STRIPS).map(|strip| {
        let y = (strip as f64 + 0.5) * high - radius;
        if !(min[1]..=max[1]).contains(&(at[1] + y)) {
            return 0.0;
        }
        let half = (radius * radius - y * y).sqrt();
        ((at[0] + half).min(max[0]) - (at[0] - half).max(min[0])).max(0.0)
    });
    high * strips.sum::<f64>()
}

/// Unit vector across a chord that points up on the page; to the right where
/// the chord stands upright.
fn upwards([from, to]: [[f64; 2]; 2]) -> [f64; 2] {
    let length = distance(from, to);
    if length < 1e-9 {
        return [0.0, -1.0];
    }
    let across: [f64; 2] = [(to[1] - from[1]) / length, (from[0] - to[0]) / length];
    let is_down = across[1] > 0.0 || across[1] == 0.0 && across[0] < 0.0;
    if is_down { across.map(|x| -x) } else { across }
}

pub(super) fn moved(from: [f64; 2], along: [f64; 2], by: f64) -> [f64; 2] {
    std::array::from_fn(|e| from[e] + by * along[e])
}
