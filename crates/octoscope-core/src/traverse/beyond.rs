//! From a leaf to the cell just beyond it: what all bottom-up walks share.
//!
//! A coordinate on a plane belongs to the cell into which the ray moves. All
//! planes that are met at once are crossed at once. The codes along the other
//! axes are found by comparing parameters, not by rounding a point, and stay
//! within the cell that is left: rounding cannot throw the ray into a wrong cell.

use super::clip::{at_planes, first};
use crate::event::{Event, Observer};
use crate::geometry::{Axes, Parameter, Ray, per_axis};
use crate::tree::{Code, Domain, last_where};

/// Where the ray leaves a leaf.
#[derive(Clone, Copy, Debug)]
pub struct Exit<const D: usize, P> {
    /// Grid indices of the far planes.
    pub planes: [u32; D],
    /// Their parameters; +∞ along axes without motion.
    pub exits: [P; D],
    /// The earliest of them.
    pub at: P,
    /// The planes that are met then.
    pub axes: Axes<D>,
}

/// Where the ray leaves the cell with this level and code.
#[inline]
pub fn exit_of<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    level: u8,
    code: Code<D>,
) -> Exit<D, P> {
    let planes = per_axis(|e| {
        let moves_down = ray.direction()[e] < 0.0;
        if moves_down { code[e] } else { code[e] + (1 << level) }
    });
    let exits = at_planes::<D, P>(domain, ray, planes);
    let (at, axes) = first(exits);
    Exit { planes, exits, at, axes }
}

impl<const D: usize, P: Parameter> Exit<D, P> {
    /// The step of finding the exit.
    pub fn event(&self, domain: &Domain<D>) -> Event<D> {
        Event::Exits {
            planes: std::array::from_fn(|e| domain.plane(e, self.planes[e])),
            exits: self.exits.map(P::value),
            axes: self.axes,
        }
    }
}

/// Codes of the place just beyond the cell with this level and code, which the
/// ray leaves by `exit`; −1 or 2^R outside the domain.
pub fn target_of<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    level: u8,
    code: Code<D>,
    exit: &Exit<D, P>,
) -> [i64; D] {
    per_axis(|e| {
        let [first, last] = [code[e], code[e] + ((1 << level) - 1)];
        match (exit.axes.contains(e), ray.direction()[e] > 0.0) {
            (true, true) => i64::from(last) + 1,
            (true, false) => i64::from(first) - 1,
            (false, _) => i64::from(code_at(domain, ray, e, exit.at, [first, last])),
        }
    })
}

/// The same as a step, with the test whether the place is in the domain; `None`
/// if it is not.
pub fn beyond<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    level: u8,
    code: Code<D>,
    exit: &Exit<D, P>,
    observe: &mut impl Observer<D>,
) -> Option<Code<D>> {
    // New codes: beyond the planes that are crossed, within the cell elsewhere.
    let target = target_of(domain, ray, level, code, exit);
    observe.observe(Event::Target { level, from: code, to: target, axes: exit.axes });

    // Border: any code outside ends the walk.
    let outside = Axes::<D>::of(|e| target[e] < 0 || target[e] >= i64::from(domain.grid_size()));
    observe.observe(Event::Border { outside });
    outside.is_empty().then(|| per_axis(|e| target[e] as u32))
}

/// Code of the smallest cell in which the ray is just after parameter `t`.
pub fn code_of_entry<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    t: P,
) -> Code<D> {
    let grid = [0, domain.grid_size() - 1];
    per_axis(|e| code_at(domain, ray, e, t, grid))
}

/// Index on `axis` of the smallest cell, between `first` and `last`, in which
/// the ray is just after parameter `t`. The rounded point is but a first guess;
/// the parameters of the grid planes decide.
fn code_at<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    axis: usize,
    t: P,
    [first, last]: [u32; 2],
) -> u32 {
    let (origin, direction) = (ray.origin()[axis], ray.direction()[axis]);
    let passed = |plane| P::at_plane(domain.plane(axis, plane), origin, direction).not_after(t);
    let guess = domain.nearest_index(axis, ray.at(t.value())[axis]);
    if direction > 0.0 {
        last_where([first, last], guess, passed)
    } else if direction < 0.0 {
        // The same, counted from above: the upper plane of the cell is passed.
        last - last_where([0, last - first], last.saturating_sub(guess), |n| passed(last - n + 1))
    } else {
        last_where([first, last], guess, |plane| domain.plane(axis, plane) <= origin)
    }
}
