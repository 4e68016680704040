//! Which lines of memory an algorithm reads.
//!
//! What an algorithm reads follows from its events and from how the tree lies in
//! memory: to learn what a child is, the row of its parent; to learn the level, code or
//! parent of a node, its place; to go through a link, the links of the node. The ray,
//! the stack and the code itself are taken to be at hand.

use super::{Cache, LINE};
use crate::event::{Event, Observer};
use crate::traverse::Algorithm;
use crate::tree::{Array, NodeId, Tree};
use std::collections::HashSet;

/// A line that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Read {
    /// Number of the line; every array has numbers of its own.
    pub line: u64,
    /// Whether this ray reads it for the first time.
    pub is_first: bool,
    /// Whether the cache had it.
    pub is_cached: bool,
}

/// Watches which lines are read.
#[derive(Clone, Debug)]
pub struct Memory<'a, const D: usize> {
    tree: &'a Tree<D>,
    /// Whether the cells of the finest grid are an array of their own.
    has_grid: bool,
    cache: Cache,
    /// Where the algorithm is.
    current: NodeId,
    /// Lines of this ray.
    seen: HashSet<u64>,
    /// Number of reads.
    pub n_reads: u64,
    /// Lines that a ray read for the first time, summed over the rays.
    pub n_lines: u64,
    /// Reads of lines that the cache did not have.
    pub n_misses: u64,
    /// All reads, if they are wanted.
    pub history: Option<Vec<Read>>,
}

/// Bytes of a cell in the array of a grid: the number of what is in it.
const CELL: u64 = 4;

impl<'a, const D: usize> Memory<'a, D> {
    /// Watches an algorithm in `tree`, with an empty `cache`.
    pub fn of(tree: &'a Tree<D>, algorithm: Algorithm, cache: Cache) -> Self {
        Self {
            tree,
            has_grid: algorithm == Algorithm::Dda,
            cache,
            current: NodeId::ROOT,
            seen: HashSet::new(),
            n_reads: 0,
            n_lines: 0,
            n_misses: 0,
            history: None,
        }
    }

    /// Says that another ray begins; the cache stays as it is.
    pub fn next_ray(&mut self) {
        self.current = NodeId::ROOT;
        self.seen.clear();
    }

    /// Reads what `array` holds of a node.
    fn read(&mut self, array: Array, id: NodeId) {
        let Some(bytes) = self.tree.bytes_of(array, id) else { return };
        let base = match array {
            Array::Rows => 0,
            Array::Places => 1 << 40,
            Array::Links => 2 << 40,
        };
        let [first, last] = [bytes.start / LINE, (bytes.end - 1) / LINE];
        for line in first..=last {
            self.touch(base + line as u64);
        }
    }

    /// Reads a cell of the grid.
    fn read_cell(&mut self, cell: [u64; D]) {
        const BASE: u64 = 3 << 40;
        let size = u64::from(self.tree.domain().grid_size());
        let index = cell.iter().fold(0, |index, &c| index * size + c);
        self.touch(BASE + index * CELL / LINE as u64);
    }

    fn touch(&mut self, line: u64) {
        let read =
            Read { line, is_first: self.seen.insert(line), is_cached: self.cache.touch(line) };
        self.n_reads += 1;
        self.n_lines += u64::from(read.is_first);
        self.n_misses += u64::from(!read.is_cached);
        if let Some(history) = &mut self.history {
            history.push(read);
        }
    }
}

