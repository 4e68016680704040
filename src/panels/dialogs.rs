//! Windows over the window.

mod find;

use crate::command::{COMMANDS, Command, Menu, Row};
use crate::files::Purpose;
use crate::finder::Target;
use crate::job::Title;
use crate::look::Look;
use crate::shortcut;
use crate::view::{Dialog, Typed};
use crate::widgets::{default_button, progress_bar, text_field};
use eframe::egui::{
    Align2, Area, Context, Frame, Grid, Id, Key, KeyboardShortcut, Label, Margin, Modal, Order,
    RichText, ScrollArea, Spinner, Stroke, TextEdit, Ui,
    text::{CCursor, CCursorRange},
    text_edit::TextEditState,
    vec2,
};
use std::ops::Range;

/// What the user asks for in a dialog.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// This path was typed.
    Path(Typed),
    /// Do what was found.
    Take(Target),
}

/// Shows the dialog, if there is one; closes it on Escape, a click beside it or
/// its button.
pub fn ui(
    context: &Context,
    look: &Look,
    dialog: &mut Option<Dialog>,
    commands: &mut Vec<Command>,
) -> Option<Answer> {
    let shown = dialog.as_mut()?;
    if matches!(shown, Dialog::Export | Dialog::Lab) {
        commands.clear();
        return None;
    }
    let mut answer = None;
    let mut close = false;
    let frame = Frame::popup(&context.global_style()).inner_margin(20.0);
    let response = Modal::new(Id::unique("dialog")).frame(frame).show(context, |ui| {
        let room = context.content_rect().width();
        ui.set_max_width(most_width(shown).min(room - 60.0));
        let mut confirm = None;
        match shown {
            Dialog::Find(search) => {
                title(ui, &look.text("command-find"));
                if let Some(target) = find::ui(ui, look, search) {
                    answer = Some(Answer::Take(target));
                    close = true;
                }
            }
            Dialog::Keys => keys(ui, look),
            Dialog::About => about(ui, look),
            Dialog::Error(message) => {
                title(ui, &look.text("dialog-error"));
                ScrollArea::vertical()
                    .max_height(most_height(ui, 260.0))
                    .show(ui, |ui| ui.label(&*message));
            }
            // They have windows of their own.
            Dialog::Export | Dialog::Lab => {}
            Dialog::Path(typed) => {
                let entered = path(ui, look, typed);
                let is_named = !typed.path.trim().is_empty();
                confirm = Some((confirmation(typed), is_named, entered && is_named));
            }
        }
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            let confirmed = confirm.is_some_and(|(key, is_possible, entered)| {
                let button = default_button(look, look.text(key));
                ui.add_enabled(is_possible, button).clicked() || entered
            });
            if confirmed && let Dialog::Path(typed) = shown {
                answer = Some(Answer::Path(typed.clone()));
                close = true;
            }
            let leave = if confirm.is_some() { "dialog-cancel" } else { "dialog-close" };
            close |= ui.button(look.text(leave)).clicked();
        });
    });
    if close || response.should_close() {
        *dialog = None;
    }
    // Keys belong to the dialog while it is open.
    commands.clear();
    answer
}

/// How wide a dialog may be.
fn most_width(dialog: &Dialog) -> f32 {
    match dialog {
        Dialog::Keys => 900.0,
        Dialog::Find(_) => 640.0,
        Dialog::About | Dialog::Error(_) | Dialog::Path(_) => 480.0,
        // They have windows of their own.
        Dialog::Export | Dialog::Lab => 0.0,
    }
}

/// What the button says that takes the path.
fn confirmation(typed: &Typed) -> &'static str {
    match typed.purpose {
        _ if typed.replaces => "path-replace",
        Purpose::Open => "path-open-confirm",
        Purpose::Save => "path-save-confirm",
        Purpose::Export(_) | Purpose::Lab(_) => "path-export-confirm",
    }
}

