//! The trace as a ruler, with the keys of a player.

mod count;

use crate::command::Command;
use crate::look::Look;
use crate::playback::Playback;
use crate::shortcut;
use crate::widgets::{acted_at, hint_above, step_slider};
use count::Count;
use eframe::egui::{
    Color32, Painter, Pos2, Rangef, Rect, Response, RichText, Sense, Shape, Stroke, Ui, WidgetInfo,
    accesskit::Role, lerp, pos2, remap_clamp, vec2,
};
use octoscope_core::event::Event;
use octoscope_core::trace::Trace;
use octoscope_core::tree::NodeId;

/// Height of the row, in points.
pub const HEIGHT: f32 = 36.0;

/// What is marked on the ruler.
#[derive(Clone, Copy, Debug)]
pub struct Marked<'a> {
    /// The first step at which a misprint leads astray: a cross; a click goes there.
    pub first_wrong: Option<usize>,
    /// Steps that doubles would have made otherwise: a badge each.
    pub rounded: &'a [usize],
    /// The node that is pointed at somewhere: the events about it are lit.
    pub lit: Option<NodeId>,
}

/// Buttons and ruler, from left to right in a row of [`HEIGHT`]; dragging the ruler moves
/// the playhead. Hints lie above `bar`, in which the sentence is, too. Returns the node of
/// the event that is pointed at.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    trace: &Trace<D>,
    marked: Marked<'_>,
    playback: &mut Playback,
    bar: Rangef,
    commands: &mut Vec<Command>,
) -> Option<NodeId> {
    let play = if playback.playing { Icon::Pause } else { Icon::Play };
    for (icon, command) in [
        (Icon::First, Command::First),
        (Icon::Back, Command::StepBack),
        (play, Command::Play),
        (Icon::Forward, Command::StepForward),
        (Icon::Last, Command::Last),
    ] {
        if button(ui, look, icon, command, bar).clicked() {
            commands.push(command);
        }
    }
    // In a hall the ruler needs the room; the keys are there, too.
    if !look.is_for_hall() {
        speed(ui, look, playback, bar, commands);
    }
    let count = Count::of(ui, look, trace);
    let width = ui.available_width() - count.width() - 16.0;
    let pointed = ruler(ui, look, trace, marked, playback, bar, width.max(60.0));
    count.ui(ui, look, playback, bar);
    pointed
}

/// How fast it plays, between what makes it slower and faster.
fn speed(ui: &mut Ui, look: &Look, playback: &Playback, bar: Rangef, commands: &mut Vec<Command>) {
    let slower = ui.small_button("−");
    let slower = hint_above(ui, slower, bar, &look.text("command-slower"));
    slower.widget_info(|| WidgetInfo::labeled(Role::Button, true, look.text("command-slower")));
    let speed = format!("{} ×", playback.speed / Playback::default().speed);
    let speed = ui.label(RichText::new(speed).size(14.0));
    hint_above(ui, speed, bar, &look.text("timeline-speed"));
    let faster = ui.small_button("+");
    let faster = hint_above(ui, faster, bar, &look.text("command-faster"));
    faster.widget_info(|| WidgetInfo::labeled(Role::Button, true, look.text("command-faster")));
    if slower.clicked() {
        commands.push(Command::Slower);
    }
    if faster.clicked() {
        commands.push(Command::Faster);
    }
}

fn ruler<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    trace: &Trace<D>,
    marked: Marked<'_>,
    playback: &mut Playback,
    bar: Rangef,
    width: f32,
) -> Option<NodeId> {
    let Marked { first_wrong, rounded, lit } = marked;
    let length = trace.events.len();
    let (rect, response) = ui.allocate_exact_size(vec2(width, HEIGHT), Sense::click_and_drag());
    let track = rect.shrink2(vec2(8.0, 4.0));
    if let Some(pointer) = acted_at(&response) {
        let step = remap_clamp(pointer.x, track.x_range(), 0.0..=length as f32);
        playback.playing = false;
        playback.go_to(step.round() as usize, length);
    }
    let name = look.text("timeline-name");
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(Role::Slider, true, name.as_str());
        info.value = Some(playback.step as f64);
        info
    });
    if let Some(step) = step_slider(ui, &response, playback.step, length) {
        playback.playing = false;
        playback.go_to(step, length);
    }
    let painter = ui.painter_at(rect.expand(2.0));
    painter.hline(track.x_range(), track.center().y, Stroke::new(1.0, look.palette.grid));
    paint_ticks(&painter, look, trace, playback.step, track);
    paint_lit(&painter, look, trace, lit, track);
    for &step in rounded {
        let x = lerp(track.x_range(), step as f32 / length.max(1) as f32);
        paint_badge(&painter, look, pos2(x, track.bottom()));
    }
    let x = lerp(track.x_range(), playback.step as f32 / length.max(1) as f32);
    painter.vline(x, track.y_range(), Stroke::new(2.0, look.palette.ray));
    painter.circle_filled(pos2(x, track.top()), 5.5, look.palette.ray);
    if let Some(step) = first_wrong {
        let x = lerp(track.x_range(), step as f32 / length.max(1) as f32);
        if cross(ui, look, step, pos2(x, track.bottom() - 1.0), bar).clicked() {
            playback.playing = false;
            playback.go_to(step, length);
        }
    }
    let pointed = response.hover_pos().and_then(|pointer| {
        let step = remap_clamp(pointer.x, track.x_range(), 0.0..=length as f32).round() as usize;
        trace.events.get(step.checked_sub(1)?)?.node()
    });
    let mut why = look.text("timeline-why");
    if !rounded.is_empty() {
        why = format!("{why}\n{}", look.text("timeline-rounded"));
    }
    hint_above(ui, response, bar, &why);
    pointed
}

