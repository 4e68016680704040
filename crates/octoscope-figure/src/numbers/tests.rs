//! Numbers along random rays, in random trees.

use super::crowd::collide;
use super::places::{GAP, moved};
use super::*;
use crate::camera::clipped;
use octoscope_core::random::Random;

const PAGE: [f64; 2] = [800.0, 600.0];
const RADIUS: f64 = 9.5;
const TIGHT: f64 = 7.0;
/// So many numbers have a place each, in the plane and in space.
const FEW: usize = 40;
const FEW_IN_SPACE: usize = 12;
const FREE: Kept<'static> = Kept { taken: &[], lines: &[], page: PAGE };

fn area(corners: Vec<[f64; 2]>) -> Area {
    Area { own: Convex::new(corners).into_iter().collect(), before: Vec::new() }
}

/// The area between two corners.
fn rectangle([min, max]: [[f64; 2]; 2]) -> Area {
    area(vec![min, [max[0], min[1]], max, [min[0], max[1]]])
}

/// Chords of these lengths, one after the other along a line from `from`, in leaves that
/// reach as far as discs beside the line.
fn path(from: [f64; 2], along: [f64; 2], lengths: impl IntoIterator<Item = f64>) -> Vec<Number> {
    const ASIDE: f64 = 2.0 * RADIUS + GAP + 1.0;
    let across = [-along[1], along[0]];
    let mut at = 0.0;
    let mut numbers = Vec::new();
    for (index, length) in lengths.into_iter().enumerate() {
        let chord = [at, at + length].map(|by| moved(from, along, by));
        let Some(chord) = clipped(chord, [[0.0; 2], PAGE]) else { break };
        let [from, to] = chord;
        let ends = [(from, -ASIDE), (to, -ASIDE), (to, ASIDE), (from, ASIDE)];
        let leaf = area(ends.map(|(end, by)| moved(end, across, by)).to_vec());
        numbers.push(Number { order: index + 1, chord, radius: RADIUS, tight: TIGHT, leaf });
        at += length;
    }
    numbers
}

fn check(numbers: &[Number], taken: &[Taken]) -> Vec<usize> {
    let stands = stands(numbers, Kept { taken, ..FREE }, FEW_IN_SPACE);
    let shown: Vec<(&Number, Stand)> =
        numbers.iter().zip(stands).filter_map(|(n, stand)| Some((n, stand?))).collect();
    for (index, (number, stand)) in shown.iter().enumerate() {
        let away = distance_to_segment(stand.at, number.chord);
        let is_near = match stand.leader {
            Some(_) => away <= if numbers.len() <= FEW_IN_SPACE { 8.0 } else { 4.0 } * RADIUS,
            None => number.leaf.share_of(stand.at, stand.radius) >= 0.7,
        };
        assert!(is_near, "{number:?} stands at {stand:?}");
        for (other, place) in &shown[..index] {
            assert!(!collide(stand, place), "{number:?} and {other:?}");
        }
        for [middle, reach] in taken {
            let clear =
                (0..2).any(|e| (stand.at[e] - middle[e]).abs() >= reach[e] + stand.radius / 1.5);
            assert!(clear, "{number:?} covers a handle");
        }
    }
    shown.into_iter().map(|(number, _)| number.order).collect()
}