/// Field for a path; true once Enter is pressed in it.
fn path(ui: &mut Ui, look: &Look, typed: &mut Typed) -> bool {
    let (name, hint) = match typed.purpose {
        Purpose::Open => ("path-open", "path-open-hint"),
        Purpose::Save => ("path-save", "path-hint"),
        Purpose::Export(_) | Purpose::Lab(_) => ("path-export", "path-hint"),
    };
    title(ui, &look.text(name));
    ui.label(look.text(hint));
    let field = TextEdit::singleline(&mut typed.path).desired_width(f32::INFINITY);
    let field = text_field(ui, look, field);
    let spoken = look.text(name);
    ui.ctx().accesskit_node_builder(field.id, |node| node.set_label(spoken));
    if field.changed() {
        (typed.replaces, typed.refused) = (false, None);
    }
    let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    // Whoever is asked for a path can type it at once: what is typed is the name.
    if !entered && ui.memory(|memory| memory.focused().is_none()) {
        field.request_focus();
        let mut state = TextEditState::load(ui.ctx(), field.id).unwrap_or_default();
        let stem = stem(&typed.path);
        let [start, end] = [stem.start, stem.end].map(CCursor::new);
        state.cursor.set_char_range(Some(CCursorRange::two(start, end)));
        state.store(ui.ctx(), field.id);
    }
    if let Some(refused) = &typed.refused {
        ui.add(Label::new(RichText::new(refused).color(look.palette.rejected)).wrap());
    }
    if typed.replaces {
        let question = RichText::new(look.text("path-replaces")).strong();
        ui.add(Label::new(question).wrap());
    }
    entered
}

/// The letters of a path that are the name of its file without its ending.
fn stem(path: &str) -> Range<usize> {
    let start = path.rfind(std::path::is_separator).map_or(0, |at| at + 1);
    let name = &path[start..];
    let length = name.rfind('.').filter(|&at| at > 0).unwrap_or(name.len());
    let [start, end] = [start, start + length].map(|at| path[..at].chars().count());
    start..end
}

/// Shows how far the work is; true if it is to be cancelled.
pub fn progress(context: &Context, look: &Look, title: &Title, fraction: Option<f64>) -> bool {
    // Above dialogs, which keep the mouse from what lies below them.
    let area = Area::new(Id::unique("progress")).order(Order::Tooltip);
    let area = area.anchor(Align2::CENTER_TOP, vec2(0.0, 64.0));
    let shown = area.show(context, |ui| {
        Frame::popup(ui.style()).inner_margin(14.0).show(ui, |ui| {
            ui.set_width(320.0);
            ui.label(RichText::new(title.told(&look.texts)).strong());
            match fraction {
                Some(fraction) => progress_bar(ui, fraction),
                None => {
                    ui.add(Spinner::new());
                }
            }
            ui.button(look.text("job-cancel")).clicked()
        })
    });
    shown.inner.inner
}

/// `wanted`, or what the window has room for beside the dialog's title and button.
fn most_height(ui: &Ui, wanted: f32) -> f32 {
    wanted.min(ui.ctx().content_rect().height() - 180.0)
}

fn title(ui: &mut Ui, text: &str) {
    ui.label(RichText::new(text).heading().strong());
    ui.add_space(6.0);
}

fn keys(ui: &mut Ui, look: &Look) {
    /// Least width of a column.
    const COLUMN: f32 = 420.0;
    title(ui, &look.text("dialog-keys"));
    let menus = Menu::ALL.iter().flat_map(|menu| std::iter::once(menu).chain(menu.inner()));
    let groups = menus.map(|&menu| {
        let rows = COMMANDS.iter().filter(|row| row.menu == menu && !row.keys.is_empty());
        (menu, rows.collect::<Vec<_>>())
    });
    let groups: Vec<_> = groups.filter(|(_, rows)| !rows.is_empty()).collect();
    let columns = if ui.available_width() >= 2.0 * COLUMN {
        let n_lines: Vec<_> = groups.iter().map(|(_, rows)| 2 + rows.len()).collect();
        let is_left = balanced(&n_lines);
        let (left, right) = groups.iter().zip(is_left).partition::<Vec<_>, _>(|(_, left)| *left);
        [left, right].map(|column| column.into_iter().map(|(group, _)| group).collect()).to_vec()
    } else {
        vec![groups.iter().collect::<Vec<_>>()]
    };
    let height = most_height(ui, 900.0);
    let scroll = ScrollArea::vertical().max_height(height).min_scrolled_height(height);
    ui.spacing_mut().scroll.floating_allocated_width = 12.0;
    scroll.show(ui, |ui| {
        // They are only read.
        ui.spacing_mut().interact_size.y = 19.0;
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = 32.0;
            for (n, groups) in columns.into_iter().enumerate() {
                ui.vertical(|ui| keys_of(ui, look, n, &groups));
            }
        });
    });
}

