//! Sorting by keys.

/// Bits that a pass sorts by.
const DIGIT: u32 = 11;

/// Sorts items by their keys; items with equal keys stay in their order. One pass for
/// every 11 bits that are not the same in all keys, from the lowest: O(n).
pub fn sort_by_key(items: &mut Vec<(u64, u32)>) {
    let differing = items.iter().fold(0, |bits, item| bits | item.0 ^ items[0].0);
    let mut sorted = Vec::new();
    for shift in (0..u64::BITS).step_by(DIGIT as usize) {
        let digit = |key: u64| (key >> shift) as usize & ((1 << DIGIT) - 1);
        if digit(differing) == 0 {
            continue;
        }

        // Where the items of each digit begin: after all those of smaller ones.
        let mut place = [0u32; 1 << DIGIT];
        for &(key, _) in items.iter() {
            place[digit(key)] += 1;
        }
        let mut before = 0;
        for place in &mut place {
            (before, *place) = (before + *place, before);
        }

        sorted.resize(items.len(), (0, 0));
        for &item in items.iter() {
            let place = &mut place[digit(item.0)];
            sorted[*place as usize] = item;
            *place += 1;
        }
        std::mem::swap(items, &mut sorted);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    #[test]
    fn keys_ascend_and_equal_ones_stay_in_order() {
        let mut random = Random::new(1);
        for (n, bits) in [(0, 1), (1, 64), (2, 64), (1000, 3), (5000, 24), (5000, 60), (900, 64)] {
            let item = |number| (random.bits() >> (64 - bits), number);
            let mut items: Vec<(u64, u32)> = (0..n).map(item).collect();
            let mut expected = items.clone();
            expected.sort();
            sort_by_key(&mut items);
            assert_eq!(items, expected);
        }
    }
}
