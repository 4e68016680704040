//! Queries without a ray: where is a point, a region, a neighbour?

mod ancestor;
mod by_tables;
mod misprint;
mod neighbour;
mod point;
mod region;

pub use ancestor::climb;
pub(crate) use by_tables::ascend_and_mirror;
pub use by_tables::{adjacent, common_part, neighbour_by_tables, reflected};
pub use neighbour::{
    Direction, DirectionError, NeighbourMethod, Reach, neighbour, neighbour_as_printed,
};
pub(crate) use point::descend;
pub use point::{locate_by_codes, locate_by_codes_as_printed, locate_by_comparison};
pub use region::{locate_region, locate_region_as_printed};
