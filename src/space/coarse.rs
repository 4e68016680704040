//! Fewer cells in the place of many, for a picture that moves.

use octoscope_core::tree::{Code, morton};

/// A cell of a tree and how it looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen<T, const D: usize> {
    /// Level of the node.
    pub level: u8,
    /// Location code.
    pub code: Code<D>,
    /// Style or colour.
    pub look: T,
}

/// At most `most` cells that cover the same part of the tree: the smallest are merged
/// into larger ones, level by level, up to the root's. O(n (log n + levels)).
pub fn coarser<T: Copy, const D: usize>(
    mut cells: Vec<Seen<T, D>>,
    root_level: u8,
    most: usize,
    merged: impl Fn(&[Seen<T, D>]) -> T,
) -> Vec<Seen<T, D>> {
    // In this order the parts of a cell follow one another, those of its size first.
    cells.sort_unstable_by_key(|cell| (morton(cell.code), u8::MAX - cell.level));
    for level in 1..=root_level {
        if cells.len() <= most {
            break;
        }
        let place = |cell: &Seen<T, D>| {
            let level = level.max(cell.level);
            (level, cell.code.map(|c| c >> level << level))
        };
        let together = |parts: &[Seen<T, D>]| {
            let (level, code) = place(&parts[0]);
            Seen { level, code, look: merged(parts) }
        };
        cells = cells.chunk_by(|a, b| place(a) == place(b)).map(together).collect();
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cell(level: u8, x: u32, y: u32) -> Seen<u32, 2> {
        Seen { level, code: [x, y], look: 1 }
    }

    fn sum(parts: &[Seen<u32, 2>]) -> u32 {
        parts.iter().map(|part| part.look).sum()
    }

    #[test]
    fn small_cells_are_merged_and_large_ones_stay() {
        let cells = vec![cell(0, 3, 2), cell(1, 0, 0), cell(0, 2, 2), cell(1, 2, 0)];
        assert_eq!(coarser(cells.clone(), 2, 4, sum).len(), 4);
        let merged = coarser(cells, 2, 3, sum);
        assert_eq!(merged, [cell(1, 0, 0), cell(1, 2, 0), Seen { look: 2, ..cell(1, 2, 2) }]);
    }

    #[test]
    fn an_inner_node_takes_its_parts_in() {
        let cells = vec![cell(0, 0, 0), cell(0, 1, 1), cell(1, 0, 0)];
        assert_eq!(coarser(cells, 2, 1, sum), [Seen { look: 3, ..cell(1, 0, 0) }]);
    }

    #[test]
    fn no_tree_is_so_large_that_it_does_not_fit() {
        let grid = |n: u32| (0..n).flat_map(move |x| (0..n).map(move |y| cell(0, x, y)));
        let cells: Vec<_> = grid(16).collect();
        for most in [1, 5, 16, 64, 100, 256] {
            let merged = coarser(cells.clone(), 4, most, sum);
            assert!(merged.len() <= most && merged.len() * 4 > most.min(255));
            assert_eq!(sum(&merged), 256);
        }
    }
}
