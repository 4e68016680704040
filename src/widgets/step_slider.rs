//! A slider along the steps of a trace, for keys and screen readers.

use eframe::egui::accesskit::{Action, ActionData};
use eframe::egui::{Event, EventFilter, Key, Response, Ui};

/// Makes a drawn slider one that also keys and screen readers move: arrows, Home and
/// End while it is focused. It is at `step` of `n_steps`. Returns the step to go to.
pub fn step_slider(ui: &Ui, response: &Response, step: usize, n_steps: usize) -> Option<usize> {
    let id = response.id;
    ui.ctx().accesskit_node_builder(id, |node| {
        node.set_numeric_value(step as f64);
        node.set_min_numeric_value(0.0);
        node.set_max_numeric_value(n_steps as f64);
        node.set_numeric_value_step(1.0);
        node.add_action(Action::SetValue);
        node.add_action(Action::Increment);
        node.add_action(Action::Decrement);
    });
    let focused = response.has_focus();
    if focused {
        // The arrows move the slider, not the focus.
        let filter = EventFilter { horizontal_arrows: true, ..Default::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(id, filter));
    }
    let wanted = ui.input(|input| {
        // With another key they are a command.
        let plain = |event: &&Event| matches!(event, Event::Key { modifiers, .. } if modifiers.is_none());
        let is_press_of = |event: &Event, wanted: Key| {
            matches!(event, Event::Key { key, pressed: true, .. } if *key == wanted)
        };
        let presses = |key| {
            let events = input.events.iter().filter(|_| focused).filter(plain);
            events.filter(|event| is_press_of(event, key)).count()
        };
        let asked = |action| input.num_accesskit_action_requests(id, action);
        let set = input.accesskit_action_requests(id, Action::SetValue).filter_map(|request| {
            let Some(ActionData::NumericValue(value)) = request.data else { return None };
            // Rounded and cut off by the conversion.
            Some(value.round() as usize)
        });
        let from = if presses(Key::Home) > 0 {
            0
        } else if presses(Key::End) > 0 {
            n_steps
        } else {
            set.last().unwrap_or(step)
        };
        let forward = presses(Key::ArrowRight) + asked(Action::Increment);
        let back = presses(Key::ArrowLeft) + asked(Action::Decrement);
        (from + forward).saturating_sub(back).min(n_steps)
    });
    (wanted != step).then_some(wanted)
}
