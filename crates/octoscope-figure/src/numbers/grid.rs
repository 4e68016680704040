//! Places in rows along the ray, on both sides of it, and how numbers are shared out among
//! them so that no line to one crosses another.

use super::crowd::BETWEEN;
use super::places::{LINE, foot, led, moved, upwards};
use super::{Number, Stand, between};
use std::ops::Range;

/// Number of rows on either side.
pub(super) const ROWS: usize = 6;
/// Slots that a disc and the next one in the row are apart.
const APART: usize = 3;

/// Slots along a ray, in rows on both sides of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    from: [f64; 2],
    along: [f64; 2],
    across: [f64; 2],
    /// Radius of discs, and length of a slot.
    radius: f64,
    step: f64,
    /// Number of slots in a row.
    pub n_slots: usize,
}

/// A place in a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Slot {
    /// On which side of the ray, 0 for the upper.
    pub side: usize,
    pub row: usize,
    /// Its place in the row.
    pub index: usize,
}

impl Grid {
    /// The grid beside these numbers, as far as lines to them reach.
    pub fn of(numbers: &[&Number]) -> Option<Self> {
        let (first, last) = (numbers.first()?, numbers.last()?);
        let across = upwards([first.chord[0], last.chord[1]]);
        let along = [-across[1], across[0]];
        let radius = numbers.iter().map(|number| number.radius).fold(0.0, f64::max);
        let step = (2.0 * radius + BETWEEN) / APART as f64 + 1e-6;
        let origin = first.chord[0];
        let grid = Self { from: origin, along, across, radius, step, n_slots: 0 };
        let places = numbers.iter().flat_map(|number| number.chord);
        let places: Vec<f64> = places.map(|at| grid.along(at)).collect();
        let reach = SLANT * grid.away(ROWS - 1) + step;
        let low = places.iter().copied().fold(f64::INFINITY, f64::min) - reach;
        let high = places.iter().copied().fold(f64::NEG_INFINITY, f64::max) + reach;
        let n_slots = ((high - low) / step).ceil() as usize + 1;
        Some(Self { from: moved(origin, along, low), n_slots, ..grid })
    }

    fn along(&self, at: [f64; 2]) -> f64 {
        (0..2).map(|e| (at[e] - self.from[e]) * self.along[e]).sum()
    }

    /// How far a row lies from the ray.
    fn away(&self, row: usize) -> f64 {
        self.radius + LINE + 1.7 * self.radius * row as f64
    }

    /// Where a number stands along the grid.
    pub fn place_of(&self, number: &Number) -> f64 {
        self.along(between(number.chord, 0.5))
    }

    /// The places of a number in a row, on both sides, with a line that is not too flat.
    pub fn places(&self, number: &Number, row: usize) -> Vec<(Slot, Stand)> {
        let mut places = Vec::new();
        for (side, sign) in [1.0, -1.0].into_iter().enumerate() {
            let foot = foot(number, self.across, sign);
            let off = [0, 1].map(|e| (foot[e] - self.from[e]) * self.across[e]);
            let away = self.away(row) - sign * (off[0] + off[1]);
            if away < self.radius + 0.6 * LINE {
                continue;
            }
            for index in self.slots_around(self.along(foot), SLANT * away) {
                let on_line = moved(self.from, self.along, index as f64 * self.step);
                let at = moved(on_line, self.across, sign * self.away(row));
                places.push((Slot { side, row, index }, led(foot, at, number.radius)));
            }
        }
        places
    }

    fn slots_around(&self, place: f64, reach: f64) -> Range<usize> {
        let low = ((place - reach) / self.step).ceil().max(0.0) as usize;
        let high = ((place + reach) / self.step).floor() as usize + 1;
        low..high.min(self.n_slots).max(low)
    }
}

/// How far a line goes along the ray, at most, for how far it leads away from it: a flatter
/// one would strike the next disc of its row.
const SLANT: f64 = 1.6;

/// What it costs a number to stand in the slots of one row, by side and slot.
pub(super) type Costs = [Vec<f64>; 2];

/// The cheapest way to share numbers out among the slots of a row on both sides, in their
/// order along the ray, with what all of it costs; `none` is what it costs each to have no
/// place. O(numbers · slots²).
pub(super) fn shared_out(
    costs: &[Costs],
    n_slots: usize,
    none: impl Fn(usize) -> f64,
) -> (f64, Vec<Option<[usize; 2]>>) {
    let size = n_slots + APART;
    let at = |[upper, lower]: [usize; 2]| upper * size + lower;
    // By the first slots that are free above and below: what that costs at least, and how
    // it was come to.
    let mut best = vec![f64::INFINITY; size * size];
    best[0] = 0.0;
    let mut ways: Vec<Vec<Way>> = Vec::new();
    for (number, costs) in costs.iter().enumerate() {
        let mut next: Vec<f64> = best.iter().map(|cost| cost + none(number)).collect();
        let mut way: Vec<Way> =
            (0..size * size).map(|from| Way { place: None, from: from as u32 }).collect();
        for (side, of_side) in costs.iter().enumerate() {
            for other in 0..size {
                let place = |own: usize| if side == 0 { [own, other] } else { [other, own] };
                let (mut least, mut from) = (f64::INFINITY, 0);
                for (slot, cost) in of_side.iter().enumerate() {
                    let here = at(place(slot));
                    if best[here] < least {
                        (least, from) = (best[here], here);
                    }
                    let to = at(place(slot + APART));
                    if least + cost < next[to] {
                        next[to] = least + cost;
                        way[to] = Way { place: Some([side, slot]), from: from as u32 };
                    }
                }
            }
        }
        best = next;
        ways.push(way);
    }
    let ends = best.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
    let Some((mut end, &cost)) = ends else { return (0.0, Vec::new()) };
    let mut places = vec![None; costs.len()];
    for (number, way) in ways.iter().enumerate().rev() {
        places[number] = way[end].place;
        end = way[end].from as usize;
    }
    (cost, places)
}

/// How a state of the sharing out was come to.
#[derive(Clone, Copy)]
struct Way {
    /// Side and slot of the number, if it has a place.
    place: Option<[usize; 2]>,
    from: u32,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_shared_out_in_their_order_and_apart() {
        // All would stand best in one slot.
        let of = |slot: usize| (slot as f64 - 9.0).abs();
        let costs: Vec<Costs> =
            (0..6).map(|_| [(0..19).map(of).collect(), (0..19).map(of).collect()]).collect();
        let (cost, places) = shared_out(&costs, 19, |_| 1e6);
        assert_eq!(cost, 12.0);
        for side in 0..2 {
            let own = places.iter().flatten().filter(|place| place[0] == side);
            let own: Vec<usize> = own.map(|place| place[1]).collect();
            assert_eq!(own, [6, 9, 12]);
        }
        let (cost, places) = shared_out(&costs[..1], 19, |_| -1.0);
        assert_eq!((cost, places), (-1.0, vec![None]));
    }
}
