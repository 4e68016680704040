//! The dialog of an export: what is chosen, how it looks, the command that does
//! the same.

mod request;
mod settings;

use crate::export::{Choice, OneOf, Origin, Request, shell_line};
use crate::files::{self, There};
use crate::look::Look;
use crate::panels::show::Of;
use crate::widgets::{default_button, path_line, text_field};
use eframe::egui::{
    Align, Context, Event, Frame, Id, Image, Key, Label, Layout, Modal, RichText, ScrollArea,
    Spinner, TextEdit, TextStyle, TextureHandle, Ui, vec2,
};
use octoscope_core::explain::Notation;
use octoscope_core::text::Language;
use octoscope_figure::Show;
use octoscope_figure::views::{FigureView, rows_of_table};
use settings::settings;
use std::ops::RangeInclusive;
use std::path::Path;

pub use request::request;

/// What is chosen, and all that the dialog shows beside it.
pub struct Shown<'a> {
    /// What is chosen.
    pub choice: &'a mut Choice,
    /// The views that have something to show.
    pub views: &'a [FigureView],
    /// What the figure shows.
    pub show: &'a mut Show,
    /// Language of the figure's title, and of the window.
    pub language: &'a mut Language,
    /// How formulas are written, in the figure and in the window.
    pub notation: &'a mut Notation,
    /// Dimension of the tree.
    pub of: Of,
    /// Number of the last step.
    pub last_step: usize,
    /// What all that comes to.
    pub request: &'a Request,
    /// What the command names.
    pub origin: &'a Origin,
    /// The picture of the figure and what it is of, if it is there already.
    pub preview: Option<&'a (TextureHandle, OneOf)>,
    /// Why the figure cannot be drawn, in words.
    pub fault: Option<&'a str>,
    /// Why what was asked for could not be made, in words.
    pub refused: Option<&'a str>,
}

/// What the user asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Write the file.
    Export,
    /// Choose where to.
    Choose,
    /// Copy the figure as an image.
    CopyImage,
    /// Copy the figure as the text of an SVG.
    CopySvg,
    /// Copy the table of steps.
    CopyText,
    /// Copy the command.
    CopyCommand,
    /// Close the dialog.
    Close,
}

/// Height of what is said of the preview, two lines.
const CAPTION: f32 = 36.0;

/// Largest extent of the preview, in points.
pub const PREVIEW: [f32; 2] = [360.0, 270.0];

/// Shows the dialog.
pub fn ui(context: &Context, look: &Look, mut shown: Shown) -> Option<Answer> {
    // Enter in a field is for the field.
    let is_free = context.memory(|memory| memory.focused().is_none());
    let is_entered = is_free && is_entered(context);
    let mut answer = (is_entered && can_export(there(shown.choice))).then_some(Answer::Export);
    let frame = Frame::popup(&context.global_style()).inner_margin(20.0);
    let room = context.content_rect().size();
    let response = Modal::new(Id::unique("export")).frame(frame).show(context, |ui| {
        ui.label(RichText::new(look.text("dialog-export")).heading().strong());
        ui.add_space(6.0);
        let is_wide = room.x > 860.0;
        ui.set_width(if is_wide { 800.0 } else { (room.x - 60.0).min(440.0) });
        let most = (room.y - 272.0).clamp(120.0, 430.0);
        if is_wide {
            ui.horizontal_top(|ui| {
                ui.vertical(|ui| {
                    ui.set_width(410.0);
                    let scroll = ScrollArea::vertical().max_height(most).auto_shrink([false, true]);
                    scroll.show(ui, |ui| settings(ui, look, &mut shown));
                });
                ui.vertical(|ui| preview(ui, look, &shown));
            });
        } else {
            let scroll = ScrollArea::vertical().max_height(most).auto_shrink([false, true]);
            scroll.show(ui, |ui| {
                settings(ui, look, &mut shown);
                preview(ui, look, &shown);
            });
        }
        ui.separator();
        answer = answer.or(command(ui, look, &shown)).or(buttons(ui, look, &mut shown));
    });
    if response.should_close() { answer.or(Some(Answer::Close)) } else { answer }
}

/// Whether Enter is pressed, and not only held since it has opened the dialog.
fn is_entered(context: &Context) -> bool {
    let is_press = |event: &Event| {
        matches!(event, Event::Key { key: Key::Enter, pressed: true, repeat: false, .. })
    };
    context.input(|input| input.events.iter().any(is_press))
}

fn preview(ui: &mut Ui, look: &Look, shown: &Shown) {
    let [width, height] = PREVIEW;
    let name = look.text("export-preview");
    Frame::new().fill(look.palette.panel).inner_margin(8.0).show(ui, |ui| {
        ui.set_min_size(vec2(width, height));
        let layout = Layout::centered_and_justified(eframe::egui::Direction::TopDown);
        ui.allocate_ui_with_layout(vec2(width, height), layout, |ui| {
            match (shown.fault, shown.preview) {
                (Some(fault), _) => {
                    ui.add(Label::new(fault).wrap());
                }
                (None, Some((texture, _))) => {
                    ui.add(Image::new(texture).max_size(vec2(width, height)).alt_text(name));
                }
                (None, None) => {
                    ui.add(Spinner::new());
                }
            }
        });
        if let (None, Some((_, of))) = (shown.fault, shown.preview) {
            let told = RichText::new(told(look, shown, of)).color(look.palette.quiet).size(13.0);
            // As high as at most, so that nothing below it moves.
            let below = Layout::top_down(Align::Center);
            ui.allocate_ui_with_layout(vec2(width, CAPTION), below, |ui| {
                ui.set_min_size(vec2(width, CAPTION));
                ui.add(Label::new(told).wrap());
            });
        }
    });
}

