//! Quadtrees and octrees, generic over the dimension D (2 or 3).

mod build;
mod child;
mod code;
mod domain;
mod grow;
mod keys;
mod layout;
mod memory;
mod net;
mod occupied;
mod overlap;
mod part;
mod picture;
mod recipe;
mod sort;

pub use build::{BuildError, build, build_on};
pub use child::Child;
pub use code::{Code, branch, common_level, joined, morton};
pub use domain::{Domain, DomainError, last_where};
pub use grow::{Cell, Split, grow};
pub use keys::{Outside, outside};
pub(crate) use layout::Row;
pub use layout::{Node, NodeId, Siblings, Tree};
pub use memory::Array;
pub use part::Part;
pub use recipe::{Fill, MAX_NODES, Merge, Recipe};

/// Highest root level: codes of 20 bits are exact in `f32` as well.
pub const MAX_ROOT_LEVEL: u8 = 20;
