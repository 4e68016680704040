//! A number that can be dragged and typed.

use eframe::egui::{Color32, DragValue, Response, RichText, Ui, WidgetInfo, accesskit::Role};
use octoscope_core::explain::number;

/// Field for a number in `color`, called `name` by a screen reader. It takes
/// decimals, fractions such as 3/4 and hexadecimal floats such as 0x1.8p-1.
pub fn number_field(
    ui: &mut Ui,
    name: &str,
    value: &mut f64,
    drag_speed: f64,
    color: Color32,
) -> Response {
    let mut edited = *value;
    let response = ui
        .scope(|ui| {
            ui.visuals_mut().override_text_color = Some(color);
            let field = DragValue::new(&mut edited)
                .speed(drag_speed)
                .max_decimals(6)
                .custom_formatter(|x, _| number(x))
                .custom_parser(parse);
            ui.add_sized([ui.available_width().min(110.0), 24.0], field)
        })
        .inner;
    if response.changed() && edited.is_finite() {
        *value = edited;
    }
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(Role::SpinButton, true, name);
        info.value = Some(*value);
        info
    });
    response.on_hover_text(RichText::new(name))
}

/// A decimal, a fraction or a hexadecimal float.
pub fn parse(text: &str) -> Option<f64> {
    let text = text.trim().replace('−', "-");
    let number = match text.split_once('/') {
        Some((above, below)) => simple(above)? / simple(below)?,
        None => simple(&text)?,
    };
    number.is_finite().then_some(number)
}

fn simple(text: &str) -> Option<f64> {
    let text = text.trim();
    octoscope_import::hexadecimal(text).or_else(|| text.replace(',', ".").parse().ok())
}

#[cfg(test)]
mod tests {
    use super::parse;

    #[test]
    fn numbers_are_read_in_three_notations() {
        assert_eq!(parse(" 0.25 "), Some(0.25));
        assert_eq!(parse("−3/4"), Some(-0.75));
        assert_eq!(parse("0x1.8p-1"), Some(0.75));
        assert_eq!(parse("1,5"), Some(1.5));
        assert_eq!(parse("-0.0").map(f64::to_bits), Some((-0.0f64).to_bits()));
    }

    #[test]
    fn nonsense_is_no_number() {
        for text in ["", "x", "1/0", "inf", "nan", "1/2/3"] {
            assert_eq!(parse(text), None, "{text}");
        }
    }
}
