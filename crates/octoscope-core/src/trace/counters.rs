//! What a run has cost, counted from its events.
//!
//! Counted is what the method needs, as the literature counts it: the smallest of
//! D parameters takes D − 1 comparisons. Left out are leaf and loop tests, finding
//! which others equal the smallest, and what is done only to report the interval
//! of a leaf. An axis without motion takes no division, except by the gem of `bsp`.
//! Sorting n leaves counts as n ⌊log₂ n⌋ comparisons.

use crate::event::{Event, Lookup, Search};
use crate::tree::{NodeId, Part};

/// One kind of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Counter {
    /// A node is reached by a link: from its parent, from a child or across a side, so
    /// never the root from which a walk begins. Of the binary tree that emulates an
    /// octree, every part that is entered counts.
    NodeTouches,
    /// A node is asked whether it is a leaf.
    LeafTests,
    /// Comparisons that find where a node or its first child is entered.
    EntryComparisons,
    /// Comparisons that find where a node or child is left.
    ExitComparisons,
    /// Comparisons with the border, the origin, or of both ends of an interval.
    RangeComparisons,
    /// Comparisons with planes of the grid that find the codes of a place on the
    /// ray.
    CodeComparisons,
    /// Comparisons that sort.
    SortComparisons,
    /// Divisions.
    Divisions,
    /// Additions, subtractions and multiplications of doubles.
    Additions,
    /// Operations on the bits of codes: XOR, masks, reading a bit of all axes.
    BitOperations,
    /// Transitions of the automaton, by table or by rule.
    Transitions,
    /// Look-ups in tables of neighbours.
    TableLookups,
    /// Cells of the finest grid that the ray is in.
    GridCells,
    /// Searches that start at the root.
    PointLocations,
    /// Steps from a node to its parent.
    Ascends,
    /// Steps from a node to a child.
    Descends,
    /// Recursive calls.
    Calls,
    /// Greatest number of nodes on the stack so far.
    StackDepth,
    /// Leaves visited.
    Leaves,
    /// Leaves met in one point only.
    Touches,
}

impl Counter {
    /// All counters, in the order in which they are shown.
    pub const ALL: [Self; 20] = [
        Self::NodeTouches,
        Self::LeafTests,
        Self::EntryComparisons,
        Self::ExitComparisons,
        Self::RangeComparisons,
        Self::CodeComparisons,
        Self::SortComparisons,
        Self::Divisions,
        Self::Additions,
        Self::BitOperations,
        Self::Transitions,
        Self::TableLookups,
        Self::GridCells,
        Self::PointLocations,
        Self::Ascends,
        Self::Descends,
        Self::Calls,
        Self::StackDepth,
        Self::Leaves,
        Self::Touches,
    ];

    /// Key of the counter's name in the language files.
    pub fn id(self) -> &'static str {
        match self {
            Self::NodeTouches => "node-touches",
            Self::LeafTests => "leaf-tests",
            Self::EntryComparisons => "entry-comparisons",
            Self::ExitComparisons => "exit-comparisons",
            Self::RangeComparisons => "range-comparisons",
            Self::CodeComparisons => "code-comparisons",
            Self::SortComparisons => "sort-comparisons",
            Self::Divisions => "divisions",
            Self::Additions => "additions",
            Self::BitOperations => "bit-operations",
            Self::Transitions => "transitions",
            Self::TableLookups => "table-lookups",
            Self::GridCells => "grid-cells",
            Self::PointLocations => "point-locations",
            Self::Ascends => "ascends",
            Self::Descends => "descends",
            Self::Calls => "calls",
            Self::StackDepth => "stack-depth",
            Self::Leaves => "leaves",
            Self::Touches => "touches",
        }
    }
}

/// Number of parameters that a division has led to: without motion along an axis
/// they are ±∞ without one.
fn finite<const N: usize>(parameters: [f64; N]) -> u64 {
    parameters.iter().filter(|t| t.is_finite()).count() as u64
}

/// A number for each [`Counter`].
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    counts: [u64; Counter::ALL.len()],
    on_stack: u64,
}

