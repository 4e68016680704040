//! The number of the step beside the ruler.

use crate::command::Command;
use crate::look::Look;
use crate::playback::Playback;
use crate::shortcut;
use crate::widgets::{hint_above, ranged_field};
use eframe::egui::{Align, Color32, FontId, Layout, Rangef, RichText, Stroke, Ui, vec2};
use octoscope_core::trace::Trace;

/// The number of the step, to be typed, and how many there are.
pub(super) struct Count {
    length: usize,
    is_cut: bool,
    /// Width of the field, and of what is said of all steps.
    widths: [f32; 2],
}

impl Count {
    /// Size of the numbers, and room between a number and the border of its field.
    const SIZE: f32 = 16.0;
    const PADDING: f32 = 6.0;
    /// Room between both.
    const GAP: f32 = 3.0;

    /// That of `trace`, laid out.
    pub(super) fn of<const D: usize>(ui: &Ui, look: &Look, trace: &Trace<D>) -> Self {
        let (length, is_cut) = (trace.events.len(), trace.is_cut());
        let font = FontId::proportional(Self::SIZE);
        let wide = |text: String| {
            ui.painter().layout_no_wrap(text, font.clone(), look.palette.ink).size().x
        };
        let field = wide(length.to_string()) + 2.0 * Self::PADDING + 2.0;
        Self { length, is_cut, widths: [field, wide(all(length, is_cut))] }
    }

    /// The room that it takes.
    pub(super) fn width(&self) -> f32 {
        (self.widths.iter().sum::<f32>() + Self::GAP).max(84.0)
    }

    /// Shows both; the number is a field only while it is pointed at or typed.
    pub(super) fn ui(&self, ui: &mut Ui, look: &Look, playback: &mut Playback, bar: Rangef) {
        let Self { length, is_cut, widths: [width, _] } = *self;
        let layout = Layout::left_to_right(Align::Center).with_main_align(Align::Max);
        let layout = layout.with_main_justify(true).with_cross_justify(true);
        let (name, mut step) = (look.text("timeline-number"), playback.step.min(length));
        ui.spacing_mut().item_spacing.x = Self::GAP;
        let field = ui.allocate_ui_with_layout(vec2(width, 28.0), layout, |ui| {
            let style = ui.style_mut();
            let font = FontId::proportional(Self::SIZE);
            style.text_styles.insert(style.drag_value_text_style.clone(), font);
            style.spacing.button_padding.x = Self::PADDING;
            style.spacing.interact_size.x = width;
            style.visuals.widgets.inactive.weak_bg_fill = Color32::TRANSPARENT;
            style.visuals.widgets.inactive.bg_stroke = Stroke::NONE;
            if playback.take_question() {
                let field = ui.next_auto_id();
                ui.memory_mut(|memory| memory.request_focus(field));
            }
            ranged_field(ui, look, &name, &mut step, [0, length], 0.25)
        });
        let field = field.inner;
        if field.has_focus() || field.dragged() {
            playback.playing = false;
        }
        if step != playback.step {
            playback.go_to(step, length);
        }
        let row = Command::GoToStep.row();
        let hint = format!("{} ({})", look.text(row.id), shortcut::all_shown(look, row.keys));
        hint_above(ui, field, bar, &hint);
        let label = ui.label(RichText::new(all(length, is_cut)).size(Self::SIZE).strong());
        if is_cut {
            hint_above(ui, label, bar, &look.text("timeline-cut"));
        }
    }
}

/// How many steps there are, behind the number of one.
fn all(length: usize, is_cut: bool) -> String {
    let more = if is_cut { " …" } else { "" };
    format!("/ {length}{more}")
}