/// What of the export the preview is, where it is not the whole.
fn told(look: &Look, shown: &Shown, of: &OneOf) -> String {
    let texts = &look.texts;
    let numbers = |key: &str, (name, n): (&str, usize), range: RangeInclusive<usize>| {
        let [first, last] = [*range.start(), *range.end()];
        let ends = [("first", first.into()), ("last", last.into())];
        (first < last).then(|| texts.format(key, &[&[(name, n.into())], &ends[..]].concat()))
    };
    let of_steps = match shown.choice.format.is_of_text() {
        true => numbers("export-preview-text", ("steps", shown.last_step), rows_of_table(of.step)),
        false => numbers("export-preview-step", ("step", of.step), of.steps.clone()),
    };
    let rows = shown.request.last_rows(of.step).map(|rows| {
        let numbers = [("shown", rows.count().into()), ("steps", of.step.into())];
        texts.format("export-preview-rows", &numbers)
    });
    let told: Vec<_> = [of_steps, rows].into_iter().flatten().collect();
    told.join("\n")
}

/// The command that does the same, to be read and copied.
fn command(ui: &mut Ui, look: &Look, shown: &Shown) -> Option<Answer> {
    let line = line(shown.request, shown.origin, shown.choice);
    let mut answer = None;
    ui.horizontal(|ui| {
        ui.label(RichText::new(look.text("export-command")).color(look.palette.quiet));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if ui.button(look.text("export-copy-command")).clicked() {
                answer = Some(Answer::CopyCommand);
            }
        });
    });
    let frame = Frame::new().fill(look.palette.field).inner_margin(8.0);
    frame.show(ui, |ui| {
        ui.set_min_width(ui.available_width());
        ui.add(Label::new(RichText::new(line).monospace().size(12.5)).wrap().selectable(true));
    });
    if shown.origin.is_unsaved {
        let note =
            look.texts.format("export-unsaved", &[("file", shown.origin.file.clone().into())]);
        ui.label(RichText::new(note).color(look.palette.quiet).size(13.0));
    }
    answer
}

/// The command, as a shell reads it.
pub fn line(request: &Request, origin: &Origin, choice: &Choice) -> String {
    shell_line(&request.command(&origin.file, origin.ray.as_deref(), choice.file.trim()))
}

/// What is where the file will be; `None` if that has no name yet.
fn there(choice: &Choice) -> Option<There> {
    let file = choice.file.trim();
    (!file.is_empty()).then(|| files::there(Path::new(file)))
}

/// Whether the file can be written, as far as that shows.
fn can_export(there: Option<There>) -> bool {
    match there {
        None | Some(There::Folder) => false,
        Some(There::Nothing | There::File) => true,
    }
}

/// Where the file will be, and what is there already.
fn target(ui: &mut Ui, look: &Look, choice: &Choice, there: Option<There>) {
    let file = Path::new(choice.file.trim());
    let key = match there {
        None => "export-nameless",
        Some(There::Nothing) => "export-new",
        Some(There::File) => "export-replaces",
        Some(There::Folder) => "export-folder",
    };
    path_line(ui, look, &files::whole(file), |path| {
        look.texts.format(key, &[("path", path.to_owned().into())])
    });
}

fn buttons(ui: &mut Ui, look: &Look, shown: &mut Shown) -> Option<Answer> {
    let mut answer = None;
    ui.add_space(6.0);
    let is_entered_in_field = ui.horizontal(|ui| {
        let label = ui.label(look.text("export-file"));
        let field = ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if ui.button(look.text("export-choose")).clicked() {
                answer = Some(Answer::Choose);
            }
            let room = ui.available_width() - 12.0;
            let mut file = shown.choice.file.clone();
            let field = TextEdit::singleline(&mut file).desired_width(room);
            let field = text_field(ui, look, field).labelled_by(label.id);
            if field.changed() {
                shown.choice.set_file(&file);
            }
            field
        });
        field.inner.lost_focus() && is_entered(ui.ctx())
    });
    // Asked for once a frame.
    let there = there(shown.choice);
    if is_entered_in_field.inner && can_export(there) {
        answer = Some(Answer::Export);
    }
    if let Some(refused) = shown.refused {
        ui.add(Label::new(RichText::new(refused).color(look.palette.rejected)).wrap());
    } else {
        target(ui, look, shown.choice, there);
    }
    ui.add_space(4.0);
    ui.horizontal_wrapped(|ui| {
        let copies: &[_] = if shown.choice.format.is_of_text() {
            &[("export-copy-table", Answer::CopyText)]
        } else {
            &[("export-copy-image", Answer::CopyImage), ("export-copy-svg", Answer::CopySvg)]
        };
        let export = default_button(look, look.text("export-do"));
        if ui.add_enabled(can_export(there), export).clicked() {
            answer = Some(Answer::Export);
        }
        for &(key, asked) in copies {
            if ui.button(look.text(key)).clicked() {
                answer = Some(asked);
            }
        }
        // At the right where there is room, else in the next row.
        let close = look.text("dialog-close");
        let font = TextStyle::Button.resolve(ui.style());
        let letters = ui.painter().layout_no_wrap(close.clone(), font, look.palette.ink).size().x;
        let needed = letters + 2.0 * ui.spacing().button_padding.x + 4.0;
        let is_closed = if ui.available_size_before_wrap().x < needed {
            ui.button(close).clicked()
        } else {
            let at_right = Layout::right_to_left(Align::Center);
            ui.with_layout(at_right, |ui| ui.button(close).clicked()).inner
        };
        if is_closed {
            answer = Some(Answer::Close);
        }
    });
    answer
}
