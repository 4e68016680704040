//! A figure, painted in the window.

use super::PageInWindow;
use crate::look::Look;
use crate::theme::color32;
use eframe::egui::text::LayoutJob;
use eframe::egui::{Align, Color32, FontFamily, Painter, Pos2, Shape, Stroke, vec2};
use octoscope_core::explain::RichText;
use octoscope_figure::{Colour, Drawn, Figure, Form, Lettering, Page, Paint, Style, Theme, Weight};

/// Paints `figure` where `frame` says its page lies.
pub fn paint_on_page(
    painter: &Painter,
    look: &Look,
    theme: Theme,
    frame: PageInWindow,
    figure: &Figure,
) {
    for drawn in &figure.spelled_out().drawn {
        paint(painter, look, theme, (frame, figure.page), drawn);
    }
}

fn paint(
    painter: &Painter,
    look: &Look,
    theme: Theme,
    (frame, page): (PageInWindow, Page),
    drawn: &Drawn,
) {
    let paint = Paint::of(theme, drawn);
    let Paint { fill, stroke, width, .. } = paint;
    let dashes = paint.dashes(&drawn.form);
    let shown = |colour: Option<Colour>| colour.map_or(Color32::TRANSPARENT, color32);
    let (fill, stroke) = (shown(fill), Stroke::new(frame.scale * width as f32, shown(stroke)));
    let place =
        |points: &[[f64; 2]]| -> Vec<Pos2> { points.iter().map(|&p| frame.on_screen(p)).collect() };
    match &drawn.form {
        Form::Polygon(points) => {
            if fill != Color32::TRANSPARENT {
                painter.add(Shape::convex_polygon(place(points), fill, Stroke::NONE));
            }
            let Some(dashes) = dashes else {
                // Closed, so that its corners are whole.
                painter.add(Shape::closed_line(place(points), stroke));
                return;
            };
            let ring: Vec<_> = points.iter().chain(points.first()).copied().collect();
            let dashes = dashes.along(&ring, page);
            painter.extend(dashes.iter().map(|dash| Shape::line(place(dash), stroke)));
        }
        Form::Polyline(points) => {
            let whole = || vec![points.clone()];
            let lines = dashes.map_or_else(whole, |dashes| dashes.along(points, page));
            painter.extend(lines.iter().map(|line| Shape::line(place(line), stroke)));
        }
        Form::Circle { centre, radius } => {
            painter.circle(frame.on_screen(*centre), frame.scale * *radius as f32, fill, stroke);
        }
        Form::Text { at, anchor, text } => {
            let Some(lettering) = Style::of(theme, drawn.role).text else { return };
            let scale = f64::from(frame.scale);
            let lettering = Lettering { size: scale * lettering.size, ..lettering };
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
