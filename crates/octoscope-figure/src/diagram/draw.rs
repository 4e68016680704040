//! A laid out diagram as a figure.

use super::below::Below;
use super::layout::Item;
use super::state::{State, States};
use super::{DiagramNode, DiagramOf, NodeKind};
use crate::figure::radius_around;
use crate::{Anchor, Drawn, Figure, Form, Page, Part, Role};
use octoscope_core::event::Event;
use octoscope_core::tree::NodeId;

/// A diagram whose nodes have their places on the page.
pub(super) struct Drawing<'a, const D: usize> {
    pub of: &'a DiagramOf<'a, D>,
    pub items: &'a [Item],
    pub states: &'a States,
    /// Places of the items on the page.
    pub placed: &'a [[f64; 2]],
    /// Distances of siblings and of levels, in page units.
    pub spacing: f64,
    pub levels: f64,
    pub page: Page,
    pub gutter: f64,
}

/// Share of a visited leaf that the disc for its number takes.
const DISC: f64 = 0.9;
/// Distance of siblings at which nodes have their full size; nearer, they are so much
/// smaller that none touches another.
const SPACED: f64 = 22.0;
/// Room above a node for its number.
pub(super) const NUMBER: f64 = 14.0;
/// More than this beyond the page is not drawn.
pub(super) const BEYOND: f64 = 40.0;

