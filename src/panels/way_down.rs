//! From the exit point down from the root again.

use crate::look::Look;
use crate::widgets::{caption, captioned, per_axis};
use eframe::egui::{FontId, Frame, Margin, RichText, Stroke, Ui};
use octoscope_core::event::Event;
use octoscope_core::explain::{RichText as Coloured, approx};
use octoscope_core::geometry::Ray;
use octoscope_core::trace::{Counter, Moment};
use octoscope_core::tree::Tree;

/// Which of the searches from the root it is.
pub fn note<const D: usize>(look: &Look, moment: &Moment<D>) -> String {
    let n = moment.counters.get(Counter::PointLocations);
    if n == 0 { String::new() } else { look.texts.format("way-down-count", &[("n", n.into())]) }
}

/// The height that it takes in a lecture, in points.
pub const LECTURE_HEIGHT: f32 = 86.0;

/// The exit point, where it is pushed to or the codes beyond, and the path from
/// the root to the leaf in which that is. `past` are the events so far.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    tree: &Tree<D>,
    ray: &Ray<D>,
    moment: &Moment<D>,
    past: &[Event<D>],
) {
    let Some(begun) = past.iter().rposition(|event| matches!(event, Event::Begin { .. })) else {
        caption(ui, look, look.text("way-down-none"));
        return;
    };
    path(ui, look, tree, &past[begun..]);
    let line = |ui: &mut Ui, key: &str, texts: Coloured| {
        captioned(ui, look, &look.text(key), &texts, "");
    };
    if let Some(exits) = moment.exits {
        let t = exits.exits.into_iter().fold(f64::INFINITY, f64::min);
        line(ui, "way-down-exit", per_axis(ray.at(t).map(approx)));
    }
    if let Some([_, to]) = moment.pushed {
        line(ui, "way-down-pushed", per_axis(to.map(approx)));
    } else if let Some(target) = moment.target
        && moment.exits.is_some()
    {
        line(ui, "way-down-target", per_axis(target.to.map(|c| c.to_string())));
    }
}

/// The root and the children below it, as far as the search has come.
fn path<const D: usize>(ui: &mut Ui, look: &Look, tree: &Tree<D>, search: &[Event<D>]) {
    let steps = search.iter().filter_map(|event| {
        if let Event::Follow { level, child, .. } = event { Some((*level, *child)) } else { None }
    });
    let palette = &look.palette;
    let steps: Vec<_> = steps.collect();
    let at_leaf = search.iter().any(|event| matches!(event, Event::Leaf { .. }));
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let chip = |ui: &mut Ui, text: String, level: u8, lit: bool| {
            let color = if lit { palette.current_line } else { palette.grid };
            let frame = Frame::new().fill(palette.field).stroke(Stroke::new(1.5, color));
            let shown =
                frame.corner_radius(4.0).inner_margin(Margin::symmetric(6, 2)).show(ui, |ui| {
                    let font = FontId::new(14.0, look.mono_strong_family());
                    ui.label(RichText::new(text).font(font).color(palette.ink));
                });
            let level = [("level", level.into())];
            shown.response.on_hover_text(look.texts.format("way-down-level", &level));
        };
        let root_level = tree.domain().root_level();
        chip(ui, look.text("way-down-root"), root_level, steps.is_empty() && !at_leaf);
        for (n, (level, child)) in steps.iter().enumerate() {
            ui.label(RichText::new("→").color(palette.quiet));
            chip(ui, child.0.to_string(), level - 1, n + 1 == steps.len());
        }
    });
}
