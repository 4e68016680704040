//! The dialog of an export: what is chosen, how it looks, the command that does
//! the same.

use crate::export::{
    Choice, ExerciseChoice, Extent, Format, MomentChoice, Origin, Request, StepChoice, shell_line,
};
use crate::figures::Moments;
use crate::files;
use crate::look::Look;
use crate::panels::show::{self, Of};
use crate::widgets::{MOST_SEED, ranged_field, segments};
use eframe::egui::{
    Align, CollapsingHeader, ComboBox, Context, Frame, Grid, Id, Image, Label, Layout, Modal,
    RichText, ScrollArea, Spinner, TextEdit, TextureHandle, Ui, accesskit::Role, vec2,
};
use octoscope_core::explain::Notation;
use octoscope_core::text::Language;
use octoscope_figure::views::FigureView;
use octoscope_figure::{Background, Show, Theme, TikzForm, Unit};
use std::path::Path;

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
    /// The picture of the figure, if it is there already.
    pub preview: Option<&'a TextureHandle>,
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

/// Largest extent of the preview, in points.
pub const PREVIEW: [f32; 2] = [360.0, 270.0];

/// Shows the dialog.
pub fn ui(context: &Context, look: &Look, mut shown: Shown) -> Option<Answer> {
    let mut answer = None;
    let frame = Frame::popup(&context.global_style()).inner_margin(20.0);
    let room = context.content_rect().size();
    let response = Modal::new(Id::unique("export")).frame(frame).show(context, |ui| {
        ui.label(RichText::new(look.text("dialog-export")).heading().strong());
        ui.add_space(6.0);
        let is_wide = room.x > 860.0;
        ui.set_width(if is_wide { 800.0 } else { (room.x - 60.0).min(440.0) });
        let most = (room.y - 250.0).clamp(120.0, 430.0);
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
        answer = command(ui, look, &shown).or(buttons(ui, look, &mut shown));
    });
    if response.should_close() { answer.or(Some(Answer::Close)) } else { answer }
}

fn settings(ui: &mut Ui, look: &Look, shown: &mut Shown) {
    let Shown { choice, views, show: what, of, last_step, language, notation, .. } = shown;
    let name = |key: &str| look.text(key);
    Grid::new("export").num_columns(2).spacing([12.0, 8.0]).show(ui, |ui| {
        let label = ui.label(name("dialog-export-view")).id;
        let named = |view: FigureView| name(&format!("figure-{}", view.id()));
        let list = ComboBox::from_id_salt("view").width(260.0).height(400.0);
        let mut chosen = choice.view;
        let list = list.selected_text(named(chosen)).show_ui(ui, |ui| {
            for &view in *views {
                ui.selectable_value(&mut chosen, view, named(view));
            }
        });
        list.response.labelled_by(label);
        if chosen != choice.view {
            choice.set_view(chosen);
        }
        ui.end_row();
        if choice.view == FigureView::Formula {
            let label = ui.label(name("export-notation")).id;
            let named = |notation: Notation| name(&format!("notation-{notation}"));
            let list = ComboBox::from_id_salt("notation").width(260.0);
            let list = list.selected_text(named(**notation)).show_ui(ui, |ui| {
                for one in Notation::ALL {
                    ui.selectable_value(*notation, one, named(one));
                }
            });
            list.response.labelled_by(label);
            ui.end_row();
        }
        if choice.view == FigureView::Worksheet {
            ui.label(name("export-exercise"));
            ui.vertical(|ui| exercise(ui, look, choice));
            ui.end_row();
        }
        if choice.view == FigureView::Storyboard {
            ui.label(name("export-moments"));
            ui.vertical(|ui| moments(ui, look, choice, *last_step));
            ui.end_row();
        }

        ui.label(name("export-format"));
        // A name may have told a format that this view has not.
        let has_text = choice.view == FigureView::Table || choice.format.is_of_text();
        let formats = Format::ALL.into_iter().filter(|format| has_text || !format.is_of_text());
        let formats: Vec<_> = formats.map(|format| (format, format.name().to_owned())).collect();
        let mut format = choice.format;
        if segments(ui, &mut format, &formats) {
            choice.set_format(format);
        }
        ui.end_row();
        if choice.format.is_of_text() {
            languages(ui, look, language);
            return;
        }

        ui.label(name("export-extent"));
        let extents = [
            (Extent::Cropped, "export-cropped"),
            (Extent::Wide, "export-wide"),
            (Extent::Sized, "export-sized"),
        ];
        segments(ui, &mut choice.extent, &extents.map(|(extent, key)| (extent, name(key))));
        ui.end_row();
        if choice.extent != Extent::Cropped {
            ui.label(name("export-size"));
            sides(ui, look, choice);
            ui.end_row();
        }
        if choice.can_be_enlarged() {
            ui.label(name("export-enlarged"));
            number(ui, look, "export-enlarged", &mut choice.enlarged, [0.1, 8.0], 0.02);
            ui.end_row();
        }

        ui.label(name("export-type-scale"));
        ui.horizontal(|ui| {
            number(ui, look, "export-type-scale", &mut choice.type_scale, [0.25, 8.0], 0.01);
            ui.add_space(8.0);
            ui.label(name("export-line-scale"));
            number(ui, look, "export-line-scale", &mut choice.line_scale, [0.25, 8.0], 0.01);
        });
        ui.end_row();

        ui.label(name("export-theme"));
        let themes = Theme::ALL.map(|theme| (theme, name(&format!("theme-{}", theme.id()))));
        segments(ui, &mut choice.theme, &themes);
        ui.end_row();

        ui.label(name("export-background"));
        let mut is_clear = choice.background == Background::Transparent;
        ui.checkbox(&mut is_clear, name("export-transparent"));
        choice.background = if is_clear { Background::Transparent } else { Background::Filled };
        ui.end_row();

        if choice.view.is_of_a_step() {
            ui.label(name("export-steps"));
            ui.vertical(|ui| steps(ui, look, choice, *last_step));
            ui.end_row();
        }
        if choice.format.moves() {
            ui.label(name("export-pause"));
            number(ui, look, "export-pause", &mut choice.pause_secs, [0.02, 10.0], 0.01);
            ui.end_row();
        }
        if choice.format == Format::Tikz {
            ui.label("TikZ");
            ui.vertical(|ui| tikz(ui, look, choice));
            ui.end_row();
        }

        languages(ui, look, language);
    });
    if choice.view.shows_space() {
        CollapsingHeader::new(name("export-show")).show(ui, |ui| show::ui(ui, look, what, *of));
    }
}

