//! Which comparisons decide the way an algorithm goes, and how well that can be predicted.
//!
//! A processor works on later instructions before a comparison is done; where it has
//! predicted wrongly, all of that is thrown away. Told here is the outcome of every
//! comparison that the events tell of, each predicted by a two-bit counter of its own
//! ([`TwoBit`]). Left out are the comparisons that find codes, and those of the planes
//! of a box that is tested by itself, of which events tell only what they come to. A
//! compiler may turn a comparison into arithmetic, and processors predict better than
//! two bits do: this is what a plain processor and a plain program would meet.

use super::TwoBit;
use crate::event::{Event, Observer};
use crate::tree::{NodeId, Tree};

/// What a comparison is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BranchKind {
    /// Whether a node is a leaf.
    Leaf,
    /// Where a node or its first child is entered.
    Entry,
    /// Where a node or child is left.
    Exit,
    /// With the border, the origin, or the ends of an interval.
    Range,
    /// What comes first.
    Sort,
    /// Whether to climb further.
    Climb,
}

impl BranchKind {
    /// All kinds.
    pub const ALL: [Self; 6] =
        [Self::Leaf, Self::Entry, Self::Exit, Self::Range, Self::Sort, Self::Climb];

    /// Key of its name in the language files.
    pub fn id(self) -> &'static str {
        match self {
            Self::Leaf => "leaf",
            Self::Entry => "entry",
            Self::Exit => "exit",
            Self::Range => "range",
            Self::Sort => "sort",
            Self::Climb => "climb",
        }
    }
}

/// A comparison that was made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Branch {
    /// What it was for.
    pub kind: BranchKind,
    /// What it came to.
    pub taken: bool,
    /// Whether that was predicted.
    pub is_predicted: bool,
}

/// Places in a program at which comparisons of one kind are made.
const PLACES: usize = 20;

/// Watches which way comparisons go.
#[derive(Clone, Debug)]
pub struct Branches<'a, const D: usize> {
    tree: &'a Tree<D>,
    counters: [[TwoBit; PLACES]; BranchKind::ALL.len()],
    /// Planes of the node that was visited last.
    near: [f64; D],
    far: [f64; D],
    /// Whether it is still open how far is climbed.
    climbs: bool,
    /// Of every kind the number of comparisons, and of those predicted wrongly.
    pub counts: [[u64; 2]; BranchKind::ALL.len()],
    /// All comparisons, if they are wanted.
    pub history: Option<Vec<Branch>>,
}

impl<'a, const D: usize> Branches<'a, D> {
    /// Watches a program in `tree` that has not run before.
    pub fn of(tree: &'a Tree<D>) -> Self {
        Self {
            tree,
            counters: [[TwoBit::default(); PLACES]; BranchKind::ALL.len()],
            near: [0.0; D],
            far: [0.0; D],
            climbs: false,
            counts: [[0; 2]; BranchKind::ALL.len()],
            history: None,
        }
    }

    /// Number of comparisons, and of those predicted wrongly, of all kinds.
    pub fn total(&self) -> [u64; 2] {
        std::array::from_fn(|n| self.counts.iter().map(|count| count[n]).sum())
    }

    fn branch(&mut self, kind: BranchKind, place: usize, taken: bool) {
        let is_predicted = self.counters[kind as usize][place].meets(taken);
        let [n, n_missed] = &mut self.counts[kind as usize];
        *n += 1;
        *n_missed += u64::from(!is_predicted);
        if let Some(history) = &mut self.history {
            history.push(Branch { kind, taken, is_predicted });
        }
    }

    /// Whether the node is a leaf.
    fn leaf_test(&mut self, node: NodeId) {
        let is_leaf = self.tree.node(node).is_leaf();
        self.branch(BranchKind::Leaf, 0, is_leaf);
    }

    /// The largest of several numbers is found; returns it.
    fn latest(&mut self, numbers: [f64; D]) -> f64 {
        let mut latest = numbers[0];
        for e in 1..D {
            self.branch(BranchKind::Entry, e, numbers[e] > latest);
            latest = latest.max(numbers[e]);
        }
        latest
    }

    /// The smallest of several numbers is found.
    fn earliest(&mut self, numbers: [f64; D]) {
        let mut earliest = numbers[0];
        for e in 1..D {
            self.branch(BranchKind::Exit, e, numbers[e] < earliest);
            earliest = earliest.min(numbers[e]);
        }
    }

    /// The axes are sorted by insertion into `order`.
    fn sort(&mut self, order: [u8; D]) {
        let rank = |axis: usize| order.iter().position(|&e| usize::from(e) == axis);
        let mut so_far: [usize; D] = std::array::from_fn(|e| e);
        for end in 1..D {
            for place in (1..=end).rev() {
                let is_earlier = rank(so_far[place]) < rank(so_far[place - 1]);
                self.branch(BranchKind::Sort, 0, is_earlier);
                if !is_earlier {
                    break;
                }
                so_far.swap(place, place - 1);
            }
        }
    }
}

