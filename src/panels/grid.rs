//! The walk from cell to cell of the finest grid.

use crate::look::Look;
use crate::widgets::{caption, per_axis, rich_job};
use eframe::egui::{
    Align2, FontId, Label, RichText, Sense, Stroke, Ui, WidgetInfo, accesskit::Role, pos2, vec2,
};
use octoscope_core::event::Event;
use octoscope_core::explain::approx;
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::trace::{Counter, Moment};

/// Number of cells so far.
pub fn note<const D: usize>(look: &Look, moment: &Moment<D>) -> String {
    let n = moment.counters.get(Counter::GridCells);
    look.texts.format("grid-count", &[("n", n.into())])
}

/// How far it is to the next plane of every axis, the nearest lit, and the codes
/// of the cell. `past` are the events so far.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, moment: &Moment<D>, past: &[Event<D>]) {
    let Some(grid) = moment.grid else {
        caption(ui, look, look.text("grid-none"));
        return;
    };
    let palette = &look.palette;
    let now = reached(past);
    let ahead = grid.next.into_iter().filter(|t| t.is_finite()).fold(now, f64::max);
    let nearest = grid.next.into_iter().fold(f64::INFINITY, f64::min);
    let row = 26.0;
    let size = vec2(ui.available_width(), row * D as f32);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let spoken: Vec<_> =
        (0..D).map(|e| format!("tMax {} {}", AXIS_NAMES[e], approx(grid.next[e]))).collect();
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, spoken.join(", ")));
    let painter = ui.painter_at(rect);
    let track = (rect.left() + 24.0)..=(rect.right() - 84.0);
    let length = track.end() - track.start();
    for axis in 0..D {
        let y = rect.top() + row * (axis as f32 + 0.5);
        let t = grid.next[axis];
        let color = palette.axes[axis];
        let wins = t == nearest;
        let strong = FontId::new(14.0, look.strong_family());
        painter.text(pos2(rect.left(), y), Align2::LEFT_CENTER, AXIS_NAMES[axis], strong, color);
        painter.hline(track.clone(), y, Stroke::new(1.0, palette.grid));
        let share = if ahead > now { ((t - now) / (ahead - now)) as f32 } else { 0.0 };
        let end = track.start() + share.clamp(0.0, 1.0) * length;
        if t.is_finite() {
            let width = if wins { 11.0 } else { 6.0 };
            painter.hline(
                *track.start()..=end.max(track.start() + 2.0),
                y,
                Stroke::new(width, color),
            );
        } else {
            painter.arrow(pos2(*track.start(), y), vec2(length, 0.0), Stroke::new(1.5, color));
        }
        let font = if wins {
            FontId::new(13.0, look.mono_strong_family())
        } else {
            FontId::monospace(13.0)
        };
        let ink = if wins { palette.ink } else { palette.quiet };
        let at = pos2(rect.right(), y);
        painter.text(at, Align2::RIGHT_CENTER, approx(t), font, ink);
    }
    ui.horizontal_wrapped(|ui| {
        caption(ui, look, look.text("grid-cell"));
        match grid.cell {
            Some(cell) => {
                let codes = per_axis(cell.map(|c| c.to_string()));
                ui.add(Label::new(rich_job(&codes, look, 14.0, 220.0)));
            }
            None => {
                ui.label(RichText::new(look.text("grid-outside")).size(14.0));
            }
        }
        if !grid.crossed.is_empty() {
            let axes: Vec<_> = grid.crossed.iter().map(|axis| AXIS_NAMES[axis]).collect();
            let crossed = look.texts.format("grid-crossed", &[("axes", axes.join(", ").into())]);
            ui.add_space(8.0);
            caption(ui, look, crossed);
        }
    });
}

/// Parameter at which the cell was entered.
fn reached<const D: usize>(past: &[Event<D>]) -> f64 {
    let mut steps = past.iter().rev().filter_map(|event| {
        if let Event::Cross { next, axes, .. } = event {
            axes.iter().map(|axis| next[axis]).next()
        } else {
            None
        }
    });
    let clipped = past.iter().find_map(|event| {
        if let Event::Clip { enter, .. } = event { Some(enter.max(0.0)) } else { None }
    });
    steps.next().or(clipped).unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::geometry::Axes;

    #[test]
    fn planes_ahead_are_measured_from_where_the_cell_was_entered() {
        let cross = |t: f64| Event::<2>::Cross {
            next: [t, 9.0],
            axes: Axes::one(0),
            cell: [0; 2],
            outside: Axes::NONE,
            ahead: [t + 1.0, 9.0],
        };
        assert_eq!(reached::<2>(&[]), 0.0);
        assert_eq!(reached(&[cross(1.0), cross(2.0), cross(3.0)]), 3.0);
    }
}
