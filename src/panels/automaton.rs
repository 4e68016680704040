//! The automaton that leads from child to child.

use crate::look::Look;
use crate::widgets::{Lit, lit};
use eframe::egui::{
    Align, Align2, Color32, FontId, Grid, Layout, Painter, Pos2, RichText, Sense, Stroke, Ui, Vec2,
    WidgetInfo, accesskit::Role, pos2, vec2,
};
use octoscope_core::event::Event;
use octoscope_core::geometry::{AXIS_NAMES, Axes};
use octoscope_core::trace::Moment;
use octoscope_core::traverse::{entry_axes, transition};
use octoscope_core::tree::Child;

/// The mirror mask, and what it means.
pub fn note<const D: usize>(look: &Look, moment: &Moment<D>) -> String {
    look.texts.format("automaton-mask", &[("mask", mask(moment).0.into())])
}

fn mask<const D: usize>(moment: &Moment<D>) -> Axes<D> {
    moment.clip.map_or(Axes::NONE, |clip| clip.mirror)
}

/// States as corners of a square or cube, the lit transition, and the tables
/// with the used row and column lit. `event` is what has just happened.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, moment: &Moment<D>, event: Option<&Event<D>>) {
    let mask = mask(moment);
    let (state, lit) = if let Some(&Event::Step { state, axes, next, .. }) = event {
        (Some(state), Some((axes, next)))
    } else {
        (moment.stack.iter().rev().find_map(|frame| frame.child_state), None)
    };
    // The table beside it needs the same room whatever is lit.
    let [table, least, most] = if D == 2 { [152.0, 96.0, 120.0] } else { [176.0, 150.0, 184.0] };
    let beside = ui.available_width() - table;
    let side = if beside < least { most } else { beside.min(most) };
    let direction = if beside < least {
        Layout::top_down(Align::Min)
    } else {
        Layout::left_to_right(Align::Min)
    };
    ui.with_layout(direction, |ui| {
        let (rect, response) = ui.allocate_exact_size(Vec2::splat(side), Sense::hover());
        let now = state.map_or("–".to_owned(), |state| state.0.to_string());
        let spoken = look.texts.format("automaton-state", &[("state", now.into())]);
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, spoken.as_str()));
        let painter = ui.painter_at(rect.expand(4.0));
        let place = |child: Child<D>| corner(child, rect.center(), side * 0.5 - 20.0);
        paint_edges(&painter, look, state, lit, &place);
        paint_states(&painter, look, state, lit.and_then(|(_, next)| next), mask, &place);
        ui.vertical(|ui| exit_table(ui, look, state, lit));
    });
    if D == 3 {
        entry_table::<D>(ui, look, event);
    }
}

/// Place of a state: x to the right, y up, z towards the upper right.
fn corner<const D: usize>(state: Child<D>, centre: Pos2, reach: f32) -> Pos2 {
    let bit = |axis: usize| if axis < D && state.is_upper(axis) { 1.0 } else { -1.0 };
    if D == 2 {
        return centre + vec2(bit(0), -bit(1)) * reach;
    }
    let depth = vec2(0.32, -0.27) * bit(2);
    centre + (vec2(bit(0), -bit(1)) * 0.68 + depth) * reach
}

fn paint_edges<const D: usize>(
    painter: &Painter,
    look: &Look,
    state: Option<Child<D>>,
    lit: Option<(Axes<D>, Option<Child<D>>)>,
    place: &impl Fn(Child<D>) -> Pos2,
) {
    for from in Child::<D>::all() {
        for axis in (0..D).filter(|&axis| !from.is_upper(axis)) {
            let Some(to) = transition(from, axis) else { continue };
            let taken = lit.is_some_and(|(axes, _)| axes == Axes::one(axis)) && state == Some(from);
            let color = look.palette.axes[axis];
            let (width, color) =
                if taken { (4.0, color) } else { (1.3, color.gamma_multiply(0.45)) };
            arrow(painter, place(from), place(to), Stroke::new(width, color));
        }
    }
    // Through an edge or a corner of the cell: several planes at once.
    if let (Some(from), Some((axes, Some(to)))) = (state, lit)
        && axes.count() > 1
    {
        arrow(painter, place(from), place(to), Stroke::new(4.0, look.palette.current_line));
    }
}

fn arrow(painter: &Painter, from: Pos2, to: Pos2, stroke: Stroke) {
    let along = (to - from).normalized();
    let [start, tip] = [from + along * 15.0, to - along * 15.0];
    painter.line_segment([start, tip - along * 4.0], stroke);
    let across = along.rot90();
    let head = 4.0 + stroke.width;
    let points = vec![
        tip,
        tip - along * head * 1.6 + across * head * 0.7,
        tip - along * head * 1.6 - across * head * 0.7,
    ];
    painter.add(eframe::egui::Shape::convex_polygon(points, stroke.color, Stroke::NONE));
}