impl<const D: usize> Observer<D> for Branches<'_, D> {
    fn observe(&mut self, event: Event<D>) {
        use BranchKind::{Climb, Entry, Range};
        /// First place for what is asked of every axis.
        const AXES: usize = 8;
        if self.climbs && !matches!(event, Event::Climb { .. }) {
            self.climbs = false;
            self.branch(Climb, 0, false);
        }
        match event {
            Event::Clip { near, far, hit, .. } => {
                self.latest(near);
                self.earliest(far);
                self.branch(Range, 0, hit);
            }
            Event::Visit { node, near, far, .. } => {
                (self.near, self.far) = (near, far);
                self.leaf_test(node);
            }
            Event::Enter { node, .. }
            | Event::Compare { node, .. }
            | Event::Follow { node, .. }
            | Event::Mirror { node, .. }
            | Event::Facing { node, .. } => self.leaf_test(node),
            Event::Skip { behind, .. } => {
                self.earliest(self.far);
                self.branch(Range, 1, behind);
            }
            Event::First { entry_axis, compared, state, .. } => {
                let latest = self.latest(self.near);
                if entry_axis.is_none() || compared.count() == D {
                    self.branch(Entry, D, latest <= 0.0);
                }
                for axis in compared.iter() {
                    self.branch(Entry, AXES + axis, state.is_upper(axis));
                }
            }
            Event::Step { exits, next, .. } => {
                self.earliest(exits);
                self.branch(Range, 2, next.is_none());
            }
            Event::Cuts { order, inside, .. } => {
                self.sort(order);
                for axis in 0..D {
                    self.branch(Range, AXES + axis, inside.contains(axis));
                }
            }
            Event::Classify { child, .. } => {
                for axis in 0..D {
                    self.branch(Entry, AXES + axis, child.is_upper(axis));
                }
            }
            Event::Split { at, interval: [from, to], taken, .. } => {
                let is_behind = at <= 0.0;
                self.branch(Range, 3, is_behind);
                if !is_behind {
                    let is_after = at >= to;
                    self.branch(Range, 4, is_after);
                    if !is_after {
                        self.branch(Range, 5, at <= from);
                    }
                }
                self.leaf_test(taken.node);
            }
            Event::Pop { part, .. } => self.leaf_test(part.node),
            Event::Exits { exits, .. } | Event::Leave { exits, .. } => self.earliest(exits),
            Event::Cross { next, axes, outside, .. } => {
                self.earliest(next);
                for axis in axes.iter() {
                    self.branch(Range, AXES + 4 + axis, outside.contains(axis));
                }
            }
            Event::Border { tested, outside } => {
                for axis in tested.iter() {
                    self.branch(Range, AXES + 4 + axis, outside.contains(axis));
                }
            }
            Event::Test { interval, .. } => self.branch(Range, 6, interval.is_some()),
            Event::Rope { node, .. } => self.branch(Range, 7, node.is_some()),
            Event::Parent { common, .. } => {
                self.branch(Climb, 0, common.iter().any(|&step| step != 0));
            }
            // Codes climb bit by bit; a stack goes up at once.
            Event::Difference { .. } => self.climbs = true,
            Event::Climb { .. } => self.branch(Climb, 0, true),
            Event::Resume { .. }
            | Event::Sort { .. }
            | Event::Halve { .. }
            | Event::Up { .. }
            | Event::Flip { .. }
            | Event::Grid { .. }
            | Event::Push { .. }
            | Event::Begin { .. }
            | Event::Encode { .. }
            | Event::Target { .. }
            | Event::Corners { .. }
            | Event::Leaf { .. }
            | Event::Touch { .. }
            | Event::Found { .. }
            | Event::End(_) => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ray;
    use crate::progress::Progress;
    use crate::query::Query;
    use crate::traverse::{Algorithm, Method};
    use crate::tree::{Domain, Split, grow};

    /// Outcomes on a ray through the four leaves of a quadtree: it is in leaf 0 for
    /// 0.5 ≤ t < 1, in leaf 2 until 1.5.
    fn check(algorithm: Algorithm, expected: &str) {
        let tree = grow(Domain::<2>::unit(1), (), &Progress::default(), |cell, ()| {
            if cell.level > 0 { Split::Inner(vec![(); 4]) } else { Split::Empty }
        });
        let tree = tree.unwrap();
        let ray = Ray::new([-0.5, 0.25], [1.0, 0.125]).unwrap();
        let mut branches = Branches::of(&tree);
        branches.history = Some(Vec::new());
        let query = Query::default().along_the_ray_by(Method::from(algorithm));
        query.run(&tree, &ray, &mut branches);
        let told: Vec<String> = branches
            .history
            .as_ref()
            .unwrap()
            .iter()
            .map(|branch| {
                let taken = if branch.taken { '1' } else { '0' };
                let missed = if branch.is_predicted { "" } else { "!" };
                format!("{}{taken}{missed}", branch.kind.id())
            })
            .collect();
        assert_eq!(told.join(" "), expected, "{algorithm:?}");
        let missed = told.iter().filter(|word| word.ends_with('!')).count() as u64;
        assert_eq!(branches.total(), [told.len() as u64, missed]);
    }

    /// Near planes at t = 0.5 and −2, far ones at 1.5 and 6, mid planes at 1 and 2.
    #[test]
    fn comparisons_are_counted_by_hand() {
        // It takes a second leaf to expect a third one: both are predicted wrongly.
        // Root: −2 > 0.5? 6 < 1.5? A hit. No leaf; −2 > 0.5, 0.5 ≤ 0, mid planes passed?
        // Leaf 0 is one; left at min(1, 2), not the last. Leaf 2 is one, the last: left
        // at min(1.5, 2).
        check(
            Algorithm::Parametric,
            "entry0 exit0 range1! leaf0 entry0 entry0 entry0 entry0 \
             leaf1! exit0 range0 leaf1! exit0 range1!",
        );
        // Two binary levels: x at t = 1 in (0.5, 1.5), both; y at 2, near; then a leaf,
        // and the other half with y at 2 again.
        check(
            Algorithm::Bsp,
            "entry0 exit0 range1! leaf0 range0 range0 range0 leaf0 range0 range1! leaf1! \
             leaf0 range0 range1! leaf1!",
        );
    }
}
