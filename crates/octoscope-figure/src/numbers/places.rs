//! The places of one number.

use super::{Number, Stand, between, distance, distance_to_segment};

/// Room between a disc and the ray.
pub(super) const GAP: f64 = 4.0;
/// The same of a small disc, and of one in a corner of its leaf.
const LEAST_GAP: f64 = 2.5;
/// Room between a disc in a corner and the sides there.
const INSET: f64 = 1.0;
/// Least length of a line from a leaf to its number: less is not seen as a line.
pub(super) const LINE: f64 = 9.0;
/// Share of a disc that lies on what is seen of its leaf, at least, where no line tells
/// whose it is.
const LEAST: f64 = 0.7;

/// Places on the leaf, the best first: those where all of the disc lies on it, at the ray
/// or in its corners; the same with a smaller disc; then those where most of it does.
pub(super) fn beside(number: &Number) -> Vec<Stand> {
    let Number { chord, radius, tight, ref leaf, .. } = *number;
    let [mut whole, mut most] = [const { Vec::new() }; 2];
    for (radius, gap) in [(radius, GAP), (tight, LEAST_GAP)] {
        let stand = |at| Stand { at, radius, leader: None };
        for at in touching(chord, radius + gap) {
            let share = leaf.share_of(at, radius);
            if share >= 1.0 {
                whole.push(stand(at));
            } else if share >= LEAST {
                most.push(stand(at));
            }
        }
        let is_off = |at: &[f64; 2]| distance_to_segment(*at, chord) >= radius + LEAST_GAP;
        let corners = leaf.corners(radius + INSET).into_iter().filter(is_off);
        let is_seen = |at: &[f64; 2]| leaf.share_of(*at, radius) >= 1.0;
        whole.extend(corners.filter(is_seen).map(stand));
    }
    whole.append(&mut most);
    whole
}

/// Points so far from a chord: at its middle, to the upper side, then the lower; then
/// towards its ends.
fn touching(chord: [[f64; 2]; 2], away: f64) -> impl Iterator<Item = [f64; 2]> {
    let across = upwards(chord);
    [0.5, 0.25, 0.75, 0.0, 1.0]
        .into_iter()
        .flat_map(move |share| [away, -away].map(|away| moved(between(chord, share), across, away)))
}

/// Places outside the leaf with a line that ends in it, the nearest first: not farther than
/// a glance follows the line.
pub(super) fn aside(number: &Number) -> impl Iterator<Item = Stand> + use<> {
    const ROWS: u32 = 3;
    const SHIFTS: [f64; 5] = [0.0, -0.6, 0.6, -1.2, 1.2];
    let across = upwards(number.chord);
    let along = [-across[1], across[0]];
    let radius = number.radius;
    let feet = [1.0, -1.0].map(|side| foot(number, across, side));
    (0..ROWS).flat_map(move |row| {
        let away = radius + LINE + 0.9 * radius * f64::from(row);
        SHIFTS.into_iter().flat_map(move |shift| {
            [(feet[0], away), (feet[1], -away)].map(|(foot, away)| {
                led(foot, moved(moved(foot, across, away), along, shift * radius), radius)
            })
        })
    })
}

/// A disc with a line to it.
pub(super) fn led(foot: [f64; 2], at: [f64; 2], radius: f64) -> Stand {
    let rim = between([foot, at], 1.0 - radius / distance(foot, at));
    Stand { at, radius, leader: Some([foot, rim]) }
}

/// Where a line to one side of the ray ends: well in the leaf, though not beyond the ray,
/// unless that only cuts a corner of the leaf, in which others meet.
pub(super) fn foot(number: &Number, across: [f64; 2], side: f64) -> [f64; 2] {
    /// Chords of less than this, in page units, lie in a corner.
    const CORNER: f64 = 12.0;
    let at_ray = between(number.chord, 0.5);
    let within = number.leaf.middle().map(|middle| between([at_ray, middle], 0.5));
    let within = within.filter(|at| number.leaf.holds(*at));
    let is_there = |at: &[f64; 2]| {
        let off = [0, 1].map(|e| across[e] * (at[e] - at_ray[e])).into_iter().sum::<f64>();
        side * off >= 0.0 || distance(number.chord[0], number.chord[1]) < CORNER
    };
    within.filter(is_there).unwrap_or(at_ray)
}

/// Unit vector across a chord that points up on the page; to the right where
/// the chord stands upright.
pub(super) fn upwards([from, to]: [[f64; 2]; 2]) -> [f64; 2] {
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
