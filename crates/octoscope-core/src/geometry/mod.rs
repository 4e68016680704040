//! Points, boxes, rays and exact comparisons. Knows no tree.

mod aabb;
mod axes;
mod exact;
mod guarded;
mod parameter;
mod per_axis;
mod ray;
mod scaled;
mod short;

pub use aabb::Aabb;
pub use axes::{AXIS_NAMES, Axes};
pub use exact::Exact;
pub use guarded::{Guarded, doubt, trust};
pub use parameter::Parameter;
pub(crate) use per_axis::{either, per_axis};
pub use ray::{Ray, RayError};
pub(crate) use scaled::Scaled;
use short::Short;
