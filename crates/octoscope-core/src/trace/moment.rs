//! The debugger's state after some steps of a trace, folded from its events.

use super::{Counters, Trace};
use crate::event::{End, Event};
use crate::geometry::Axes;
use crate::tree::{Child, Code, NodeId, Tree};

/// State of an algorithm after some number of its events.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Moment<const D: usize> {
    /// Number of events that have happened.
    pub step: usize,
    /// Node at which the algorithm is.
    pub current: Option<NodeId>,
    /// Nodes on the stack of a top-down traversal, the root first.
    pub stack: Vec<Frame<D>>,
    /// Leaves visited so far, in order.
    pub leaves: Vec<LeafOnRay>,
    /// Leaves met in one point so far, with the parameter of the point.
    pub touches: Vec<(NodeId, f64)>,
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
    /// Node that a query has found.
    pub found: Option<NodeId>,
    /// What it has cost.
    pub counters: Counters,
    /// Why the algorithm has ended, if it has.
    pub end: Option<End>,
}

/// Node on the stack of a top-down traversal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<const D: usize> {
    /// The node.
    pub node: NodeId,
    /// Its child index in the mirrored numbering; `None` for the root.
    pub state: Option<Child<D>>,
    /// Parameters of its near planes.
    pub near: [f64; D],
    /// Parameters of its mid planes, once they are known.
    pub mid: Option<[f64; D]>,
    /// Parameters of its far planes.
    pub far: [f64; D],
    /// State of its automaton: the child that is visited or was left last.
    pub child_state: Option<Child<D>>,
}

impl<const D: usize> Frame<D> {
    /// Parameter at which the ray enters the node: its latest near plane.
    pub fn enter(&self) -> f64 {
        self.near.into_iter().fold(f64::NEG_INFINITY, f64::max)
    }

    /// Parameter at which the ray leaves the node: its earliest far plane.
    pub fn exit(&self) -> f64 {
        self.far.into_iter().fold(f64::INFINITY, f64::min)
    }
}

/// A visited leaf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeafOnRay {
    /// The leaf.
    pub node: NodeId,
    /// Where the ray enters it, at least 0.
    pub enter: f64,
    /// Where the ray leaves it.
    pub exit: f64,
}

/// Codes on the way down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Codes<const D: usize> {
    /// One code an axis.
    pub code: Code<D>,
    /// Number of the bit that was read last.
    pub bit: Option<u8>,
}

/// A cell and the codes of the place beyond it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target<const D: usize> {
    /// Level of the cell.
    pub level: u8,
    /// Codes of the cell.
    pub from: Code<D>,
    /// Codes beyond it; −1 or 2^R outside the domain.
    pub to: [i64; D],
    /// Axes along which the cell is left.
    pub axes: Axes<D>,
    /// Axes along which the target is outside, once they are known.
    pub outside: Option<Axes<D>>,
}

/// Two codes and their XOR.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference<const D: usize> {
    /// One place.
    pub from: Code<D>,
    /// The other.
    pub to: Code<D>,
    /// Bitwise XOR, axis by axis.
    pub xor: Code<D>,
    /// Level of the smallest cell that holds both.
    pub level: u8,
    /// Level that climbing has reached.
    pub climbed: u8,
}

/// The far planes of a leaf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exits<const D: usize> {
    /// Coordinates of the planes, in world units.
    pub planes: [f64; D],
    /// Their parameters; +∞ on axes that the ray does not move along.
    pub exits: [f64; D],
    /// The planes that are met first.
    pub axes: Axes<D>,
}

/// The ray cut with the root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RootClip<const D: usize> {
    /// Parameters of the near planes.
    pub near: [f64; D],
    /// Parameters of the far planes.
    pub far: [f64; D],
    /// Whether the ray meets the root at some t ≥ 0.
    pub hit: bool,
    /// Axes along which the direction is negative.
    pub mirror: Axes<D>,
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

    /// Advances the state by one event.
    pub fn apply(&mut self, tree: &Tree<D>, event: &Event<D>) {
        self.step += 1;
        self.counters.add(event);
        match *event {
            Event::Clip { near, far, hit, mirror, .. } => {
                self.clip = Some(RootClip { near, far, hit, mirror });
            }
            Event::Test { node, interval } => {
                self.current = Some(node);
                if interval.is_none() {
                    self.missed.push(node);
                }
            }
            Event::Sort { .. } => self.current = None,
            Event::Visit { node, state, near, far } => {
                if let Some(parent) = self.stack.last_mut() {
                    parent.child_state = state;
                }
                self.stack.push(Frame { node, state, near, mid: None, far, child_state: None });
                self.current = Some(node);
            }
            Event::Skip { .. } => {}
            Event::Halve { mid } => self.change_frame(|frame| frame.mid = Some(mid)),
            Event::First { state, .. } => {
                self.change_frame(|frame| frame.child_state = Some(state))
            }
            Event::Step { next, .. } => self.change_frame(|frame| {
                frame.child_state = next.or(frame.child_state);
            }),
            Event::Up { node } => {
                self.stack.pop();
                self.current = node;
            }
            Event::Begin { node } => self.current = Some(node),
            Event::Encode { code, .. } => self.codes = Some(Codes { code, bit: None }),
            Event::Compare { node, .. } => self.current = Some(node),
            Event::Follow { level, code, node, .. } => {
                self.codes = Some(Codes { code, bit: Some(level - 1) });
                self.current = Some(node);
            }
            Event::Exits { planes, exits, axes } => {
                self.exits = Some(Exits { planes, exits, axes });
            }
            Event::Target { level, from, to, axes } => {
                self.target = Some(Target { level, from, to, axes, outside: None });
                self.difference = None;
            }
            Event::Border { outside } => {
                if let Some(target) = &mut self.target {
                    target.outside = Some(outside);
                }
            }
            Event::Difference { from, to, xor, level } => {
                let climbed = self.current.map_or(level, |node| tree.level(node));
                self.difference = Some(Difference { from, to, xor, level, climbed });
                self.codes = Some(Codes { code: to, bit: None });
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
            }
            Event::Touch { node, at } => {
                self.touches.push((node, at));
                self.current = Some(node);
            }
            Event::Found { node } => {
                self.current = Some(node);
                self.found = Some(node);
            }
            Event::End(end) => self.end = Some(end),
        }
    }

    fn change_frame(&mut self, change: impl FnOnce(&mut Frame<D>)) {
        if let Some(frame) = self.stack.last_mut() {
            change(frame);
        }
    }
}
