//! The debugger's state after some steps of a trace, folded from its events.

use super::state::{
    Codes, Cuts, Detour, Difference, Exits, Extent, Frame, GridCell, HalvingPlane, LeafOnRay,
    RootClip, Target, Towards,
};
use super::{Counters, Trace};
use crate::event::{End, Event};
use crate::geometry::Axes;
use crate::tree::{Child, Code, NodeId, Part, Tree};

/// State of an algorithm after some number of its events.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Moment<const D: usize> {
    /// Number of events that have happened.
    pub step: usize,
    /// Node at which the algorithm is.
    pub current: Option<NodeId>,
    /// Node from which a query searches on.
    pub start: Option<NodeId>,
    /// Nodes on the stack of a top-down traversal, the root first.
    pub stack: Vec<Frame<D>>,
    /// Leaves visited so far, in order.
    pub leaves: Vec<LeafOnRay>,
    /// Leaves met in one point so far, with the parameter of the point.
    pub touches: Vec<(NodeId, f64)>,
    /// Parameters between which the ray is in the current node, if that was tested
    /// last.
    pub tested: Option<[f64; 2]>,
    /// Leaves that were tested by themselves and are cut by the ray, in the order of the
    /// tests. At the end only those count that were visited, and none is left here.
    pub met: Vec<LeafOnRay>,
    /// Number of leaves that were tested by themselves and met the ray, be it in a point.
    pub n_met: usize,
    /// Leaves that were tested by themselves and missed the ray.
    pub missed: Vec<NodeId>,
    /// Codes that are followed.
    pub codes: Option<Codes<D>>,
    /// Cell that is left, and the codes beyond.
    pub target: Option<Target<D>>,
    /// Codes that are compared by XOR.
    pub difference: Option<Difference<D>>,
    /// Corners of the region that is located, as codes.
    pub corners: Option<[Code<D>; 2]>,
    /// Far planes of the leaf that a walk by codes leaves.
    pub exits: Option<Exits<D>>,
    /// Parameters of the root's planes, and the mirror mask.
    pub clip: Option<RootClip<D>>,
    /// Part of the current node in which a binary space partition is.
    pub part: Option<Part<D>>,
    /// Parameters between which the ray is in that part.
    pub part_interval: Option<[f64; 2]>,
    /// The plane that halved the part before it, until it is visited or another one comes
    /// from the stack.
    pub halving: Option<HalvingPlane>,
    /// Parts that wait on the stack of a binary space partition, its top last,
    /// with the parameters between which the ray is in them.
    pub pending: Vec<(Part<D>, [f64; 2])>,
    /// Cell of a walk through the grid.
    pub grid: Option<GridCell<D>>,
    /// The way to a neighbour through the tree.
    pub detour: Detour,
    /// Where the neighbour is looked for, step by step: on the way up to be found
    /// beyond the parents, on the way down mirrored.
    pub towards: Option<Towards<D>>,
    /// What is still to be mirrored on the way down, the next step last.
    pub to_mirror: Vec<Towards<D>>,
    /// Exit point of a leaf and the point to which it was pushed.
    pub pushed: Option<[[f64; D]; 2]>,
    /// Node that a query has found.
    pub found: Option<NodeId>,
    /// What it has cost.
    pub counters: Counters,
    /// Why the algorithm has ended, if it has.
    pub end: Option<End>,
}

impl<const D: usize> Moment<D> {
    /// State after the first `step` events of `trace`, or after all of them.
    /// O(`step`): microseconds for the trace of a ray.
    pub fn after(tree: &Tree<D>, trace: &Trace<D>, step: usize) -> Self {
        let mut moment = Self::default();
        for event in trace.events.iter().take(step) {
            moment.apply(tree, event);
        }
        moment
    }

    /// The node whose planes are at work: on top of the stack.
    pub fn frame(&self) -> Option<&Frame<D>> {
        self.stack.last()
    }

