//! Comparisons that doubles leave open, made exactly.

use super::super::clip::{at_planes, earliest, latest, slabs};
use crate::geometry::{Axes, Exact, Parameter, Ray, per_axis};
use crate::tree::{Code, Domain};

/// The node in which a lane is: its level and its code in the mirrored numbering.
#[derive(Clone, Copy, Debug)]
pub struct Place<const D: usize> {
    pub level: u8,
    pub mirrored: Code<D>,
    pub is_leaf: bool,
}

/// The planes that are passed next: of a leaf those through which the ray leaves it,
/// of an inner node the mid planes that are not after the entry.
#[cold]
#[inline(never)]
pub fn settle<const D: usize>(domain: &Domain<D>, ray: &Ray<D>, place: Place<D>) -> Axes<D> {
    let Place { level, mirrored, is_leaf } = place;
    let side = 1 << level;
    let code: Code<D> = per_axis(|e| {
        let is_mirrored = ray.direction()[e] < 0.0;
        if is_mirrored { domain.grid_size() - side - mirrored[e] } else { mirrored[e] }
    });
    let (near, far) = slabs::<D, Exact>(domain, ray, level, code);
    if is_leaf {
        let exit = earliest(far);
        return Axes::of(|e| far[e].not_after(exit));
    }
    let entry = latest(near).later(Exact::ORIGIN);
    let mid = at_planes::<D, Exact>(domain, ray, per_axis(|e| code[e] + side / 2));
    Axes::of(|e| mid[e].not_after(entry))
}
