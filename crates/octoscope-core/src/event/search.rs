//! What finding a cell on the ray took.

/// Work of finding the cell in which a ray is just after some parameter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Search {
    /// Axes along which a point of the ray was computed as a first guess.
    pub guesses: u8,
    /// Planes of the grid whose parameter was computed and compared.
    pub parameters: u8,
    /// Planes of the grid that were compared with the origin of the ray, along
    /// axes that it does not move along.
    pub coordinates: u8,
}

impl Search {
    /// No work: the cell is known.
    pub const NONE: Self = Self { guesses: 0, parameters: 0, coordinates: 0 };

    /// The work of both.
    pub fn and(self, other: Self) -> Self {
        Self {
            guesses: self.guesses + other.guesses,
            parameters: self.parameters + other.parameters,
            coordinates: self.coordinates + other.coordinates,
        }
    }
}
