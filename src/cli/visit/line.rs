//! The line of a ray.

use super::{Asked, Touches};
use octoscope_core::event::{Event, Observer};
use octoscope_core::geometry::Ray;
use octoscope_core::traverse::Method;
use octoscope_core::tree::{NodeId, Tree};
use std::fmt::Write;

/// A leaf that a ray meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Met {
    /// An empty leaf is visited.
    Empty(NodeId),
    /// An occupied leaf is visited.
    Full(NodeId),
    /// A leaf is met in one point.
    Touch(NodeId),
}

/// Leaves along `ray` in order; touches only where asked for.
pub fn met<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, method: Method, asked: Asked) -> Vec<Met> {
    let mut list = List { met: Vec::new(), touches: asked.touches };
    asked.along(method).run(tree, ray, &mut list);
    list.met
}

/// The visited leaves of a list.
pub fn visited(met: &[Met]) -> Vec<NodeId> {
    met.iter()
        .filter_map(|met| match *met {
            Met::Empty(node) | Met::Full(node) => Some(node),
            Met::Touch(_) => None,
        })
        .collect()
}

/// Appends the line of a ray with its end: the number of visited leaves, then a token
/// for each leaf.
pub fn push_line<const D: usize>(text: &mut String, tree: &Tree<D>, met: &[Met]) {
    let n_visited = met.iter().filter(|met| !matches!(met, Met::Touch(_))).count();
    write!(text, "{n_visited}").expect("a string takes everything");
    for met in met {
        text.push(' ');
        push_token(text, tree, *met);
    }
    text.push('\n');
}

/// Token of a leaf: `level:x,y,z`, `*` behind it if it is full, `~` before it
/// if it is touched.
pub fn push_token<const D: usize>(text: &mut String, tree: &Tree<D>, met: Met) {
    let (before, node, behind) = match met {
        Met::Empty(node) => ("", node, ""),
        Met::Full(node) => ("", node, "*"),
        Met::Touch(node) => ("~", node, ""),
    };
    text.push_str(before);
    let mut separator = ':';
    let infallible = "a string takes everything";
    write!(text, "{}", tree.level(node)).expect(infallible);
    for code in tree.code(node) {
        write!(text, "{separator}{code}").expect(infallible);
        separator = ',';
    }
    text.push_str(behind);
}

struct List {
    met: Vec<Met>,
    touches: Touches,
}

impl<const D: usize> Observer<D> for List {
    fn observe(&mut self, event: Event<D>) {
        if let Event::Leaf { node, full, .. } = event {
            self.met.push(if full { Met::Full(node) } else { Met::Empty(node) });
        } else if let Event::Touch { node, .. } = event
            && self.touches == Touches::Listed
        {
            self.met.push(Met::Touch(node));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::progress::Progress;
    use octoscope_core::tree::{Domain, Split, grow};

    /// Two levels; the cell in the corner is full.
    fn tree() -> Tree<2> {
        grow(Domain::unit(2), (), &Progress::default(), |cell, ()| match cell.level {
            2 => Split::Inner(vec![(); 4]),
            _ if cell.code == [0, 0] => Split::Full(vec![]),
            _ => Split::Empty,
        })
        .unwrap()
    }

    #[test]
    fn a_line_counts_visited_leaves_and_marks_full_ones_and_touches() {
        let met = [Met::Full(NodeId(1)), Met::Touch(NodeId(2)), Met::Empty(NodeId(4))];
        let mut lines = String::new();
        push_line(&mut lines, &tree(), &met);
        push_line(&mut lines, &tree(), &[]);
        assert_eq!(lines, "2 1:0,0* ~1:0,2 1:2,2\n0\n");
    }
}
