//! What has happened to the nodes of a diagram.

use super::DiagramOf;
use super::layout::Item;
use crate::marks::Choice;
use octoscope_core::event::End;
use octoscope_core::trace::{Fate, Reason, fate};
use octoscope_core::tree::NodeId;
use std::collections::HashMap;

/// What has happened to the nodes of a diagram, item by item.
pub(super) struct States {
    pub of_items: Vec<State>,
    /// The current node, or what it lies in, else the leaf visited last.
    pub focus: Option<usize>,
}

/// What has happened to one node.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct State {
    /// First and last number of the visited leaves in it.
    pub visited: Option<[usize; 2]>,
    /// Share of the way at which it begins, where it is a leaf that the ray was found to meet.
    pub met: Option<f64>,
    /// Whether one of them, or what is found there, is not right.
    pub is_strayed: bool,
    /// Share of the way along the ray at which the last of them begins.
    pub share: f64,
    /// Number of levels between it and the current node in it, 0 at that itself.
    pub above_current: Option<u8>,
    /// Whether it is a child of the node at work and is ruled out.
    pub is_rejected: bool,
    /// Whether it is a child of the node at work and has a number to be seen.
    pub is_in_question: bool,
    /// Whether it is touched in one point.
    pub is_touched: bool,
}

/// States of the items of a layout. O(visited leaves + items · levels).
pub(super) fn states<const D: usize>(of: &DiagramOf<D>, items: &[Item]) -> States {
    let DiagramOf { tree, ray, query, moment, event, .. } = *of;
    let index: HashMap<NodeId, usize> =
        items.iter().enumerate().map(|(n, item)| (item.node.id, n)).collect();
    let drawn = |node: NodeId| {
        let own_and_above = std::iter::once(node).chain(tree.ancestors(node));
        own_and_above.into_iter().find_map(|id| index.get(&id).copied())
    };
    let mut states = vec![State::default(); items.len()];

    // Leaves on the ray, and everything above them.
    let root = of.root_interval();
    let mut last: Option<usize> = None;
    for (n, leaf) in moment.leaves.iter().enumerate() {
        // Leaves that follow one another often lie in the same folded node.
        let same = last.filter(|&item| tree.holds(items[item].node.id, leaf.node));
        last = same.or_else(|| drawn(leaf.node));
        if let Some(item) = last {
            let share = ((leaf.enter - root[0]) / (root[1] - root[0])).clamp(0.0, 1.0);
            states[item].visit([n + 1; 2], share);
        }
    }
    for leaf in &moment.met {
        if let Some(item) = index.get(&leaf.node) {
            let share = ((leaf.enter - root[0]) / (root[1] - root[0])).clamp(0.0, 1.0);
            states[*item].met = Some(share);
        }
    }
    let reported = moment.leaves.iter().map(|leaf| leaf.node).chain(moment.found);
    for node in reported.filter(|node| of.strayed.binary_search(node).is_ok()) {
        if let Some(item) = drawn(node) {
            states[item].is_strayed = true;
        }
    }
    for n in (1..items.len()).rev() {
        if let (Some(parent), Some(numbers)) = (items[n].parent, states[n].visited) {
            let share = states[n].share;
            states[parent].visit(numbers, share);
        }
    }
    for &(node, _) in &moment.touches {
        if let Some(item) = index.get(&node) {
            states[*item].is_touched = true;
        }
    }

    // The current node; after the last step there is none in the picture either.
    let ended = match moment.end {
        Some(End::LeftRoot | End::Missed | End::Outside | End::SegmentEnd | End::Looped) => true,
        Some(End::FirstFull | End::Found | End::Cut) | None => false,
    };
    let current = moment.current.filter(|_| !ended);
    let last = moment.leaves.last().map(|leaf| leaf.node);
    let focus = current.or(moment.current).or(last).and_then(drawn);
    let mut next = current.and_then(drawn);
    let mut above = current.map_or(0, |node| {
        let at = next.map_or(node, |item| items[item].node.id);
        tree.level(at) - tree.level(node)
    });
    while let Some(item) = next {
        states[item].above_current = Some(above);
        above = above.saturating_add(1);
        next = items[item].parent;
    }

    // The children that are chosen among, as in the picture.
    let choice = Choice::of(tree, ray, query, moment, event);
    let at_work = choice.as_ref().map(|choice| choice.parent).or_else(|| moment.at_work(tree));
    let at_work = at_work.and_then(|node| index.get(&node).copied());
    let rejected = choice.map_or_else(Vec::new, |choice| choice.rejected);
    for (n, item) in items.iter().enumerate().skip(1) {
        if at_work.is_some() && item.parent == at_work {
            states[n].is_in_question = true;
            states[n].is_rejected = rejected.contains(&item.node.id);
            let is_touched = states[n].is_rejected && is_touched(of, item.node.id);
            states[n].is_touched |= is_touched;
        }
    }
    States { of_items: states, focus }
}

/// Whether a node is ruled out as the ray meets it in one point.
fn is_touched<const D: usize>(of: &DiagramOf<D>, node: NodeId) -> bool {
    let fate = fate(of.tree, of.ray, of.query, of.moment, node);
    matches!(fate, Some(Fate::RuledOut(Reason::Touched { .. })))
}

impl State {
    /// Visited leaves with these numbers lie in it, the last of which begins at
    /// `share` of the way.
    fn visit(&mut self, [first, last]: [usize; 2], share: f64) {
        let [least, most] = self.visited.unwrap_or([first, 0]);
        if last > most {
            self.share = share;
        }
        self.visited = Some([least.min(first), most.max(last)]);
    }

    /// Whether it is a leaf that was found to meet the ray, and has no number yet.
    pub fn is_met(&self) -> bool {
        self.met.is_some() && self.visited.is_none()
    }

    /// Whether the algorithm is or was in it.
    pub fn is_lit(&self) -> bool {
        self.visited.is_some() || self.above_current.is_some()
    }
}
