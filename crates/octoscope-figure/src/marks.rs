//! The marks of a moment.

mod apart;
mod choice;
mod mirrored;
mod passage;
mod ray;
mod sides;

pub(crate) use choice::Choice;
pub(crate) use mirrored::mirrored_origins;
pub(crate) use ray::{STRETCH, interval, nearest, stretch};
pub use ray::{arrow_end, far_end};

use crate::space::BETWEEN;
use crate::ways::ways;
use crate::{Mark, Role, Shape, Show};
use octoscope_core::event::{End, Event};
use octoscope_core::geometry::{AXIS_NAMES, Aabb, Axes, Ray};
use octoscope_core::locate::Direction;
use octoscope_core::query::Query;
use octoscope_core::trace::{LeafOnRay, Moment};
use octoscope_core::tree::{Child, NodeId, Tree};
use std::collections::HashSet;

/// Marks of a query at a moment, the lowest first; O(length of the path), so
/// that they can be made anew while the ray is dragged. `event` is the last
/// that has happened.
pub fn marks<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    query: &Query<D>,
    moment: &Moment<D>,
    event: Option<&Event<D>>,
    show: &Show,
) -> Vec<Mark<D>> {
    let scene = Scene { tree, ray, query, moment, event, show };
    let mut marks = vec![node_mark(tree, NodeId::ROOT, Role::Root)];
    scene.visited(&mut marks);
    scene.ancestors(&mut marks);
    scene.children(&mut marks);
    scene.apart(&mut marks);
    scene.current(&mut marks);
    scene.planes(&mut marks);
    marks.extend(ways(tree, ray, moment, event));
    scene.query(&mut marks);
    scene.mirrored(&mut marks);
    scene.ray(&mut marks);
    marks.sort_by_cached_key(|mark| mark.role.layer());
    marks
}

/// Makes the reports of nodes that are not right known as such; `strayed` are all of the
/// run, in the order of their numbers.
pub fn cross_out<const D: usize>(marks: &mut [Mark<D>], strayed: &[NodeId]) {
    for mark in marks {
        let is_report = matches!(mark.role, Role::Visited { .. } | Role::Found);
        if is_report && mark.node.is_some_and(|node| strayed.binary_search(&node).is_ok()) {
            mark.role = Role::Strayed;
        }
    }
}

/// Mark of a node that means `role`.
pub fn node_mark<const D: usize>(tree: &Tree<D>, node: NodeId, role: Role) -> Mark<D> {
    Mark::new(Shape::Box(tree.node_box(node)), role).of_node(node)
}

struct Scene<'a, const D: usize> {
    tree: &'a Tree<D>,
    ray: &'a Ray<D>,
    query: &'a Query<D>,
    moment: &'a Moment<D>,
    event: Option<&'a Event<D>>,
    show: &'a Show,
}

