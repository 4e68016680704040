//! Single rules of the parametric traversals, right or as misprinted.

use super::clip::{earliest, latest};
use super::variant::{Variant, Variants};
use crate::geometry::{Axes, Ray};
use crate::tree::{Child, Domain};

/// Which rules are misprinted.
#[derive(Clone, Copy, Debug)]
pub struct Rules(pub Variants);

/// Which of a node's planes is met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plane {
    /// The one that a cell owns.
    Near,
    /// One inside the node.
    Mid,
    /// The one that the next cell owns.
    Far,
}

impl Rules {
    /// Whether the rule is misprinted, or in another form.
    pub fn has(self, variant: Variant) -> bool {
        self.0.has(variant)
    }

    /// Parameter of a plane, for a direction that is not negative: eq. 5, and
    /// without motion eq. 14.
    pub fn parameter(self, at: f64, origin: f64, direction: f64, plane: Plane) -> f64 {
        let distance = at - origin;
        if direction != 0.0 {
            return distance / direction;
        }
        if distance == 0.0 && self.has(Variant::B5) {
            return f64::NAN;
        }
        let owned = distance == 0.0 && self.has(Variant::B11) && plane == Plane::Far;
        if distance > 0.0 || owned { f64::INFINITY } else { f64::NEG_INFINITY }
    }

    /// Parameter of a mid plane: from its coordinate, as the mean of those of
    /// the node's planes (eq. 13), or without motion by eq. 15.
    pub fn mid(self, at: f64, origin: f64, direction: f64, [near, far]: [f64; 2]) -> f64 {
        let moves = direction != 0.0;
        if moves && self.has(Variant::B4) {
            // The index is missing in print: read as that of the near plane.
            0.5 * (near + near)
        } else if (moves && self.has(Variant::Averaged)) || (!moves && self.has(Variant::B6)) {
            0.5 * (near + far)
        } else {
            self.parameter(at, origin, direction, Plane::Mid)
        }
    }

    /// Axes along which the parameter of a mid plane takes a division.
    pub fn divided<const D: usize>(self, direction: [f64; D]) -> Axes<D> {
        let averaged = self.has(Variant::B4) || self.has(Variant::Averaged);
        Axes::where_true(direction.map(|d| d != 0.0 && !averaged))
    }

    /// Parameters of entry and exit of a node: eq. 12.
    pub fn interval<const D: usize>(self, near: [f64; D], far: [f64; D]) -> [f64; 2] {
        if self.has(Variant::B1) {
            [earliest(near), latest(far)]
        } else {
            [latest(near), earliest(far)]
        }
    }

    /// The same for a leaf that is reported: finite, and not before t = 0
    /// unless that is never asked.
    pub fn interval_of_leaf<const D: usize>(self, near: [f64; D], far: [f64; D]) -> [f64; 2] {
        let [enter, exit] = self.interval(near, far);
        let enter = if enter.is_finite() { enter } else { latest(near) };
        let exit = if exit.is_finite() { exit } else { earliest(far) };
        [if self.has(Variant::B10) { enter } else { enter.max(0.0) }, exit]
    }

    /// Whether the root is hit: eq. 11.
    pub fn is_crossed(self, enter: f64, exit: f64) -> bool {
        let closed = self.has(Variant::B11);
        let precedes = |a: f64, b: f64| if closed { a <= b } else { a < b };
        precedes(enter, exit) && (self.has(Variant::B10) || precedes(0.0, exit))
    }
}

/// Origin of the ray mirrored so that no component of its direction is negative:
/// eq. 16, p' = x_0 + x_1 − p.
pub fn mirrored_origin<const D: usize>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    variants: Variants,
) -> [f64; D] {
    let (origin, direction) = (ray.origin(), ray.direction());
    std::array::from_fn(|e| {
        let [low, high] = [0, domain.grid_size()].map(|index| domain.plane(e, index));
        if direction[e] >= 0.0 {
            origin[e]
        } else if variants.has(Variant::B7) {
            domain.side() - origin[e]
        } else {
            low + high - origin[e]
        }
    })
}

/// State of the first child from the upper halves that are past: Table 2. As printed,
/// x sets bit 0 and z bit 2; in the plane there is no such table.
pub fn first_child<const D: usize>(upper: [bool; D], rules: Rules) -> Child<D> {
    let printed = D == 3 && (rules.has(Variant::B2) || rules.has(Variant::B2Morton));
    Child::from_upper_halves(std::array::from_fn(|e| upper[if printed { D - 1 - e } else { e }]))
}

/// Children of a node in the plane by the selection as printed: q1 in either
/// branch, a last condition that always holds, and no branch for equality.
pub fn selection<const D: usize>(near: [f64; D], mid: [f64; D], far: [f64; D]) -> Vec<Child<D>> {
    let [x, y] = [0, 1];
    let [q0, q1, q3] = [0, 1, 3].map(Child);
    let (before, after) = if mid[y] < mid[x] {
        (near[x] < mid[y], mid[x] < far[y])
    } else if mid[x] < mid[y] {
        (near[y] < mid[x], mid[y] < far[y])
    } else {
        return Vec::new();
    };
    let chosen = [(before, q0), (true, q1), (after, q3)];
    chosen.into_iter().filter_map(|(crossed, child)| crossed.then_some(child)).collect()
}
