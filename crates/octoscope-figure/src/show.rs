//! What a picture of space shows beside the algorithm's state.

use crate::Slice;
use octoscope_core::tree::{Node, NodeId, Tree};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

/// What is to be seen beside the algorithm's state.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Show {
    /// Numbers of the visited leaves.
    pub order_numbers: bool,
    /// The sides that the current node owns, and those it does not.
    pub half_open_sides: bool,
    /// Codes, written into the current node and the visited leaves.
    pub codes: bool,
    /// The ray and the path in the mirrored tree, and both numbers of children.
    pub mirrored_ray: bool,
    /// Points and primitives.
    pub content: bool,
    /// Leaves without contents.
    pub empty_leaves: bool,
    /// Nodes above the current one.
    pub ancestors: bool,
    /// Children of the current node, taken and not, with their indices.
    pub children: bool,
    /// Inner nodes off the path, not leaves alone.
    pub inner_nodes: bool,
    /// Levels of the nodes off the path.
    pub levels: Levels,
    /// How the nodes off the path are drawn.
    pub rest: Rest,
    /// Plane before which nothing off the path is drawn; in space only.
    pub slice: Option<Slice>,
    /// How far the children of the current node are moved apart, in their own
    /// sides; 0 leaves them where they are.
    #[serde(deserialize_with = "apart")]
    pub explosion: f64,
}

/// Sides by which children are moved apart.
fn apart<'de, S: Deserializer<'de>>(from: S) -> Result<f64, S::Error> {
    let sides = f64::deserialize(from)?;
    if (0.0..=Show::MOST_APART).contains(&sides) {
        Ok(sides)
    } else {
        Err(S::Error::custom(format!("children cannot be {sides} sides apart")))
    }
}

/// Levels from the least to the most, both included; 0 is that of the smallest cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Levels {
    /// Level of the smallest nodes.
    pub least: u8,
    /// Level of the largest nodes.
    pub most: u8,
}

/// How nodes off the path are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Rest {
    /// As they are.
    #[default]
    Plain,
    /// As faint lines.
    Faint,
    /// Not at all.
    Hidden,
}

impl Levels {
    /// Every level.
    pub const ALL: Self = Self { least: 0, most: u8::MAX };

    /// Whether a level is among these.
    pub fn contains(self, level: u8) -> bool {
        (self.least..=self.most).contains(&level)
    }

    /// The levels of a tree that are among these; where none is, that of its root.
    pub fn up_to(self, root_level: u8) -> Self {
        Self { least: self.least.min(root_level), most: self.most.min(root_level) }
    }
}

impl Default for Levels {
    fn default() -> Self {
        Self::ALL
    }
}

impl Rest {
    /// All ways, the strongest first.
    pub const ALL: [Self; 3] = [Self::Plain, Self::Faint, Self::Hidden];

    /// Name in files and arguments.
    pub fn id(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Faint => "faint",
            Self::Hidden => "hidden",
        }
    }
}

impl Show {
    /// Moved apart, the children are so far from each other.
    pub const APART: f64 = 0.7;
    /// The farthest.
    pub const MOST_APART: f64 = 2.0;

    /// What is seen at first: in space only a hint of the leaves off the path.
    pub fn at_first<const D: usize>() -> Self {
        Self { empty_leaves: D == 2, ..Self::default() }
    }

    /// The same of the whole tree: nothing is cut off, left out by its level or moved apart.
    #[must_use]
    pub fn whole(self) -> Self {
        Self { levels: Levels::ALL, slice: None, explosion: 0.0, ..self }
    }

    /// The nodes off the path that are shown, the root not among them unless it is
    /// a leaf. O(nodes).
    pub fn nodes<'a, const D: usize>(
        &'a self,
        tree: &'a Tree<D>,
    ) -> impl Iterator<Item = Node> + 'a {
        let nodes = tree.nodes().take(if self.rest == Rest::Hidden { 0 } else { usize::MAX });
        nodes.filter(|&node| self.shows(tree, node))
    }

    /// Whether a node is shown where it is not on the path.
    pub fn shows<const D: usize>(&self, tree: &Tree<D>, node: Node) -> bool {
        let is_of_kind = match node.is_leaf() {
            true => node.is_full() || self.empty_leaves,
            false => self.inner_nodes && node.id != NodeId::ROOT,
        };
        // Few ask for levels, and to look one up takes as long as all the rest.
        let is_of_level =
            || self.levels == Levels::ALL || self.levels.contains(tree.level(node.id));
        self.rest != Rest::Hidden && is_of_kind && is_of_level()
    }
}

impl Default for Show {
    fn default() -> Self {
        Self {
            order_numbers: true,
            half_open_sides: false,
            codes: false,
            mirrored_ray: false,
            content: true,
            empty_leaves: true,
            ancestors: true,
            children: true,
            inner_nodes: false,
            levels: Levels::ALL,
            rest: Rest::default(),
            slice: None,
            explosion: 0.0,
        }
    }
}
