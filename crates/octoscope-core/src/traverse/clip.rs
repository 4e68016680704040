//! Where a ray meets the root, and the planes of any cell.

use super::algorithm::Options;
use crate::event::{Event, Observer};
use crate::geometry::{Axes, Parameter, Ray, per_axis};
use crate::tree::{Code, Domain};

/// Interval of a ray inside the root.
#[derive(Clone, Copy, Debug)]
pub struct Clip<const D: usize, P> {
    /// Parameters of the near planes; −∞ along axes without motion.
    pub near: [P; D],
    /// Parameters of the far planes; +∞ along axes without motion.
    pub far: [P; D],
    /// The latest near plane, or the origin if that comes later.
    pub enter: P,
    /// The earliest far plane.
    pub exit: P,
    /// Axes along which the direction is negative: the mirror mask a.
    pub mirror: Axes<D>,
}

/// Cuts the ray with the root; `None` if it is in no point of positive length
/// inside at t ≥ 0 and before its end. The event says what happened in either
/// case.
pub fn clip<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    options: Options,
) -> (Option<Clip<D, P>>, Event<D>) {
    let (near, far) = slabs::<D, P>(domain, ray, domain.root_level(), [0; D]);
    let mirror = Axes::where_true(ray.direction().map(|d| d < 0.0));
    let first_in = latest(near);
    let exit = earliest(far);
    let in_time = |end: f64| first_in.later(P::ORIGIN).before(P::given(end));
    let hit = first_in.before(exit) && P::ORIGIN.before(exit) && options.end().is_none_or(in_time);
    let event = Event::Clip {
        near: near.map(P::value),
        far: far.map(P::value),
        enter: first_in.value(),
        exit: exit.value(),
        hit,
        mirror,
    };
    let enter = first_in.later(P::ORIGIN);
    (hit.then_some(Clip { near, far, enter, exit, mirror }), event)
}

/// The same as a step.
#[inline]
pub fn clip_root<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    options: Options,
    observe: &mut impl Observer<D>,
) -> Option<Clip<D, P>> {
    let (clip, event) = clip(domain, ray, options);
    observe.observe(event);
    clip
}

/// Parameters of the near and the far planes of the cell with this level and
/// code. Without motion along an axis they are −∞ and +∞ if the cell owns the
/// origin there; otherwise both lie on the side of the cell.
#[inline]
pub fn slabs<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    level: u8,
    code: Code<D>,
) -> ([P; D], [P; D]) {
    let (origin, direction) = (ray.origin(), ray.direction());
    let mut near = [P::BEFORE_ALL; D];
    let mut far = [P::BEYOND_ALL; D];
    for e in 0..D {
        let low = domain.plane(e, code[e]);
        let high = domain.plane(e, code[e] + (1 << level));
        let at = |plane| P::at_plane(plane, origin[e], direction[e]);
        if direction[e] > 0.0 {
            (near[e], far[e]) = (at(low), at(high));
        } else if direction[e] < 0.0 {
            (near[e], far[e]) = (at(high), at(low));
        } else if origin[e] < low {
            near[e] = P::BEYOND_ALL;
        } else if origin[e] >= high {
            far[e] = P::BEFORE_ALL;
        }
    }
    (near, far)
}

/// The latest of some parameters.
#[inline]
pub fn latest<const D: usize, P: Parameter>(parameters: [P; D]) -> P {
    P::latest(parameters)
}

/// The earliest of some parameters.
#[inline]
pub fn earliest<const D: usize, P: Parameter>(parameters: [P; D]) -> P {
    P::earliest(parameters)
}

/// The earliest of some parameters, and the axes of all that come with it.
#[inline(always)]
pub fn first<const D: usize, P: Parameter>(parameters: [P; D]) -> (P, Axes<D>) {
    P::first(parameters)
}

/// Grid indices of the mid planes of a node whose children have a side of `half`.
#[inline(always)]
pub fn middle<const D: usize>(code: Code<D>, half: u32) -> [u32; D] {
    per_axis(|e| code[e] + half)
}

/// The step of finding the parameters `mid` of mid planes, each from its
/// coordinate.
#[inline(always)]
pub fn halved<const D: usize, P: Parameter>(ray: &Ray<D>, mid: [P; D]) -> Event<D> {
    let divided = Axes::of(|e| ray.direction()[e] != 0.0);
    Event::Halve { mid: mid.map(P::value), divided }
}

/// Parameters of three planes, one per axis, at grid indices `planes`: what
/// halves a node. Without motion along an axis the side of the origin decides:
/// −∞ if it lies in the upper half, +∞ if in the lower [Revelles 2000, eq. 15].
#[inline]
pub fn at_planes<const D: usize, P: Parameter>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    planes: [u32; D],
) -> [P; D] {
    let (origin, direction) = (ray.origin(), ray.direction());
    per_axis(|e| {
        let plane = domain.plane(e, planes[e]);
        if direction[e] != 0.0 {
            P::at_plane(plane, origin[e], direction[e])
        } else if origin[e] < plane {
            P::BEYOND_ALL
        } else {
            P::BEFORE_ALL
        }
    })
}
