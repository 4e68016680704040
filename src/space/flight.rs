//! A camera on its way to where it is to be.

use crate::view::View;
use eframe::egui::Ui;
use octoscope_figure::Camera;
use std::any::Any;

/// Where the camera came from, and when it left, in seconds since the program started.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flight {
    plane: Option<Camera<2>>,
    orbit: Option<Camera<3>>,
    since: f64,
}

/// How long a flight takes.
const SECS: f64 = 0.25;

impl Flight {
    /// A flight that begins at a camera.
    pub fn from<const D: usize>(camera: Camera<D>, since: f64) -> Self {
        let any: &dyn Any = &camera;
        let plane = any.downcast_ref::<Camera<2>>().copied();
        Self { plane, orbit: any.downcast_ref::<Camera<3>>().copied(), since }
    }

    fn start<const D: usize>(&self) -> Option<Camera<D>> {
        let any: &dyn Any = if D == 2 { &self.plane } else { &self.orbit };
        any.downcast_ref::<Option<Camera<D>>>().copied().flatten()
    }
}

/// What is seen on the way to `goal`; the goal itself without a flight, and after it.
pub fn on_the_way<const D: usize>(ui: &Ui, view: &mut View, goal: Camera<D>) -> Camera<D> {
    let now = ui.input(|input| input.time);
    let flight = view.flight.filter(|_| !view.reduced_motion);
    let Some((start, since)) = flight.and_then(|flight| Some((flight.start()?, flight.since)))
    else {
        view.flight = None;
        return goal;
    };
    let share = (now - since) / SECS;
    if share >= 1.0 {
        view.flight = None;
        return goal;
    }
    ui.ctx().request_repaint();
    start.towards(&goal, smooth(share.max(0.0)))
}

/// From 0 to 1, slow at both ends.
fn smooth(share: f64) -> f64 {
    share * share * (3.0 - 2.0 * share)
}