/// A cross below the tick of the first wrong step.
fn cross(ui: &Ui, look: &Look, step: usize, centre: Pos2, bar: Rangef) -> Response {
    let rect = Rect::from_center_size(centre, vec2(14.0, 14.0));
    let response = ui.interact(rect, ui.scope_id().with("first-wrong"), Sense::click());
    let name = look.texts.format("timeline-wrong", &[("step", step.into())]);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.as_str()));
    let painter = ui.painter();
    painter.circle_filled(centre, 7.0, look.palette.background);
    let wide = if response.hovered() || response.has_focus() { 3.0 } else { 2.0 };
    for arm in [vec2(4.0, 4.0), vec2(4.0, -4.0)] {
        let stroke = Stroke::new(wide, look.palette.rejected);
        painter.line_segment([centre - arm, centre + arm], stroke);
    }
    hint_above(ui, response, bar, &name)
}

/// Dots above the events about a node.
fn paint_lit<const D: usize>(
    painter: &Painter,
    look: &Look,
    trace: &Trace<D>,
    node: Option<NodeId>,
    track: Rect,
) {
    let length = trace.events.len().max(1);
    let about = |event: &Event<D>| node.is_some() && event.node() == node;
    let mut last = f32::NEG_INFINITY;
    for (index, _) in trace.events.iter().enumerate().filter(|(_, event)| about(event)) {
        let x = lerp(track.x_range(), (index + 1) as f32 / length as f32);
        if x - last >= 2.0 {
            last = x;
            let stroke = Stroke::new(1.6, look.palette.quiet);
            painter.circle_stroke(pos2(x, track.top() + 1.0), 3.0, stroke);
            painter.vline(x, track.y_range(), stroke);
        }
    }
}

/// A triangle below the tick of a step, that points at it.
fn paint_badge(painter: &Painter, look: &Look, tip: Pos2) {
    let corners = vec![tip - vec2(0.0, 5.0), tip + vec2(4.5, 3.0), tip + vec2(-4.5, 3.0)];
    painter.add(Shape::convex_polygon(corners, look.palette.accent, Stroke::NONE));
}

/// One tick an event; of crowded ones the tallest.
fn paint_ticks<const D: usize>(
    painter: &Painter,
    look: &Look,
    trace: &Trace<D>,
    step: usize,
    track: Rect,
) {
    /// Least distance of two ticks, and what ticks of the usual width have between them.
    const CLOSEST: f32 = 2.5;
    const LOOSE: f32 = 4.0;
    let length = trace.events.len();
    let distance = track.width() / length.max(1) as f32;
    let per_column = ((CLOSEST / distance).ceil() as usize).max(1);
    let width = if distance * per_column as f32 >= LOOSE { 2.0 } else { 1.0 };
    for (column, events) in trace.events.chunks(per_column).enumerate() {
        let tallest = events.iter().map(|event| tick(look, event));
        let tallest = tallest.max_by(|a, b| a.height().total_cmp(&b.height()));
        let Some(Tick { up, down, color }) = tallest else { continue };
        let n = column * per_column + events.len();
        let x = lerp(track.x_range(), n as f32 / length as f32);
        // Thin lines are crisp on whole pixels alone.
        let x = if width < 2.0 { painter.round_to_pixel_center(x) } else { x };
        let color = if n <= step { color } else { color.gamma_multiply(0.4) };
        let (reach, middle) = (track.height() * 0.5, track.center().y);
        painter.vline(x, middle - up * reach..=middle + down * reach, Stroke::new(width, color));
    }
}

/// What stands for an event on the ruler.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Tick {
    /// How far it goes up and down from the line, 0 to 1.
    up: f32,
    down: f32,
    color: Color32,
}

impl Tick {
    fn height(&self) -> f32 {
        self.up + self.down
    }
}

