//! The choice of a child among those of a node, and what it rules out.

use octoscope_core::event::Event;
use octoscope_core::geometry::{Axes, Ray};
use octoscope_core::query::Query;
use octoscope_core::trace::Moment;
use octoscope_core::tree::{Child, NodeId, Part, Tree, branch};

/// What an event has decided about the children of a node.
pub(crate) struct Choice<const D: usize> {
    /// The node whose children are chosen among.
    pub parent: NodeId,
    /// The child that is taken, if one is, or from which the algorithm comes back.
    pub taken: Option<Child<D>>,
    /// The children that the algorithm has ruled out so far: it does not come to them any
    /// more, and has visited no leaf in them.
    pub rejected: Vec<NodeId>,
}

impl<const D: usize> Choice<D> {
    /// What the last `event` has decided, if it has decided anything about children.
    /// O(visited leaves + missed nodes + parts that wait).
    pub fn of(
        tree: &Tree<D>,
        ray: &Ray<D>,
        query: &Query<D>,
        moment: &Moment<D>,
        event: Option<&Event<D>>,
    ) -> Option<Self> {
        let run = Run { tree, ray, query, moment };
        let all = Axes::where_true([true; D]);
        match *event? {
            Event::First { .. } | Event::Step { .. } => {
                let frame = moment.frame()?;
                // Once the last child is left, no plane is crossed within the node.
                let is_last = matches!(event, Some(Event::Step { next: None, .. }));
                let crossed = if is_last { Axes::NONE } else { all };
                Some(run.after_state(frame.node, frame.child_state?, crossed))
            }
            Event::Classify { child, .. } | Event::Flip { child, .. } => {
                let frame = moment.frame()?;
                let crossed = frame.cuts.map_or(all, |cuts| cuts.inside);
                Some(run.after(frame.node, child, crossed))
            }
            Event::Compare { child, node, .. }
            | Event::Follow { child, node, .. }
            | Event::Facing { child, node }
            | Event::Mirror { mirrored: child, node, .. } => {
                Some(run.after(tree.parent(node)?, child, all))
            }
            Event::Test { node, .. } => {
                let is_missed = |child: NodeId| moment.missed.contains(&child);
                Some(run.choice(tree.parent(node)?, None, |_, node| is_missed(node)))
            }
            Event::Up { node: Some(node) } => {
                let frame = moment.frame().filter(|frame| frame.node == node)?;
                let left = frame.child.or_else(|| Some(run.child_of(frame.child_state?)))?;
                Some(run.choice(node, Some(left), |_, _| false))
            }
            Event::Parent { node, child, .. } => Some(run.choice(node, Some(child), |_, _| false)),
            Event::Split { taken: part, .. } | Event::Pop { part, .. } => run.halved(part),
            Event::Clip { .. }
            | Event::Sort { .. }
            | Event::Visit { .. }
            | Event::Skip { .. }
            | Event::Halve { .. }
            | Event::Enter { .. }
            | Event::Cuts { .. }
            | Event::Grid { .. }
            | Event::Cross { .. }
            | Event::Rope { .. }
            | Event::Push { .. }
            | Event::Up { node: None }
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
        }
    }
}

struct Run<'a, const D: usize> {
    tree: &'a Tree<D>,
    ray: &'a Ray<D>,
    query: &'a Query<D>,
    moment: &'a Moment<D>,
}

impl<const D: usize> Run<'_, D> {
    /// The choice of a child. A ray goes on from it to those beyond it, across the planes
    /// of `crossed` axes alone; what is no ray is in one child.
    fn after(&self, parent: NodeId, taken: Child<D>, crossed: Axes<D>) -> Choice<D> {
        let is_beyond = |child: Child<D>, axis: usize| {
            let along = self.ray.direction()[axis];
            along != 0.0 && crossed.contains(axis) && child.is_upper(axis) == (along > 0.0)
        };
        let is_ahead = |child: Child<D>| match self.query {
            Query::Ray { .. } => (0..D)
                .all(|axis| child.is_upper(axis) == taken.is_upper(axis) || is_beyond(child, axis)),
            Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => false,
        };
        self.choice(parent, Some(taken), |child, _| !is_ahead(child))
    }

    /// The choice of a state of the automaton, which goes on to states with more bits,
    /// those of `crossed` axes. Which children these mean, a misprint decides, too.
    fn after_state(&self, parent: NodeId, state: Child<D>, crossed: Axes<D>) -> Choice<D> {
        let moving = Axes::<D>::of(|e| crossed.contains(e) && self.ray.direction()[e] != 0.0);
        let is_ahead = |later: &Child<D>| {
            let gained = later.0 ^ state.0;
            gained & state.0 == 0 && gained & !moving.0 == 0
        };
        let ahead = Child::all().filter(is_ahead);
        let ahead: Vec<Child<D>> = ahead.map(|state| self.child_of(state)).collect();
        self.choice(parent, Some(self.child_of(state)), |child, _| !ahead.contains(&child))
    }

    /// The child that a state of the automaton means.
    fn child_of(&self, state: Child<D>) -> Child<D> {
        let mask = self.moment.clip.map_or(Axes::NONE, |clip| clip.mirror);
        self.query.variants_at_work().child_of_state(state, mask)
    }

    /// What halving has left of the children: of a node that is halved, or of the parent
    /// of one that is whole.
    fn halved(&self, part: Part<D>) -> Option<Choice<D>> {
        let (parent, taken) = if part.halved.is_empty() {
            (self.tree.parent(part.node)?, self.tree.child_index(part.node))
        } else {
            (part.node, None)
        };
        let pending = self.moment.pending.iter().map(|(part, _)| *part);
        let parts: Vec<Part<D>> = pending.chain([part]).collect();
        let is_in = |part: &Part<D>, child: Child<D>, node: NodeId| {
            let is_half = part.node == parent && (child.0 ^ part.upper.0) & part.halved.0 == 0;
            is_half || self.tree.holds(node, part.node)
        };
        let is_left =
            |child: Child<D>, node: NodeId| parts.iter().any(|part| is_in(part, child, node));
        Some(self.choice(parent, taken, |child, node| !is_left(child, node)))
    }

    /// The choice of `taken`, by which some of the children are ruled out; not one that
    /// the algorithm is or was in.
    fn choice(
        &self,
        parent: NodeId,
        taken: Option<Child<D>>,
        is_ruled_out: impl Fn(Child<D>, NodeId) -> bool,
    ) -> Choice<D> {
        let visited = self.visited(parent);
        let children = Child::all().zip(self.tree.children(self.tree.node(parent)));
        let children = children.map(|(child, node)| (child, node.id));
        let others = children.filter(|&(child, node)| {
            Some(child) != taken
                && self.moment.current != Some(node)
                && !visited[usize::from(child.0)]
                && is_ruled_out(child, node)
        });
        Choice { parent, taken, rejected: others.map(|(_, node)| node).collect() }
    }

    /// For each of the children, whether a visited leaf lies in it: one pass
    /// over the path for all of them.
    fn visited(&self, parent: NodeId) -> [bool; 8] {
        let (level, code) = (self.tree.level(parent), self.tree.code(parent));
        let mut visited = [false; 8];
        for leaf in &self.moment.leaves {
            let leaf = self.tree.code(leaf.node);
            if level > 0 && (0..D).all(|e| leaf[e] >> level == code[e] >> level) {
                visited[usize::from(branch(leaf, level).0)] = true;
            }
        }
        visited
    }
}
