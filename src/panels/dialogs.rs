//! Windows over the window.

use crate::command::{COMMANDS, Command, Menu};
use crate::look::Look;
use crate::view::Dialog;
use eframe::egui::{
    Align2, Area, Context, Frame, Grid, Id, Key, Label, Modal, Order, ProgressBar, RichText,
    ScrollArea, Spinner, Ui, vec2,
};
use std::path::PathBuf;

/// What the user asks for in a dialog.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// Open this path.
    Path(PathBuf),
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
    if *shown == Dialog::Export {
        commands.clear();
        return None;
    }
    let mut answer = None;
    let mut close = false;
    let frame = Frame::popup(&context.global_style()).inner_margin(20.0);
    let response = Modal::new(Id::unique("dialog")).frame(frame).show(context, |ui| {
        ui.set_max_width(480.0);
        match shown {
            Dialog::Keys => keys(ui, look),
            Dialog::About => about(ui, look),
            Dialog::Error(message) => {
                title(ui, &look.text("dialog-error"));
                ScrollArea::vertical()
                    .max_height(most_height(ui, 260.0))
                    .show(ui, |ui| ui.label(&*message));
            }
            // It has a window of its own.
            Dialog::Export => {}
            Dialog::Path(path) => {
                title(ui, &look.text("dialog-path"));
                let label = ui.label(look.text("dialog-path-hint"));
                let field = ui.text_edit_singleline(path).labelled_by(label.id);
                let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
                if ui.button(look.text("dialog-path-open")).clicked() || entered {
                    answer = Some(Answer::Path(PathBuf::from(path.trim())));
                    close = true;
                }
            }
        }
        ui.add_space(8.0);
        close |= ui.button(look.text("dialog-close")).clicked();
    });
    if close || response.should_close() {
        *dialog = None;
    }
    // Keys belong to the dialog while it is open.
    commands.clear();
    answer
}

/// Shows how far the work is; true if it is to be cancelled.
pub fn progress(context: &Context, look: &Look, title: &str, fraction: Option<f64>) -> bool {
    let area = Area::new(Id::unique("progress")).order(Order::Foreground);
    let area = area.anchor(Align2::CENTER_TOP, vec2(0.0, 64.0));
    let shown = area.show(context, |ui| {
        Frame::popup(ui.style()).inner_margin(14.0).show(ui, |ui| {
            ui.set_width(320.0);
            ui.label(RichText::new(title).strong());
            match fraction {
                Some(fraction) => {
                    ui.add(ProgressBar::new(fraction as f32).show_percentage());
                }
                None => {
                    ui.add(Spinner::new());
                }
            }
            ui.button(look.text("job-cancel")).clicked()
        })
    });
    shown.inner.inner
}

/// One line at the lower edge of the view that says what has happened; a click
/// takes it away.
pub fn status(context: &Context, look: &Look, status: &mut String) {
    if status.is_empty() {
        return;
    }
    let area = Area::new(Id::unique("status")).order(Order::Foreground);
    let area = area.anchor(Align2::CENTER_TOP, vec2(0.0, 48.0));
    let clicked = area.show(context, |ui| {
        let frame = Frame::popup(ui.style()).inner_margin(10.0).fill(look.palette.field);
        frame.show(ui, |ui| {
            ui.horizontal(|ui| {
                let close = look.text("dialog-close");
                ui.scope(|ui| {
                    ui.set_max_width(420.0);
                    ui.add(Label::new(&*status).wrap());
                });
                ui.button(close).clicked()
            })
        })
    });
    let moved_on = context.input(|input| input.key_pressed(Key::Escape));
    if clicked.inner.inner.inner || moved_on {
        status.clear();
    }
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
    title(ui, &look.text("dialog-keys"));
    ScrollArea::vertical().max_height(most_height(ui, 380.0)).show(ui, |ui| {
        for menu in Menu::ALL {
            ui.add_space(4.0);
            ui.label(RichText::new(look.text(menu.id())).color(look.palette.quiet));
            Grid::new(menu.id()).num_columns(2).spacing([24.0, 2.0]).show(ui, |ui| {
                for row in COMMANDS.iter().filter(|row| row.menu == menu && !row.keys.is_empty()) {
                    let keys = row.keys.iter().map(|key| ui.ctx().format_shortcut(key));
                    let keys = keys.collect::<Vec<_>>().join(", ");
                    ui.label(look.text(row.id));
                    ui.label(RichText::new(keys).monospace());
                    ui.end_row();
                }
            });
        }
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
