//! What the colours of a map mean.

use super::mark::Mark;
use crate::look::Look;
use crate::map::{Colouring, NOTHING, RIGHT, Raster, Scale, UNKNOWN, WRONG};
use crate::theme::color32;
use crate::widgets::caption;
use eframe::egui::{Color32, Rect, Sense, Stroke, StrokeKind, Ui, pos2, vec2};

/// Every colour with what it means, and the mark of the present ray, or that there is none.
pub fn ui(ui: &mut Ui, look: &Look, colouring: Colouring, raster: &Raster, mark: Option<Mark>) {
    let scale = Scale::of(colouring, raster);
    match colouring {
        Colouring::Sequence => caption(ui, look, look.text("map-sequence-legend")),
        Colouring::Leaves | Colouring::Steps | Colouring::Comparisons => ramp(ui, look, scale),
        Colouring::Differences => differences(ui, look, scale, raster),
    }
    let has_nothing = raster.values.contains(&NOTHING);
    ui.horizontal_wrapped(|ui| {
        if has_nothing {
            let nothing = look.text("map-legend-nothing");
            entry(ui, look, color32(scale.colour(look.theme, NOTHING)), nothing);
        }
        let Some(mark) = mark else {
            caption(ui, look, look.text("map-legend-ray-beyond"));
            return;
        };
        ui.horizontal(|ui| {
            let (rect, _) = ui.allocate_exact_size(vec2(14.0, 14.0), Sense::hover());
            mark.paint_sample(ui.painter(), look, rect);
            caption(ui, look, look.text(mark.meaning()));
        });
    });
}

/// The smallest and the largest number, and what lies between them.
fn ramp(ui: &mut Ui, look: &Look, scale: Scale) {
    const PIECES: u32 = 48;
    let [least, most] = scale.range;
    ui.horizontal(|ui| {
        caption(ui, look, least.to_string());
        let size = vec2(2.0 * PIECES as f32, 12.0);
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        for n in 0..PIECES {
            let way = u64::from(most - least) * u64::from(n) / u64::from(PIECES - 1);
            let left = rect.left() + 2.0 * n as f32;
            let piece = Rect::from_min_size(pos2(left, rect.top()), vec2(2.5, rect.height()));
            let colour = color32(scale.colour(look.theme, least + way as u32));
            ui.painter().rect_filled(piece, 0.0, colour);
        }
        caption(ui, look, most.to_string());
    });
}

fn differences(ui: &mut Ui, look: &Look, scale: Scale, raster: &Raster) {
    let colour = |value: u32| color32(scale.colour(look.theme, value));
    let arguments = [("wrong", scale.n_wrong.into()), ("rays", raster.values.len().into())];
    let wrong = look.texts.format("map-differences-legend", &arguments);
    if scale.n_wrong > 0 {
        entry(ui, look, colour(WRONG), wrong);
    } else {
        caption(ui, look, wrong);
    }
    if scale.n_unknown > 0 {
        let arguments = [("rays", scale.n_unknown.into())];
        entry(ui, look, colour(UNKNOWN), look.texts.format("map-unknown-legend", &arguments));
    }
    if raster.values.contains(&RIGHT) {
        entry(ui, look, colour(RIGHT), look.text("map-legend-right"));
    }
}

/// A colour and what it means.
fn entry(ui: &mut Ui, look: &Look, colour: Color32, text: String) {
    ui.horizontal(|ui| {
        let (rect, _) = ui.allocate_exact_size(vec2(14.0, 14.0), Sense::hover());
        ui.painter().rect_filled(rect, 2.0, colour);
        let line = Stroke::new(1.0, look.palette.quiet);
        ui.painter().rect_stroke(rect, 2.0, line, StrokeKind::Inside);
        caption(ui, look, text);
    });
}