fn paint_states<const D: usize>(
    painter: &Painter,
    look: &Look,
    state: Option<Child<D>>,
    next: Option<Child<D>>,
    mask: Axes<D>,
    place: &impl Fn(Child<D>) -> Pos2,
) {
    let palette = &look.palette;
    for child in Child::<D>::all() {
        let at = place(child);
        let (fill, stroke) = if state == Some(child) {
            (palette.current_line, Stroke::new(2.0, palette.current_line))
        } else if next == Some(child) {
            (palette.field, Stroke::new(3.0, palette.current_line))
        } else {
            (palette.field, Stroke::new(1.2, palette.quiet))
        };
        painter.circle(at, 13.0, fill, stroke);
        let ink = if state == Some(child) { readable_on(fill) } else { palette.ink };
        let font = FontId::new(14.0, look.strong_family());
        painter.text(at, Align2::CENTER_CENTER, child.0.to_string(), font, ink);
        if !mask.is_empty() {
            let text = format!("→{}", child.mirrored(mask).0);
            let at = pos2(at.x + 14.0, at.y + 13.0);
            painter.text(
                at,
                Align2::CENTER_CENTER,
                text,
                FontId::proportional(11.0),
                palette.quiet,
            );
        }
    }
}

/// Black or white, whichever reads better on `fill`.
fn readable_on(fill: Color32) -> Color32 {
    let light =
        0.299 * f32::from(fill.r()) + 0.587 * f32::from(fill.g()) + 0.114 * f32::from(fill.b());
    if light > 110.0 { Color32::BLACK } else { Color32::WHITE }
}

/// Table 1 or 3: next state by state and exit plane.
fn exit_table<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    state: Option<Child<D>>,
    step: Option<(Axes<D>, Option<Child<D>>)>,
) {
    let key = if D == 2 { "automaton-table-1" } else { "automaton-table-3" };
    ui.label(RichText::new(look.text(key)).size(13.0).color(look.palette.quiet));
    Grid::new("exit-table")
        .num_columns(D + 1)
        .spacing([8.0, 0.0])
        .min_col_width(28.0)
        .min_row_height(18.0)
        .show(ui, |ui| {
            ui.label(RichText::new(look.text("automaton-state-column")).size(13.0));
            for axis in 0..D {
                let text = RichText::new(AXIS_NAMES[axis]).strong().color(look.palette.axes[axis]);
                ui.label(text);
            }
            ui.end_row();
            for row in Child::<D>::all() {
                let in_row = state == Some(row);
                let tone = if in_row { Lit::Used } else { Lit::No };
                ui.label(lit(look, row.0.to_string(), tone));
                for axis in 0..D {
                    let used = in_row && step.is_some_and(|(axes, _)| axes.contains(axis));
                    let text = transition(row, axis)
                        .map_or_else(|| look.text("automaton-end"), |next| next.0.to_string());
                    let tone = match (in_row, used) {
                        (_, true) => Lit::Used,
                        (true, false) => Lit::Line,
                        (false, false) => Lit::No,
                    };
                    ui.label(lit(look, text, tone));
                }
                ui.end_row();
            }
        });
}

/// Table 2: which mid planes decide, by the plane of entry.
fn entry_table<const D: usize>(ui: &mut Ui, look: &Look, event: Option<&Event<D>>) {
    let entered =
        if let Some(Event::First { entry_axis, .. }) = event { *entry_axis } else { None };
    ui.label(RichText::new(look.text("automaton-table-2")).size(13.0).color(look.palette.quiet));
    Grid::new("entry-table").num_columns(3).spacing([12.0, 0.0]).min_row_height(18.0).show(
        ui,
        |ui| {
            for axis in 0..D {
                let plane: String =
                    (0..D).filter(|&e| e != axis).map(|e| AXIS_NAMES[e].to_uppercase()).collect();
                let used = entered == Some(axis);
                ui.label(lit(look, plane, if used { Lit::Used } else { Lit::No }));
                for other in entry_axes::<D>(axis).iter() {
                    let bit = Axes::<D>::one(other).0;
                    let [o, e] = [AXIS_NAMES[other], AXIS_NAMES[axis]];
                    let tone = if used { Lit::Line } else { Lit::No };
                    ui.label(lit(look, format!("t{o}m < t{e}0 → {bit}"), tone));
                }
                ui.end_row();
            }
        },
    );
}
