//! Parameters t of the planes of the current node, on one axis.

use crate::look::Look;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{
    Align, Align2, Color32, FontId, Label, Layout, Painter, Rect, RichText, Sense, Stroke, Ui,
    UiBuilder, WidgetInfo, accesskit::Role, pos2, vec2,
};
use octoscope_core::event::Event;
use octoscope_core::explain::{approx, number};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::trace::{Moment, Trace};

/// What the rail shows of a node.
struct Rail<const D: usize> {
    /// How the ends of the bars are called, where they are planes and not only
    /// the ends of an interval.
    ends: [Option<&'static str>; 2],
    near: [f64; D],
    mid: Option<[f64; D]>,
    far: [f64; D],
}

/// Names of the near and the far plane.
const PLANES: [Option<&str>; 2] = [Some("0"), Some("1")];

/// Where the ray comes into the root.
fn entered<const D: usize>(moment: &Moment<D>) -> f64 {
    let near = moment.clip.map_or([0.0; D], |clip| clip.near);
    near.into_iter().fold(0.0, f64::max)
}

impl<const D: usize> Rail<D> {
    /// Of the node on top of the stack, of the leaf that is left, or of the root.
    fn of(moment: &Moment<D>) -> Option<Self> {
        if let Some(frame) = moment.frame() {
            return Some(match frame.planes() {
                Some([near, far]) => Self { ends: PLANES, near, mid: frame.mid, far },
                None => Self::interval([frame.enter(), frame.exit()], frame.mid),
            });
        }
        if let Some(interval) = moment.part.and(moment.part_interval) {
            return Some(Self::interval(interval, None));
        }
        if let Some(grid) = moment.grid {
            // From where the ray was last to the planes ahead.
            let left = moment.leaves.last().map(|leaf| leaf.exit);
            let near = [left.unwrap_or_else(|| entered(moment)); D];
            return Some(Self { ends: [None, Some("max")], near, mid: None, far: grid.next });
        }
        if let Some(exits) = moment.exits {
            let enter = moment.leaves.last().map_or(0.0, |leaf| leaf.enter);
            let near = [enter; D];
            return Some(Self { ends: PLANES, near, mid: None, far: exits.exits });
        }
        let clip = moment.clip?;
        Some(Self { ends: PLANES, near: clip.near, mid: None, far: clip.far })
    }

    /// Of a node of which only the interval is known in which the ray is in it.
    fn interval([enter, exit]: [f64; 2], mid: Option<[f64; D]>) -> Self {
        Self { ends: [None; 2], near: [enter; D], mid, far: [exit; D] }
    }

    fn enter(&self) -> f64 {
        self.near.into_iter().fold(f64::NEG_INFINITY, f64::max)
    }

    fn exit(&self) -> f64 {
        self.far.into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Range of t that is shown: all finite parameters and the origin, with a margin.
    fn range(&self) -> [f64; 2] {
        let mids = self.mid.into_iter().flatten();
        let all = self.near.into_iter().chain(self.far).chain(mids);
        let finite: Vec<f64> = all.filter(|t| t.is_finite()).collect();
        let low = finite.iter().copied().fold(f64::INFINITY, f64::min);
        let high = finite.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if low > high {
            return [0.0, 1.0];
        }
        // Term by term, as the whole length may be larger than any number.
        let margin = (high * 0.08 - low * 0.08).max(f64::EPSILON * high.abs().max(1.0) * 16.0);
        [(low - margin).max(f64::MIN), (high + margin).min(f64::MAX)]
    }
}

/// Where `t` lies between `low` and `high`, from 0 to 1; halved, as the whole
/// length may be larger than any number.
fn share_of(t: f64, [low, high]: [f64; 2]) -> f64 {
    ((t / 2.0 - low / 2.0) / (high / 2.0 - low / 2.0)).clamp(0.0, 1.0)
}

/// The parameter at this share of the way from `low` to `high`.
fn at_share(share: f64, [low, high]: [f64; 2]) -> f64 {
    low * (1.0 - share) + high * share
}

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
    let size = vec2(ui.available_width(), row * D as f32 + 34.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    let Some(rail) = Rail::of(moment) else {
        let hint = RichText::new(look.text("t-rail-none")).color(look.palette.quiet);
        let middle = UiBuilder::new().max_rect(rect).layout(Layout::top_down(Align::Center));
        let mut middle = ui.new_child(middle);
        middle.add_space(rect.height() / 2.0 - 20.0);
        middle.add(Label::new(hint).wrap());
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, title.as_str()));
        return None;
    };
    let range = rail.range();
    let [low, high] = range;
    let track = Rect::from_min_max(
        pos2(rect.left() + 24.0, rect.top()),
        rect.right_bottom() - vec2(8.0, 0.0),
    );
    let x_of = |t: f64| track.left() + share_of(t, range) as f32 * track.width();
    let (enter, exit) = (rail.enter(), rail.exit());
    let spoken = format!(
        "{title}: {} {}, {} {}",
        look.text("t-rail-enter"),
        approx(enter),
        look.text("t-rail-exit"),
        approx(exit)
    );
    response.widget_info(|| WidgetInfo::labeled(Role::Slider, true, spoken.as_str()));
    let painter = ui.painter_at(rect);