/// Which of groups of so many lines stand in the left of two columns, the first among
/// them, where the higher column is as low as it can be.
fn balanced(n_lines: &[usize]) -> Vec<bool> {
    let is_left = |choice: usize, n: usize| n == 0 || choice >> n & 1 == 0;
    let height = |choice: usize, left: bool| -> usize {
        let column = n_lines.iter().enumerate().filter(|&(n, _)| is_left(choice, n) == left);
        column.map(|(_, lines)| lines).sum()
    };
    let choices = 0..1 << n_lines.len();
    let best = choices.min_by_key(|&choice| height(choice, true).max(height(choice, false)));
    (0..n_lines.len()).map(|n| is_left(best.unwrap_or(0), n)).collect()
}

/// A column of keys, all of them below each other.
fn keys_of(ui: &mut Ui, look: &Look, column: usize, groups: &[&(Menu, Vec<&Row>)]) {
    /// Room above the name of a group.
    const ABOVE: f32 = 7.0;
    Grid::new(("keys", column)).num_columns(2).spacing([24.0, 1.0]).show(ui, |ui| {
        for (n, (menu, rows)) in groups.iter().enumerate() {
            ui.vertical(|ui| {
                ui.add_space(if n == 0 { 0.0 } else { ABOVE });
                let name = RichText::new(look.text(menu.id())).family(look.strong_family());
                ui.label(name.color(look.palette.ink));
            });
            ui.end_row();
            for row in rows {
                ui.label(look.text(row.id));
                ui.horizontal(|ui| {
                    ui.spacing_mut().item_spacing.x = 6.0;
                    row.keys.iter().for_each(|key| cap(ui, look, key));
                });
                ui.end_row();
            }
        }
    });
}

/// A key with its modifiers, by itself: signs on keys are not taken for signs between them.
fn cap(ui: &mut Ui, look: &Look, key: &KeyboardShortcut) {
    let frame = Frame::new().fill(look.palette.field).corner_radius(3.0);
    let frame = frame.stroke(Stroke::new(1.0, look.palette.hairline));
    frame.inner_margin(Margin::symmetric(5, 0)).show(ui, |ui| {
        ui.label(RichText::new(shortcut::shown(look, key)).monospace());
    });
}

fn about(ui: &mut Ui, look: &Look) {
    title(ui, &look.text("dialog-about"));
    ui.label(look.text("about-text"));
    ui.add_space(6.0);
    let version = env!("CARGO_PKG_VERSION");
    let licence = look.texts.format("about-licence", &[("version", version.into())]);
    ui.label(RichText::new(licence).color(look.palette.quiet));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_group_stands_beside_all_the_others() {
        assert_eq!(balanced(&[6, 3, 25, 5, 11, 3]), [true, true, false, true, true, true]);
        assert_eq!(balanced(&[4, 4]), [true, false]);
        assert!(balanced(&[]).is_empty());
    }

    #[test]
    fn the_stem_of_a_name_is_what_another_name_replaces() {
        for (path, expected) in [
            ("ä/scenario.octo", 2..10),
            ("a.b/c", 4..5),
            ("a.b/", 4..4),
            ("x.tar.gz", 0..5),
            ("a/.octo", 2..7),
            ("", 0..0),
        ] {
            assert_eq!(stem(path), expected, "{path}");
        }
    }
}
