//! A number of a known range that can be dragged and typed.

use super::number_field::{number, parse};
use super::typed_field::{Edited, Typing, typed_field};
use crate::look::Look;
use eframe::egui::accesskit::Role;
use eframe::egui::emath::Numeric;
use eframe::egui::{DragValue, Response, SliderClamping, Ui, WidgetInfo};

/// The largest seed that a field takes: larger whole numbers are not all in its numbers.
pub const MOST_SEED: u64 = 1 << 53;

/// Field for a number of type `N`, whole or not, from the first to the last of `range`,
/// called `name` by a screen reader; dragging changes it by `drag_speed` a point.
pub fn ranged_field<N: Numeric>(
    ui: &mut Ui,
    look: &Look,
    name: &str,
    value: &mut N,
    range: [N; 2],
    drag_speed: f64,
) -> Response {
    field_in_range(ui, look, name, value, range, drag_speed, SliderClamping::Always)
}

/// The same; what becomes of a number that was outside of the range before, `clamping`
/// says.
pub(super) fn field_in_range<N: Numeric>(
    ui: &mut Ui,
    look: &Look,
    name: &str,
    value: &mut N,
    range: [N; 2],
    drag_speed: f64,
    clamping: SliderClamping,
) -> Response {
    let now = value.to_f64();
    let [least, most] = range.map(N::to_f64);
    let read = |text: &str| {
        let is_wanted = |x: &f64| (least..=most).contains(x) && (!N::INTEGRAL || x.fract() == 0.0);
        parse(text).filter(is_wanted)
    };
    let wrong = |typed: &str| {
        let key = if N::INTEGRAL { "whole-refused" } else { "range-refused" };
        let typed = ("typed", typed.trim().to_owned().into());
        let ends = [("least", number(least).into()), ("most", number(most).into())];
        look.texts.format(key, &[vec![typed], ends.to_vec()].concat())
    };
    let decimals = if N::INTEGRAL { 0 } else { 2 };
    let typing = Typing { value: now, shown: &|x| number(x), read: &read, wrong: &wrong };
    let field = DragValue::new(value).range(range[0]..=range[1]).speed(drag_speed);
    let field = field.clamp_existing_to_range(clamping == SliderClamping::Always);
    let Edited { response, restored } =
        typed_field(ui, look, field.max_decimals(decimals), &typing);
    if let Some(restored) = restored {
        *value = N::from_f64(restored);
    }
    let value = value.to_f64();
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(Role::SpinButton, true, name);
        info.value = Some(value);
        info
    });
    response
}