impl<const D: usize> Observer<D> for Memory<'_, D> {
    fn observe(&mut self, event: Event<D>) {
        match event {
            Event::Visit { node, .. }
            | Event::Enter { node, .. }
            | Event::Test { node, .. }
            | Event::Compare { node, .. }
            | Event::Follow { node, .. }
            | Event::Mirror { node, .. }
            | Event::Facing { node, .. } => self.read(Array::Rows, node),
            Event::Split { taken, kept, .. } => {
                for part in [Some(taken), kept].into_iter().flatten() {
                    if part.halved.is_empty() {
                        self.read(Array::Rows, part.node);
                    }
                }
            }
            Event::Pop { part, .. } => self.read(Array::Places, part.node),
            // From the place of the node that is left.
            Event::Parent { .. } | Event::Climb { .. } | Event::Exits { .. } => {
                self.read(Array::Places, self.current);
            }
            Event::Rope { node, .. } => {
                self.read(Array::Links, self.current);
                if let Some(node) = node {
                    self.read(Array::Rows, node);
                }
            }
            Event::Grid { cell, .. } if self.has_grid => self.read_cell(cell.map(u64::from)),
            Event::Cross { cell, outside, .. } if self.has_grid && outside.is_empty() => {
                self.read_cell(cell.map(|c| c as u64));
            }
            Event::Clip { .. }
            | Event::Sort { .. }
            | Event::Skip { .. }
            | Event::Halve { .. }
            | Event::First { .. }
            | Event::Step { .. }
            | Event::Up { .. }
            | Event::Cuts { .. }
            | Event::Classify { .. }
            | Event::Flip { .. }
            | Event::Grid { .. }
            | Event::Cross { .. }
            | Event::Push { .. }
            | Event::Begin { .. }
            | Event::Encode { .. }
            | Event::Target { .. }
            | Event::Border { .. }
            | Event::Difference { .. }
            | Event::Leave { .. }
            | Event::Resume { .. }
            | Event::Corners { .. }
            | Event::Leaf { .. }
            | Event::Touch { .. }
            | Event::Found { .. }
            | Event::End(_) => {}
        }
        if let Some(node) = event.node().filter(|_| !matches!(event, Event::Test { .. })) {
            self.current = node;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ray;
    use crate::progress::Progress;
    use crate::query::Query;
    use crate::traverse::Method;
    use crate::tree::{Domain, Split, grow};

    /// Rows of 8 and places of 16 bytes in the plane: 8 and 4 of them in a line. All
    /// cells are divided down to level 0.
    fn tree(depth: u8) -> Tree<2> {
        let tree = grow(Domain::unit(depth), (), &Progress::default(), |cell, ()| {
            if cell.level > 0 { Split::Inner(vec![(); 4]) } else { Split::Empty }
        });
        tree.unwrap()
    }

    /// Numbers of the lines that are read on a ray.
    fn check(algorithm: Algorithm, depth: u8, ray: [f64; 4], expected: &[u64]) {
        let tree = tree(depth);
        tree.link(&Progress::default()).unwrap();
        let ray = Ray::new([ray[0], ray[1]], [ray[2], ray[3]]).unwrap();
        let mut memory = Memory::of(&tree, algorithm, Cache::usual());
        memory.history = Some(Vec::new());
        let query = Query::default().along_the_ray_by(Method::from(algorithm));
        query.run(&tree, &ray, &mut memory);
        let lines: Vec<u64> = memory.history.unwrap().iter().map(|read| read.line).collect();
        assert_eq!(lines, expected, "{algorithm:?}");
        let different: HashSet<&u64> = lines.iter().collect();
        assert_eq!((memory.n_reads, memory.n_lines), (lines.len() as u64, different.len() as u64));
        assert_eq!(memory.n_misses, memory.n_lines, "nothing is given up on a short way");
    }

    #[test]
    fn lines_are_counted_by_hand() {
        const PLACES: u64 = 1 << 40;
        const LINKS: u64 = 2 << 40;
        const GRID: u64 = 3 << 40;
        // Four leaves below the root: its row tells of all of them.
        let across = [-0.5, 0.25, 1.0, 0.125];
        check(Algorithm::Parametric, 1, across, &[0, 0]);
        // Down to leaf 0; its place for the exit planes and once more to climb; down to
        // leaf 2 and its place.
        check(Algorithm::Codes, 1, across, &[0, PLACES, PLACES, 0, PLACES]);
        // Down, exit planes, the links of leaf 0 (node 1, 16 bytes each) and what leaf 2
        // is; its exit planes, and its links (node 3) lead out.
        check(Algorithm::SametNet, 1, across, &[0, PLACES, LINKS, 0, PLACES, LINKS]);
        // Two cells of the grid, in the rows y = 0 of x = 0 and x = 1.
        check(Algorithm::Dda, 1, across, &[GRID, GRID]);
        // Cells of 4 bytes: x = 0 and 1 begin the lines of 8 · 4 bytes.
        check(
            Algorithm::Dda,
            3,
            [-0.5, 0.01, 1.0, 0.0],
            &[0, 0, 1, 1, 2, 2, 3, 3].map(|n| GRID + n),
        );
    }

    #[test]
    fn rows_of_a_level_follow_each_other() {
        // 21 rows: the root's, its children's 1 to 4, their children's 5 to 20. Along
        // y = 0 the ray visits of the root children 0 and 2 (rows 1 and 3), below them
        // 0 and 2 each (rows 5, 7 and 13, 15), below each two leaves.
        let path = [0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 1, 1];
        check(Algorithm::Parametric, 3, [-0.5, 0.01, 1.0, 0.0], &path);
    }

    #[test]
    fn another_ray_reads_its_first_lines_anew_but_finds_them_in_the_cache() {
        let tree = tree(1);
        let ray = Ray::new([-0.5, 0.25], [1.0, 0.125]).unwrap();
        let mut memory = Memory::of(&tree, Algorithm::Parametric, Cache::usual());
        for _ in 0..3 {
            memory.next_ray();
            Query::default().run(&tree, &ray, &mut memory);
        }
        assert_eq!((memory.n_reads, memory.n_lines, memory.n_misses), (6, 3, 1));
    }
}
