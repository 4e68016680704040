//! Where the numbers of the visited leaves stand: each in its leaf, beside the part of
//! the ray that lies in it, or outside it with a line to it, and none on another or on
//! a handle. Of many that have no room together evenly spaced ones are left, so that the
//! sequence can still be read, and the last one, which tells where the algorithm is.

mod crowd;
mod places;

use crowd::Crowd;
use places::{aside, beside};

/// Number that looks for a place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Number {
    /// Its place in the order, from 1.
    pub order: usize,
    /// The part of the ray in its leaf, on the page.
    pub chord: [[f64; 2]; 2],
    /// Radius of its disc, the line around it included.
    pub radius: f64,
    /// Least and largest corner of its leaf on the page, where the leaf is an area
    /// of it: in the plane.
    pub leaf: Option<[[f64; 2]; 2]>,
}

/// Where a number stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stand {
    /// Middle of its disc.
    pub at: [f64; 2],
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

/// In the plane, at most so many have a place each, near or far; more are thinned.
const FEW: usize = 40;
/// In space, where they are thinned sooner.
const FEW_IN_SPACE: usize = 12;

/// Where `numbers`, in their order, stand, one entry each. The last of them has a
/// place unless handles leave none. Where there is not room for all of many, every
/// second, fifth or tenth has one, and so on, with the first and the last. O(n): a disc is
/// compared with those nearby alone, and there is room for few.
pub(crate) fn stands(numbers: &[Number], kept: Kept) -> Vec<Option<Stand>> {
    const STEPS: [usize; 7] = [1, 2, 5, 10, 20, 50, 100];
    let n = numbers.len();
    let every = |step: usize| -> Vec<usize> {
        let has_place = |index: &usize| {
            let order = numbers[*index].order;
            order == 1 || *index + 1 == n || order.is_multiple_of(step)
        };
        (0..n).filter(has_place).collect()
    };
    if are_few(numbers) {
        return placed(numbers, &every(1), kept);
    }
    // So many never have room; they are not tried.
    let most = kept.page[0] * kept.page[1] / 400.0;
    let sparse = STEPS.into_iter().map(every).filter(|chosen| chosen.len() as f64 <= most);
    let mut last = Vec::new();
    for chosen in sparse {
        last = placed(numbers, &chosen, kept);
        if chosen.iter().all(|&index| last[index].is_some()) {
            return last;
        }
    }
    if last.is_empty() { placed(numbers, &every(100), kept) } else { last }
}

/// Whether each number is to have its place.
fn are_few(numbers: &[Number]) -> bool {
    let is_plane = numbers.iter().any(|number| number.leaf.is_some());
    numbers.len() <= if is_plane { FEW } else { FEW_IN_SPACE }
}

/// Where the `chosen` of the numbers stand, the last of which chooses first: it tells where
/// the algorithm is. Then those by which one counts, then the others.
fn placed(numbers: &[Number], chosen: &[usize], kept: Kept) -> Vec<Option<Stand>> {
    let mut crowd = Crowd::new(kept);
    let mut stands = vec![None; numbers.len()];
    let last = numbers.len().saturating_sub(1);
    let mut by_rank = chosen.to_vec();
    by_rank.sort_by_key(|&index| if index == last { 0 } else { 1 + rank(numbers[index].order) });
    let is_far = are_few(numbers);
    for index in by_rank {
        let number = &numbers[index];
        let reach = if is_far && number.leaf.is_some() { Reach::Far } else { Reach::Near };
        let place = places_of(number, reach).find(|stand| crowd.has_room(number, stand));
        if let Some(stand) = place {
            crowd.place(number.radius, stand);
            stands[index] = place;
        }
    }
    stands
}

/// The smaller, the earlier a number chooses its place.
fn rank(order: usize) -> usize {
    let steps = [10, 5, 2].iter().position(|step| order.is_multiple_of(*step));
    if order == 1 { 0 } else { steps.unwrap_or(3) }
}

/// How far from its leaf a number may stand.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Reach {
    /// As far as a glance follows a line.
    Near,
    /// Wherever there is room.
    Far,
}

/// The places of a number, the best first.
fn places_of(number: &Number, reach: Reach) -> impl Iterator<Item = Stand> + use<> {
    let rows = match reach {
        Reach::Near => 3,
        Reach::Far => 14,
    };
    beside(number).into_iter().chain(aside(number, rows))
}

