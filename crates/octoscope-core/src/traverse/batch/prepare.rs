//! What a ray is turned into before it gets a lane.

use super::super::algorithm::Options;
use super::super::clip::clip;
use crate::geometry::{Exact, Ray};
use crate::tree::Domain;

/// A ray as a lane needs it, mirrored so that it goes up along every axis: plane k of
/// the mirrored grid has the parameter `k · slope + start`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prepared<const D: usize> {
    /// Change of the parameter from plane to plane, positive.
    pub slope: [f64; D],
    /// Parameter of plane 0.
    pub start: [f64; D],
    /// The order of two parameters is certain if they differ by more.
    pub error: f64,
    /// When the root is entered.
    pub entry: f64,
    /// The mirror mask a.
    pub mirror: u64,
}

/// How a ray gets through the root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start<const D: usize> {
    /// Not at all.
    Misses,
    /// In a lane.
    Lane(Prepared<D>),
    /// With parameters that are no good as doubles.
    Single,
}

/// Stands for the slope along axes without motion: beyond all true parameters in a
/// lane, and the rounding of neither can overflow.
const WITHOUT_MOTION: f64 = 1e200;
/// Largest parameter and smallest slope in a lane.
const LARGEST: f64 = 1e150;
const SMALLEST: f64 = 1e-250;

/// Prepares a ray.
///
/// The error: slope and start are rounded two and three times, product and sum once
/// more, by half an ε each; and the planes of a cell are themselves rounded sums.
/// All of that is below 2 ε (G · slope + |start|) + ε · |pace| · (size of the
/// coordinates), for each of two parameters; twice as much is taken.
#[inline(always)]
pub fn prepare<const D: usize>(domain: &Domain<D>, ray: &Ray<D>) -> Start<D> {
    let (origin, direction) = (ray.origin(), ray.direction());
    let grid_size = f64::from(domain.grid_size());
    let mut lane = Prepared { slope: [0.0; D], start: [0.0; D], error: 0.0, entry: 0.0, mirror: 0 };
    let mut exit = f64::INFINITY;
    for e in 0..D {
        let [low, high] = [domain.plane(e, 0), domain.plane(e, domain.grid_size())];
        if direction[e] == 0.0 {
            // Without motion every plane is long past or far ahead: as if the origin
            // were in the middle of its smallest cell.
            let Some(cell) = domain.encode(e, origin[e]) else { return Start::Misses };
            lane.slope[e] = WITHOUT_MOTION;
            lane.start[e] = -(f64::from(cell) + 0.5) * WITHOUT_MOTION;
            continue;
        }
        let pace = direction[e].recip();
        let is_mirrored = direction[e] < 0.0;
        let near = if is_mirrored { high } else { low };
        let slope = domain.cell_side(0) * pace.abs();
        let start = (near - origin[e]) * pace;
        let range = slope * grid_size + start.abs();
        if !(slope > SMALLEST && range < LARGEST) {
            return Start::Single;
        }
        let coordinates = low.abs().max(high.abs()) + domain.side();
        let error = 8.0 * f64::EPSILON * (range + coordinates * pace.abs());
        lane.slope[e] = slope;
        lane.start[e] = start;
        lane.mirror |= u64::from(is_mirrored) << (D - 1 - e);
        lane.error = lane.error.max(error);
        lane.entry = lane.entry.max(start);
        exit = exit.min(grid_size * slope + start);
    }

    // Hit: certainly, certainly not, or as exact comparisons say.
    let inside = exit - lane.entry;
    if inside > lane.error {
        Start::Lane(lane)
    } else if inside < -lane.error || !is_hit(domain, ray) {
        Start::Misses
    } else {
        Start::Lane(lane)
    }
}

#[cold]
fn is_hit<const D: usize>(domain: &Domain<D>, ray: &Ray<D>) -> bool {
    clip::<D, Exact>(domain, ray, Options::default()).0.is_some()
}
