//! What several sequences have in common, run by run.

use std::collections::HashMap;

/// Items that follow each other in every one of the sequences.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct SharedRun {
    /// Number of items.
    pub(crate) length: usize,
    /// Where it begins in each sequence.
    pub(crate) starts: Vec<usize>,
}

/// Runs of at least `least` items that all sequences share, in the order of the
/// first one. Items that one of them has twice are shared by none. O(items).
pub(crate) fn shared_runs(sequences: &[&[u32]], least: usize) -> Vec<SharedRun> {
    let Some((first, others)) = sequences.split_first() else { return Vec::new() };
    let places: Vec<_> = others.iter().map(|sequence| places_of(sequence)).collect();
    let own = places_of(first);
    let mut runs: Vec<SharedRun> = Vec::new();
    for (index, item) in first.iter().enumerate() {
        if own.get(item) != Some(&Some(index)) {
            continue;
        }
        let others: Option<Vec<usize>> =
            places.iter().map(|places| places.get(item).copied().flatten()).collect();
        let Some(others) = others else { continue };
        let starts = [vec![index], others].concat();
        let goes_on = |run: &&mut SharedRun| {
            run.starts.iter().zip(&starts).all(|(start, now)| start + run.length == *now)
        };
        match runs.last_mut().filter(goes_on) {
            Some(run) => run.length += 1,
            None => runs.push(SharedRun { length: 1, starts }),
        }
    }
    runs.retain(|run| run.length >= least);
    runs
}

/// Place of every item; `None` for those that are there twice.
fn places_of(sequence: &[u32]) -> HashMap<u32, Option<usize>> {
    let mut places = HashMap::new();
    for (index, &item) in sequence.iter().enumerate() {
        places.entry(item).and_modify(|place| *place = None).or_insert(Some(index));
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(sequences: &[&[u32]], expected: &[(usize, &[usize])]) {
        let found = shared_runs(sequences, 2);
        let found: Vec<_> = found.iter().map(|run| (run.length, &run.starts[..])).collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn runs_stand_in_every_sequence() {
        check(&[&[1, 2, 3, 9, 4, 5], &[8, 1, 2, 3, 4, 5]], &[(3, &[0, 1]), (2, &[4, 4])]);
        check(&[&[1, 2, 3], &[3, 2, 1]], &[]);
        check(&[&[1, 2, 1, 2], &[1, 2]], &[]);
        check(&[&[1, 2], &[1, 2], &[5]], &[]);
        check(&[&[1, 2]], &[(2, &[0])]);
        check(&[], &[]);
    }
}
