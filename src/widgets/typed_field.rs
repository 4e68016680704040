//! A field for a number that keeps what was typed until it is one.

use super::fields::{outline_if_edited, while_edited};
use super::number_field::number;
use crate::look::Look;
use eframe::egui::{
    Color32, Context, DragValue, Id, Key, Modifiers, Response, Stroke, Ui, accesskit::Invalid,
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
    /// Whether it was confirmed as if it were one.
    is_confirmed: bool,
    /// Whether it was left by Escape; that frame may be drawn twice.
    is_given_up: bool,
}

impl Kept {
    /// What was confirmed although it is no number.
    fn refused(&self) -> Option<&str> {
        self.text.as_deref().filter(|_| self.is_confirmed)
    }
}

/// What a field has come to.
pub struct Edited {
    /// The field.
    pub response: Response,
    /// The number that is to hold again, because what was typed after it was given up or
    /// is no number.
    pub restored: Option<f64>,
}

/// Shows `field`, which may be dragged and typed into. What is confirmed by Enter without
/// being a number stays in it, marked, and is edited on until it is mended, or given up by
/// Escape, or the field is left, or the number changes; what is wrong is said
/// ([`refused_number`]). Whatever ends that, the number is then what it was before.
pub fn typed_field(ui: &mut Ui, look: &Look, field: DragValue<'_>, typing: &Typing<'_>) -> Edited {
    let field_id = ui.next_auto_id();
    let of_field = field_id.with("typed");
    let before = before_editing(ui, field_id, typing.value);
    let kept: Kept = ui.data(|data| data.get_temp(of_field)).unwrap_or_default();
    let kept = if kept.value == typing.value.to_bits() { kept } else { Kept::default() };
    let Shown { response, is_left, read } = show(ui, look, field, typing, &kept);
    let read = read.unwrap_or_else(|| kept.clone());
    let Ended { kept: mut now, mut said, restored } = match is_left {
        true => ended(ui, look, &response, typing, before, read),
        false => Ended { kept: read, said: None, restored: None },
    };
    now.is_given_up &= !response.has_focus();
    if kept.refused() != now.refused() {
        ui.ctx().request_repaint();
    }
    if let Some(text) = now.refused() {
        let wrong = told(look, typing, text, now.value, "number-meanwhile");
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_invalid(Invalid::True);
            node.set_description(wrong.clone());
        });
        said = Some(wrong);
    } else if kept.refused().is_some() && said.is_none() {
        // It is mended.
        said = Some(String::new());
    }
    ui.data_mut(|data| data.insert_temp(of_field, now));
    if let Some(said) = said {
        ui.data_mut(|data| data.insert_temp(Id::unique(REFUSED), said));
    }
    Edited { response, restored }
}

/// A field as it was shown.
struct Shown {
    response: Response,
    /// Whether it was left in this frame.
    is_left: bool,
    /// What is typed in it, if anything was read.
    read: Option<Kept>,
}

/// Shows a field with the text that was refused, if one was, else with its number.
fn show(ui: &mut Ui, look: &Look, field: DragValue<'_>, typing: &Typing<'_>, kept: &Kept) -> Shown {
    let last_read = RefCell::new(None);
    let field = field
        .custom_formatter(|x, _| match kept.refused() {
            Some(text) if x == typing.value => text.to_owned(),
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
    let is_refused = kept.refused().is_some();
    let border = if is_refused { look.palette.rejected } else { look.palette.accent };
    while_edited(ui, look, border);
    if is_refused {
        colour(ui, look.palette.rejected);
    }
    let field_id = ui.next_auto_id();
    let has_focus = |ui: &Ui| ui.memory(|memory| memory.has_focus(field_id));
    let was_focused = has_focus(ui);
    let response = ui.add(field);
    outline_if_edited(ui, &response, border);
    // By the tabulator it is left at once, and tells so a frame later only.
    let is_left = response.lost_focus() || was_focused && !has_focus(ui);
    ui.set_style(style);
    Shown { response, is_left, read: last_read.into_inner() }
}

/// Gives the letters and the border of what comes next this colour.
fn colour(ui: &mut Ui, colour: Color32) {
    let visuals = ui.visuals_mut();
    visuals.override_text_color = Some(colour);
    let widgets = &mut visuals.widgets;
    for state in [&mut widgets.inactive, &mut widgets.hovered, &mut widgets.active] {
        state.bg_stroke = Stroke::new(1.5, colour);
    }
}

/// What has come of a field that was left.
struct Ended {
    kept: Kept,
    /// What is said of it: nothing of what was given up.
    said: Option<String>,
    /// See [`Edited`].
    restored: Option<f64>,
}

/// What comes of a field that is left with `kept`, after it had the number `before`: what
/// was typed is given up by Escape, edited on by Enter, else given up with a word of it.
fn ended(
    ui: &mut Ui,
    look: &Look,
    response: &Response,
    typing: &Typing<'_>,
    before: Option<f64>,
    kept: Kept,
) -> Ended {
    if kept.is_given_up || ui.input(|input| input.key_pressed(Key::Escape)) {
        let is_given_up_now = kept.text.is_some() && !kept.is_given_up;
        if is_given_up_now {
            // Nothing else is given up with it.
            ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
        }
        let value = before.unwrap_or(typing.value).to_bits();
        let kept = Kept { value, is_given_up: true, ..Kept::default() };
        return Ended { kept, said: is_given_up_now.then(String::new), restored: before };
    }
    let Some(text) = &kept.text else { return Ended { kept, said: None, restored: None } };
    let value = before.map_or(kept.value, f64::to_bits);
    if ui.input(|input| input.key_pressed(Key::Enter)) {
        // It is edited on.
        response.request_focus();
        let kept = Kept { value, is_confirmed: true, ..kept };
        return Ended { kept, said: None, restored: before };
    }
    let said = told(look, typing, text, value, "number-restored");
    Ended { kept: Kept { value, ..Kept::default() }, said: Some(said), restored: before }
}

/// What is wrong with a text, and by the text `key` which number holds.
fn told(look: &Look, typing: &Typing<'_>, text: &str, holds: u64, key: &str) -> String {
    let value = ("value", number(f64::from_bits(holds)).into());
    format!("{} {}", (typing.wrong)(text), look.texts.format(key, &[value]))
}

/// The number that a field had when its editing began, while it is edited and when that
/// ends.
fn before_editing(ui: &Ui, field: Id, value: f64) -> Option<f64> {
    let memory = field.with("before");
    let kept: Option<f64> = ui.data(|data| data.get_temp(memory));
    if ui.memory(|memory| memory.has_focus(field)) {
        let before = kept.unwrap_or(value);
        ui.data_mut(|data| data.insert_temp(memory, before));
        return Some(before);
    }
    ui.data_mut(|data| data.remove::<f64>(memory));
    kept
}

/// What is wrong with what was typed into the field that is edited or was just left; empty
/// if that was just given up or mended.
pub fn refused_number(context: &Context) -> Option<String> {
    context.data_mut(|data| data.remove_temp(Id::unique(REFUSED)))
}

const REFUSED: &str = "refused number";
