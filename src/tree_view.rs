//! What is unfolded in the diagram of the tree, and how it is looked at.

use octoscope_core::tree::{NodeId, Tree};
use octoscope_figure::{Diagram, DiagramLens};

/// State of the diagram that is neither saved nor follows from the step.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeView {
    /// Number of nodes of the tree that this is about; another tree has others.
    n_nodes: usize,
    /// Nodes that the user has unfolded, the last one last.
    unfolded: Vec<NodeId>,
    zoom: f64,
    /// What was dragged into the middle, and at which step: the next one shows the
    /// current node again.
    centre: Option<([f64; 2], usize)>,
}

impl Default for TreeView {
    fn default() -> Self {
        Self { n_nodes: 0, unfolded: Vec::new(), zoom: 1.0, centre: None }
    }
}

impl TreeView {
    /// Smallest and largest zoom.
    const ZOOMS: [f64; 2] = [0.4, 6.0];
    /// The first ones are folded again when there are more.
    const MOST_UNFOLDED: usize = 48;

    /// The nodes of `tree` that the user has unfolded.
    pub fn unfolded<const D: usize>(&self, tree: &Tree<D>) -> &[NodeId] {
        if self.n_nodes == tree.n_nodes() { &self.unfolded } else { &[] }
    }

    /// Unfolds a node of `tree`, or folds it again.
    pub fn toggle<const D: usize>(&mut self, tree: &Tree<D>, node: NodeId) {
        if self.n_nodes != tree.n_nodes() {
            (self.n_nodes, self.unfolded) = (tree.n_nodes(), Vec::new());
        }
        if self.unfolded.contains(&node) {
            self.unfolded.retain(|&other| !tree.holds(node, other));
        } else {
            self.unfolded.push(node);
        }
        if self.unfolded.len() > Self::MOST_UNFOLDED {
            self.unfolded.remove(0);
        }
    }

    /// How the diagram is looked at, at `step`.
    pub fn lens(&self, step: usize) -> DiagramLens {
        let centre = self.centre.filter(|&(_, then)| then == step).map(|(centre, _)| centre);
        DiagramLens { zoom: self.zoom, centre }
    }

    /// Moves what is shown by so many page units.
    pub fn pan(&mut self, shown: &Diagram, by: [f64; 2], step: usize) {
        let moved = std::array::from_fn(|e| shown.centre[e] - by[e] / shown.scale[e]);
        self.centre = Some((moved, step));
    }

    /// Makes all larger by `factor`; what lies at `offset` from the middle of the
    /// page stays there.
    pub fn zoom(&mut self, shown: &Diagram, offset: [f64; 2], factor: f64, step: usize) {
        let zoom = (self.zoom * factor).clamp(Self::ZOOMS[0], Self::ZOOMS[1]);
        let factor = zoom / self.zoom;
        self.zoom = zoom;
        let shift = |e: usize| offset[e] / shown.scale[e] * (1.0 - 1.0 / factor);
        self.centre = Some((std::array::from_fn(|e| shown.centre[e] + shift(e)), step));
    }

    /// Shows all of it again, as far as it has room.
    pub fn fit(&mut self) {
        (self.zoom, self.centre) = (1.0, None);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::progress::Progress;
    use octoscope_core::tree::{Domain, Split, grow};
    use octoscope_figure::{Figure, Page};

    fn tree(depth: u8) -> Tree<2> {
        grow(Domain::unit(depth), (), &Progress::default(), |cell, ()| match cell.level {
            0 => Split::Empty,
            _ => Split::Inner(vec![(); 4]),
        })
        .unwrap()
    }

    #[test]
    fn folding_a_node_folds_what_is_in_it_and_another_tree_has_nothing_unfolded() {
        let (tree, other) = (tree(3), tree(2));
        let mut view = TreeView::default();
        for node in [NodeId(1), NodeId(5), NodeId(2)] {
            view.toggle(&tree, node);
        }
        assert!(tree.holds(NodeId(1), NodeId(5)));
        view.toggle(&tree, NodeId(1));
        assert_eq!(view.unfolded(&tree), [NodeId(2)]);
        assert_eq!(view.unfolded(&other), []);
        view.toggle(&other, NodeId(3));
        assert_eq!(view.unfolded(&other), [NodeId(3)]);
    }

    #[test]
    fn only_so_many_stay_unfolded() {
        let tree = tree(5);
        let mut view = TreeView::default();
        (1..200).for_each(|id| view.toggle(&tree, NodeId(id)));
        assert_eq!(view.unfolded(&tree).len(), TreeView::MOST_UNFOLDED);
        assert_eq!(view.unfolded(&tree).last(), Some(&NodeId(199)));
    }

    #[test]
    fn what_is_dragged_or_zoomed_to_stays_until_the_next_step() {
        let page = Page { width: 100.0, height: 100.0 };
        let figure = Figure { page, drawn: Vec::new() };
        let shown = Diagram {
            figure,
            nodes: Vec::new(),
            centre: [10.0, 20.0],
            scale: [2.0, 1.0],
            natural: page,
        };
        let mut view = TreeView::default();
        view.pan(&shown, [-8.0, 3.0], 7);
        assert_eq!(view.lens(7).centre, Some([14.0, 17.0]));
        assert_eq!(view.lens(8).centre, None);
        // The place at [10 + 20/2, 20 + 0] stays 20 units right of the middle.
        view.zoom(&shown, [20.0, 0.0], 2.0, 7);
        assert_eq!(view.lens(7), DiagramLens { zoom: 2.0, centre: Some([15.0, 20.0]) });
        view.fit();
        assert_eq!(view.lens(7), DiagramLens::default());
    }
}
