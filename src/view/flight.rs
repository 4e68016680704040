//! A camera on its way to where it is to be.

use octoscope_figure::Camera;
use std::any::Any;

/// Where a camera came from, and when it left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flight {
    plane: Option<Camera<2>>,
    orbit: Option<Camera<3>>,
    /// When it left, in seconds since the program started.
    pub since: f64,
}

impl Flight {
    /// A flight that begins at a camera.
    pub fn from<const D: usize>(camera: Camera<D>, since: f64) -> Self {
        let any: &dyn Any = &camera;
        let plane = any.downcast_ref::<Camera<2>>().copied();
        Self { plane, orbit: any.downcast_ref::<Camera<3>>().copied(), since }
    }

    /// Where it began; `None` with a tree of another dimension.
    pub fn start<const D: usize>(&self) -> Option<Camera<D>> {
        let any: &dyn Any = if D == 2 { &self.plane } else { &self.orbit };
        any.downcast_ref::<Option<Camera<D>>>().copied().flatten()
    }
}
