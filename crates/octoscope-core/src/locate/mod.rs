//! Queries without a ray: where is a point, a region, a neighbour?

mod ancestor;
mod neighbour;
mod point;
mod region;

pub use ancestor::climb;
pub use neighbour::{Direction, DirectionError, Reach, neighbour};
pub use point::{locate_by_codes, locate_by_comparison};
pub use region::locate_region;
