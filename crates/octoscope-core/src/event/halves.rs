//! The halves that a ray is in.

/// Halves of a part that a ray is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Halves {
    /// Only the half on the side of the origin.
    Near,
    /// Only the half beyond the plane.
    Far,
    /// First the near, then the far half.
    Both,
}
