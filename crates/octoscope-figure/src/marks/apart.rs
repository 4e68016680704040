//! The children of the current node, moved apart.

use super::{Scene, node_mark};
use crate::{Mark, Role, Shape};
use octoscope_core::event::End;
use octoscope_core::geometry::Aabb;
use octoscope_core::tree::{Child, NodeId};

impl<const D: usize> Scene<'_, D> {
    /// The children of the node that is looked into, each away from the middle of
    /// the node by the same share, so that none covers another from any side.
    pub(super) fn apart(&self, marks: &mut Vec<Mark<D>>) {
        let Some(parent) = self.looked_into().filter(|_| self.is_apart()) else {
            return;
        };
        let taken = self.choice().and_then(|choice| choice.taken);
        let middle = self.tree.node_box(parent).centre();
        if self.moment.current != Some(parent) {
            marks.push(node_mark(self.tree, parent, Role::Ancestor { above: 1 }));
        }
        let children = self.tree.children(self.tree.node(parent));
        for (child, node) in Child::all().zip(children) {
            let bounds = self.tree.node_box(node.id);
            let moved = moved(&bounds, middle, self.show.explosion);
            // Seen without the ray, the place of the node is the only one that counts.
            let is_taken =
                Some(child) == taken || taken.is_none() && self.moment.current == Some(node.id);
            let role = if is_taken { Role::ApartTaken } else { Role::Apart };
            let [from, to] = [bounds, moved].map(|bounds| bounds.centre());
            marks.push(Mark::new(Shape::Segment([from, to]), Role::Tie).of_node(node.id));
            let mark = Mark::new(Shape::Box(moved), role).of_node(node.id);
            marks.push(mark.with_text(self.child_name(child)));
        }
    }

    /// Whether children are drawn away from where they are.
    pub(super) fn is_apart(&self) -> bool {
        self.show.explosion > 0.0 && self.looked_into().is_some()
    }

    /// The node whose children are chosen among or, where none is, the current one;
    /// of a leaf its parent.
    fn looked_into(&self) -> Option<NodeId> {
        let ended = match self.moment.end {
            Some(End::LeftRoot | End::Missed | End::Outside | End::SegmentEnd | End::Looped) => {
                true
            }
            Some(End::FirstFull | End::Found | End::Cut) | None => false,
        };
        let current = self.moment.current.filter(|_| !ended)?;
        let node = self.choice().map_or(current, |choice| choice.parent);
        if self.tree.node(node).is_leaf() { self.tree.parent(node) } else { Some(node) }
    }
}

/// A box away from `middle`, by a share of its side on every axis.
fn moved<const D: usize>(bounds: &Aabb<D>, middle: [f64; D], share: f64) -> Aabb<D> {
    let (centre, size) = (bounds.centre(), bounds.size());
    let by: [f64; D] =
        std::array::from_fn(|e| share * size[e] * if centre[e] > middle[e] { 0.5 } else { -0.5 });
    let [min, max] = [bounds.min, bounds.max].map(|p| std::array::from_fn(|e| p[e] + by[e]));
    Aabb { min, max }
}
