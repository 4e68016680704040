//! Where the root lies.

use crate::geometry::Aabb;
use crate::tree::{Domain, DomainError};

/// Cube of the root, still without a grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cube<const D: usize> {
    /// Smallest corner, in world units.
    pub min: [f64; D],
    /// Edge length, in world units; above 0.
    pub side: f64,
}

impl<const D: usize> Cube<D> {
    /// [0, 1) on every axis.
    pub const UNIT: Self = Self { min: [0.0; D], side: 1.0 };

    /// The cube cut into 2^`depth` smallest cells per axis.
    ///
    /// # Errors
    /// Refuses what [`Domain::new`] refuses.
    pub fn cut(&self, depth: u8) -> Result<Domain<D>, DomainError> {
        Domain::new(self.min, self.side, depth)
    }
}

/// Cube that owns all of `bounds`, their upper faces too.
///
/// The unit cube if that does. Otherwise side and corner are multiples of a
/// power of two, the side has at most five significant bits, and what is left
/// over is shared between both sides: then the planes of the grid are exact.
pub fn fit_domain<const D: usize>(bounds: &Aabb<D>) -> Cube<D> {
    let owns = |cube: &Cube<D>| {
        (0..D).all(|e| cube.min[e] <= bounds.min[e] && bounds.max[e] < cube.min[e] + cube.side)
    };
    let magnitude = bounds.min.iter().chain(&bounds.max).fold(0.0f64, |m, x| m.max(x.abs()));
    let extent = bounds.size().into_iter().fold(0.0, f64::max);
    if owns(&Cube::UNIT) && extent > 0.25 {
        return Cube::UNIT;
    }

    // A step of 1/16 to 1/8 of the extent, and not so small against the
    // coordinates that 20 levels could no longer be told apart.
    let least = (magnitude * 2f64.powi(-24)).max(f64::MIN_POSITIVE * 2f64.powi(60));
    let mut step = (extent / 16.0).max(least).log2().floor().exp2();
    loop {
        let mut cells = (extent / step).floor() + 1.0;
        for _ in 0..3 {
            let side = cells * step;
            let min = std::array::from_fn(|e| {
                let slack = side - (bounds.max[e] - bounds.min[e]);
                ((bounds.min[e] - slack / 2.0) / step).floor() * step
            });
            let cube = Cube { min, side };
            if owns(&cube) {
                return cube;
            }
            cells += 1.0;
        }
        if !step.is_finite() {
            return Cube { min: [0.0; D], side: f64::INFINITY };
        }
        step *= 2.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    #[test]
    fn the_fitted_domain_owns_its_bounds_and_has_twenty_levels() {
        let mut random = Random::new(1);
        for _ in 0..2000 {
            let scale = random.between(-60.0, 60.0).exp2();
            let offset = random.between(-30.0, 10.0).exp2() * scale;
            let mut point = || [(); 3].map(|()| offset + scale * random.between(-1.0, 1.0));
            let bounds = Aabb::around([point(), point()]).unwrap();
            let cube = fit_domain(&bounds);
            let root = cube.cut(20).unwrap().root_box();
            assert!(root.owns(bounds.min) && root.owns(bounds.max), "{bounds:?} in {cube:?}");
            let extent = bounds.size().into_iter().fold(0.0, f64::max);
            let tight = cube.side <= 1.5 * extent.max(offset * 1e-3);
            assert!(tight || cube == Cube::UNIT, "{bounds:?} in {cube:?}");
        }
    }

    #[test]
    fn a_single_point_gets_a_domain() {
        for x in [0.0, 1.0, -1e9, 1e300, 5e-324] {
            let bounds = Aabb { min: [x; 2], max: [x; 2] };
            assert!(fit_domain(&bounds).cut(20).unwrap().root_box().owns([x; 2]), "{x}");
        }
    }

    #[test]
    fn bounds_in_the_unit_cube_keep_it() {
        let bounds = Aabb { min: [0.0, 0.125], max: [0.5, 0.9] };
        assert_eq!(fit_domain(&bounds), Cube::UNIT);
    }
}