fn languages(ui: &mut Ui, look: &Look, language: &mut Language) {
    ui.label(look.text("export-language"));
    let languages = [Language::English, Language::German];
    segments(ui, language, &languages.map(|one| (one, one.id().to_uppercase())));
    ui.end_row();
}

fn steps(ui: &mut Ui, look: &Look, choice: &mut Choice, last_step: usize) {
    let steps = [
        (StepChoice::Here, "export-here"),
        (StepChoice::Range, "export-range"),
        (StepChoice::All, "export-all"),
    ];
    segments(ui, &mut choice.steps, &steps.map(|(step, key)| (step, look.text(key))));
    if choice.steps == StepChoice::Range {
        ui.horizontal(|ui| {
            for (step, key) in choice.range.iter_mut().zip(["export-from", "export-to"]) {
                let name = look.text(key);
                ui.label(&name);
                ranged_field(ui, look, &name, step, [0, last_step], 1.0);
            }
        });
    }
}

/// Which moments a storyboard shows.
fn moments(ui: &mut Ui, look: &Look, choice: &mut Choice, last_step: usize) {
    let rules = [
        (MomentChoice::Even, "export-even"),
        (MomentChoice::Leaves, "export-leaves"),
        (MomentChoice::Listed, "export-listed"),
    ];
    segments(ui, &mut choice.moments, &rules.map(|(rule, key)| (rule, look.text(key))));
    match choice.moments {
        MomentChoice::Even | MomentChoice::Leaves => {
            ui.horizontal(|ui| {
                let name = look.text("export-at-most");
                ui.label(&name);
                let range = [1, Moments::MOST];
                ranged_field(ui, look, &name, &mut choice.n_moments, range, 1.0);
            });
        }
        MomentChoice::Listed => {
            let field = TextEdit::singleline(&mut choice.listed_moments).hint_text("3, 7, 12");
            let field = ui.add(field.desired_width(240.0));
            let name = look.text("export-listed");
            field.widget_info(|| {
                eframe::egui::WidgetInfo::labeled(Role::TextInput, true, name.as_str())
            });
            if choice.listed(last_step).is_none() {
                let arguments = [("most", Moments::MOST.into()), ("last", last_step.into())];
                let note = look.texts.format("export-listed-wrong", &arguments);
                ui.label(RichText::new(note).color(look.palette.quiet).size(13.0));
            }
        }
    }
}

