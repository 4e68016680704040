//! A figure, painted in the window.

use super::PageInWindow;
use crate::look::Look;
use crate::theme::color32;
use eframe::egui::{Align2, Color32, FontFamily, FontId, Painter, Pos2, Shape, Stroke};
use octoscope_figure::{Colour, Drawn, Figure, Form, Paint, Style, Theme, Weight};

/// Paints `figure` where `frame` says its page lies.
pub fn figure(painter: &Painter, look: &Look, theme: Theme, frame: PageInWindow, figure: &Figure) {
    for drawn in &figure.drawn {
        paint(painter, look, theme, frame, drawn);
    }
}

fn paint(painter: &Painter, look: &Look, theme: Theme, frame: PageInWindow, drawn: &Drawn) {
    let Paint { fill, stroke, width, dash } = Paint::of(theme, drawn);
    let shown = |colour: Option<Colour>| colour.map_or(Color32::TRANSPARENT, color32);
    let (fill, stroke) = (shown(fill), Stroke::new(width as f32, shown(stroke)));
    let place =
        |points: &[[f64; 2]]| -> Vec<Pos2> { points.iter().map(|&p| frame.on_screen(p)).collect() };
    match &drawn.form {
        Form::Polygon(points) => {
            let mut points = place(points);
            if fill != Color32::TRANSPARENT {
                painter.add(Shape::convex_polygon(points.clone(), fill, Stroke::NONE));
            }
            points.extend(points.first().copied());
            paint_line(painter, &points, stroke, dash.pattern());
        }
        Form::Polyline(points) => paint_line(painter, &place(points), stroke, dash.pattern()),
        Form::Circle { centre, radius } => {
            painter.circle(frame.on_screen(*centre), *radius as f32, fill, stroke);
        }
        Form::Text { at, text } => {
            let Some(lettering) = Style::of(theme, drawn.role).text else { return };
            let family = match lettering.weight {
                Weight::Regular => FontFamily::Proportional,
                Weight::Strong => look.strong_family(),
                Weight::Mono => FontFamily::Monospace,
            };
            let font = FontId::new(lettering.size as f32, family);
            let at = frame.on_screen(*at);
            painter.text(at, Align2::CENTER_CENTER, text, font, color32(lettering.colour));
        }
    }
}

fn paint_line(painter: &Painter, points: &[Pos2], stroke: Stroke, dashes: &[f64]) {
    if stroke.color == Color32::TRANSPARENT || stroke.width <= 0.0 {
        return;
    }
    if let [dash, gap] = dashes {
        let [dash, gap] = [dash, gap].map(|length| *length as f32 * stroke.width.max(1.0));
        painter.extend(Shape::dashed_line(points, stroke, dash, gap));
    } else {
        painter.add(Shape::line(points.to_vec(), stroke));
    }
}
