//! One plane halves the current part, and its parameter decides.

use crate::look::Look;
use crate::widgets::caption;
use eframe::egui::{
    FontId, Painter, Pos2, Rect, RichText, Sense, Stroke, Ui, WidgetInfo, accesskit::Role, pos2,
    vec2,
};
use octoscope_core::event::{Event, Halves};
use octoscope_core::explain::approx;
use octoscope_core::geometry::AXIS_NAMES;

/// Form of the rule that decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Whatever the ray, only halves in which it has a length.
    Robust,
    /// As the gem compares.
    Gem,
}

/// The height that it takes in a lecture, in points.
pub const LECTURE_HEIGHT: f32 = 138.0;

/// What is decided by the parameter of a plane.
#[derive(Clone, Copy)]
struct Decision {
    axis: usize,
    plane: f64,
    /// The parameter of the plane.
    at: f64,
    /// That of the part that is halved.
    interval: [f64; 2],
    halves: Halves,
}

impl Decision {
    fn of<const D: usize>(event: &Event<D>) -> Option<Self> {
        let &Event::Split { axis, plane, at, interval, halves, .. } = event else { return None };
        Some(Self { axis: usize::from(axis), plane, at, interval, halves })
    }
}

/// The last decision: axis and plane, where its parameter lies on the part's
/// interval, and the halves that follow by the rule `form`. `past` are the events so
/// far.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, form: Form, past: &[Event<D>]) {
    let Some(decision) = past.iter().rev().find_map(Decision::of) else {
        caption(ui, look, look.text("halves-none"));
        return;
    };
    let Decision { axis, plane, at, interval, halves } = decision;
    let color = look.palette.axes[axis];
    let told = look.text(match halves {
        Halves::Near => "halves-near",
        Halves::Far => "halves-far",
        Halves::Both => "halves-both",
    });
    let why = match (form, halves) {
        (Form::Robust, Halves::Near) => "halves-near-why",
        (Form::Robust, Halves::Far) => "halves-far-why",
        (Form::Robust, Halves::Both) => "halves-both-why",
        (Form::Gem, Halves::Near) => "halves-gem-near-why",
        (Form::Gem, Halves::Far) => "halves-gem-far-why",
        (Form::Gem, Halves::Both) if at.is_nan() => "halves-gem-nan-why",
        (Form::Gem, Halves::Both) => "halves-gem-both-why",
    };
    ui.horizontal(|ui| {
        let text = format!("{} = {}", AXIS_NAMES[axis], approx(plane));
        let text = RichText::new(text).size(15.0).family(look.strong_family());
        ui.label(text.color(color));
        ui.add_space(8.0);
        let text = RichText::new(told.as_str()).size(15.0).family(look.strong_family());
        ui.label(text.color(look.palette.ink)).on_hover_text(look.text(why));
    });
    let size = vec2(ui.available_width(), 52.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let spoken =
        format!("t = {}, [{}, {}]: {told}", approx(at), approx(interval[0]), approx(interval[1]));
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, spoken.as_str()));
    bar(ui, look, rect, decision);
    caption(ui, look, look.text(why));
}

/// Where the plane lies on the bar, and what of the bar is to scale.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Scale {
    /// The t at the left and at the right of the bar.
    range: [f64; 2],
    /// The side on which the parameter of the plane lies beyond that, if it does: 0 left,
    /// 1 right.
    beyond: Option<usize>,
}

impl Scale {
    /// The interval, and the parameter as long as that leaves the interval a share of the
    /// bar that is seen.
    fn of([low, high]: [f64; 2], at: f64) -> Self {
        /// Of the bar the interval takes so much at least.
        const LEAST: f64 = 0.12;
        let range = [low.min(at), high.max(at)];
        if !at.is_nan() && (high - low) / (range[1] - range[0]) >= LEAST {
            return Self { range, beyond: None };
        }
        // What has no place counts as before, as the words say.
        let beyond = usize::from(at > high);
        Self { range: [low, high], beyond: Some(beyond) }
    }

    /// Place of a t on a bar between two places.
    fn place(&self, t: f64, [left, right]: [f32; 2]) -> f32 {
        let [low, high] = self.range;
        // An interval without a length has one place, the middle.
        let share = if high > low { (t - low) / (high - low) } else { 0.5 };
        left + share as f32 * (right - left)
    }
}

/// What of the bar is where, in points.
struct Places {
    /// Both ends of the interval.
    interval: [f32; 2],
    plane: f32,
    /// The middle of the break in the line to the plane, if that is broken.
    broken: Option<f32>,
}