    /// Ancestors of the current node, its parent first.
    pub fn ancestors<'a>(&self, tree: &'a Tree<D>) -> impl Iterator<Item = NodeId> + 'a {
        self.current.into_iter().flat_map(|node| tree.ancestors(node))
    }

    /// The node whose children are chosen among: the current one, or its parent if
    /// it is a leaf; the root before and after everything. `None` if that is a leaf.
    pub fn at_work(&self, tree: &Tree<D>) -> Option<NodeId> {
        let node = self.current.unwrap_or(NodeId::ROOT);
        if tree.node(node).is_leaf() { tree.parent(node) } else { Some(node) }
    }

    /// Advances the state by one event.
    pub fn apply(&mut self, tree: &Tree<D>, event: &Event<D>) {
        self.step += 1;
        self.counters.add(event);
        if let Some(grid) = &mut self.grid {
            grid.left = None;
        }
        match *event {
            Event::Clip { near, far, enter, exit, hit, mirror } => {
                let interval = [enter, exit];
                self.clip = Some(RootClip { near, far, interval, hit, mirror });
            }
            Event::Test { node, interval, touch, .. } => {
                self.current = Some(node);
                self.tested = interval;
                match interval {
                    None => self.missed.push(node),
                    Some([enter, exit]) if tree.node(node).is_leaf() => {
                        self.n_met += 1;
                        if !touch {
                            self.met.push(LeafOnRay { node, enter, exit });
                        }
                    }
                    Some(_) => {}
                }
            }
            Event::Sort { .. } => {
                self.current = None;
                self.tested = None;
            }
            Event::Visit { node, state, near, far } => {
                self.change_frame(|parent| parent.child_state = state);
                self.push(node, state, Extent::Planes { near, far });
            }
            Event::Skip { .. } => {}
            Event::Halve { mid, .. } => self.change_frame(|frame| frame.mid = Some(mid)),
            Event::First { entry, state, .. } => self.change_frame(|frame| {
                frame.entry = Some(entry);
                frame.child_state = Some(state);
            }),
            Event::Step { next, .. } => self.change_frame(|frame| {
                frame.child_state = next.or(frame.child_state);
            }),
            Event::Up { node } => {
                self.stack.pop();
                self.current = node;
            }
            Event::Enter { node, interval, .. } => {
                // The place that was looked for is reached.
                self.codes = None;
                self.push(node, None, Extent::Interval(interval));
            }
            Event::Cuts { order, inside, .. } => {
                self.change_frame(|frame| frame.cuts = Some(Cuts { order, inside }));
            }
            Event::Classify { child, .. } | Event::Flip { child, .. } => {
                self.change_frame(|frame| frame.child = Some(child));
            }
            Event::Split { axis, taken, kept, at, interval: [enter, exit], .. } => {
                let node = self.part.map_or(NodeId::ROOT, |part| part.node);
                self.halving = Some(HalvingPlane { node, axis: usize::from(axis), at });
                self.current = Some(taken.node);
                self.part = Some(taken);
                self.part_interval = Some([enter, if kept.is_some() { at } else { exit }]);
                self.pending.extend(kept.map(|part| (part, [at, exit])));
            }
            Event::Pop { part, interval } => {
                self.current = Some(part.node);
                self.part = Some(part);
                self.part_interval = Some(interval);
                self.halving = None;
                self.pending.pop();
            }
            Event::Grid { cell, next, .. } => {
                let near = self.clip.map_or([0.0; D], |clip| clip.near);
                let enter = near.into_iter().fold(0.0, f64::max);
                let (cell, crossed, left) = (Some(cell), Axes::NONE, None);
                self.grid = Some(GridCell { enter, cell, next, crossed, left });
            }
            Event::Cross { next, axes, cell, ahead, .. } => {
                let enter = next.into_iter().fold(f64::INFINITY, f64::min);
                let cell = tree.domain().code_inside(cell);
                let left = Some(next);
                self.grid = Some(GridCell { enter, cell, next: ahead, crossed: axes, left });
            }
            Event::Parent { node, child, direction, common, .. } => {
                self.current = Some(node);
                self.codes = None;
                self.detour.up.push(node);
                self.towards = Some(Towards { direction: common, child });
                self.to_mirror.push(Towards { direction, child });
            }
            Event::Mirror { node, .. } | Event::Facing { node, .. } => {
                self.current = Some(node);
                self.codes = None;
                self.detour.down.push(node);
                self.towards = self.to_mirror.pop().or(self.towards);
            }
            Event::Rope { node, .. } => {
                self.codes = None;
                if let (Some(from), Some(to)) = (self.current, node) {
                    self.detour.links.push([from, to]);
                    self.current = Some(to);
                }
            }
            Event::Push { from, to, .. } => self.pushed = Some([from, to]),
            Event::Begin { node } => {
                self.current = Some(node);
                self.start = Some(node);
                // What is searched for now are the codes just beyond the last cell.
                let beyond = self.target.and_then(|target| tree.domain().code_inside(target.to));
                let code = beyond.or(self.codes.map(|codes| codes.code));
                self.codes = code.map(|code| Codes { code, bit: None });
            }
            Event::Encode { code, .. } => self.codes = Some(Codes { code, bit: None }),
            Event::Compare { node, .. } => self.current = Some(node),
            Event::Follow { level, code, node, .. } => {
                self.codes = Some(Codes { code, bit: Some(level - 1) });
                self.current = Some(node);
            }
            Event::Exits { planes, exits, axes } => {
                // What was looked for is reached, and left.
                self.codes = None;
                self.towards = None;
                self.to_mirror.clear();
                self.exits = Some(Exits { planes, exits, axes });
            }
            Event::Target { level, from, to, axes, .. } => {
                self.target = Some(Target { level, from, to, axes, outside: None });
                self.difference = None;
            }
            Event::Border { outside, .. } => {
                if let Some(target) = &mut self.target {
                    target.outside = Some(outside);
                }
            }
            Event::Difference { from, to, xor, level } => {
                let climbed = self.current.map_or(level, |node| tree.level(node));
                self.difference = Some(Difference { from, to, xor, level, climbed });
                self.codes = Some(Codes { code: to, bit: None });
            }
            Event::Leave { .. } => {}
            Event::Resume { node, .. } => {
                let kept = self.stack.iter().position(|frame| frame.node == node);
                self.stack.truncate(kept.map_or(self.stack.len(), |index| index + 1));
                self.current = Some(node);
            }
            Event::Climb { node, level } => {
                self.current = Some(node);
                if let Some(difference) = &mut self.difference {
                    difference.climbed = level;
                }
            }
            Event::Corners { from, to, .. } => self.corners = Some([from, to]),
            Event::Leaf { node, enter, exit, .. } => {
                self.leaves.push(LeafOnRay { node, enter, exit });
                self.current = Some(node);
                self.exits = None;
                self.pushed = None;
                self.towards = None;
                self.halving = None;
                self.to_mirror.clear();
                self.detour = Detour::default();
            }
            Event::Touch { node, at } => {
                self.touches.push((node, at));
                self.current = Some(node);
            }
            Event::Found { node } => {
                self.current = Some(node);
                self.found = Some(node);
            }
            Event::End(end) => {
                self.end = Some(end);
                self.met.clear();
            }
        }
    }

    fn push(&mut self, node: NodeId, state: Option<Child<D>>, extent: Extent<D>) {
        let (mid, entry, child_state, child, cuts) = (None, None, None, None, None);
        self.stack.push(Frame { node, state, extent, mid, entry, child_state, child, cuts });
        self.current = Some(node);
    }

    fn change_frame(&mut self, change: impl FnOnce(&mut Frame<D>)) {
        if let Some(frame) = self.stack.last_mut() {
            change(frame);
        }
    }
}
