//! Parameters t of the planes of the current node, on one axis.

use crate::look::Look;
use crate::widgets::{acted_at, paint_figure, rich_label, room, step_slider};
use eframe::egui::{
    Align, Label, Layout, Pos2, RichText, Sense, Ui, UiBuilder, WidgetInfo, accesskit::Role, vec2,
};
use octoscope_core::event::Event;
use octoscope_core::explain::{Span, approx, shown_number};
use octoscope_core::trace::{Moment, Trace};
use octoscope_core::tree::{NodeId, Tree};
use octoscope_figure::DiagramOf;
use octoscope_figure::views::{RailFigure, RailRows, rail_of, t_rail, t_rail_height};

/// How rows are set in a lecture.
pub fn lecture_rows<const D: usize>() -> RailRows {
    // Three large ones would leave no room for formulas.
    if D == 2 { RailRows::Large } else { RailRows::Small }
}

/// Height of the rail in a lecture.
pub fn lecture_height<const D: usize>() -> f32 {
    height::<D>(lecture_rows::<D>())
}

/// Height of the rail with rows that are set like this.
fn height<const D: usize>(rows: RailRows) -> f32 {
    t_rail_height::<D>(rows) as f32
}

/// One bar per axis from t0 to t1 with tm; dragging goes to the leaf at that t. Returns what
/// is pointed at.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    trace: &Trace<D>,
    of: &DiagramOf<'_, D>,
    rows: RailRows,
) -> Pointed {
    let moment = of.moment;
    let title = look.text("panel-t-rail");
    let width = ui.available_width();
    let least = f64::from(look.least_type);
    let Some(rail) = t_rail(&look.texts, of, f64::from(width), rows, least) else {
        let size = vec2(width, height::<D>(rows));
        let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
        let hint = RichText::new(look.text("t-rail-none")).color(look.palette.quiet);
        let middle = UiBuilder::new().max_rect(rect).layout(Layout::top_down(Align::Center));
        let mut middle = ui.new_child(middle);
        middle.add_space(rect.height() / 2.0 - 20.0);
        middle.add(Label::new(hint).wrap());
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, title.as_str()));
        return Pointed::default();
    };
    let (rect, response) = room(ui, rail.figure.page, Sense::click_and_drag());
    let [enter, exit] = rail.limits;
    let spoken = match &rail.missed {
        Some(missed) => format!("{title}: {missed}"),
        None => format!(
            "{title}: {} {}, {} {}",
            look.text("t-rail-enter"),
            approx(enter),
            look.text("t-rail-exit"),
            approx(exit)
        ),
    };
    response.widget_info(|| WidgetInfo::labeled(Role::Slider, true, spoken.as_str()));
    paint_figure(ui, look, rect, &rail.figure);
    let response = response.on_hover_ui(|ui| digits(ui, look, &rail));
    let t_at = |pointer: Pos2| rail.t_at(f64::from(pointer.x - rect.left()));
    Pointed {
        step: match acted_at(&response) {
            Some(pointer) => Some(step_at(trace, t_at(pointer))),
            None => step_slider(ui, &response, moment.step, trace.events.len()),
        },
        node: response.hover_pos().and_then(|pointer| leaf_at(trace, t_at(pointer))),
    }
}

/// All parameters with all their digits.
fn digits(ui: &mut Ui, look: &Look, rail: &RailFigure) {
    for (name, t) in &rail.parameters {
        let mut text = name.clone();
        text.0.push(Span { text: format!(" = {}", shown_number(*t)), ..Span::default() });
        rich_label(ui, look, &text, 14.0, f32::INFINITY);
    }
    for (key, t) in ["t-rail-enter", "t-rail-exit"].into_iter().zip(rail.limits) {
        ui.label(format!("{} = {}", look.text(key), shown_number(t)));
    }
}

/// The node or the cell of which the rail tells.
pub fn note<const D: usize>(look: &Look, tree: &Tree<D>, moment: &Moment<D>) -> String {
    let of = rail_of(moment);
    of.map_or_else(String::new, |of| of.note(&look.texts, tree))
}

/// What is pointed at on the rail.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pointed {
    /// The step to go to, while it is dragged.
    pub step: Option<usize>,
    /// The leaf in which the ray is at this parameter.
    pub node: Option<NodeId>,
}

fn leaf_at<const D: usize>(trace: &Trace<D>, t: f64) -> Option<NodeId> {
    let mut leaves = trace.leaves();
    leaves.find(|(_, [enter, exit])| (*enter..*exit).contains(&t)).map(|(node, _)| node)
}

/// Number of events until the leaf in which the ray is at parameter `t`.
fn step_at<const D: usize>(trace: &Trace<D>, t: f64) -> usize {
    let past = |event: &Event<D>| matches!(event, Event::Leaf { exit, .. } if *exit > t);
    trace.events.iter().position(past).map_or(trace.events.len(), |index| index + 1)
}
