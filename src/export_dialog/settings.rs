//! What is chosen in the dialog of an export.

use super::Shown;
use crate::export::{Choice, ExerciseChoice, Extent, Format, MomentChoice, StepChoice};
use crate::figures::Moments;
use crate::look::Look;
use crate::panels::show;
use crate::widgets::{Listed, MOST_SEED, Present, drop_down, ranged_field, segments, text_field};
use eframe::egui::{CollapsingHeader, Grid, Layout, RichText, TextEdit, Ui, accesskit::Role, vec2};
use octoscope_core::explain::Notation;
use octoscope_core::text::Language;
use octoscope_figure::views::FigureView;
use octoscope_figure::{Background, Theme, TikzForm, Unit};

/// Width of lists, in points.
const LIST: f32 = 260.0;

/// Shows and takes all choices but that of the file.
pub(super) fn settings(ui: &mut Ui, look: &Look, shown: &mut Shown) {
    let Shown { choice, views, show: what, of, last_step, language, notation, .. } = shown;
    let name = |key: &str| look.text(key);
    Grid::new("export").num_columns(2).spacing([12.0, 8.0]).show(ui, |ui| {
        let label = ui.label(name("dialog-export-view")).id;
        let named = |view: FigureView| name(&format!("figure-{}", view.id()));
        let lines: Vec<_> = views.iter().map(|&view| Listed::Entry(view, named(view))).collect();
        let shown = Present { entry: Some(choice.view), name: named(choice.view) };
        let (list, chosen) = drop_down(ui, look, "view", LIST, shown, &lines);
        list.labelled_by(label);
        if let Some(view) = chosen {
            choice.set_view(view);
        }
        ui.end_row();
        if choice.view == FigureView::Formula {
            let label = ui.label(name("export-notation")).id;
            let named = |notation: Notation| name(&format!("notation-{notation}"));
            let lines = Notation::ALL.map(|one| Listed::Entry(one, named(one)));
            let shown = Present { entry: Some(**notation), name: named(**notation) };
            let (list, chosen) = drop_down(ui, look, "notation", LIST, shown, &lines);
            list.labelled_by(label);
            **notation = chosen.unwrap_or(**notation);
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
        formats(ui, choice);
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
        let extents = extents.map(|(extent, key)| (extent, name(key)));
        // Where they wrap, the row has the height of all their lines.
        ui.vertical(|ui| segments(ui, &mut choice.extent, &extents));
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
        ui.vertical(|ui| segments(ui, &mut choice.theme, &themes));
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

/// Shows the formats of figures and, below them, those of a table as text.
fn formats(ui: &mut Ui, choice: &mut Choice) {
    // A name may have told a format that this view has not.
    let has_text = choice.view == FigureView::Table || choice.format.is_of_text();
    let mut format = choice.format;
    ui.vertical(|ui| {
        for is_of_text in [false, true] {
            let of_kind = Format::ALL.into_iter().filter(|f| f.is_of_text() == is_of_text);
            let of_kind: Vec<_> =
                of_kind.map(|format| (format, format.name().to_owned())).collect();
            if (!is_of_text || has_text) && segments(ui, &mut format, &of_kind) {
                choice.set_format(format);
            }
        }
    });
}

fn languages(ui: &mut Ui, look: &Look, language: &mut Language) {
    ui.label(look.text("export-language"));
    let languages = [Language::English, Language::German];
    segments(ui, language, &languages.map(|one| (one, one.id().to_uppercase())));
    ui.end_row();
}

fn steps(ui: &mut Ui, look: &Look, choice: &mut Choice, last_step: usize) {
    // A table ends with the step that it is of.
    let is_table = choice.view == FigureView::Table;
    let steps = [
        (StepChoice::Here, if is_table { "export-up-to-here" } else { "export-here" }),
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
            let field = text_field(ui, look, field.desired_width(240.0));
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
