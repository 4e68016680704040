//! Ray traversals: the leaves along a ray, in order.
//!
//! A leaf is *visited* if the ray is in it for a positive length of t ≥ 0;
//! along an axis on which the ray does not move, a cell owns its lower plane
//! and not its upper one. A leaf met in one point is a *touch*.

mod agree;
mod algorithm;
mod all_children;
mod batch;
mod beyond;
mod bsp;
mod clip;
mod codes;
mod dda;
mod esvo;
mod exactly;
mod exhaustive;
mod gargantini;
mod glassner;
mod hero;
mod misprint;
mod misprinted_rules;
mod parametric;
mod parametric_table;
mod report;
mod samet;
mod samet_corner;
mod samet_net;
mod variant;

pub(crate) use agree::is_sliver;
pub use agree::{
    Difference, SLIVER, Slivers, doubles_suffice, first_difference, first_difference_of_run,
};
pub use algorithm::{Algorithm, Method, MethodError, Options, StopAt, UnknownAlgorithm};
pub use batch::{Kernel, Leaf, visit_many};
pub(crate) use beyond::{Exit, code_of_entry, target_of};
pub(crate) use bsp::halves;
pub use clip::{Clip, clip, slabs};
pub(crate) use hero::sorted;
pub(crate) use misprint::{Base, traverse as traverse_mirrored};
pub use misprinted_rules::mirrored_origin;
pub(crate) use misprinted_rules::selection;
pub use parametric_table::{TABLE_2, TABLE_3, TABLE_IN_PLANE, entry_axes, transition};
pub use variant::{UnknownVariant, Variant, Variants};
