//! The mark of the present ray in a map.

use crate::look::Look;
use crate::map::Rays;
use eframe::egui::{Painter, Pos2, Rect, Stroke, vec2};
use octoscope_core::geometry::Ray;
use octoscope_core::tree::Tree;
use octoscope_figure::far_end;

/// How the present ray is marked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// By a ring: it is the ray of this place.
    Ring([f64; 2]),
    /// As a line from its origin on: it is no ray of the map, but is seen in it.
    Line([[f64; 2]; 2]),
}

impl Mark {
    /// The mark of `ray` among `rays`; `None` where it lies beyond the sides.
    pub fn of<const D: usize>(rays: &Rays<D>, tree: &Tree<D>, ray: &Ray<D>) -> Option<Self> {
        if let Some(place) = rays.place(ray) {
            return Some(Self::Ring(place));
        }
        rays.seen([ray.origin(), far_end(tree, ray)]).map(Self::Line)
    }

    /// The place of the present ray, if it is a ray of the map.
    pub fn place(self) -> Option<[f64; 2]> {
        match self {
            Self::Ring(place) => Some(place),
            Self::Line(_) => None,
        }
    }

    /// Key of what it means.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Ring(_) => "map-legend-ray",
            Self::Line(_) => "map-legend-ray-seen",
        }
    }

    /// Paints it in a map, on a line of the background so that it stands out.
    pub fn paint(self, painter: &Painter, look: &Look, map: Rect) {
        let strokes =
            [Stroke::new(4.5, look.palette.background), Stroke::new(2.0, look.palette.ray)];
        for stroke in strokes {
            match self {
                Self::Ring(place) => painter.circle_stroke(on_screen(map, place), 6.0, stroke),
                Self::Line(ends) => {
                    let ends = ends.map(|end| on_screen(map, end));
                    painter.circle_filled(ends[0], 1.5 + stroke.width, stroke.color);
                    painter.line_segment(ends, stroke)
                }
            };
        }
    }

    /// Paints a small one in a legend.
    pub fn paint_sample(self, painter: &Painter, look: &Look, room: Rect) {
        let stroke = Stroke::new(2.0, look.palette.ray);
        match self {
            Self::Ring(_) => painter.circle_stroke(room.center(), 5.0, stroke),
            Self::Line(_) => painter.hline(room.x_range(), room.center().y, stroke),
        };
    }
}

/// Place in the window of a place in a map.
pub fn on_screen(map: Rect, [u, v]: [f64; 2]) -> Pos2 {
    map.lerp_inside(vec2(u as f32, 1.0 - v as f32))
}