fn between([from, to]: [[f64; 2]; 2], share: f64) -> [f64; 2] {
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

#[cfg(test)]
mod tests {
    use super::crowd::collide;
    use super::places::{GAP, area_in, moved};
    use super::*;
    use crate::camera::clipped;
    use octoscope_core::random::Random;

    const PAGE: [f64; 2] = [800.0, 600.0];
    const RADIUS: f64 = 9.5;
    const FREE: Kept<'static> = Kept { taken: &[], lines: &[], page: PAGE };

    /// Chords of these lengths, one after the other along a line from `from`.
    fn path(
        from: [f64; 2],
        along: [f64; 2],
        lengths: impl IntoIterator<Item = f64>,
    ) -> Vec<Number> {
        let mut at = 0.0;
        let mut numbers = Vec::new();
        for (index, length) in lengths.into_iter().enumerate() {
            let chord = [at, at + length].map(|by| moved(from, along, by));
            numbers.push(Number { order: index + 1, chord, radius: RADIUS, leaf: None });
            at += length;
        }
        numbers
    }

    fn check(numbers: &[Number], taken: &[Taken]) -> Vec<usize> {
        let stands = stands(numbers, Kept { taken, lines: &[], page: PAGE });
        let shown: Vec<(&Number, Stand)> =
            numbers.iter().zip(stands).filter_map(|(n, stand)| Some((n, stand?))).collect();
        for (index, (number, stand)) in shown.iter().enumerate() {
            let away = distance_to_segment(stand.at, number.chord);
            let near = if stand.leader.is_some() { 4.0 * RADIUS } else { RADIUS + GAP + 1e-9 };
            assert!(away <= near, "{number:?} stands at {stand:?}");
            for (other, place) in &shown[..index] {
                assert!(!collide((RADIUS, *stand), (RADIUS, *place)), "{number:?} and {other:?}");
            }
            for [middle, reach] in taken {
                let clear =
                    (0..2).any(|e| (stand.at[e] - middle[e]).abs() >= reach[e] + RADIUS / 1.5);
                assert!(clear, "{number:?} covers a handle");
            }
        }
        shown.into_iter().map(|(number, _)| number.order).collect()
    }

    #[test]
    fn all_numbers_are_shown_where_there_is_room() {
        let numbers = path([50.0, 500.0], [0.8, -0.6], [40.0; 15]);
        assert_eq!(check(&numbers, &[]).len(), 15);
        let upper = stands(&numbers, FREE);
        assert!(upper.iter().all(|stand| stand.is_some_and(|stand| stand.leader.is_none())));
    }

    #[test]
    fn round_numbers_and_the_last_one_stay_in_a_crowd() {
        let numbers = path([50.0, 300.0], [1.0, 0.0], [2.0; 157]);
        let shown = check(&numbers, &[]);
        assert!(shown.len() < 100, "{shown:?}");
        for order in (10..=150).step_by(10).chain([1, 157]) {
            assert!(shown.contains(&order), "{order} of {shown:?}");
        }
    }

    #[test]
    fn many_that_have_no_room_together_are_evenly_spaced() {
        for n in [30, 80, 157, 400] {
            let numbers = path([50.0, 300.0], [1.0, 0.0], vec![600.0 / n as f64; n]);
            let shown = check(&numbers, &[]);
            let [first, inner @ .., last] = &shown[..] else { panic!("{shown:?}") };
            assert_eq!([*first, *last], [1, n], "{shown:?}");
            let by = inner[1] - inner[0];
            assert!(inner.windows(2).all(|pair| pair[1] - pair[0] == by), "{shown:?}");
        }
    }

    #[test]
    fn numbers_stand_in_their_leaf_where_it_has_room() {
        // The ray cuts the upper left corner off; above it lies another leaf.
        let chord = [[0.0, 112.0], [20.0, 100.0]];
        let leaf = Some([[0.0, 100.0], [80.0, 180.0]]);
        let number = Number { order: 1, chord, radius: RADIUS, leaf };
        let stand = stands(&[number], FREE)[0].unwrap();
        assert!(stand.at[0] > RADIUS && stand.at[1] > 100.0 + RADIUS, "{stand:?}");
    }

    #[test]
    fn numbers_keep_off_the_handles() {
        let numbers = path([100.0, 300.0], [1.0, 0.0], [12.0; 30]);
        let handles = [[[100.0, 300.0], [8.0; 2]], [[220.0, 300.0], [5.0; 2]]];
        assert!(check(&numbers, &handles).contains(&30));
    }

    #[test]
    fn numbers_of_any_path_stand_at_their_leaves() {
        let mut random = Random::new(7);
        for _ in 0..200 {
            let angle = random.between(0.0, std::f64::consts::TAU);
            let from = [random.between(0.0, 800.0), random.between(0.0, 600.0)];
            let n = random.between(1.0, 120.0) as usize;
            let lengths: Vec<f64> = (0..n).map(|_| random.between(0.0, 9.0).powi(2)).collect();
            check(&path(from, [angle.cos(), angle.sin()], lengths), &[[from, [8.0; 2]]]);
        }
    }

    /// The leaves of a random quadtree between two corners on the page.
    fn leaves(random: &mut Random, [min, max]: [[f64; 2]; 2], depth: usize) -> Vec<[[f64; 2]; 2]> {
        if depth == 0 || depth < 3 && random.below(3) == 0 {
            return vec![[min, max]];
        }
        let middle: [f64; 2] = std::array::from_fn(|e| 0.5 * (min[e] + max[e]));
        let quarters = [[0, 0], [0, 1], [1, 0], [1, 1]].map(|upper: [usize; 2]| {
            let corner = |ends: [[f64; 2]; 2]| std::array::from_fn(|e| ends[upper[e]][e]);
            [corner([min, middle]), corner([middle, max])]
        });
        quarters.into_iter().flat_map(|quarter| leaves(random, quarter, depth - 1)).collect()
    }

    #[test]
    fn a_number_without_a_line_covers_more_of_its_leaf_than_of_any_other() {
        let mut random = Random::new(11);
        let (mut n_beside, mut n_aside) = (0, 0);
        for _ in 0..200 {
            let cells = leaves(&mut random, [[90.0, 30.0], [630.0, 570.0]], 6);
            let angle = random.between(0.0, std::f64::consts::TAU);
            let along = [angle.cos(), angle.sin()];
            let through = [random.between(150.0, 570.0), random.between(90.0, 510.0)];
            let ray = [-2000.0, 2000.0].map(|by| moved(through, along, by));
            let mut chords: Vec<_> = cells
                .iter()
                .filter_map(|&leaf| Some((clipped(ray, leaf)?, leaf)))
                .filter(|([from, to], _)| distance(*from, *to) > 1e-6)
                .collect();
            chords.sort_by(|(a, _), (b, _)| {
                distance(ray[0], a[0]).total_cmp(&distance(ray[0], b[0]))
            });
            chords.truncate(1 + random.below(chords.len() as u64) as usize);
            let numbers: Vec<Number> = chords
                .iter()
                .enumerate()
                .map(|(n, &(chord, leaf))| Number {
                    order: n + 1,
                    chord,
                    radius: RADIUS,
                    leaf: Some(leaf),
                })
                .collect();
            let shown = stands(&numbers, Kept { lines: &[ray], ..FREE });
            assert!(shown.last().is_some_and(Option::is_some), "the last of {numbers:?}");
            let all = || shown.iter().zip(&numbers).filter_map(|(stand, n)| Some(((*stand)?, n)));
            for (Stand { at, leader }, number) in all() {
                assert!(distance_to_segment(at, ray) >= RADIUS, "{number:?} covers the ray");
                let Some(line) = leader else {
                    n_beside += 1;
                    let own = number.leaf.map_or(0.0, |leaf| area_in(at, RADIUS, leaf));
                    let others = cells.iter().filter(|cell| Some(**cell) != number.leaf);
                    let most = others.map(|cell| area_in(at, RADIUS, *cell)).fold(0.0, f64::max);
                    assert!(own > most, "{number:?} stands at {at:?}: {own} < {most}");
                    continue;
                };
                n_aside += 1;
                for (other, _) in all().filter(|(_, other)| other.order != number.order) {
                    let clear = distance_to_segment(other.at, line);
                    assert!(clear > RADIUS, "the line of {number:?} crosses {other:?}");
                }
            }
        }
        assert!(n_beside > 500 && n_aside > 500, "{n_beside} {n_aside}");
    }

    #[test]
    fn lines_to_leaves_do_not_strike_what_is_taken() {
        let chord = [[300.0, 300.0], [310.0, 300.0]];
        let leaf = Some([[300.0, 295.0], [310.0, 305.0]]);
        let number = Number { order: 1, chord, radius: RADIUS, leaf };
        let taken = [[[305.0, 286.0], [3.0; 2]]];
        let stand = stands(&[number], Kept { taken: &taken, ..FREE })[0].unwrap();
        assert!(stand.at[1] > 305.0, "{stand:?}");
    }
}
