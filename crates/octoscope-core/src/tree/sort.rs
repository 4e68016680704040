//! Sorting by keys.

use crate::threads::in_order;
use std::num::NonZeroUsize;
use std::ops::Range;

/// Most bits that a pass sorts by.
const DIGIT: u32 = 11;

/// Items that are sorted together: so few that they and their copies stay at hand.
const BLOCK: usize = 1 << 15;

/// A key and the number of its item.
type Item = (u64, u32);

/// Sorts items by their keys; items with equal keys stay in their order.
///
/// Blocks are sorted by the highest bits alone, then what they have of the same values
/// is brought together and sorted by the rest: O(n), by so many threads. Where one value
/// has more than a block and the share of a thread, all of them go on with it.
pub fn sort_by_key(threads: NonZeroUsize, items: &mut [Item]) {
    let share = (items.len() / threads).max(BLOCK);
    let Some(highest) = digits(differing_bits(items)).last() else { return };
    if items.len() <= BLOCK {
        return sort_block(items);
    }
    let blocks = in_order(threads, items.chunks(BLOCK), |block| {
        let mut sorted = vec![(0, 0); block.len()];
        let starts = sort_by_digit(block, &mut sorted, highest);
        (sorted, starts)
    });
    let n_of = |value: usize| -> usize {
        blocks.iter().map(|(_, starts)| (starts[value + 1] - starts[value]) as usize).sum()
    };

    let mut room = items;
    let mut parts = Vec::new();
    let (mut first, mut n) = (0, 0);
    let end = 1 << highest.bits;
    for value in 0..end {
        n += n_of(value);
        if n >= BLOCK || value + 1 == end || n_of(value + 1) > share {
            let (part, rest) = std::mem::take(&mut room).split_at_mut(n);
            parts.push((first..value + 1, part));
            (room, first, n) = (rest, value + 1, 0);
        }
    }
    let large = in_order(threads, parts.into_iter(), |(values, part): (Range<usize>, &mut [_])| {
        let mut n = 0;
        for (block, starts) in &blocks {
            let some = &block[starts[values.start] as usize..starts[values.end] as usize];
            part[n..n + some.len()].copy_from_slice(some);
            n += some.len();
        }
        if values.len() == 1 && n > share {
            return Some(part);
        }
        sort_block(part);
        None
    });
    // They are as much again as the items.
    drop(blocks);
    for part in large.into_iter().flatten() {
        sort_by_key(threads, part);
    }
}

/// Some bits of a key.
#[derive(Clone, Copy)]
struct Digit {
    shift: u32,
    bits: u32,
}

impl Digit {
    fn of(self, key: u64) -> usize {
        (key >> self.shift) as usize & ((1 << self.bits) - 1)
    }
}

/// Bits that are not the same in all keys.
fn differing_bits(items: &[Item]) -> u64 {
    items.iter().fold(0, |bits, item| bits | item.0 ^ items[0].0)
}

/// Digits of about equal length that hold all these bits, from the lowest.
fn digits(bits: u64) -> impl Iterator<Item = Digit> {
    let (first, end) = (bits.trailing_zeros(), u64::BITS - bits.leading_zeros());
    let n_bits = end.saturating_sub(first);
    let n_digits = n_bits.div_ceil(DIGIT);
    let bits = n_bits.div_ceil(n_digits.max(1));
    (0..n_digits).map(move |digit| Digit { shift: first + digit * bits, bits })
}

/// Sorts by all bits that differ.
fn sort_block(items: &mut [Item]) {
    let mut copy = vec![(0, 0); items.len()];
    let digits: Vec<Digit> = digits(differing_bits(items)).collect();
    for (pass, &digit) in digits.iter().enumerate() {
        if pass % 2 == 0 {
            sort_by_digit(items, &mut copy, digit);
        } else {
            sort_by_digit(&copy, items, digit);
        }
    }
    if digits.len() % 2 == 1 {
        items.copy_from_slice(&copy);
    }
}

/// Sorts by one digit into `sorted`; the place where the items of each value begin.
fn sort_by_digit(items: &[Item], sorted: &mut [Item], digit: Digit) -> Vec<u32> {
    let mut starts = vec![0; (1 << digit.bits) + 1];
    for &(key, _) in items {
        starts[digit.of(key) + 1] += 1;
    }
    for value in 0..1 << digit.bits {
        starts[value + 1] += starts[value];
    }
    let mut places = starts.clone();
    for &item in items {
        let place = &mut places[digit.of(item.0)];
        sorted[*place as usize] = item;
        *place += 1;
    }
    starts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Sorts `items`, numbered in their order, by one thread and by several.
    fn check(items: &[(u64, u32)]) {
        let mut expected = items.to_vec();
        expected.sort();
        for threads in [1, 2, 5] {
            let mut items = items.to_vec();
            sort_by_key(NonZeroUsize::new(threads).unwrap(), &mut items);
            assert_eq!(items, expected);
        }
    }

    #[test]
    fn keys_ascend_and_equal_ones_stay_in_order() {
        let mut random = Random::new(1);
        for (n, bits) in [
            (0, 1),
            (1, 64),
            (2, 64),
            (1000, 3),
            (5000, 24),
            (5000, 60),
            (900, 64),
            (100_000, 7),
            (200_000, 24),
            (70_000, 64),
        ] {
            let item = |number| (random.bits().checked_shr(64 - bits).unwrap_or(0), number);
            let items: Vec<(u64, u32)> = (0..n).map(item).collect();
            check(&items);
        }
    }

    /// Most keys have their highest bits in common, most of those the next ones too.
    #[test]
    fn keys_that_lie_close_together_are_sorted_as_well() {
        let mut random = Random::new(2);
        let mut key = || match random.below(8) {
            0 => random.bits() >> 8,
            1 => 1 << 55 | random.bits() >> 30,
            2 => 1 << 55 | 3,
            _ => 1 << 55 | random.bits() >> 50,
        };
        let items: Vec<(u64, u32)> = (0..300_000).map(|number| (key(), number)).collect();
        check(&items);
    }
}
