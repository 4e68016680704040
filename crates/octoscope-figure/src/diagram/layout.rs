//! Where the nodes of a diagram stand: every parent above the middle of its
//! children, subtrees as close together as they can be [Reingold, Tilford 1981].

use octoscope_core::tree::{Node, NodeId, Tree};
use std::collections::HashSet;

/// Distance between siblings, in units of the layout.
pub(super) const SPACING: f64 = 22.0;
/// Distance between levels.
pub(super) const LEVEL: f64 = 54.0;
/// Room between children of different parents.
const BETWEEN: f64 = 6.0;

/// A node and its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Item {
    pub node: Node,
    /// Index of the parent among the items, which comes before it.
    pub parent: Option<usize>,
    /// Whether its children are among the items.
    pub is_unfolded: bool,
    /// Number of levels below the root.
    pub depth: usize,
    /// Place across; of the root, 0.
    pub x: f64,
}

/// The items of a tree in which the nodes `unfolded` show their children, parents
/// first, in the order of the children's indices. O(items · levels).
pub(super) fn layout<const D: usize>(tree: &Tree<D>, unfolded: &HashSet<NodeId>) -> Vec<Item> {
    let mut items = Vec::new();
    place(tree, unfolded, (tree.root(), None, 0), &mut items);
    for index in 1..items.len() {
        let parent = items[index].parent.map_or(0.0, |parent| items[parent].x);
        items[index].x += parent;
    }
    items
}

/// Smallest and largest x of a layout, with the room that its nodes take.
pub(super) fn width(items: &[Item]) -> [f64; 2] {
    items.iter().fold([-0.5 * SPACING, 0.5 * SPACING], |[least, most], item| {
        [least.min(item.x - 0.5 * SPACING), most.max(item.x + 0.5 * SPACING)]
    })
}

/// Places a node and what is below it; x is from its parent. Returns how far it
/// reaches to both sides, level by level.
fn place<const D: usize>(
    tree: &Tree<D>,
    unfolded: &HashSet<NodeId>,
    (node, parent, depth): (Node, Option<usize>, usize),
    items: &mut Vec<Item>,
) -> Vec<[f64; 2]> {
    let index = items.len();
    let is_unfolded = !node.is_leaf() && unfolded.contains(&node.id);
    items.push(Item { node, parent, is_unfolded, depth, x: 0.0 });
    let own = [-0.5 * SPACING, 0.5 * SPACING];
    if !is_unfolded {
        return vec![own];
    }
    let mut reach: Vec<[f64; 2]> = Vec::new();
    let mut children = Vec::new();
    for child in tree.children(node) {
        let at = items.len();
        let below = place(tree, unfolded, (child, Some(index), depth + 1), items);
        // As far to the right as the siblings before it reach.
        let gap = |level: usize| if level == 0 { 0.0 } else { BETWEEN };
        let needed = reach.iter().zip(&below).enumerate();
        let x = needed.map(|(level, (left, right))| left[1] - right[0] + gap(level));
        let x = x.fold(if children.is_empty() { 0.0 } else { f64::MIN }, f64::max);
        children.push((at, x));
        for (level, side) in below.iter().enumerate() {
            let shifted = side.map(|end| end + x);
            match reach.get_mut(level) {
                Some(reach) => *reach = [reach[0].min(shifted[0]), reach[1].max(shifted[1])],
                None => reach.push(shifted),
            }
        }
    }
    let ends = [children.first(), children.last()].map(|end| end.map_or(0.0, |(_, x)| *x));
    let middle = 0.5 * (ends[0] + ends[1]);
    children.iter().for_each(|&(at, x)| items[at].x = x - middle);
    let below = reach.into_iter().map(|side| side.map(|end| end - middle));
    [own].into_iter().chain(below).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::progress::Progress;
    use octoscope_core::random::Random;
    use octoscope_core::tree::{Domain, Split, grow};

    fn random_tree<const D: usize>(random: &mut Random) -> Tree<D> {
        grow(Domain::unit(5), (), &Progress::default(), |cell, ()| {
            if cell.level == 0 || cell.level < 5 && random.below(3) > 0 {
                return Split::Empty;
            }
            Split::Inner(vec![(); 1 << D])
        })
        .unwrap()
    }

    fn laws<const D: usize>() {
        let mut random = Random::new(3);
        for _ in 0..30 {
            let tree = random_tree::<D>(&mut random);
            let chosen = tree.nodes().filter(|_| random.below(4) > 0).map(|node| node.id);
            let unfolded: HashSet<NodeId> = chosen.chain([NodeId::ROOT]).collect();
            let items = layout(&tree, &unfolded);
            for (n, item) in items.iter().enumerate() {
                let children: Vec<&Item> =
                    items.iter().filter(|child| child.parent == Some(n)).collect();
                assert_eq!(children.len(), if item.is_unfolded { 1 << D } else { 0 });
                if let [first, .., last] = children[..] {
                    assert!((first.x + last.x - 2.0 * item.x).abs() < 1e-6);
                    let ids: Vec<_> = children.iter().map(|child| child.node.id).collect();
                    assert_eq!(ids, tree.children(item.node).map(|c| c.id).collect::<Vec<_>>());
                }
            }
            for depth in 0..6 {
                let level: Vec<&Item> = items.iter().filter(|item| item.depth == depth).collect();
                for pair in level.windows(2) {
                    let cousins = pair[0].parent != pair[1].parent;
                    let least = SPACING + if cousins { BETWEEN } else { 0.0 };
                    assert!(pair[1].x - pair[0].x > least - 1e-6, "{pair:?}");
                }
            }
        }
    }

    #[test]
    fn parents_stand_in_the_middle_and_nodes_apart() {
        laws::<2>();
        laws::<3>();
    }

    #[test]
    fn what_is_folded_takes_the_room_of_one_node() {
        let tree = random_tree::<2>(&mut Random::new(1));
        let items = layout(&tree, &HashSet::new());
        assert_eq!((items.len(), width(&items)), (1, [-11.0, 11.0]));
    }
}