impl Counters {
    /// The number of one counter.
    pub fn get(&self, counter: Counter) -> u64 {
        self.counts[counter as usize]
    }

    /// Comparisons of coordinates and parameters, of every kind.
    pub fn comparisons(&self) -> u64 {
        use Counter::{
            CodeComparisons, EntryComparisons, ExitComparisons, RangeComparisons, SortComparisons,
        };
        [EntryComparisons, ExitComparisons, RangeComparisons, CodeComparisons, SortComparisons]
            .map(|counter| self.get(counter))
            .iter()
            .sum()
    }

    /// Adds the work of one event.
    pub fn add<const D: usize>(&mut self, event: &Event<D>) {
        use Counter::{
            Additions, Ascends, BitOperations, Calls, Descends, Divisions, EntryComparisons,
            ExitComparisons, GridCells, LeafTests, Leaves, NodeTouches, PointLocations,
            RangeComparisons, SortComparisons, TableLookups, Touches, Transitions,
        };
        let axes = D as u64;
        let mut count = |counter: Counter, n: u64| self.counts[counter as usize] += n;
        match *event {
            Event::Clip { near, .. } => {
                count(Additions, 2 * finite(near));
                count(Divisions, 2 * finite(near));
                count(EntryComparisons, axes);
                count(ExitComparisons, axes - 1);
                count(RangeComparisons, 2);
            }
            Event::Test { divided, .. } => {
                // By its planes alone: the node itself is reached only by a visit.
                let divided = divided.count() as u64;
                count(Additions, 2 * divided);
                count(Divisions, 2 * divided);
                count(EntryComparisons, axes);
                count(ExitComparisons, axes - 1);
                count(RangeComparisons, 1);
            }
            Event::Sort { n_leaves } => {
                let n = u64::from(n_leaves);
                count(SortComparisons, n * u64::from(n.max(1).ilog2()));
            }
            Event::Visit { node, .. } | Event::Enter { node, .. } => {
                // No link leads to the root.
                let by_link = u64::from(node != NodeId::ROOT);
                count(NodeTouches, by_link);
                count(Descends, by_link);
                count(LeafTests, 1);
                let in_a_loop = matches!(event, Event::Enter { call: false, .. });
                count(Calls, u64::from(!in_a_loop));
                self.push();
            }
            Event::Cuts { sorting, ranging, .. } => {
                count(SortComparisons, u64::from(sorting));
                count(RangeComparisons, u64::from(ranging));
            }
            Event::Classify { .. } => count(EntryComparisons, axes),
            Event::Flip { axes: crossed, .. } => count(BitOperations, crossed.count() as u64),
            Event::Split { divided, kept, .. } => {
                let divided = u64::from(divided);
                count(Additions, divided);
                count(Divisions, divided);
                count(RangeComparisons, 3);
                count(LeafTests, 1);
                count(Descends, 1);
                count(NodeTouches, 1);
                if kept.is_some() {
                    self.push();
                }
            }
            Event::Pop { part, .. } => {
                count(NodeTouches, u64::from(part != Part::whole(NodeId::ROOT)));
                count(LeafTests, 1);
                self.on_stack = self.on_stack.saturating_sub(1);
            }
            Event::Grid { search, next, .. } => {
                count(GridCells, 1);
                count(Additions, finite(next));
                count(Divisions, finite(next));
                self.search(search);
            }
            Event::Cross { axes: crossed, outside, .. } => {
                let crossed = crossed.count() as u64;
                count(ExitComparisons, axes - 1);
                count(RangeComparisons, crossed);
                if outside.is_empty() {
                    // On to the cell, whose next planes are computed.
                    count(GridCells, 1);
                    count(Additions, crossed);
                    count(Divisions, crossed);
                }
            }
            Event::Parent { lookup, .. } => {
                count(NodeTouches, 1);
                count(Ascends, 1);
                match lookup {
                    Lookup::Tables => count(TableLookups, 1),
                    Lookup::Bits => count(BitOperations, 2),
                }
            }
            Event::Mirror { .. } => {
                count(NodeTouches, 1);
                count(LeafTests, 1);
                count(Descends, 1);
                count(TableLookups, 1);
            }
            Event::Facing { .. } => {
                count(NodeTouches, 1);
                count(LeafTests, 1);
                count(Descends, 1);
                count(BitOperations, axes);
            }
            Event::Rope { node, .. } => count(NodeTouches, u64::from(node.is_some())),
            Event::Push { .. } => count(Additions, 2 * axes + 1),
            Event::Begin { node } => {
                if node == NodeId::ROOT {
                    count(PointLocations, 1);
                    count(LeafTests, 1);
                }
            }
            Event::Skip { .. } => {
                count(ExitComparisons, axes - 1);
                count(RangeComparisons, 1);
            }
            Event::Halve { divided, .. } => {
                // A mean takes a sum and a product, any other a difference.
                let divided = divided.count() as u64;
                count(Additions, if divided == 0 { 2 * axes } else { divided });
                count(Divisions, divided);
            }
            Event::First { compared, entry_axis, .. } => {
                count(EntryComparisons, axes - 1 + compared.count() as u64);
                if entry_axis.is_none() || compared.count() == D {
                    // The origin takes part, in case it lies inside.
                    count(EntryComparisons, 1);
                }
            }
            Event::Step { .. } => {
                count(ExitComparisons, axes - 1);
                count(Transitions, 1);
            }
            Event::Up { .. } => {
                count(Ascends, 1);
                self.on_stack = self.on_stack.saturating_sub(1);
            }
            Event::Encode { after: None, .. } => count(Additions, 2 * axes),
            Event::Encode { after: Some(_), search, .. } => self.search(search),
            Event::Compare { .. } => {
                count(NodeTouches, 1);
                count(LeafTests, 1);
                count(Descends, 1);
                count(RangeComparisons, axes);
            }
            Event::Follow { .. } => {
                count(NodeTouches, 1);
                count(LeafTests, 1);
                count(Descends, 1);
                count(BitOperations, axes);
            }
            Event::Exits { exits, .. } => {
                count(Additions, finite(exits));
                count(Divisions, finite(exits));
                count(ExitComparisons, axes - 1);
            }
            // What is added to codes is no sum of doubles.
            Event::Target { search, .. } => self.search(search),
            Event::Border { tested, .. } => count(RangeComparisons, tested.count() as u64),
            Event::Difference { .. } => count(BitOperations, axes),
            Event::Leave { .. } => count(ExitComparisons, axes - 1),
            Event::Resume { popped, .. } => {
                count(Ascends, 1);
                self.on_stack = self.on_stack.saturating_sub(u64::from(popped));
            }
            Event::Climb { .. } => {
                count(NodeTouches, 1);
                count(Ascends, 1);
            }
            Event::Corners { .. } => count(Additions, 4 * axes),
            Event::Leaf { .. } => count(Leaves, 1),
            Event::Touch { .. } => count(Touches, 1),
            Event::Found { .. } | Event::End(_) => {}
        }
    }

    /// Adds the work of another run; of the stack, the greater depth counts.
    pub fn absorb(&mut self, other: &Self) {
        for counter in Counter::ALL {
            let (own, more) = (self.get(counter), other.get(counter));
            let is_a_depth = counter == Counter::StackDepth;
            self.counts[counter as usize] = if is_a_depth { own.max(more) } else { own + more };
        }
    }

    /// Adds the work of finding a place on the ray: a point and its distance in
    /// cells as a guess, then parameters of planes.
    fn search(&mut self, search: Search) {
        let [guesses, parameters, coordinates] =
            [search.guesses, search.parameters, search.coordinates].map(u64::from);
        let mut count = |counter: Counter, n: u64| self.counts[counter as usize] += n;
        count(Counter::Additions, 3 * guesses + parameters);
        count(Counter::Divisions, guesses + parameters);
        count(Counter::CodeComparisons, parameters + coordinates);
    }

    /// One more on the stack.
    fn push(&mut self) {
        self.on_stack += 1;
        let deepest = &mut self.counts[Counter::StackDepth as usize];
        *deepest = (*deepest).max(self.on_stack);
    }
}