impl<const D: usize> Scene<'_, D> {
    /// Visited leaves and touches.
    fn visited(&self, marks: &mut Vec<Mark<D>>) {
        let root = interval(self.ray, &self.tree.domain().root_box()).unwrap_or([0.0, 1.0]);
        let misprinted = self.query.is_misprinted();
        let share_of = |leaf: &LeafOnRay| {
            ((leaf.enter - root[0].max(0.0)) / (root[1] - root[0].max(0.0))).clamp(0.0, 1.0)
        };
        // They have their numbers once they are sorted.
        let numbered: HashSet<NodeId> = self.moment.leaves.iter().map(|leaf| leaf.node).collect();
        for leaf in self.moment.met.iter().filter(|leaf| !numbered.contains(&leaf.node)) {
            let role = Role::Visited { share: share_of(leaf) };
            marks.push(node_mark(self.tree, leaf.node, role));
        }
        for (index, leaf) in self.moment.leaves.iter().enumerate() {
            let share = share_of(leaf);
            marks.push(node_mark(self.tree, leaf.node, Role::Visited { share }));
            if self.show.order_numbers {
                let label = Mark::new(self.number_in(leaf, misprinted), Role::OrderNumber);
                marks.push(label.of_node(leaf.node).with_text((index + 1).to_string()));
            }
            if self.show.codes {
                marks.push(self.code_label(leaf.node));
            }
        }
        // Where a misprint comes to a leaf without a length, the ray need not be.
        let touches = if misprinted { &[] } else { &self.moment.touches[..] };
        for &(node, at) in touches {
            let point = Mark::new(Shape::Point(self.ray.at(at)), Role::Touch);
            marks.push(point.of_node(node));
        }
    }

    /// Where the number of a visited leaf stands: along the ray. What a misprint reports
    /// may be beside it, and has its number at the middle.
    fn number_in(&self, leaf: &LeafOnRay, misprinted: bool) -> Shape<D> {
        let chord = [leaf.enter, leaf.exit].map(|t| self.ray.at(t));
        let bounds = self.tree.node_box(leaf.node);
        let middle: [f64; D] = std::array::from_fn(|e| 0.5 * chord[0][e] + 0.5 * chord[1][e]);
        if misprinted && !bounds.owns(middle) {
            return Shape::LabelAlong([bounds.centre(); 2]);
        }
        Shape::LabelAlong(chord)
    }

    fn code_label(&self, node: NodeId) -> Mark<D> {
        let codes = self.tree.code(node).map(|code| code.to_string()).join(BETWEEN);
        let bounds = self.tree.node_box(node);
        let label = Mark::new(Shape::LabelIn { at: bounds.centre(), bounds }, Role::CellCode);
        label.of_node(node).with_text(codes)
    }

    fn ancestors(&self, marks: &mut Vec<Mark<D>>) {
        if self.show.ancestors {
            for (index, node) in self.moment.ancestors(self.tree).enumerate() {
                if node != NodeId::ROOT {
                    let above = (index + 1).min(u8::MAX as usize) as u8;
                    marks.push(node_mark(self.tree, node, Role::Ancestor { above }));
                }
            }
        }
    }

    fn choice(&self) -> Option<Choice<D>> {
        Choice::of(self.tree, self.ray, self.query, self.moment, self.event)
    }

    fn children(&self, marks: &mut Vec<Mark<D>>) {
        let is_shown = self.show.children && !self.is_apart();
        let Some(choice) = self.choice().filter(|_| is_shown) else {
            return;
        };
        let parent = self.tree.node(choice.parent);
        for (child, node) in Child::all().zip(self.tree.children(parent)) {
            let bounds = self.tree.node_box(node.id);
            // The current node has its own, stronger mark.
            if choice.rejected.contains(&node.id) {
                marks.push(node_mark(self.tree, node.id, Role::Rejected));
            } else if Some(child) == choice.taken && self.moment.current != Some(node.id) {
                marks.push(node_mark(self.tree, node.id, Role::Taken));
            }
            let at = index_place(&bounds, child);
            let label = Mark::new(Shape::LabelIn { at, bounds }, Role::ChildIndex);
            marks.push(label.of_node(node.id).with_text(self.child_name(child)));
        }
    }

    fn current(&self, marks: &mut Vec<Mark<D>>) {
        let ended = match self.moment.end {
            Some(End::LeftRoot | End::Missed | End::Outside | End::SegmentEnd | End::Looped) => {
                true
            }
            Some(End::FirstFull | End::Found | End::Cut) | None => false,
        };
        let Some(node) = self.moment.current.filter(|_| !ended) else {
            return;
        };
        let part = self.moment.part.filter(|part| part.node == node);
        let bounds = part.map_or_else(|| self.tree.node_box(node), |part| part.bounds(self.tree));
        let missed = matches!(self.event, Some(Event::Test { interval: None, .. }));
        let role = match (self.moment.found == Some(node), missed) {
            (true, _) => Role::Found,
            (false, true) => Role::Missed,
            (false, false) => Role::Current,
        };
        marks.push(Mark::new(Shape::Box(bounds), role).of_node(node));
        let is_visited = || self.moment.leaves.iter().any(|leaf| leaf.node == node);
        if self.show.codes && !is_visited() {
            marks.push(self.code_label(node));
        }
        self.sides(node, &bounds, marks);
        self.passage(&bounds, marks);
    }

    /// Planes that are compared or met in this step.
    fn planes(&self, marks: &mut Vec<Mark<D>>) {
        let mut middle = |node: NodeId, axes: Axes<D>| {
            let bounds = self.tree.node_box(node);
            for axis in axes.iter() {
                let shape = side(&bounds, axis, bounds.centre()[axis]);
                let mark = Mark::new(shape, Role::MidPlane(axis));
                marks.push(mark.of_node(node).with_text(AXIS_NAMES[axis]));
            }
        };
        let all = Axes::where_true([true; D]);
        let frame = self.moment.frame().map(|frame| frame.node);
        match (self.event, frame) {
            (Some(&Event::Split { axis, plane, taken, .. }), _) => {
                // Both halves have the same extent across the plane.
                let (axis, mut bounds) = (usize::from(axis), taken.bounds(self.tree));
                (bounds.min[axis], bounds.max[axis]) = (plane, plane);
                let mark = Mark::new(Shape::Plane { axis, bounds }, Role::MidPlane(axis));
                marks.push(mark.of_node(taken.node).with_text(AXIS_NAMES[axis]));
            }
            (
                Some(Event::Halve { .. } | Event::Cuts { .. } | Event::Classify { .. }),
                Some(node),
            ) => {
                middle(node, all);
            }
            (Some(Event::Flip { axes, .. }), Some(node)) => middle(node, *axes),
            (Some(Event::First { compared, .. }), Some(node)) => middle(node, *compared),
            (Some(&(Event::Compare { node, .. } | Event::Follow { node, .. })), _) => {
                if let Some(parent) = self.tree.parent(node) {
                    middle(parent, all);
                }
            }
            (Some(&Event::Step { state, axes, .. }), Some(parent)) => {
                let mask = self.moment.clip.map_or(Axes::NONE, |clip| clip.mirror);
                let parent = self.tree.node(parent);
                if !parent.is_leaf() {
                    let variants = self.query.variants_at_work();
                    let left = self.tree.child(parent, variants.child_of_state(state, mask)).id;
                    self.exit_planes(left, axes, marks);
                }
            }
            (
                Some(
                    &(Event::Exits { axes, .. }
                    | Event::Target { axes, .. }
                    | Event::Leave { axes, .. }),
                ),
                _,
            ) => {
                if let Some(node) = self.moment.current {
                    self.exit_planes(node, axes, marks);
                }
            }
            (Some(&Event::Parent { node, direction, .. }), _) => {
                // Whether the child lies there is what is asked.
                let axes = Axes::of(|e| direction[e] != 0);
                self.far_sides(node, axes, direction.map(f64::from), marks);
            }
            (Some(&Event::Cross { axes, cell, .. }), _) => {
                // Between the cell that is left and the next one, as far as the leaf reaches.
                let Some(leaf) = self.moment.current else { return };
                let bounds = self.tree.node_box(leaf);
                for axis in axes.iter() {
                    let is_on = self.ray.direction()[axis] > 0.0;
                    let index = cell[axis] + i64::from(!is_on);
                    let at = self.tree.domain().plane(axis, index as u32);
                    marks.push(exit_plane(&bounds, axis, at).of_node(leaf));
                }
            }
            (Some(_) | None, _) => {}
        }
    }

    /// Sides of `node` through which the ray leaves it, or the query asks.
    fn exit_planes(&self, node: NodeId, axes: Axes<D>, marks: &mut Vec<Mark<D>>) {
        let along = match *self.query {
            Query::Neighbour { direction, .. } => direction.components().map(f64::from),
            Query::Ray { .. } | Query::Point { .. } | Query::Region { .. } => self.ray.direction(),
        };
        self.far_sides(node, axes, along, marks);
    }

    /// Sides of `node` across these axes, towards which a direction leads.
    fn far_sides(&self, node: NodeId, axes: Axes<D>, along: [f64; D], marks: &mut Vec<Mark<D>>) {
        let bounds = self.tree.node_box(node);
        for axis in axes.iter() {
            let at = if along[axis] > 0.0 { bounds.max[axis] } else { bounds.min[axis] };
            marks.push(exit_plane(&bounds, axis, at).of_node(node));
        }
    }

    /// What is asked for.
    fn query(&self, marks: &mut Vec<Mark<D>>) {
        match *self.query {
            Query::Ray { .. } => {}
            Query::Point { at, .. } => {
                marks.push(Mark::new(Shape::Point(at), Role::QueryPoint));
            }
            Query::Region { min, max, .. } => {
                marks.push(Mark::new(Shape::Box(Aabb { min, max }), Role::Region));
            }
            Query::Neighbour { level, code, direction, .. } => {
                if let Some(node) = self.tree.node_at(level, code) {
                    let bounds = self.tree.node_box(node.id);
                    let found = self.moment.found.map(|found| self.tree.node_box(found));
                    let ends = direction_ends(&bounds, direction, found.as_ref());
                    marks.push(node_mark(self.tree, node.id, Role::Region));
                    marks.push(Mark::new(Shape::Arrow(ends), Role::Direction));
                }
            }
        }
        marks.extend(self.target().map(|bounds| Mark::new(Shape::Box(bounds), Role::Target)));
    }

    /// The cell beyond the border, if it is in the domain, until its leaf is reached: as large
    /// as the one that is left, or the smallest, as the query looks for it.
    fn target(&self) -> Option<Aabb<D>> {
        let (domain, target) = (self.tree.domain(), self.moment.target?);
        let code = domain.code_inside(target.to)?;
        let holds = |node: NodeId| {
            let (level, of_node) = (self.tree.level(node), self.tree.code(node));
            (0..D).all(|e| code[e] >> level == of_node[e] >> level)
        };
        let visited = self.moment.leaves.last().map(|leaf| leaf.node);
        let current = self.moment.current.filter(|node| self.tree.node(*node).is_leaf());
        if [visited, current, self.moment.found].into_iter().flatten().any(holds) {
            return None;
        }
        let level = if self.query.looks_for_equal_size() { target.level } else { 0 };
        Some(domain.cell_box(level, code.map(|code| code >> level << level)))
    }
}

