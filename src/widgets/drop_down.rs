//! A list from which one entry is chosen, by mouse or keyboard.

use super::menu_style_with_ring;
use crate::look::Look;
use eframe::egui::{Align, ComboBox, Key, Response, RichText, Ui};

/// A line of the list.
#[derive(Clone, Debug)]
pub enum Listed<T> {
    /// A title of the entries below it.
    Title(String),
    /// An entry with its name.
    Entry(T, String),
    /// The same with what is said of it where it is pointed at, if anything.
    Explained(T, String, String),
}

/// The entry that is chosen already.
#[derive(Clone, Debug)]
pub struct Present<T> {
    /// The entry, if it is one of the list.
    pub entry: Option<T>,
    /// Its name.
    pub name: String,
}

/// The name of the present entry, which is told apart from the others; a click or a key
/// lists all `lines`, from which a click, or the arrows and Enter, choose. Returns the
/// control and what was chosen.
pub fn drop_down<T: Copy + PartialEq>(
    ui: &mut Ui,
    look: &Look,
    salt: &str,
    width: f32,
    present: Present<T>,
    lines: &[Listed<T>],
) -> (Response, Option<T>) {
    /// Room above and below the list in a window that has none for all of it.
    const BESIDE: f32 = 48.0;
    let room = ui.ctx().content_rect().height() - BESIDE;
    let list = ComboBox::from_id_salt(salt).width(width).height(room).truncate();
    let list = list.popup_style(menu_style_with_ring.into()).selected_text(present.name);
    // Whether the present entry has been focused since the list was opened.
    let entered = ui.scope_id().with(("entered", salt));
    let present = present.entry;
    let mut chosen = None;
    let shown = list.show_ui(ui, |ui| {
        if lines.iter().any(|line| matches!(line, Listed::Title(_))) {
            // Long: as high as the window at most.
            ui.spacing_mut().item_spacing.y = 0.0;
            ui.spacing_mut().interact_size.y = 21.0;
            ui.spacing_mut().button_padding.y = 1.0;
        }
        // The present entry is entered, or where there is none the first.
        let entries = lines.iter().filter_map(|line| match line {
            Listed::Entry(entry, _) | Listed::Explained(entry, ..) => Some(*entry),
            Listed::Title(_) => None,
        });
        let first = entries.clone().next();
        let to_enter = present.filter(|present| entries.clone().any(|e| e == *present)).or(first);
        let enters = !ui.is_sizing_pass() && ui.data(|data| data.get_temp(entered) != Some(true));
        for line in lines {
            let (entry, name, why) = match line {
                Listed::Entry(entry, name) => (*entry, name, ""),
                Listed::Explained(entry, name, why) => (*entry, name, why.as_str()),
                Listed::Title(title) => {
                    ui.label(RichText::new(title).size(12.0).color(look.palette.quiet));
                    continue;
                }
            };
            let is_present = present == Some(entry);
            let row = ui.selectable_label(is_present, name);
            if enters && to_enter == Some(entry) {
                row.request_focus();
                row.scroll_to_me(Some(Align::Center));
            }
            if row.gained_focus() {
                row.scroll_to_me(None);
            }
            if row.clicked() {
                chosen = Some(entry);
                ui.close();
            }
            if !why.is_empty() {
                row.on_hover_text(why);
            }
        }
        if enters {
            ui.data_mut(|data| data.insert_temp(entered, true));
        }
    });
    if shown.inner.is_none() || chosen.is_some() {
        ui.data_mut(|data| data.remove::<bool>(entered));
    }
    // Whoever chooses by keyboard goes on from here.
    if chosen.is_some() && ui.input(|input| input.key_pressed(Key::Enter)) {
        shown.response.request_focus();
    }
    (shown.response, chosen)
}