/// The tick of an event: its kind is in its height and its side, and in no colour that
/// means an axis.
fn tick<const D: usize>(look: &Look, event: &Event<D>) -> Tick {
    let palette = &look.palette;
    let even = |reach: f32, color| Tick { up: reach, down: reach, color };
    let computed = even(0.2, palette.quiet);
    match event {
        Event::Leaf { .. }
        | Event::Found { .. }
        | Event::Clip { .. }
        | Event::Sort { .. }
        | Event::End(_) => even(0.9, palette.ink),
        Event::Touch { .. } => even(0.7, palette.rejected),
        Event::Visit { .. }
        | Event::Enter { .. }
        | Event::Pop { .. }
        | Event::Mirror { .. }
        | Event::Facing { .. }
        | Event::Rope { .. }
        | Event::Follow { .. }
        | Event::Compare { .. } => Tick { up: 0.0, down: 0.6, color: palette.quiet },
        Event::First { .. }
        | Event::Step { .. }
        | Event::Classify { .. }
        | Event::Flip { .. }
        | Event::Split { .. }
        | Event::Exits { .. }
        | Event::Leave { .. }
        | Event::Target { .. }
        | Event::Push { .. } => even(0.4, palette.current_line),
        Event::Grid { .. } | Event::Cross { .. } => even(0.4, palette.current_line),
        Event::Difference { .. }
        | Event::Climb { .. }
        | Event::Resume { .. }
        | Event::Up { .. }
        | Event::Parent { .. } => Tick { up: 0.6, down: 0.0, color: palette.quiet },
        Event::Encode { .. } | Event::Corners { .. } | Event::Begin { .. } => computed,
        Event::Halve { .. } | Event::Cuts { .. } | Event::Skip { .. } => computed,
        Event::Border { .. } | Event::Test { .. } => computed,
    }
}

#[derive(Clone, Copy)]
enum Icon {
    First,
    Back,
    Play,
    Pause,
    Forward,
    Last,
}

/// Button with a drawn icon; its name and key are its tooltip.
fn button(ui: &mut Ui, look: &Look, icon: Icon, command: Command, bar: Rangef) -> Response {
    let (rect, response) = ui.allocate_exact_size(vec2(34.0, 34.0), Sense::click());
    let row = command.row();
    let name = look.text(row.id);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.as_str()));
    let visuals = ui.style().interact(&response);
    if response.hovered() || response.has_focus() {
        ui.painter().rect_filled(rect, 6.0, visuals.bg_fill);
    }
    if response.has_focus() {
        let stroke = Stroke::new(2.0, look.palette.axes[2]);
        ui.painter().rect_stroke(rect, 6.0, stroke, eframe::egui::StrokeKind::Inside);
    }
    if matches!(icon, Icon::Play | Icon::Pause) {
        // It runs on by itself: told from what goes by one step.
        ui.painter().circle_stroke(rect.center(), 15.0, Stroke::new(1.5, look.palette.ink));
    }
    paint_icon(ui.painter(), icon, rect.shrink(10.0), look.palette.ink);
    let hint = format!("{name} ({})", shortcut::all_shown(look, row.keys));
    hint_above(ui, response, bar, &hint)
}

fn paint_icon(painter: &Painter, icon: Icon, rect: Rect, color: Color32) {
    let triangle = |from: f32, tip: f32| {
        let x = |share: f32| lerp(rect.x_range(), share);
        let points = vec![
            pos2(x(from), rect.top()),
            pos2(x(tip), rect.center().y),
            pos2(x(from), rect.bottom()),
        ];
        Shape::convex_polygon(points, color, Stroke::NONE)
    };
    let bar = |at: f32| {
        let x = lerp(rect.x_range(), at);
        Shape::rect_filled(
            Rect::from_center_size(pos2(x, rect.center().y), vec2(3.0, rect.height())),
            1.0,
            color,
        )
    };
    match icon {
        Icon::First => painter.extend([bar(0.08), triangle(1.0, 0.2)]),
        Icon::Back => painter.extend([triangle(0.9, 0.1)]),
        Icon::Play => painter.extend([triangle(0.2, 0.95)]),
        Icon::Pause => painter.extend([bar(0.3), bar(0.7)]),
        Icon::Forward => painter.extend([triangle(0.1, 0.9)]),
        Icon::Last => painter.extend([triangle(0.0, 0.8), bar(0.92)]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::AnyDocument;
    use crate::open::open_built_in;
    use crate::theme;
    use octoscope_core::progress::Progress;
    use octoscope_core::text::Language;
    use octoscope_core::trace::record;
    use octoscope_core::traverse::Algorithm;
    use octoscope_figure::Theme;

    #[test]
    fn no_tick_has_the_colour_of_an_axis() {
        let document = open_built_in("quadtree-82", &Progress::default()).unwrap();
        let AnyDocument::Plane(document) = document else { panic!("not a quadtree") };
        for theme in Theme::ALL {
            let look = theme::look(Language::English, theme);
            for algorithm in Algorithm::ALL {
                let query = document.scenario.query.with_algorithm(algorithm);
                let trace = record(&document.tree, &document.scenario.ray, &query);
                for event in &trace.events {
                    let tick = tick(&look, event);
                    assert!(!look.palette.axes.contains(&tick.color), "{theme:?} {event:?}");
                }
            }
        }
    }
}