/// Where the arrow of the direction that is asked for lies: within the node, where no way
/// leads on, until it is known what lies there.
fn direction_ends<const D: usize>(
    node: &Aabb<D>,
    direction: Direction<D>,
    found: Option<&Aabb<D>>,
) -> [[f64; D]; 2] {
    let (centre, size, step) = (node.centre(), node.size(), direction.components());
    let at = |share: f64| std::array::from_fn(|e| centre[e] + share * size[e] * f64::from(step[e]));
    found.map_or([at(-0.3), at(0.4)], |found| [centre, well_within(found, at(0.5))])
}

/// The point of a box that is nearest to `point` and not near a side of it.
fn well_within<const D: usize>(bounds: &Aabb<D>, point: [f64; D]) -> [f64; D] {
    const INSET: f64 = 0.3;
    let size = bounds.size();
    std::array::from_fn(|e| {
        point[e].clamp(bounds.min[e] + INSET * size[e], bounds.max[e] - INSET * size[e])
    })
}

/// A plane that is met, across `axis` at `at`, as far as a box reaches.
fn exit_plane<const D: usize>(bounds: &Aabb<D>, axis: usize, at: f64) -> Mark<D> {
    Mark::new(side(bounds, axis, at), Role::ExitPlane(axis)).with_text(AXIS_NAMES[axis])
}

/// The part of the plane across `axis` at `at` that lies in a box.
fn side<const D: usize>(bounds: &Aabb<D>, axis: usize, at: f64) -> Shape<D> {
    let mut bounds = *bounds;
    (bounds.min[axis], bounds.max[axis]) = (at, at);
    Shape::Plane { axis, bounds }
}

/// Where a child's index is written: towards the outer corner of the parent.
fn index_place<const D: usize>(bounds: &Aabb<D>, child: Child<D>) -> [f64; D] {
    std::array::from_fn(|e| {
        let outer = if child.is_upper(e) { 0.82 } else { 0.18 };
        bounds.min[e] + outer * (bounds.max[e] - bounds.min[e])
    })
}
