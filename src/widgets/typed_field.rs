//! A field for a number that keeps what was typed until it is one.

use crate::look::Look;
use eframe::egui::{
    Context, DragValue, Id, Key, Modifiers, Response, Stroke, Ui, accesskit::Invalid,
};
use std::cell::RefCell;

/// How a field reads and shows its number.
pub struct Typing<'a> {
    /// The number as it is now.
    pub value: f64,
    /// How a number is shown.
    pub shown: &'a dyn Fn(f64) -> String,
    /// What a text says; `None` if it is no number that is wanted here.
    pub read: &'a dyn Fn(&str) -> Option<f64>,
    /// What is wrong with a text, and what to do.
    pub wrong: &'a dyn Fn(&str) -> String,
}

/// What was typed into a field and is no number.
#[derive(Clone, Debug, Default)]
struct Kept {
    text: Option<String>,
    /// The number at that time, by its bits.
    value: u64,
    /// Whether the field was left since then.
    was_left: bool,
    /// Whether it was left by Escape; that frame may be drawn twice.
    is_given_up: bool,
}

/// Shows `field`, which may be dragged and typed into. What is typed and left there
/// without being a number stays in it, marked, and the field says what is wrong where
/// it is pointed at or edited: until it is mended, or given up by Escape, or the number
/// changes. The number itself stays as it was.
pub fn typed_field(
    ui: &mut Ui,
    look: &Look,
    field: DragValue<'_>,
    typing: &Typing<'_>,
) -> Response {
    let of_field = ui.next_auto_id().with("typed");
    let bits = typing.value.to_bits();
    let kept: Kept = ui.data(|data| data.get_temp(of_field)).unwrap_or_default();
    let mut kept = if kept.value == bits { kept } else { Kept::default() };
    let refused = kept.text.clone().filter(|_| kept.was_left);
    let last_read = RefCell::new(None);
    let field = field
        .custom_formatter(|x, _| match &refused {
            Some(text) if x == typing.value => text.clone(),
            Some(_) | None => (typing.shown)(x),
        })
        .custom_parser(|text| {
            let read = (typing.read)(text);
            let now = Kept {
                text: read.is_none().then(|| text.to_owned()),
                value: read.unwrap_or(typing.value).to_bits(),
                ..kept.clone()
            };
            *last_read.borrow_mut() = Some(now);
            read
        });
    let style = ui.style().clone();
    if refused.is_some() {
        let (stroke, visuals) = (Stroke::new(1.5, look.palette.rejected), ui.visuals_mut());
        visuals.override_text_color = Some(look.palette.rejected);
        visuals.selection.stroke = stroke;
        let widgets = &mut visuals.widgets;
        for state in [&mut widgets.inactive, &mut widgets.hovered, &mut widgets.active] {
            state.bg_stroke = stroke;
        }
    }
    let response = ui.add(field);
    ui.set_style(style);
    if let Some(now) = last_read.into_inner() {
        kept = now;
    }
    let mut said = None;
    if response.lost_focus() {
        if kept.is_given_up || ui.input(|input| input.key_pressed(Key::Escape)) {
            if kept.text.is_some() && !kept.is_given_up {
                // Nothing else is given up with it.
                ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
                said = Some(String::new());
            }
            kept = Kept { value: bits, is_given_up: true, ..Kept::default() };
        } else if let Some(text) = &kept.text {
            kept.was_left = true;
            if ui.input(|input| input.key_pressed(Key::Enter)) {
                // It is edited on, and says below itself what is wrong.
                response.request_focus();
            } else {
                said = Some((typing.wrong)(text));
            }
        }
    }
    if let Some(message) = said {
        ui.data_mut(|data| data.insert_temp(Id::unique(REFUSED), message));
    }
    kept.is_given_up &= !response.has_focus();
    let wrong = kept.text.as_deref().filter(|_| kept.was_left).map(typing.wrong);
    if refused != kept.text.clone().filter(|_| kept.was_left) {
        ui.ctx().request_repaint();
    }
    ui.data_mut(|data| data.insert_temp(of_field, kept));
    if let Some(wrong) = wrong {
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_invalid(Invalid::True);
            node.set_description(wrong.clone());
        });
        if response.has_focus() || response.hovered() {
            response.show_tooltip_text(wrong);
        }
    }
    response
}

/// What is wrong with what was typed into a field and just left there; empty if that was
/// just given up.
pub fn refused_number(context: &Context) -> Option<String> {
    context.data_mut(|data| data.remove_temp(Id::unique(REFUSED)))
}

const REFUSED: &str = "refused number";
