//! Parameters t of the planes of the current node, on one axis.

use crate::look::Look;
use crate::widgets::{paint_figure, room};
use eframe::egui::{Label, RichText, Sense, Ui, WidgetInfo, accesskit::Role, vec2};
use octoscope_core::event::Event;
use octoscope_core::explain::approx;
use octoscope_core::trace::{Moment, Trace};
use octoscope_figure::views::t_rail;

/// One bar per axis from t0 to t1 with tm, in rows of height `row`; dragging goes to the leaf at that t.
/// Returns the step to go to.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    trace: &Trace<D>,
    moment: &Moment<D>,
    row: f32,
) -> Option<usize> {
    let title = look.text("panel-t-rail");
    let width = ui.available_width();
    let Some(rail) = t_rail(&look.texts, moment, [f64::from(width), f64::from(row)]) else {
        let size = vec2(width, row * D as f32 + 34.0);
        let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
        let hint = RichText::new(look.text("t-rail-none")).color(look.palette.quiet);
        ui.put(rect, Label::new(hint).wrap());
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, title.as_str()));
        return None;
    };
    let (rect, response) = room(ui, rail.figure.page, Sense::click_and_drag());
    let [enter, exit] = rail.interval;
    let spoken = format!(
        "{title}: {} {}, {} {}",
        look.text("t-rail-enter"),
        approx(enter),
        look.text("t-rail-exit"),
        approx(exit)
    );
    response.widget_info(|| WidgetInfo::labeled(Role::Slider, true, spoken.as_str()));
    paint_figure(ui, look, rect, &rail.figure);
    let pointer = response.interact_pointer_pos()?;
    Some(step_at(trace, rail.t_at(f64::from(pointer.x - rect.left()))))
}

/// Number of events until the leaf in which the ray is at parameter `t`.
fn step_at<const D: usize>(trace: &Trace<D>, t: f64) -> usize {
    let past = |event: &Event<D>| matches!(event, Event::Leaf { exit, .. } if *exit > t);
    trace.events.iter().position(past).map_or(trace.events.len(), |index| index + 1)
}
