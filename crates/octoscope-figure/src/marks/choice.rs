//! The choice of a child among those of a node.

use octoscope_core::event::Event;
use octoscope_core::geometry::Axes;
use octoscope_core::query::Query;
use octoscope_core::trace::Moment;
use octoscope_core::tree::{Child, NodeId, Tree, branch};

/// A child that an event has chosen.
pub(crate) struct Choice<const D: usize> {
    /// The node whose children are chosen among.
    pub parent: NodeId,
    /// The child that is taken.
    pub taken: Child<D>,
}

impl<const D: usize> Choice<D> {
    /// The choice that the last `event` has made, if it has made one.
    pub fn of(
        tree: &Tree<D>,
        query: &Query<D>,
        moment: &Moment<D>,
        event: Option<&Event<D>>,
    ) -> Option<Self> {
        let (parent, taken) = match *event? {
            Event::First { .. } | Event::Step { .. } => {
                let frame = moment.frame()?;
                let mask = moment.clip.map_or(Axes::NONE, |clip| clip.mirror);
                let variants = query.variants_at_work();
                Some((frame.node, variants.child_of_state(frame.child_state?, mask)))
            }
            Event::Compare { child, node, .. }
            | Event::Follow { child, node, .. }
            | Event::Facing { child, node }
            | Event::Mirror { mirrored: child, node, .. } => Some((tree.parent(node)?, child)),
            Event::Classify { child, .. } | Event::Flip { child, .. } => {
                Some((moment.frame()?.node, child))
            }
            Event::Clip { .. }
            | Event::Test { .. }
            | Event::Sort { .. }
            | Event::Visit { .. }
            | Event::Skip { .. }
            | Event::Halve { .. }
            | Event::Enter { .. }
            | Event::Cuts { .. }
            | Event::Split { .. }
            | Event::Pop { .. }
            | Event::Grid { .. }
            | Event::Cross { .. }
            | Event::Parent { .. }
            | Event::Rope { .. }
            | Event::Push { .. }
            | Event::Up { .. }
            | Event::Begin { .. }
            | Event::Encode { .. }
            | Event::Exits { .. }
            | Event::Target { .. }
            | Event::Border { .. }
            | Event::Difference { .. }
            | Event::Leave { .. }
            | Event::Resume { .. }
            | Event::Climb { .. }
            | Event::Corners { .. }
            | Event::Leaf { .. }
            | Event::Touch { .. }
            | Event::Found { .. }
            | Event::End(_) => None,
        }?;
        Some(Self { parent, taken })
    }

    /// The children that are not taken, nor were visited before, nor are current.
    pub fn rejected(&self, tree: &Tree<D>, moment: &Moment<D>) -> Vec<NodeId> {
        let visited = self.visited(tree, moment);
        let children = Child::all().zip(tree.children(tree.node(self.parent)));
        let others =
            children.filter(|(child, _)| *child != self.taken && !visited[usize::from(child.0)]);
        others.map(|(_, node)| node.id).filter(|node| moment.current != Some(*node)).collect()
    }

    /// For each of the children, whether a visited leaf lies in it: one pass
    /// over the path for all of them.
    fn visited(&self, tree: &Tree<D>, moment: &Moment<D>) -> [bool; 8] {
        let (level, code) = (tree.level(self.parent), tree.code(self.parent));
        let mut visited = [false; 8];
        for leaf in &moment.leaves {
            let leaf = tree.code(leaf.node);
            if level > 0 && (0..D).all(|e| leaf[e] >> level == code[e] >> level) {
                visited[usize::from(branch(leaf, level).0)] = true;
            }
        }
        visited
    }
}