impl<const D: usize> Drawing<'_, D> {
    /// The nodes on the page, each with the index of its item.
    pub fn nodes(&self) -> Vec<(usize, DiagramNode)> {
        let near = |[x, y]: [f64; 2]| {
            (self.gutter - BEYOND..=self.page.width + BEYOND).contains(&x)
                && (-BEYOND..=self.page.height + BEYOND).contains(&y)
        };
        let on_page = (0..self.items.len()).filter(|&n| near(self.placed[n]));
        on_page
            .map(|n| {
                let Item { node, is_unfolded, .. } = self.items[n];
                let kind = match (node.is_leaf(), is_unfolded) {
                    (true, _) => NodeKind::Leaf,
                    (false, true) => NodeKind::Unfolded,
                    (false, false) => {
                        NodeKind::Folded { n_leaves: self.of.tree.n_leaves_in(node.id) }
                    }
                };
                let state = self.state(n);
                let matters = state.is_lit() || state.is_in_question;
                let (at, half) = (self.placed[n], self.half(n));
                (n, DiagramNode { node: node.id, at, half, kind, matters })
            })
            .collect()
    }

    /// The levels, the branches, the nodes and what is written at them.
    pub fn figure(&self, nodes: &[(usize, DiagramNode)], hovered: Option<NodeId>) -> Figure {
        let mut figure = Figure { page: self.page, drawn: Vec::new() };
        self.draw_levels(&mut figure);
        let mut below: Vec<Below> = nodes.iter().filter_map(|(n, _)| self.below(*n)).collect();
        let fans = self.fans(&below);
        self.retain_legible(&mut below, &fans);
        // What matters lies above the rest.
        for lit in [false, true] {
            for n in (1..self.items.len()).filter(|&n| self.state(n).is_lit() == lit) {
                self.draw_branch(&mut figure, n, &fans);
            }
        }
        for (n, node) in nodes {
            self.draw_node(&mut figure, *n, node);
        }
        if let Some(node) = self.hovered(nodes, hovered) {
            let radius = node.half + 4.0;
            let ring = Form::Circle { centre: node.at, radius };
            figure.drawn.push(drawn(ring, Role::Hover, node.node));
        }
        for (n, node) in nodes {
            self.write(&mut figure, *n, node);
        }
        below.into_iter().for_each(|below| below.write(&mut figure));
        figure
    }

    pub(super) fn state(&self, n: usize) -> &State {
        &self.states.of_items[n]
    }

    /// Half the side of a node's form.
    pub(super) fn half(&self, n: usize) -> f64 {
        let (item, state) = (&self.items[n], self.state(n));
        let current = state.above_current == Some(0) && !self.is_folded(n);
        let wanted = match (item.node.is_leaf(), item.is_unfolded) {
            (true, _) if state.visited.is_some() || current => 8.8,
            (true, _) if state.is_met() => 6.5,
            (true, _) => 4.5,
            (false, true) if current => 8.5,
            (false, true) => 6.5,
            (false, false) => 8.5,
        };
        f64::min(wanted, wanted / SPACED * self.spacing)
    }

    pub(super) fn is_folded(&self, n: usize) -> bool {
        !self.items[n].node.is_leaf() && !self.items[n].is_unfolded
    }

    fn draw_levels(&self, figure: &mut Figure) {
        let right = self.page.width;
        let root_level = self.of.tree.domain().root_level();
        let deepest = self.items.iter().map(|item| item.depth).max().unwrap_or(0);
        for depth in 0..=deepest {
            let y = self.placed[0][1] + depth as f64 * self.levels;
            if !(0.0..=self.page.height).contains(&y) {
                continue;
            }
            let line = Form::Polyline(vec![[self.gutter, y], [right, y]]);
            let level = usize::from(root_level).saturating_sub(depth).to_string();
            let text = Form::Text {
                at: [0.5 * self.gutter - 1.0, y],
                anchor: Anchor::Middle,
                text: level.into(),
            };
            for (form, part) in [(line, Part::Edge), (text, Part::Whole)] {
                figure.drawn.push(Drawn { form, role: Role::Level, part, node: None });
            }
        }
    }

    fn draw_node(&self, figure: &mut Figure, n: usize, node: &DiagramNode) {
        let (item, state) = (&self.items[n], self.state(n));
        let [x, y] = node.at;
        let half = node.half;
        let square = |half: f64| {
            let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
            Form::Polygon(corners.map(|[dx, dy]| [x + dx, y + dy]).to_vec())
        };
        let form = |half: f64| match node.kind {
            NodeKind::Leaf => square(half),
            NodeKind::Unfolded => Form::Circle { centre: node.at, radius: half },
            NodeKind::Folded { .. } => {
                Form::Polygon(vec![[x, y - half], [x + half, y + half], [x - half, y + half]])
            }
        };
        let here = state.above_current == Some(0) && !self.is_folded(n);
        let is_found = self.of.moment.found == Some(node.node);
        // The ground, so that no level or branch shows through.
        figure.drawn.push(ground(form(half), node.node));
        let mut push = |form, role| figure.drawn.push(drawn(form, role, node.node));
        let role = self.role(n, here, is_found).unwrap_or(Role::Node);
        match form(half) {
            Form::Polygon(corners) if role == Role::Rejected => {
                arms(&corners).for_each(|arm| push(arm, role));
            }
            form => push(form, role),
        }
        if state.is_met() && !here {
            // No number makes it stand out yet.
            let outline = drawn(form(half), Role::Node, node.node);
            figure.drawn.push(Drawn { part: Part::Edge, ..outline });
        }
        let mut push = |form, role| figure.drawn.push(drawn(form, role, node.node));
        if item.node.is_full() && state.visited.is_none() && !here {
            push(Form::Circle { centre: node.at, radius: 0.5 * half }, Role::Content);
        }
        if let Some([_, number]) = state.visited.filter(|_| !self.is_unfolded(n))
            && item.node.is_leaf()
        {
            let least = radius_around(Role::OrderNumber, &number.to_string());
            // Where there is no room for the number, it is left out.
            let radius =
                if self.has_room(half, least) { least.max(DISC * half) } else { DISC * half };
            push(Form::Circle { centre: node.at, radius }, Role::OrderNumber);
        }
        if state.is_strayed && item.node.is_leaf() {
            let at = [x, y + half + 0.5 * NUMBER];
            let sign = Form::Text { at, anchor: Anchor::Middle, text: "×".into() };
            push(sign, Role::Strayed);
        }
        if state.is_touched {
            push(Form::Circle { centre: node.at, radius: half + 2.5 }, Role::Touch);
        }
    }

    /// Whether a disc of this radius finds room on a leaf and beside the next one.
    fn has_room(&self, half: f64, radius: f64) -> bool {
        const BEYOND: f64 = 2.0;
        radius <= half + BEYOND && 2.0 * radius <= self.spacing
    }

    fn is_unfolded(&self, n: usize) -> bool {
        self.items[n].is_unfolded
    }

    /// What a node means beside that it is one.
    fn role(&self, n: usize, here: bool, is_found: bool) -> Option<Role> {
        let state = self.state(n);
        let missed = matches!(self.of.event, Some(Event::Test { interval: None, .. }));
        let visited = match state.is_strayed {
            true => Role::Strayed,
            false => Role::Visited { share: state.share },
        };
        if here {
            return Some(match (is_found, missed) {
                (true, _) if state.is_strayed => Role::Strayed,
                (true, _) => Role::Found,
                (false, true) => Role::Missed,
                (false, false) => Role::Current,
            });
        }
        if let Some(share) = state.met.filter(|_| state.is_met()) {
            return Some(Role::Visited { share });
        }
        match (state.visited, state.above_current) {
            (Some(_), _) if !self.is_unfolded(n) => Some(visited),
            (_, Some(above)) => Some(Role::Ancestor { above }),
            (Some(_), None) => None,
            (None, None) => (state.is_rejected && !self.is_unfolded(n)).then_some(Role::Rejected),
        }
    }

    /// Whether the number of a child stands above it.
    pub(super) fn has_number(&self, n: usize) -> bool {
        let has_parent = self.items[n].parent.is_some();
        has_parent && self.spacing >= 9.0 && self.levels >= 30.0
    }

    /// How far the line around a node reaches beyond those of others: that of the
    /// current one is thick.
    pub(super) fn line_around(&self, n: usize) -> f64 {
        if self.state(n).above_current == Some(0) { 2.5 } else { 0.0 }
    }

    fn write(&self, figure: &mut Figure, n: usize, node: &DiagramNode) {
        let [x, y] = node.at;
        let state = self.state(n);
        let mut push = |at: [f64; 2], text: String, role: Role| {
            figure.drawn.push(drawn(
                Form::Text { at, anchor: Anchor::Middle, text: text.into() },
                role,
                node.node,
            ));
        };
        if let Some(child) = self.of.tree.child_index(node.node).filter(|_| self.has_number(n)) {
            let role = if state.is_in_question || state.is_lit() {
                Role::ChildIndex
            } else {
                Role::Branch
            };
            let line = self.line_around(n);
            push([x, y - node.half - line - 0.5 * NUMBER], child.0.to_string(), role);
        }
        match (node.kind, state.visited) {
            (NodeKind::Leaf, Some([_, number])) => {
                let text = number.to_string();
                if self.has_room(node.half, radius_around(Role::OrderNumber, &text)) {
                    push(node.at, text, Role::OrderNumber);
                }
            }
            (NodeKind::Folded { .. } | NodeKind::Leaf | NodeKind::Unfolded, _) => {}
        }
    }

    /// The node under the pointer, or the one on the page in which it lies.
    fn hovered<'a>(
        &self,
        nodes: &'a [(usize, DiagramNode)],
        hovered: Option<NodeId>,
    ) -> Option<&'a DiagramNode> {
        let tree = self.of.tree;
        let id = hovered.filter(|id| id.index() < tree.n_nodes())?;
        let own_and_above = std::iter::once(id).chain(tree.ancestors(id));
        let shown = |id: NodeId| nodes.iter().map(|(_, node)| node).find(|node| node.node == id);
        own_and_above.into_iter().find_map(shown)
    }
}

