//! More numbers than have room: evenly spaced ones are left.

use super::crowd::Crowd;
use super::places::{aside, beside};
use super::{Kept, Number, Stand};

/// Where `numbers` stand, of which every second, fifth or tenth has its place, and so on,
/// with the first and the last, where there is not room for all. O(n): a disc is
/// compared with those nearby alone, and there is room for few.
pub(super) fn thinned(numbers: &[Number], kept: Kept) -> Vec<Option<Stand>> {
    const STEPS: [usize; 7] = [1, 2, 5, 10, 20, 50, 100];
    let n = numbers.len();
    let every = |step: usize| -> Vec<usize> {
        let has_place = |index: &usize| {
            let order = numbers[*index].order;
            order == 1 || *index + 1 == n || order.is_multiple_of(step)
        };
        (0..n).filter(has_place).collect()
    };
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

/// Where the `chosen` of the numbers stand, the last of which chooses first: it tells where
/// the algorithm is. Then those by which one counts, then the others.
fn placed(numbers: &[Number], chosen: &[usize], kept: Kept) -> Vec<Option<Stand>> {
    let mut crowd = Crowd::new(kept);
    let mut stands = vec![None; numbers.len()];
    let last = numbers.len().saturating_sub(1);
    let mut by_rank = chosen.to_vec();
    by_rank.sort_by_key(|&index| if index == last { 0 } else { 1 + rank(numbers[index].order) });
    for index in by_rank {
        let number = &numbers[index];
        let mut places = beside(number).into_iter().chain(aside(number));
        if let Some(stand) = places.find(|stand| crowd.has_room(stand)) {
            crowd.place(stand);
            stands[index] = Some(stand);
        }
    }
    stands
}

/// The smaller, the earlier a number chooses its place.
fn rank(order: usize) -> usize {
    let steps = [10, 5, 2].iter().position(|step| order.is_multiple_of(*step));
    if order == 1 { 0 } else { steps.unwrap_or(3) }
}
