//! Axis-aligned boxes.

/// Axis-parallel box, half-open: it owns `min` but not `max`, on every axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb<const D: usize> {
    /// Smallest coordinate on every axis, in world units; owned by the box.
    pub min: [f64; D],
    /// Largest coordinate on every axis, in world units; not owned.
    pub max: [f64; D],
}

impl<const D: usize> Aabb<D> {
    /// Box that holds every one of `points` between or on its sides, or `None`
    /// without points.
    pub fn around(points: impl IntoIterator<Item = [f64; D]>) -> Option<Self> {
        points.into_iter().fold(None, |bounds: Option<Self>, p| {
            let (min, max) = bounds.map_or((p, p), |b| (b.min, b.max));
            Some(Self {
                min: std::array::from_fn(|e| min[e].min(p[e])),
                max: std::array::from_fn(|e| max[e].max(p[e])),
            })
        })
    }

    /// Point in the middle.
    pub fn centre(&self) -> [f64; D] {
        std::array::from_fn(|e| 0.5 * self.min[e] + 0.5 * self.max[e])
    }

    /// Lengths of the sides.
    pub fn size(&self) -> [f64; D] {
        std::array::from_fn(|e| self.max[e] - self.min[e])
    }

    /// Whether the half-open box owns `point`.
    pub fn owns(&self, point: [f64; D]) -> bool {
        (0..D).all(|e| self.min[e] <= point[e] && point[e] < self.max[e])
    }
}
