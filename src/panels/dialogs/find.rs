//! Search over everything that has a name, in a window over the window.

use crate::finder::{Hit, Target, find};
use crate::look::Look;
use crate::shortcut;
use crate::view::Search;
use crate::widgets::text_field;
use eframe::egui::{
    Align, Atoms, Button, Event, Key, Label, Modifiers, RichText, ScrollArea, TextEdit, Ui,
};

/// Edits what is searched for and lists what is found; the arrow keys choose.
/// Returns what Enter or a click takes.
pub fn ui(ui: &mut Ui, look: &Look, search: &mut Search) -> Option<Target> {
    let moved = steps(ui);
    // Before it is shown: what was typed right after the key of the search is for it.
    let id = ui.unique_id().with("wanted");
    ui.memory_mut(|memory| memory.request_focus(id));
    let hint = RichText::new(look.text("find-hint")).color(look.palette.quiet);
    let field = TextEdit::singleline(&mut search.wanted).id(id).hint_text(hint);
    let field = text_field(ui, look, field.desired_width(f32::INFINITY));
    let hits = find(&search.wanted, look.texts.language());
    let name = look.text("command-find");
    ui.ctx().accesskit_node_builder(field.id, |node| node.set_label(name));
    if field.changed() {
        search.chosen = 0;
    }
    search.chosen = search.chosen.saturating_add_signed(moved).min(hits.len().saturating_sub(1));
    let entered = ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter));
    let mut taken = entered.then(|| hits.get(search.chosen)).flatten().map(|hit| hit.target);

    ui.add_space(4.0);
    let height = 560.0_f32.min(ui.ctx().content_rect().height() - 240.0);
    ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, |ui| {
        ui.set_min_height(height);
        ui.spacing_mut().item_spacing.y = 2.0;
        if hits.is_empty() {
            ui.add(Label::new(look.text("find-nothing")).wrap());
        }
        for (n, hit) in hits.iter().enumerate() {
            let chosen = n == search.chosen;
            let response = ui.add(row(ui, look, hit, chosen));
            if chosen && (moved != 0 || field.changed()) {
                response.scroll_to_me(Some(Align::Center));
            }
            if response.clicked() {
                taken = Some(hit.target);
            }
        }
    });
    taken
}

/// Name of a hit and in brackets what matches instead of it, at its right the key or the kind.
fn row<'a>(ui: &Ui, look: &Look, hit: &Hit, chosen: bool) -> Button<'a> {
    let key = match hit.target {
        Target::Command(command) => command.row().keys.first(),
        Target::Scene(_)
        | Target::Theme(_)
        | Target::Query(_)
        | Target::Algorithm(_)
        | Target::Erratum(_)
        | Target::Reading(_) => None,
    };
    let side = match key {
        Some(key) => shortcut::shown(look, key),
        None => look.text(hit.target.kind()),
    };
    let quiet = |text: String| {
        let text = RichText::new(text).size(13.0);
        if chosen { text } else { text.color(look.palette.quiet) }
    };
    let side = quiet(side);
    let other = hit.other.clone().map(|other| quiet(format!("({other})")));
    let mut name = Atoms::new(hit.name.clone());
    other.into_iter().for_each(|other| name.push_right(other));
    Button::selectable(chosen, name)
        .right_text(side)
        .wrap()
        .min_size(eframe::egui::vec2(ui.available_width(), 26.0))
}

/// Rows to go down: the arrow keys, taken before the field gets them.
fn steps(ui: &Ui) -> isize {
    ui.input_mut(|input| {
        let mut down = 0;
        input.events.retain(|event| {
            let step = match event {
                Event::Key { key: Key::ArrowDown, pressed: true, .. } => 1,
                Event::Key { key: Key::ArrowUp, pressed: true, .. } => -1,
                Event::Key { key: Key::PageDown, pressed: true, .. } => 10,
                Event::Key { key: Key::PageUp, pressed: true, .. } => -10,
                _ => 0,
            };
            down += step;
            step == 0
        });
        down
    })
}