/// Which ray a worksheet has, and whether it is solved.
fn exercise(ui: &mut Ui, look: &Look, choice: &mut Choice) {
    let rays =
        [(ExerciseChoice::Own, "export-own-ray"), (ExerciseChoice::Numbered, "export-numbered")];
    segments(ui, &mut choice.exercise, &rays.map(|(ray, key)| (ray, look.text(key))));
    if choice.exercise == ExerciseChoice::Numbered {
        ui.horizontal(|ui| {
            let name = look.text("export-seed");
            ui.label(&name);
            ranged_field(ui, look, &name, &mut choice.seed, [0, MOST_SEED], 0.1);
        });
    }
    ui.checkbox(&mut choice.solution, look.text("export-solution"));
}

fn sides(ui: &mut Ui, look: &Look, choice: &mut Choice) {
    ui.horizontal(|ui| {
        let n_sides = if choice.extent == Extent::Wide { 1 } else { 2 };
        let keys = ["export-width", "export-height"].into_iter().take(n_sides);
        for (index, key) in keys.enumerate() {
            if index == 1 {
                ui.label("×");
            }
            let longest = crate::export::Size::longest(choice.unit);
            number(ui, look, key, &mut choice.sides[index], [1.0, longest], 0.5);
        }
        let units = Unit::ALL.map(|unit| (unit, unit.id().to_owned()));
        let before = choice.unit;
        if segments(ui, &mut choice.unit, &units) {
            let factor = before.points() / choice.unit.points();
            choice.sides = choice.sides.map(|side| (side * factor).round().max(1.0));
        }
    });
}

fn tikz(ui: &mut Ui, look: &Look, choice: &mut Choice) {
    let (mut slides, mut snippet) = match choice.tikz {
        TikzForm::Standalone => (false, false),
        TikzForm::Snippet => (false, true),
        TikzForm::Beamer => (true, false),
        TikzForm::BeamerSnippet => (true, true),
    };
    ui.checkbox(&mut slides, look.text("export-slides"));
    ui.checkbox(&mut snippet, look.text("export-snippet"));
    choice.tikz = match (slides, snippet) {
        (false, false) => TikzForm::Standalone,
        (false, true) => TikzForm::Snippet,
        (true, false) => TikzForm::Beamer,
        (true, true) => TikzForm::BeamerSnippet,
    };
}

fn number(ui: &mut Ui, look: &Look, key: &str, value: &mut f64, range: [f64; 2], speed: f64) {
    let layout = Layout::centered_and_justified(eframe::egui::Direction::LeftToRight);
    ui.allocate_ui_with_layout(vec2(64.0, 24.0), layout, |ui| {
        ranged_field(ui, look, &look.text(key), value, range, speed);
    });
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
                (None, Some(texture)) => {
                    ui.add(Image::new(texture).max_size(vec2(width, height)).alt_text(name));
                }
                (None, None) => {
                    ui.add(Spinner::new());
                }
            }
        });
    });
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

fn buttons(ui: &mut Ui, look: &Look, shown: &mut Shown) -> Option<Answer> {
    let mut answer = None;
    ui.add_space(6.0);
    ui.horizontal(|ui| {
        let label = ui.label(look.text("export-file"));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if ui.button(look.text("export-choose")).clicked() {
                answer = Some(Answer::Choose);
            }
            let room = ui.available_width() - 12.0;
            let mut file = shown.choice.file.clone();
            let field = TextEdit::singleline(&mut file).desired_width(room);
            if ui.add(field).labelled_by(label.id).changed() {
                shown.choice.set_file(&file);
            }
        });
    });
    if let Some(refused) = shown.refused {
        ui.add(Label::new(RichText::new(refused).color(look.palette.ray)).wrap());
    } else if files::is_there(Path::new(shown.choice.file.trim())) {
        let note = RichText::new(look.text("export-replaces"));
        ui.label(note.color(look.palette.quiet).size(13.0));
    }
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        let copies: &[_] = if shown.choice.format.is_of_text() {
            &[("export-copy-table", Answer::CopyText)]
        } else {
            &[("export-copy-image", Answer::CopyImage), ("export-copy-svg", Answer::CopySvg)]
        };
        for &(key, asked) in [("export-do", Answer::Export)].iter().chain(copies) {
            if ui.button(look.text(key)).clicked() {
                answer = Some(asked);
            }
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if ui.button(look.text("dialog-close")).clicked() {
                answer = Some(Answer::Close);
            }
        });
    });
    answer
}
