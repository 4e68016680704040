//! The branches from nodes to their children.

use super::below::Below;
use super::draw::{BEYOND, Drawing, NUMBER};
use crate::camera::clipped;
use crate::{Drawn, Figure, Form, Part, Role};

/// Least height in which branches fan out.
const LEAST_FAN: f64 = 4.0;
/// Room between siblings, or what is written below them, and the branches.
const GAP: f64 = 1.0;

impl<const D: usize> Drawing<'_, D> {
    /// For every item, how far below its middle its branches part, if they are to pass
    /// under its siblings and what is written `below` them; none where they meet none of
    /// it, or where there is no room.
    pub(super) fn fans(&self, below: &[Below]) -> Vec<Option<f64>> {
        let mut branches: Vec<Vec<[[f64; 2]; 2]>> = vec![Vec::new(); self.items.len()];
        for (n, item) in self.items.iter().enumerate() {
            if let Some(parent) = item.parent {
                branches[parent].push(self.branch(n, parent));
            }
        }
        let fan = |(parent, branches): (usize, Vec<[[f64; 2]; 2]>)| {
            if branches.is_empty() {
                return None;
            }
            let depth = self.items[parent].depth;
            let others = (0..self.items.len())
                .filter(|&n| n != parent && self.items[n].depth == depth)
                .map(|n| self.area(n));
            let nodes: Vec<_> = others.collect();
            let texts = below.iter().filter(|text| text.depth == depth).map(Below::area);
            let all: Vec<_> = nodes.iter().copied().chain(texts).collect();
            // What is written gives way where there is no room for both.
            self.fan_under(parent, &branches, &all)
                .or_else(|| self.fan_under(parent, &branches, &nodes))
        };
        branches.into_iter().enumerate().map(fan).collect()
    }

    /// How far below a parent its branches part to pass under these areas.
    fn fan_under(
        &self,
        parent: usize,
        branches: &[[[f64; 2]; 2]],
        areas: &[[[f64; 2]; 2]],
    ) -> Option<f64> {
        let is_hit =
            |area: &[[f64; 2]; 2]| branches.iter().any(|&line| clipped(line, *area).is_some());
        areas.iter().find(|area| is_hit(area))?;
        // Flatter, they come under more of what is there.
        let ends = || branches.iter().map(|branch| branch[1]);
        let left = ends().map(|end| end[0]).fold(self.placed[parent][0], f64::min);
        let right = ends().map(|end| end[0]).fold(self.placed[parent][0], f64::max);
        let passed = areas.iter().filter(|[min, max]| min[0] <= right && left <= max[0]);
        let lowest = passed.map(|area| area[1][1]).fold(f64::NEG_INFINITY, f64::max) + GAP;
        let has_room = ends().all(|end| lowest + LEAST_FAN <= end[1]);
        has_room.then(|| lowest - self.placed[parent][1])
    }

    /// Least and largest corner of what a node covers, its line included.
    fn area(&self, n: usize) -> [[f64; 2]; 2] {
        let reach = self.half(n) + 1.5;
        [-reach, reach].map(|by| self.placed[n].map(|x| x + by))
    }

    /// The line to an item, which begins with the stem of its parent's branches.
    fn line(&self, n: usize, parent: usize, fans: &[Option<f64>]) -> Vec<[f64; 2]> {
        let [start, end] = self.branch(n, parent);
        match fans[parent] {
            None => vec![start, end],
            Some(fan) => {
                let [x, y] = self.placed[parent];
                vec![[x, y + self.half(parent)], [x, y + fan], end]
            }
        }
    }

    /// Whether a branch runs over what is written.
    pub(super) fn is_crossed(&self, text: &Below, fans: &[Option<f64>]) -> bool {
        let area = text.area();
        let is_of_its_level = |parent: usize| self.items[parent].depth == text.depth;
        let parents = self.items.iter().enumerate().filter_map(|(n, item)| Some((n, item.parent?)));
        let lines = parents.filter(|&(_, parent)| is_of_its_level(parent));
        lines
            .map(|(n, parent)| self.line(n, parent, fans))
            .any(|line| line.windows(2).any(|ends| clipped([ends[0], ends[1]], area).is_some()))
    }

    /// From the border of the parent, which is not covered, to above the child's number.
    fn branch(&self, n: usize, parent: usize) -> [[f64; 2]; 2] {
        let (from, to) = (self.placed[parent], self.placed[n]);
        let room = if self.has_number(n) { NUMBER + self.line_around(n) } else { 0.0 };
        let end = [to[0], to[1] - self.half(n) - room];
        let way = [end[0] - from[0], end[1] - from[1]];
        let length = way[0].hypot(way[1]).max(1e-9);
        let start = std::array::from_fn(|e| from[e] + way[e] / length * self.half(parent));
        [start, end]
    }

    pub(super) fn draw_branch(&self, figure: &mut Figure, n: usize, fans: &[Option<f64>]) {
        let Some(parent) = self.items[n].parent else { return };
        let [start, end] = self.branch(n, parent);
        let page = [self.page.width, self.page.height];
        let is_beyond = |e: usize| {
            (start[e].max(end[e]) < -BEYOND) || (f64::min(start[e], end[e]) > page[e] + BEYOND)
        };
        if is_beyond(0) || is_beyond(1) {
            return;
        }
        let state = self.state(n);
        let (role, part) = match (state.above_current.is_some(), state.visited.is_some()) {
            (true, _) => (Role::Path, Part::Edge),
            (false, true) => (Role::Path, Part::Fine),
            (false, false) if state.is_met() => (Role::Path, Part::Fine),
            (false, false) if state.is_rejected => (Role::Rejected, Part::Edge),
            (false, false) => (Role::Branch, Part::Edge),
        };
        let line = self.line(n, parent, fans);
        let node = Some(self.items[n].node.id);
        figure.drawn.push(Drawn { form: Form::Polyline(line), role, part, node });
    }
}