    // The interval in which the ray is inside.
    let bars = Rect::from_min_max(rect.min, pos2(rect.right(), rect.top() + row * D as f32));
    if enter < exit {
        let inside = Rect::from_x_y_ranges(x_of(enter)..=x_of(exit), bars.y_range());
        painter.rect_filled(inside, 0.0, look.palette.current_fill);
    }
    for (t, key, align) in
        [(enter, "t-rail-enter", Align2::LEFT_TOP), (exit, "t-rail-exit", Align2::RIGHT_TOP)]
    {
        if !t.is_finite() {
            continue;
        }
        let x = x_of(t);
        let dashes = eframe::egui::Shape::dashed_line(
            &[pos2(x, bars.top()), pos2(x, bars.bottom())],
            Stroke::new(1.5, look.palette.ink),
            4.0,
            3.0,
        );
        painter.extend(dashes);
        let side = if align == Align2::LEFT_TOP { track.left() } else { track.right() };
        let text = format!("{} {}", look.text(key), approx(t));
        let at = pos2(side, bars.bottom() + 20.0);
        painter.text(at, align, text, FontId::monospace(12.0), look.palette.quiet);
    }
    // After the dashed lines, which would cross the labels.
    for axis in 0..D {
        let y = rect.top() + row * (axis as f32 + 0.5) - 8.0;
        paint_axis(&painter, look, &rail, axis, y, &x_of, rect.left());
    }
    let ground = bars.bottom() + 3.0;
    painter.hline(track.x_range(), ground, Stroke::new(1.0, look.palette.grid));
    if low < 0.0 && high > 0.0 {
        painter.circle_filled(pos2(x_of(0.0), ground), 3.5, look.palette.ray);
        let font = FontId::monospace(11.0);
        painter.text(
            pos2(x_of(0.0), ground + 4.0),
            Align2::CENTER_TOP,
            "0",
            font,
            look.palette.ray,
        );
    }

    let response = response.on_hover_ui(|ui| digits(ui, look, &rail));
    let pointer = response.interact_pointer_pos()?;
    let share = f64::from((pointer.x - track.left()) / track.width()).clamp(0.0, 1.0);
    Some(step_at(trace, at_share(share, range)))
}

/// All parameters with all their digits.
fn digits<const D: usize>(ui: &mut Ui, look: &Look, rail: &Rail<D>) {
    for axis in 0..D {
        let mid = rail.mid.map_or(f64::NAN, |mid| mid[axis]);
        let [first, last] = rail.ends.map(Option::unwrap_or_default);
        for (t, which) in [(rail.near[axis], first), (mid, "m"), (rail.far[axis], last)] {
            if !t.is_nan() && !which.is_empty() {
                let name = format!("{}{which}", AXIS_NAMES[axis]);
                let value = format!(" = {}", number(t));
                ui.label(parameter_job(&name, &value, look.palette.axes[axis]));
            }
        }
    }
    for (key, t) in [("t-rail-enter", rail.enter()), ("t-rail-exit", rail.exit())] {
        ui.label(format!("{} = {}", look.text(key), number(t)));
    }
}

