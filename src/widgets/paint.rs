//! A figure, painted in the window.

use super::PageInWindow;
use crate::look::Look;
use crate::theme::color32;
use eframe::egui::text::LayoutJob;
use eframe::egui::{Align, Color32, FontFamily, Painter, Pos2, Shape, Stroke, vec2};
use octoscope_core::explain::RichText;
use octoscope_figure::{Colour, Drawn, Figure, Form, Lettering, Paint, Style, Theme, Weight};

/// Paints `figure` where `frame` says its page lies.
pub fn paint_on_page(
    painter: &Painter,
    look: &Look,
    theme: Theme,
    frame: PageInWindow,
    figure: &Figure,
) {
    for drawn in &figure.spelled_out().drawn {
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
        Form::Text { at, anchor, text } => {
            let Some(lettering) = Style::of(theme, drawn.role).text else { return };
            let galley = painter.layout_job(job(look, theme, lettering, text));
            // What lowered subscripts add lies below the line.
            let above = 0.5 * galley.size().y - look.lowered(lettering.size as f32, text);
            let before = vec2(anchor.share() as f32 * galley.size().x, above);
            painter.galley(frame.on_screen(*at) - before, galley, color32(lettering.colour));
        }
        // It is spelled out.
        Form::Formula { .. } => {}
    }
}

/// A line of text, piece by piece.
fn job(look: &Look, theme: Theme, lettering: Lettering, text: &RichText) -> LayoutJob {
    let mut job = LayoutJob::default();
    // Text of one height stands as the font has it.
    let is_even = !text.0.iter().any(|span| span.sub);
    for span in &text.0 {
        let Lettering { colour, weight, .. } = lettering.of_span(theme, span);
        let family = match weight {
            Weight::Regular => FontFamily::Proportional,
            Weight::Strong => look.strong_family(),
            Weight::Mono => FontFamily::Monospace,
            Weight::MonoStrong => look.mono_strong_family(),
        };
        let mut format = look.set(span, lettering.size as f32, family);
        format.color = color32(colour);
        if is_even {
            format.valign = Align::BOTTOM;
        }
        job.append(&span.text, 0.0, format);
    }
    job
}

fn paint_line(painter: &Painter, points: &[Pos2], stroke: Stroke, dashes: &[f64]) {
    if stroke.color == Color32::TRANSPARENT || stroke.width <= 0.0 {
        return;
    }
    if dashes.is_empty() {
        painter.add(Shape::line(points.to_vec(), stroke));
        return;
    }
    let every_second = |first: usize| -> Vec<f32> {
        let lengths = dashes.iter().skip(first).step_by(2);
        lengths.map(|length| *length as f32 * stroke.width.max(1.0)).collect()
    };
    let [dash, gap] = [every_second(0), every_second(1)];
    painter.extend(Shape::dashed_line_with_offset(points, stroke, &dash, &gap, 0.0));
}