#[test]
fn all_numbers_are_shown_where_there_is_room() {
    let numbers = path([50.0, 500.0], [0.8, -0.6], [40.0; 15]);
    assert_eq!(check(&numbers, &[]).len(), 15);
    let upper = stands(&numbers, FREE, FEW);
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
    let leaf = rectangle([[0.0, 100.0], [80.0, 180.0]]);
    let number = Number { order: 1, chord, radius: RADIUS, tight: TIGHT, leaf };
    let stand = stands(&[number], FREE, FEW)[0].unwrap();
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

/// Least and largest corner.
type Corners = [[f64; 2]; 2];

/// The leaves that a random ray meets in a random tree with this root, as numbers, as many
/// as it has come to, and the ray; at what is seen of it on the page.
fn met(
    random: &mut Random,
    root: [[f64; 2]; 2],
    depth: usize,
) -> (Vec<Corners>, Vec<Corners>, [[f64; 2]; 2]) {
    let cells = leaves(random, root, depth);
    let angle = random.between(0.0, std::f64::consts::TAU);
    let along = [angle.cos(), angle.sin()];
    let through = [0, 1].map(|e| {
        let inset = 0.1 * (root[1][e] - root[0][e]);
        random.between(root[0][e] + inset, root[1][e] - inset)
    });
    let ray = [-2000.0, 2000.0].map(|by| moved(through, along, by));
    let mut met: Vec<_> = cells
        .iter()
        .filter_map(|&leaf| Some((clipped(ray, leaf)?, leaf)))
        .filter(|([from, to], _)| distance(*from, *to) > 1e-6)
        .collect();
    met.sort_by(|(a, _), (b, _)| distance(ray[0], a[0]).total_cmp(&distance(ray[0], b[0])));
    met.truncate(1 + random.below(met.len() as u64) as usize);
    (cells, met.into_iter().map(|(_, leaf)| leaf).collect(), ray)
}

/// Numbers of leaves along a ray.
fn numbers_of(leaves: &[[[f64; 2]; 2]], ray: [[f64; 2]; 2]) -> Vec<Number> {
    let numbers = leaves.iter().enumerate().map(|(n, &leaf)| Number {
        order: n + 1,
        chord: clipped(ray, leaf).unwrap(),
        radius: RADIUS,
        tight: TIGHT,
        leaf: rectangle(leaf),
    });
    numbers.collect()
}

/// Area of the part of a disc that lies between two corners, strip by strip.
fn area_in(at: [f64; 2], radius: f64, [min, max]: [[f64; 2]; 2]) -> f64 {
    const STRIPS: usize = 24;
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

#[test]
fn a_number_without_a_line_covers_more_of_its_leaf_than_of_any_other() {
    let mut random = Random::new(11);
    let (mut n_beside, mut n_aside) = (0, 0);
    for _ in 0..200 {
        let (cells, met, ray) = met(&mut random, [[90.0, 30.0], [630.0, 570.0]], 6);
        let numbers = numbers_of(&met, ray);
        let shown = stands(&numbers, Kept { lines: &[ray], ..FREE }, FEW);
        assert!(shown.last().is_some_and(Option::is_some), "the last of {numbers:?}");
        let all = || shown.iter().zip(&met).filter_map(|(stand, leaf)| Some(((*stand)?, *leaf)));
        for (n, (stand @ Stand { at, radius, leader }, leaf)) in all().enumerate() {
            assert!(distance_to_segment(at, ray) >= radius, "{leaf:?} covers the ray");
            if leader.is_none() {
                n_beside += 1;
                let own = area_in(at, radius, leaf);
                let others = cells.iter().filter(|cell| **cell != leaf);
                let most = others.map(|cell| area_in(at, radius, *cell)).fold(0.0, f64::max);
                assert!(own > most, "{leaf:?} stands at {at:?}: {own} < {most}");
                continue;
            }
            n_aside += 1;
            for (_, (other, _)) in all().enumerate().filter(|(other, _)| *other != n) {
                assert!(!collide(&stand, &other), "{stand:?} of {leaf:?} meets {other:?}");
            }
        }
    }
    assert!(n_beside > 500 && n_aside > 500, "{n_beside} {n_aside}");
}

#[test]
fn each_of_a_few_has_its_number_in_its_leaf_or_near_it_on_the_page_of_a_lecture() {
    const LECTURE: [f64; 2] = [336.0, 362.0];
    let mut random = Random::new(3);
    let (mut lines, mut n_numbers, mut n_crossed) = (Vec::new(), 0, 0);
    for _ in 0..200 {
        let (_, met, ray) = met(&mut random, [[67.0, 60.0], [309.0, 302.0]], 5);
        if met.len() > FEW {
            continue;
        }
        let numbers = numbers_of(&met, ray);
        let shown = stands(&numbers, Kept { lines: &[ray], page: LECTURE, ..FREE }, FEW);
        n_numbers += numbers.len();
        for (stand, (leaf, number)) in shown.iter().zip(met.iter().zip(&numbers)) {
            let stand = stand.unwrap_or_else(|| panic!("{leaf:?} of {met:?} has no number"));
            let [foot, rim] = stand.leader.unwrap_or([stand.at; 2]);
            let is_in = (0..2).all(|e| (leaf[0][e] - 1e-9..=leaf[1][e] + 1e-9).contains(&foot[e]));
            assert!(is_in, "{stand:?} does not end in {leaf:?}");
            lines.extend(stand.leader.map(|_| distance(foot, rim)));
            let is_crossed = |other: &&Number| {
                other.order != number.order && other.leaf.length_on([foot, rim]) > 2.0
            };
            n_crossed += numbers.iter().filter(is_crossed).count();
        }
    }
    lines.sort_by(f64::total_cmp);
    let at = |share: f64| lines[(share * (lines.len() - 1) as f64) as usize];
    let told = [0.5, 0.9, 0.99, 1.0].map(at);
    assert!(told[0] < 15.0 && told[1] < 30.0 && told[3] < 90.0, "{told:?}");
    assert!(n_numbers > 2000 && lines.len() > 1000, "{n_numbers} {}", lines.len());
    assert!(20 * n_crossed < lines.len(), "{n_crossed} of {}", lines.len());
}

#[test]
fn lines_to_leaves_do_not_strike_what_is_taken() {
    let chord = [[300.0, 300.0], [310.0, 300.0]];
    let leaf = rectangle([[300.0, 295.0], [310.0, 305.0]]);
    let number = Number { order: 1, chord, radius: RADIUS, tight: TIGHT, leaf };
    let taken = [[[305.0, 286.0], [3.0; 2]]];
    let stand = stands(&[number], Kept { taken: &taken, ..FREE }, FEW)[0].unwrap();
    assert!(stand.at[1] > 305.0, "{stand:?}");
}