/// Dashes of a small outline, two from each of its corners and one in the middle of each
/// long side: of dashes that began anywhere, too little would be left to tell what it is.
fn arms(corners: &[[f64; 2]]) -> impl Iterator<Item = Form> {
    // Longer sides would fall apart into corners.
    const LONG: f64 = 12.0;
    let n = corners.len();
    (0..n).flat_map(move |at| {
        let (from, to) = (corners[at], corners[(at + 1) % n]);
        let is_long = (to[0] - from[0]).hypot(to[1] - from[1]) > LONG;
        let shares: &[[f64; 2]] = match is_long {
            true => &[[0.0, 0.2], [0.36, 0.64], [1.0, 0.8]],
            false => &[[0.0, 0.34], [1.0, 0.66]],
        };
        let place = move |share: f64| std::array::from_fn(|e| from[e] + share * (to[e] - from[e]));
        shares.iter().map(move |ends| Form::Polyline(ends.map(place).to_vec()))
    })
}

pub(super) fn drawn(form: Form, role: Role, node: NodeId) -> Drawn {
    Drawn { form, role, part: Part::Whole, node: Some(node) }
}

/// Background that hides branches.
pub(super) fn ground(form: Form, node: NodeId) -> Drawn {
    Drawn { form, role: Role::Ground, part: Part::Face(0), node: Some(node) }
}
