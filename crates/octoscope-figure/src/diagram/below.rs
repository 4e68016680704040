//! What is written below folded nodes: how many leaves lie in them.

use super::draw::{Drawing, drawn, ground};
use crate::figure::text_reach;
use crate::{Anchor, Figure, Form, Role};
use octoscope_core::tree::NodeId;
use std::collections::HashSet;

/// Distance of levels below which there is no room for a line below a node.
const ROOM_BELOW: f64 = 42.0;
/// How much lower every other line stands where they have no room beside each other.
const LINE: f64 = 10.0;

/// A line below a folded node.
pub(super) struct Below {
    pub text: String,
    pub role: Role,
    pub node: NodeId,
    /// Number of levels below the root.
    pub depth: usize,
    /// Its middle.
    pub at: [f64; 2],
    /// Another one, beside the node.
    beside: [f64; 2],
    /// Half its width and height.
    pub reach: [f64; 2],
}

impl Below {
    /// Least and largest corner of what it covers.
    pub fn area(&self) -> [[f64; 2]; 2] {
        let ([x, y], [wide, high]) = (self.at, self.reach);
        [[x - wide, y - high + 1.0], [x + wide, y + high - 1.0]]
    }

    /// Writes it on ground of its own.
    pub fn write(self, figure: &mut Figure) {
        let [[left, above], [right, below]] = self.area();
        let behind = vec![[left, above], [right, above], [right, below], [left, below]];
        figure.drawn.push(ground(Form::Polygon(behind), self.node));
        let Self { text, role, node, at, .. } = self;
        let form = Form::Text { at, anchor: Anchor::Middle, text: text.into() };
        figure.drawn.push(drawn(form, role, node));
    }
}

impl<const D: usize> Drawing<'_, D> {
    /// What is written below a node, if it is folded; every other one lower, where they
    /// have no room beside each other.
    pub(super) fn below(&self, n: usize) -> Option<Below> {
        if self.levels < ROOM_BELOW || !self.is_folded(n) {
            return None;
        }
        let (place, node) = (self.placed[n], self.items[n].node.id);
        let (text, role) = self.text_below(n);
        let [wide, high] = text_reach(role, &text);
        let is_in_the_way = |&other: &usize| {
            let apart = (self.placed[other][0] - place[0]).abs();
            let same = self.items[other].depth == self.items[n].depth;
            if other == n || !same || !self.is_folded(other) || apart > 2.0 * self.spacing {
                return false;
            }
            let (text, role) = self.text_below(other);
            apart < wide + text_reach(role, &text)[0] + 3.0
        };
        let is_tight = (0..self.items.len()).any(|other| is_in_the_way(&other));
        let is_odd = self.of.tree.child_index(node).is_some_and(|child| child.0 % 2 == 1);
        let lower = if is_tight && is_odd { LINE } else { 0.0 };
        let half = self.half(n);
        let at = [place[0], place[1] + half + high + 1.5 + lower];
        let beside = [place[0] + half + wide + 1.5, place[1] + half - high + 1.0];
        let depth = self.items[n].depth;
        Some(Below { text, role, node, depth, at, beside, reach: [wide, high] })
    }

    /// Writes what branches run over beside its node, where there is room for it, or leaves it
    /// out: numbers of visited leaves one by one, numbers of leaves for all nodes of a level,
    /// as gaps among them would be taken for nothing there.
    pub(super) fn retain_legible(&self, below: &mut Vec<Below>, fans: &[Option<f64>]) {
        for text in below.iter_mut().filter(|text| self.is_crossed(text, fans)) {
            let at = std::mem::replace(&mut text.at, text.beside);
            if self.is_crossed(text, fans) || !self.has_room_for(text) {
                text.at = at;
            }
        }
        let counts = below.iter().filter(|text| text.role == Role::Branch);
        let gaps: HashSet<usize> =
            counts.filter(|text| self.is_crossed(text, fans)).map(|text| text.depth).collect();
        below.retain(|text| {
            if text.role == Role::Branch {
                !gaps.contains(&text.depth)
            } else {
                !self.is_crossed(text, fans)
            }
        });
    }

    /// Whether a line lies on the page, and on none of the nodes of its level.
    fn has_room_for(&self, text: &Below) -> bool {
        let [min, max] = text.area();
        let of_level = |n: &usize| self.items[*n].depth == text.depth;
        let is_covered = |n: usize| {
            let reach = self.half(n) + 1.0;
            (0..2).all(|e| min[e] - reach < self.placed[n][e] && self.placed[n][e] < max[e] + reach)
        };
        max[0] <= self.page.width && !(0..self.items.len()).filter(of_level).any(is_covered)
    }

    /// The numbers of the visited leaves in a folded node, or how many leaves it has.
    fn text_below(&self, n: usize) -> (String, Role) {
        match self.state(n).visited {
            Some([first, last]) => {
                let wrong = if self.state(n).is_strayed { " ×" } else { "" };
                let last = if first == last { String::new() } else { format!("–{last}") };
                (format!("{first}{last}{wrong}"), Role::OrderNumber)
            }
            None => (short(self.of.tree.n_leaves_in(self.items[n].node.id)), Role::Branch),
        }
    }
}

/// A number of leaves in four characters: 64, 4096, 65k, 1.2M.
fn short(n: usize) -> String {
    match n {
        0..10_000 => n.to_string(),
        10_000..1_000_000 => format!("{}k", n / 1000),
        1_000_000..10_000_000 => format!("{:.1}M", (n / 100_000) as f64 / 10.0),
        _ => format!("{}M", n / 1_000_000),
    }
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn numbers_of_leaves_are_short() {
        let numbers = [1, 9_999, 10_000, 262_144, 1_048_576, 16_777_216];
        assert_eq!(numbers.map(short), ["1", "9999", "10k", "262k", "1.0M", "16M"]);
    }
}
