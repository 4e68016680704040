//! A number that can be dragged and typed.

use super::typed_field::{Edited, Typing, typed_field};
use crate::look::Look;
use eframe::egui::{
    Color32, DragValue, FontId, Layout, Response, Ui, WidgetInfo,
    accesskit::Role,
    text::{CCursor, CCursorRange},
    text_edit::TextEditState,
    vec2,
};
use octoscope_core::explain::{signed_number, with_minus};

/// Room between a number and the border of its field.
const PADDING: f32 = 8.0;

/// `x` as short as it reads back, with the minus that is shown everywhere; a field takes
/// the one of the keyboard as well.
pub(super) fn number(x: f64) -> String {
    with_minus(signed_number(x))
}

/// Field for a number in `color`, called `name` by a screen reader. It takes
/// decimals, fractions such as 3/4 and hexadecimal floats such as 0x1.8p-1. A
/// number too long for it is cut short, until it is edited.
pub fn number_field(
    ui: &mut Ui,
    look: &Look,
    name: &str,
    value: &mut f64,
    drag_speed: f64,
    color: Color32,
) -> Response {
    let mut edited = *value;
    let size = vec2(ui.available_width().min(110.0), 24.0);
    let layout = Layout::centered_and_justified(ui.layout().main_dir());
    let Edited { response, restored } = ui
        .allocate_ui_with_layout(size, layout, |ui| {
            ui.visuals_mut().override_text_color = Some(color);
            ui.spacing_mut().button_padding.x = PADDING / 2.0;
            let id = ui.next_auto_id();
            let is_edited = ui.memory(|memory| memory.has_focus(id));
            let short = if is_edited { number(*value) } else { fitting(ui, *value, size.x) };
            let typing = Typing {
                value: *value,
                shown: &|x| if x == *value { short.clone() } else { number(x) },
                read: &parse,
                wrong: &|typed| wrong(look, typed),
            };
            let field = DragValue::new(&mut edited).speed(drag_speed).max_decimals(6);
            let typed = typed_field(ui, look, field.clip_text(true), &typing);
            if typed.response.clicked() {
                // The toolkit selects as much as it has shown, which may be less.
                let all = CCursorRange::two(CCursor::new(0), CCursor::new(usize::MAX));
                let mut state =
                    TextEditState::load(ui.ctx(), typed.response.id).unwrap_or_default();
                state.cursor.set_char_range(Some(all));
                state.store(ui.ctx(), typed.response.id);
            }
            typed
        })
        .inner;
    if response.changed() && edited.is_finite() {
        *value = edited;
    }
    *value = restored.unwrap_or(*value);
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(Role::SpinButton, true, name);
        info.value = Some(*value);
        info
    });
    response.on_hover_text(format!("{name} = {}", number(*value)))
}

/// What is wrong with a text that is no number.
fn wrong(look: &Look, typed: &str) -> String {
    match typed.trim() {
        "" => look.text("number-missing"),
        typed => look.texts.format("number-refused", &[("typed", typed.to_owned().into())]),
    }
}

/// `x` as short as it reads back, or, where a field of this width has no room for
/// that, with dots instead of its last digits.
fn fitting(ui: &Ui, x: f64, width: f32) -> String {
    let font = FontId::proportional(15.0);
    let fits = |text: &str| {
        let galley = ui.painter().layout_no_wrap(text.to_owned(), font.clone(), Color32::BLACK);
        galley.size().x <= width - PADDING
    };
    shortened(x, fits)
}

/// `x` as short as it reads back, or with dots for digits, as many as `fits` allows.
fn shortened(x: f64, fits: impl Fn(&str) -> bool) -> String {
    let whole = number(x);
    if fits(&whole) || !x.is_finite() {
        return whole;
    }
    // Only digits behind the point may be missing, and never the exponent.
    let cut = |text: &str| {
        let (mantissa, exponent) = text.find('e').map_or((text, ""), |at| text.split_at(at));
        let point = mantissa.find('.')?;
        let ends = (point + 2..mantissa.len()).rev().chain([point]);
        ends.map(|end| format!("{}…{exponent}", &mantissa[..end])).find(|text| fits(text))
    };
    let scientific = with_minus(format!("{x:e}"));
    cut(&whole).or_else(|| cut(&scientific)).unwrap_or_else(|| "…".to_owned())
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
    use super::{number, parse, shortened};

    #[test]
    fn a_shown_number_has_the_minus_of_the_texts_and_reads_back() {
        for (x, shown) in [(-0.16, "−0.16"), (-1e-300, "−1e−300"), (-0.0, "−0")] {
            assert_eq!(number(x), shown);
            assert_eq!(parse(shown).map(f64::to_bits), Some(x.to_bits()));
        }
    }

    #[test]
    fn numbers_are_read_in_three_notations() {
        assert_eq!(parse(" 0.25 "), Some(0.25));
        assert_eq!(parse("−3/4"), Some(-0.75));
        assert_eq!(parse("0x1.8p-1"), Some(0.75));
        assert_eq!(parse("1,5"), Some(1.5));
        assert_eq!(parse("-0.0").map(f64::to_bits), Some((-0.0f64).to_bits()));
    }

    #[test]
    fn a_long_number_loses_only_digits_that_it_can_spare() {
        let check = |x, shown| {
            assert_eq!(shortened(x, |text: &str| text.chars().count() <= 9), shown);
        };
        check(0.25, "0.25");
        check(1.0 / 3.0, "0.333333…");
        check(-200.0 / 3.0, "−66.6666…");
        check(1.0 / 3.0 * 1e-300, "3.3…e−301");
        check(1_234_567_890_123.0, "1.234…e12");
        check(-1.234_567e-300, "−1…e−300");
    }

    #[test]
    fn nonsense_is_no_number() {
        for text in ["", "x", "1/0", "inf", "nan", "1/2/3"] {
            assert_eq!(parse(text), None, "{text}");
        }
    }
}
