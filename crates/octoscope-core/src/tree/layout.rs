//! The tree in memory.
//!
//! Only inner nodes take room: a [`Row`] each, with one bit per child that
//! tells whether it is inner and one that tells whether it is full. The inner
//! children of a node have consecutive rows, so that a child's row is the base
//! plus the number of inner children before it. What only a debugger asks for
//! (parents, levels, codes, contents) lies in side arrays.

use super::net::Net;
use super::{Child, Code, Domain};
use crate::geometry::{Aabb, either};

/// Number of a node: 0 is the root, 1 + 2^D·row + i is child i of the inner
/// node in `row`. The children of a node have consecutive numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NodeId(
    /// The number.
    pub u32,
);

impl NodeId {
    /// The root of every tree.
    pub const ROOT: Self = Self(0);

    /// As an index into arrays with one entry a node.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A node as a walk meets it: its number and what its parent's row says of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Node {
    /// Number of the node.
    pub id: NodeId,
    /// Row of an inner node, or one of the two marks below.
    row: u32,
}

const EMPTY_LEAF: u32 = u32::MAX;
const FULL_LEAF: u32 = EMPTY_LEAF - 1;

impl Node {
    /// Whether the node has no children.
    #[inline]
    pub fn is_leaf(self) -> bool {
        self.row >= FULL_LEAF
    }

    /// Whether the node is a leaf with something in it.
    #[inline]
    pub fn is_full(self) -> bool {
        self.row == FULL_LEAF
    }
}

/// What is walked of an inner node, in one word: the row of its first inner child in
/// the lowest 32 bits, above them the marks `inner` and `full`, one bit a child each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Row(pub u64);

impl Row {
    /// Where the marks begin.
    pub const INNER: u32 = 32;
    pub const FULL: u32 = 40;

    pub fn new(base: u32, inner: u8, full: u8) -> Self {
        Self(u64::from(base) | u64::from(inner) << Self::INNER | u64::from(full) << Self::FULL)
    }

    /// Row of the first inner child.
    #[inline]
    pub fn base(self) -> u32 {
        self.0 as u32
    }

    /// Bit i: child i is an inner node.
    #[inline]
    pub fn inner(self) -> u8 {
        (self.0 >> Self::INNER) as u8
    }

    /// Bit i: child i is a leaf with something in it.
    #[inline]
    pub fn full(self) -> u8 {
        (self.0 >> Self::FULL) as u8
    }
}

/// The children of an inner node.
#[derive(Clone, Copy, Debug)]
pub struct Siblings<const D: usize> {
    first_id: NodeId,
    row: Row,
}

impl<const D: usize> Siblings<D> {
    /// One of them.
    #[inline]
    pub fn node(self, child: Child<D>) -> Node {
        let (base, inner, full) = (self.row.base(), self.row.inner(), self.row.full());
        let bit = 1u8 << child.0;
        let row = base + (inner & (bit - 1)).count_ones();
        let leaf = EMPTY_LEAF - u32::from(full & bit != 0);
        let id = NodeId(self.first_id.0 + u32::from(child.0));
        Node { id, row: either(inner & bit != 0, row, leaf) }
    }
}

/// What only the debugger asks of an inner node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place<const D: usize> {
    pub id: NodeId,
    pub level: u8,
    pub code: Code<D>,
}

/// Quadtree (D = 2) or octree (D = 3) over a [`Domain`].
#[derive(Clone, Debug, PartialEq)]
pub struct Tree<const D: usize> {
    pub(super) domain: Domain<D>,
    /// Whether the root, if it is a leaf, is full.
    pub(super) root_full: bool,
    pub(super) rows: Vec<Row>,
    pub(super) places: Vec<Place<D>>,
    /// Of every row how many full leaves come before its children.
    pub(super) first_full: Vec<u32>,
    /// The contents of full leaf n are `items[first_item[n] .. first_item[n + 1]]`.
    pub(super) first_item: Vec<u32>,
    pub(super) items: Vec<u32>,
    pub(super) net: Net<D>,
}

impl<const D: usize> Tree<D> {
    /// Box of the root and its grid.
    #[inline]
    pub fn domain(&self) -> &Domain<D> {
        &self.domain
    }

    /// What is walked of the inner nodes; the root's row is the first.
    #[inline]
    pub(crate) fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// Number of nodes, inner ones and leaves.
    pub fn n_nodes(&self) -> usize {
        1 + self.rows.len() * Child::<D>::COUNT
    }

    /// Number of leaves.
    pub fn n_leaves(&self) -> usize {
        self.n_nodes() - self.rows.len()
    }

    /// The root.
    #[inline]
    pub fn root(&self) -> Node {
        let row = match (self.rows.is_empty(), self.root_full) {
            (false, _) => 0,
            (true, true) => FULL_LEAF,
            (true, false) => EMPTY_LEAF,
        };
        Node { id: NodeId::ROOT, row }
    }

    /// Child of an inner node.
    ///
    /// # Panics
    /// May panic if `node` is a leaf.
    #[inline]
    pub fn child(&self, node: Node, child: Child<D>) -> Node {
        self.siblings(node).node(child)
    }

    /// The children of an inner node, to be asked for one by one.
    ///
    /// # Panics
    /// May panic if `node` is a leaf.
    #[inline]
    pub fn siblings(&self, node: Node) -> Siblings<D> {
        let first_id = NodeId(1 + (node.row << D));
        Siblings { first_id, row: self.rows[node.row as usize] }
    }

