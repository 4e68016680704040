//! What is seen while the camera is on its way.

use crate::view::View;
use eframe::egui::Ui;
use octoscope_figure::Camera;

/// How long a flight takes.
const SECS: f64 = 0.25;

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
