//! One plane halves the current part, and its parameter decides.

use crate::look::Look;
use crate::widgets::caption;
use eframe::egui::{
    Align2, FontId, Pos2, Rect, RichText, Sense, Stroke, Ui, WidgetInfo, accesskit::Role, pos2,
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

/// The last decision: axis and plane, where its parameter lies on the part's
/// interval, and the halves that follow by the rule `form`. `past` are the events so
/// far.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, form: Form, past: &[Event<D>]) {
    let last = past.iter().rev().find_map(|event| {
        if let &Event::Split { axis, plane, at, interval, halves, .. } = event {
            Some((usize::from(axis), plane, at, interval, halves))
        } else {
            None
        }
    });
    let Some((axis, plane, at, interval, halves)) = last else {
        caption(ui, look, look.text("halves-none"));
        return;
    };
    let color = look.palette.axes[axis];
    let decision = look.text(match halves {
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
        let text = RichText::new(decision.as_str()).size(15.0).family(look.strong_family());
        ui.label(text.color(look.palette.ink)).on_hover_text(look.text(why));
    });
    let size = vec2(ui.available_width(), 52.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let spoken = format!(
        "t = {}, [{}, {}]: {decision}",
        approx(at),
        approx(interval[0]),
        approx(interval[1])
    );
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, spoken.as_str()));
    bar(ui, look, rect, at, interval, axis, halves);
    caption(ui, look, look.text(why));
}

/// The part's interval with the plane's parameter on it, or beside it.
fn bar(ui: &Ui, look: &Look, rect: Rect, at: f64, interval: [f64; 2], axis: usize, halves: Halves) {
    let palette = &look.palette;
    let painter = ui.painter_at(rect.expand(2.0));
    let [low, high] = interval;
    // A quarter of the width on either side is for what lies beyond.
    let inside = rect.shrink2(vec2(rect.width() * 0.22, 0.0));
    let y = rect.top() + 25.0;
    let share = ((at - low) / (high - low)) as f32;
    let x = if at.is_nan() || at == f64::NEG_INFINITY {
        rect.left() + 6.0
    } else {
        inside.left() + share.clamp(-0.3, 1.3) * inside.width()
    };
    let x = x.clamp(rect.left() + 6.0, rect.right() - 6.0);
    painter.hline(rect.x_range(), y, Stroke::new(1.0, palette.grid));
    painter.hline(inside.x_range(), y, Stroke::new(7.0, palette.quiet.gamma_multiply(0.45)));
    // Both halves are met on either side of the plane.
    if halves == Halves::Both {
        painter.hline(inside.left()..=x, y, Stroke::new(7.0, palette.current_line));
    } else {
        painter.hline(inside.x_range(), y, Stroke::new(7.0, palette.current_line));
    }
    painter.vline(x, y - 11.0..=y + 11.0, Stroke::new(3.0, palette.axes[axis]));
    let write = |at: Pos2, align: Align2, text: String, color| {
        painter.text(at, align, text, FontId::monospace(look.type_size(12.0)), color);
    };
    write(pos2(inside.left(), y + 13.0), Align2::CENTER_TOP, approx(low), palette.quiet);
    write(pos2(inside.right(), y + 13.0), Align2::CENTER_TOP, approx(high), palette.quiet);
    let align = if x < inside.left() {
        Align2::LEFT_BOTTOM
    } else if x > inside.right() {
        Align2::RIGHT_BOTTOM
    } else {
        Align2::CENTER_BOTTOM
    };
    let text = format!("t = {}", approx(at));
    write(pos2(x, y - 12.0), align, text, palette.axes[axis]);
}