    /// The children of a node in the order of their indices; none of a leaf.
    pub fn children(&self, node: Node) -> impl Iterator<Item = Node> + '_ {
        let count = if node.is_leaf() { 0 } else { Child::<D>::COUNT };
        Child::all().take(count).map(move |child| self.child(node, child))
    }

    /// The node with this number.
    ///
    /// # Panics
    /// Panics if the tree has no such node.
    pub fn node(&self, id: NodeId) -> Node {
        match self.place_in_parent(id) {
            None => self.root(),
            Some((row, child)) => {
                self.child(Node { id: self.places[row].id, row: row as u32 }, child)
            }
        }
    }

    /// Parent of a node; `None` for the root.
    #[inline]
    pub fn parent(&self, id: NodeId) -> Option<NodeId> {
        self.place_in_parent(id).map(|(row, _)| self.places[row].id)
    }

    /// Index of a node among its parent's children; `None` for the root.
    #[inline]
    pub fn child_index(&self, id: NodeId) -> Option<Child<D>> {
        self.place_in_parent(id).map(|(_, child)| child)
    }

    /// Level of a node; the root has level R, the smallest possible cell 0.
    #[inline]
    pub fn level(&self, id: NodeId) -> u8 {
        match self.place_in_parent(id) {
            None => self.domain.root_level(),
            Some((row, _)) => self.places[row].level - 1,
        }
    }

    /// Location code of a node: its minimum corner in units of smallest cells.
    #[inline]
    pub fn code(&self, id: NodeId) -> Code<D> {
        let Some((row, child)) = self.place_in_parent(id) else {
            return [0; D];
        };
        let Place { level, code, .. } = self.places[row];
        std::array::from_fn(|e| code[e] | u32::from(child.is_upper(e)) << (level - 1))
    }

    /// Box of a node, in world units.
    pub fn node_box(&self, id: NodeId) -> Aabb<D> {
        self.domain.cell_box(self.level(id), self.code(id))
    }

    /// Numbers of the points, primitives or pixels in a node; only leaves have
    /// any.
    pub fn items(&self, id: NodeId) -> &[u32] {
        if !self.node(id).is_full() {
            return &[];
        }
        let leaf = self.place_in_parent(id).map_or(0, |(row, child)| {
            let before = self.rows[row].full() & ((1 << child.0) - 1);
            self.first_full[row] + before.count_ones()
        });
        let [from, to] = [leaf, leaf + 1].map(|n| self.first_item[n as usize] as usize);
        &self.items[from..to]
    }

    /// All nodes, the root first, every parent before its children.
    pub fn nodes(&self) -> impl Iterator<Item = Node> + '_ {
        (0..self.n_nodes() as u32).map(|n| self.node(NodeId(n)))
    }

    /// All leaves.
    pub fn leaves(&self) -> impl Iterator<Item = Node> + '_ {
        self.nodes().filter(|node| node.is_leaf())
    }

    /// The ancestors of a node, its parent first, the root last.
    pub fn ancestors(&self, id: NodeId) -> impl Iterator<Item = NodeId> + '_ {
        std::iter::successors(self.parent(id), |&id| self.parent(id))
    }

    /// Whether `inner` is `outer` or lies in it.
    pub fn holds(&self, outer: NodeId, inner: NodeId) -> bool {
        let level = self.level(outer);
        let (a, b) = (self.code(outer), self.code(inner));
        self.level(inner) <= level && (0..D).all(|e| a[e] >> level == b[e] >> level)
    }

    /// Node of exactly this level and code, or the leaf above that covers it;
    /// the root for any level above. `None` if the code lies outside the domain.
    pub fn node_at(&self, level: u8, code: Code<D>) -> Option<Node> {
        if code.iter().any(|&c| c >= self.domain.grid_size()) {
            return None;
        }
        let mut node = self.root();
        for parent_level in (level.saturating_add(1)..=self.domain.root_level()).rev() {
            if node.is_leaf() {
                break;
            }
            node = self.child(node, super::branch(code, parent_level));
        }
        Some(node)
    }

    /// Number of leaves in a node, itself if it is one. Rows below a row follow one
    /// another in every level: O(levels · log nodes), however many leaves there are.
    pub fn n_leaves_in(&self, id: NodeId) -> usize {
        let node = self.node(id);
        if node.is_leaf() {
            return 1;
        }
        let parent_row = |place: &Place<D>| place.id.0.checked_sub(1).map(|n| (n >> D) as usize);
        let first_below = |row| self.places.partition_point(|p| parent_row(p) < Some(row));
        let (mut rows, mut n_inner) = (node.row as usize..node.row as usize + 1, 0);
        while !rows.is_empty() {
            n_inner += rows.len();
            rows = first_below(rows.start)..first_below(rows.end);
        }
        1 + n_inner * (Child::<D>::COUNT - 1)
    }

    /// Row of the parent and index below it; `None` for the root.
    #[inline]
    fn place_in_parent(&self, id: NodeId) -> Option<(usize, Child<D>)> {
        let place = id.0.checked_sub(1)?;
        Some(((place >> D) as usize, Child((place & ((1 << D) - 1)) as u8)))
    }
}