fn paint_axis<const D: usize>(
    painter: &Painter,
    look: &Look,
    rail: &Rail<D>,
    axis: usize,
    y: f32,
    x_of: &impl Fn(f64) -> f32,
    left: f32,
) {
    let color = look.palette.axes[axis];
    let font = FontId::new(14.0, look.strong_family());
    painter.text(pos2(left, y), Align2::LEFT_CENTER, AXIS_NAMES[axis], font, color);
    let (near, far) = (rail.near[axis], rail.far[axis]);
    if near < far {
        painter.hline(x_of(near)..=x_of(far), y, Stroke::new(5.0, color));
    }
    let [first, last] = rail.ends.map(|name| name.unwrap_or_default());
    let middle = rail.mid.map_or(f64::NAN, |mid| mid[axis]);
    let marks = [(near, first), (middle, "m"), (far, last)];
    let mut labels_end = f32::NEG_INFINITY;
    for (t, which) in marks {
        if t.is_nan() || which.is_empty() {
            continue;
        }
        let x = x_of(t);
        if t.is_finite() {
            painter.vline(x, y - 8.0..=y + 8.0, Stroke::new(2.0, color));
        } else {
            let tip = if t > 0.0 { 7.0 } else { -7.0 };
            painter.arrow(pos2(x - tip, y), vec2(tip, 0.0), Stroke::new(2.0, color));
        }
        // t with its subscript, and the value where there is room.
        let name = format!("{}{which}", AXIS_NAMES[axis]);
        for value in [format!(" {}", approx(t)), String::new()] {
            let galley = painter.layout_job(parameter_job(&name, &value, color));
            let wide = galley.size().x;
            // In a panel too narrow for it, the label begins at the left all the same.
            let last = painter.clip_rect().right() - wide - 2.0;
            let start = (x - wide / 2.0).min(last).max(left + 18.0);
            if start > labels_end + 6.0 {
                labels_end = start + wide;
                let at = pos2(start, y + 9.0);
                let behind = Rect::from_min_size(at, galley.size()).expand2(vec2(2.0, 0.0));
                painter.rect_filled(behind, 2.0, look.palette.panel);
                painter.galley(at, galley, color);
                break;
            }
        }
    }
}

/// t with a subscript, and a value after it.
fn parameter_job(name: &str, value: &str, color: Color32) -> LayoutJob {
    let mut job = LayoutJob::default();
    for (text, size, valign) in
        [("t", 13.0, Align::Center), (name, 10.0, Align::BOTTOM), (value, 12.0, Align::Center)]
    {
        let font_id = FontId::proportional(size);
        job.append(text, 0.0, TextFormat { font_id, color, valign, ..TextFormat::default() });
    }
    job
}

/// Number of events until the leaf in which the ray is at parameter `t`.
fn step_at<const D: usize>(trace: &Trace<D>, t: f64) -> usize {
    let past = |event: &Event<D>| matches!(event, Event::Leaf { exit, .. } if *exit > t);
    trace.events.iter().position(past).map_or(trace.events.len(), |index| index + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rail(near: f64, far: f64) -> Rail<2> {
        Rail { ends: PLANES, near: [near; 2], mid: None, far: [far; 2] }
    }

    #[test]
    fn the_largest_parameters_lie_at_different_places_of_the_rail() {
        for reach in [1e308, f64::MAX] {
            let range = rail(-reach, reach).range();
            assert!(range.iter().all(|t| t.is_finite()), "{range:?}");
            let [near, middle, far] = [-reach, 0.0, reach].map(|t| share_of(t, range));
            assert!(
                near < 0.1 && (middle - 0.5).abs() < 1e-12 && far > 0.9,
                "{near} {middle} {far}"
            );
            assert!(at_share(0.75, range) > at_share(0.25, range));
        }
    }

    #[test]
    fn the_rail_shows_something_on_both_sides_of_a_single_parameter() {
        for t in [0.0, 1.0, -7e200] {
            let range = rail(t, t).range();
            assert!(range[0] < t && t < range[1], "{range:?}");
        }
        assert_eq!(rail(f64::NEG_INFINITY, f64::INFINITY).range(), [0.0, 1.0]);
    }
}