impl Places {
    /// In a room between two places.
    fn of(Decision { at, interval, .. }: Decision, [left, right]: [f32; 2]) -> Self {
        /// Room at an end, and where a plane lies beyond a break.
        const ROOM: f32 = 24.0;
        const BROKEN: f32 = 44.0;
        /// From such a plane to the border.
        const BORDER: f32 = 6.0;
        let scale = Scale::of(interval, at);
        let room = |side: usize| if scale.beyond == Some(side) { BROKEN } else { ROOM };
        let ends = [left + room(0), right - room(1)];
        let [from, to] = interval.map(|t| scale.place(t, ends));
        let (plane, nearest) = match scale.beyond {
            None => {
                let plane = scale.place(at, ends);
                return Self { interval: [from, to], plane, broken: None };
            }
            Some(0) => (left + BORDER, from),
            Some(_) => (right - BORDER, to),
        };
        Self { interval: [from, to], plane, broken: Some(0.5 * (plane + nearest)) }
    }
}

/// The part's interval with the plane's parameter on it, or beside it, to scale; where that
/// would leave too little of the interval, the line to the plane is broken.
fn bar(ui: &Ui, look: &Look, rect: Rect, decision: Decision) {
    let palette = &look.palette;
    let painter = ui.painter_at(rect.expand(2.0));
    let places = Places::of(decision, [rect.left(), rect.right()]);
    let y = rect.top() + 25.0;
    painter.hline(rect.x_range(), y, Stroke::new(1.0, palette.grid));
    places.broken.into_iter().for_each(|x| broken(&painter, pos2(x, y), look));
    let [from, to] = places.interval;
    painter.hline(from..=to, y, Stroke::new(7.0, palette.quiet.gamma_multiply(0.45)));
    // Both halves are met on either side of the plane.
    let end = if decision.halves == Halves::Both { places.plane } else { to };
    painter.hline(from..=end, y, Stroke::new(7.0, palette.current_line));
    let stroke = Stroke::new(3.0, palette.axes[decision.axis]);
    painter.vline(places.plane, y - 11.0..=y + 11.0, stroke);
    numbers(&painter, look, rect, &places, decision);
}

/// The ends of the interval below the bar, and the parameter of the plane above it.
fn numbers(painter: &Painter, look: &Look, rect: Rect, places: &Places, decision: Decision) {
    let set = |text: String, color| {
        painter.layout_no_wrap(text, FontId::monospace(look.type_size(12.0)), color)
    };
    // The left end of what is to stand around a place.
    let left = |x: f32, wide: f32| {
        (x - 0.5 * wide).clamp(rect.left(), (rect.right() - wide).max(rect.left()))
    };
    let (quiet, own) = (look.palette.quiet, look.palette.axes[decision.axis]);
    let [low, high] = decision.interval.map(|t| set(approx(t), quiet));
    let below = rect.top() + 38.0;
    let at = left(places.interval[0], low.size().x);
    // Those of a short interval stand beside each other.
    let least = at + low.size().x + 10.0 + 0.5 * high.size().x;
    painter.galley(pos2(at, below), low, quiet);
    let at = left(places.interval[1].max(least), high.size().x);
    painter.galley(pos2(at, below), high, quiet);
    let plane = set(format!("t = {}", approx(decision.at)), own);
    let at = pos2(left(places.plane, plane.size().x), rect.top() + 13.0 - plane.size().y);
    painter.galley(at, plane, own);
}

/// Two strokes across a line, as where a drawing leaves something out.
fn broken(painter: &Painter, at: Pos2, look: &Look) {
    let palette = &look.palette;
    painter.hline(at.x - 2.5..=at.x + 2.5, at.y, Stroke::new(3.0, palette.panel));
    for by in [-2.5, 2.5] {
        let ends = [pos2(at.x + by - 2.0, at.y + 5.0), pos2(at.x + by + 2.0, at.y - 5.0)];
        painter.line_segment(ends, Stroke::new(1.5, palette.quiet));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_is_to_scale_or_says_that_it_is_not() {
        let ends = [0.0, 100.0];
        for at in [-3.0, 0.9, 1.0, 1.25, 1.9, 2.0, 4.0, 7.0] {
            let scale = Scale::of([1.0, 2.0], at);
            assert_eq!(scale.beyond, None, "{at}");
            let [a, b, x] = [1.0, 2.0, at].map(|t| scale.place(t, ends));
            let share = f64::from((x - a) / (b - a));
            assert!((share - (at - 1.0)).abs() < 1e-4, "{at}: {share}");
            assert!([a, b, x].iter().all(|x| (-0.01..=100.01).contains(x)), "{at}");
        }
        let beyond = |at: f64| Scale::of([1.0, 1.01], at).beyond;
        assert_eq!([-5.0, 0.0, 2.0, 1e9].map(beyond), [Some(0), Some(0), Some(1), Some(1)]);
        let unbounded = [f64::NEG_INFINITY, f64::NAN, f64::INFINITY].map(beyond);
        assert_eq!(unbounded, [Some(0), Some(0), Some(1)]);
    }
}
