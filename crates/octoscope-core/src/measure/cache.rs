//! The lines of memory that a processor keeps at hand.

/// Bytes of a line: what is fetched from memory at once.
pub const LINE: usize = 64;

/// A cache of the lines that were used last, as processors have it: a line has its
/// place in one of several sets, and of each set the few used last are kept.
#[derive(Clone, Debug)]
pub struct Cache {
    /// Of every set its lines, the one used last first.
    sets: Vec<Vec<u64>>,
    n_ways: usize,
}

impl Cache {
    /// Empty cache of `n_sets` sets with room for `n_ways` lines each; at least one of
    /// each.
    pub fn new(n_sets: usize, n_ways: usize) -> Self {
        Self { sets: vec![Vec::new(); n_sets.max(1)], n_ways: n_ways.max(1) }
    }

    /// The first cache of usual processors: 64 sets of 8 lines, 32 KiB.
    pub fn usual() -> Self {
        Self::new(64, 8)
    }

    /// Uses a line, by its number; whether it was there already.
    pub fn touch(&mut self, line: u64) -> bool {
        let n_sets = self.sets.len() as u64;
        let set = &mut self.sets[(line % n_sets) as usize];
        let place = set.iter().position(|&kept| kept == line);
        if let Some(place) = place {
            set[..=place].rotate_right(1);
        } else {
            set.truncate(self.n_ways - 1);
            set.insert(0, line);
        }
        place.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One set of two lines: the one that was used longer ago goes.
    #[test]
    fn the_line_used_longest_ago_gives_way() {
        let mut cache = Cache::new(1, 2);
        let hits = [1, 2, 1, 3, 1, 2, 3].map(|line| cache.touch(line));
        assert_eq!(hits, [false, false, true, false, true, false, false]);
    }

    #[test]
    fn lines_of_other_sets_do_no_harm() {
        let mut cache = Cache::new(2, 1);
        let hits = [0, 1, 0, 1, 2, 0].map(|line| cache.touch(line));
        assert_eq!(hits, [false, false, true, true, false, false]);
    }
}
