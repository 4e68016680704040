//! A light at the pointer: everything else is dimmed.

use crate::look::Look;
use eframe::egui::{Context, Id, LayerId, Mesh, Order, Shape, pos2, vec2};

/// Radius of the light, in points.
const RADIUS: f32 = 96.0;
/// Number of corners of its edge.
const N_CORNERS: u32 = 64;

/// Dims everything but the surroundings of the pointer; nothing, while it is
/// outside the window.
pub fn paint(context: &Context, look: &Look) {
    let Some(pointer) = context.pointer_latest_pos() else { return };
    let layer = LayerId::new(Order::Tooltip, Id::unique("spotlight"));
    let room = context.content_rect();
    let far = room.size().length() + RADIUS;
    // A ring whose outer edge lies outside the window, wherever the light is.
    let mut ring = Mesh::default();
    for n in 0..N_CORNERS {
        let angle = n as f32 / N_CORNERS as f32 * std::f32::consts::TAU;
        let direction = vec2(angle.cos(), angle.sin());
        for radius in [RADIUS, far] {
            let corner = pointer + radius * direction;
            ring.colored_vertex(pos2(corner.x, corner.y), look.palette.shade);
        }
        let [here, next] = [2 * n, 2 * ((n + 1) % N_CORNERS)];
        ring.add_triangle(here, here + 1, next);
        ring.add_triangle(next, here + 1, next + 1);
    }
    context.layer_painter(layer).add(Shape::mesh(ring));
}
