//! The camera goes where the user asks by name, and behind the current node.

use crate::document::Document;
use crate::view::{Standpoint, View};
use octoscope_core::trace::Moment;
use octoscope_figure::{Camera, Lens, Page};
use std::f64::consts::FRAC_PI_2;

/// How much of the view's height the current node takes.
const NODE_SHARE: f64 = 0.45;

/// Moves the camera to what is asked for in `view`, and behind the current node
/// where it is to be followed: once a node, so that the mouse can look elsewhere.
pub fn stand<const D: usize>(
    view: &mut View,
    camera: &mut Camera<D>,
    page: Page,
    document: &Document<D>,
    moment: &Moment<D>,
) {
    camera.lens = if D == 2 { Lens::default() } else { view.lens };
    let asked = view.standpoint.take();
    let node = moment.current.map(|node| document.tree.node_box(node));
    match asked {
        None => {}
        Some(Standpoint::Node) => {
            if let Some(bounds) = node {
                camera.target = bounds.centre();
                camera.height = bounds.size()[0] / NODE_SHARE;
                view.fitted = false;
            }
        }
        Some(Standpoint::Everything) => {
            document.frame(camera, page);
            view.fitted = true;
        }
        Some(side @ (Standpoint::Right | Standpoint::Front | Standpoint::Above)) => {
            (camera.yaw, camera.pitch) = match side {
                Standpoint::Right => (0.0, 0.0),
                Standpoint::Front => (-FRAC_PI_2, 0.0),
                Standpoint::Above | Standpoint::Node | Standpoint::Everything => {
                    (-FRAC_PI_2, FRAC_PI_2)
                }
            };
            document.frame(camera, page);
            view.fitted = true;
        }
    }
    let followed = moment.current.filter(|_| view.follow);
    if followed != view.followed
        && let (Some(_), Some(bounds)) = (followed, node)
    {
        camera.target = bounds.centre();
        view.fitted = false;
    }
    view.followed = followed;
}
