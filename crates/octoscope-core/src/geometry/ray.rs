//! Rays.

use thiserror::Error;

/// Ray `origin + t · direction` with `t ≥ 0`.
///
/// The direction need not have length 1, so `t` is not a length. A component
/// −0.0 counts as 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray<const D: usize> {
    origin: [f64; D],
    direction: [f64; D],
}

/// Why numbers do not make a ray.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum RayError {
    /// A coordinate of the origin or the direction is NaN or infinite.
    #[error("a coordinate of the ray is not a finite number; give finite decimal numbers")]
    NotFinite,
    /// Every component of the direction is zero.
    #[error("the direction of the ray is zero; give at least one component another value")]
    ZeroDirection,
}

impl<const D: usize> Ray<D> {
    /// Ray from `origin` along `direction`, in world units.
    ///
    /// # Errors
    /// Refuses numbers that are not finite and a direction of length zero.
    pub fn new(origin: [f64; D], direction: [f64; D]) -> Result<Self, RayError> {
        if !origin.iter().chain(&direction).all(|x| x.is_finite()) {
            return Err(RayError::NotFinite);
        }
        if direction.iter().all(|&d| d == 0.0) {
            return Err(RayError::ZeroDirection);
        }
        Ok(Self { origin, direction })
    }

    /// Point at t = 0.
    #[inline]
    pub fn origin(&self) -> [f64; D] {
        self.origin
    }

    /// Change of the point per unit of t; finite and not zero.
    #[inline]
    pub fn direction(&self) -> [f64; D] {
        self.direction
    }

    /// Point at parameter `t`.
    #[inline]
    pub fn at(&self, t: f64) -> [f64; D] {
        std::array::from_fn(|e| self.origin[e] + t * self.direction[e])
    }
}
