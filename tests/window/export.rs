//! Exports from the window, and what comes back from them.

use crate::desk::Desk;
use eframe::egui::{Event, Key, Modifiers, OutputCommand, Rect, accesskit::Role};
use egui_kittest::kittest::{NodeT, Queryable};
use octoscope::export::{Choice, Extent, Format, StepChoice};
use octoscope::text::texts;
use octoscope::view::{Dialog, View};
use octoscope::with_document;
use octoscope_core::explain::Notation;
use octoscope_core::text::Language;
use octoscope_figure::views::FigureView;
use octoscope_figure::{Theme, Unit};
use tempfile::tempdir;

/// The command that the dialog shows.
pub fn shown_command(desk: &Desk) -> String {
    let texts = desk.texts();
    let command = texts.iter().find(|text| text.starts_with("octoscope export"));
    command.expect("the dialog shows a command").clone()
}

/// What can be chosen of a table in the dialog: formats, pages and colours.
fn choices_of_a_table(desk: &Desk) -> Vec<(String, Rect)> {
    let texts = texts(desk.state().view.language);
    let pages = ["export-cropped", "export-wide", "export-sized"].map(|key| texts.get(key));
    let themes = Theme::ALL.map(|theme| texts.get(&format!("theme-{}", theme.id())));
    let formats = Format::ALL.map(|format| format.name().to_owned());
    let names = formats.into_iter().chain(pages).chain(themes);
    names.map(|name| (name.clone(), desk.get_by_label(&name).rect())).collect()
}

#[test]
fn choices_of_a_table_stand_apart_in_every_size_of_type() {
    for (language, scale) in [1.0, 1.6].into_iter().flat_map(|s| Language::ALL.map(|l| (l, s))) {
        let mut desk = Desk::new();
        (desk.state_mut().view.language, desk.state_mut().view.scale) = (language, scale);
        desk.state_mut().view.export.view = FigureView::Table;
        desk.state_mut().view.dialog = Some(Dialog::Export);
        desk.run_steps(4);
        let choices = choices_of_a_table(&desk);
        for (n, (name, rect)) in choices.iter().enumerate() {
            for (other, place) in &choices[n + 1..] {
                let is_apart = !rect.shrink(0.5).intersects(*place);
                assert!(is_apart, "{language:?} {scale}: {name} on {other}");
            }
        }
    }
}

#[test]
fn the_buttons_of_the_dialog_stand_apart_in_every_size_of_type() {
    let keys = ["export-do", "export-copy-image", "export-copy-svg", "dialog-close"];
    for (language, scale) in [1.0, 1.6, 2.4].into_iter().flat_map(|s| Language::ALL.map(|l| (l, s)))
    {
        let mut desk = Desk::new();
        (desk.state_mut().view.language, desk.state_mut().view.scale) = (language, scale);
        desk.state_mut().view.dialog = Some(Dialog::Export);
        desk.run_steps(4);
        let window = desk.ctx.content_rect();
        let names = keys.map(|key| texts(language).get(key));
        let rects = names.map(|name| desk.get_by_role_and_label(Role::Button, &name).rect());
        for (n, rect) in rects.iter().enumerate() {
            assert!(window.contains_rect(*rect), "{language:?} {scale}: {} is cut", keys[n]);
            for other in n + 1..keys.len() {
                let is_apart = !rect.shrink(0.5).intersects(rects[other]);
                assert!(is_apart, "{language:?} {scale}: {} on {}", keys[n], keys[other]);
            }
        }
    }
}

/// What is chosen at first, in a format.
pub fn choice(format: Format) -> Choice {
    let mut choice = Choice::default();
    choice.set_format(format);
    choice
}

#[test]
fn moments_and_exercises_are_chosen_in_the_dialog() {
    let mut desk = Desk::new();
    desk.state_mut().view.export.view = FigureView::Storyboard;
    desk.press_with(Modifiers::COMMAND, Key::E);
    assert!(!desk.says("from … to"), "a storyboard has its own steps");
    desk.click(Role::Button, "at leaves");
    desk.type_into("at most", "4");
    assert!(shown_command(&desk).contains("--steps=leaves:4"), "{}", shown_command(&desk));
    desk.click(Role::Button, "these steps");
    assert!(desk.says("Give steps from 0 to 173 with commas between, at most 24."));
    desk.get_by_role_and_label(Role::TextInput, "these steps").click();
    desk.run();
    desk.event(Event::Text("3, 7, 12".to_owned()));
    desk.run();
    assert!(shown_command(&desk).contains("--steps=3,7,12"), "{}", shown_command(&desk));
    assert!(!desk.says("Give steps from 0 to 173 with commas between, at most 24."));

    desk.state_mut().view.export.view = FigureView::Worksheet;
    desk.run();
    desk.click(Role::Button, "a new one for each number");
    desk.type_into("number", "17");
    desk.click(Role::CheckBox, "with its solution");
    let command = shown_command(&desk);
    assert!(command.contains("--seed=17") && command.contains("--solution"), "{command}");
    desk.type_into("lines alone", "1.5");
    assert!(shown_command(&desk).contains("--line-scale=1.5"));
}

#[test]
fn what_is_not_saved_is_told_to_be_saved_first() {
    let mut desk = Desk::new();
    with_document!(desk.state_mut().document_mut(), d => d.scenario.recipe.depth -= 1);
    desk.step();
    desk.state_mut().finish_work();
    desk.run();
    desk.press_with(Modifiers::COMMAND, Key::E);
    assert!(desk.says("First save the scenario as scenario.octo."));
    assert!(shown_command(&desk).contains(" scenario.octo "));
}

#[test]
fn an_exported_figure_opens_at_the_same_step() {
    let folder = tempdir().unwrap();
    for format in [Format::Svg, Format::Pdf] {
        let mut desk = Desk::new();
        desk.press(Key::R);
        desk.press(Key::ArrowDown);
        let (step, ray, sentence) =
            (desk.step_number(), desk.plane().scenario.ray, desk.sentence());
        let path = folder.path().join(format!("figure.{}", format.ending()));
        desk.state_mut().view.export =
            Choice { file: path.display().to_string(), ..choice(format) };
        desk.press_with(Modifiers::COMMAND, Key::E);
        desk.click(Role::Button, "Export");
        let context = desk.ctx.clone();
        desk.state_mut().finish_export(&context);

        let again = Desk::with_file(&path);
        assert_eq!(again.state().view.dialog, None);
        assert_eq!(again.step_number(), step, "{format:?}");
        assert_eq!(again.plane().scenario.ray, ray);
        assert_eq!(again.sentence(), sentence);
        assert!(again.plane().path.is_none(), "it is saved under another name");
    }
}

#[test]
fn every_view_that_fits_can_be_chosen() {
    let mut desk = Desk::new();
    desk.press_with(Modifiers::COMMAND, Key::E);
    desk.click(Role::ComboBox, "What");
    desk.click(Role::Button, "t-rail");
    assert_eq!(desk.state().view.export.view, FigureView::TRail);
    assert!(shown_command(&desk).contains("--view=t-rail"));
    // What space shows is asked for only where it is seen.
    assert!(!desk.says("What is shown"));
}

#[test]
fn the_format_follows_the_name_that_is_typed() {
    let mut desk = Desk::new();
    desk.press_with(Modifiers::COMMAND, Key::E);
    let mut type_name = |name: &str| {
        desk.get_by_role_and_label(Role::TextInput, "File").click();
        desk.run();
        desk.press_with(Modifiers::COMMAND, Key::A);
        desk.event(Event::Text(name.to_owned()));
        desk.run();
        shown_command(&desk)
    };
    let command = type_name("a.pdf");
    assert!(command.contains("--format=pdf") && command.ends_with("-o a.pdf"), "{command}");
    let command = type_name(" b.gif ");
    assert!(command.contains("--format=gif --step=all"), "{command}");
    assert!(command.ends_with("-o b.gif"), "{command}");
}

#[test]
fn only_steps_are_a_table_and_are_copied_as_text() {
    let mut desk = Desk::new();
    desk.state_mut().view.export = Choice { view: FigureView::Table, ..choice(Format::Latex) };
    desk.press_with(Modifiers::COMMAND, Key::E);
    assert!(desk.says("Copy as text") && !desk.says("Copy as SVG"));
    desk.click(Role::ComboBox, "What");
    desk.click(Role::Button, "t-rail");
    assert!(shown_command(&desk).contains("--format=svg"), "{}", shown_command(&desk));
    assert!(!desk.says("Markdown"), "only steps are a table");
}

#[test]
fn what_is_copied_is_made_elsewhere_and_said() {
    let mut desk = Desk::new();
    let mut copy = |choice: Choice, button: &str, said: &str| {
        desk.state_mut().view.export = choice;
        desk.press_with(Modifiers::COMMAND, Key::E);
        desk.get_by_role_and_label(Role::Button, button).click();
        let mut copied = Vec::new();
        for _ in 0..2 {
            desk.step();
            copied.extend(desk.output().platform_output.commands.clone());
        }
        // If it was not there at once.
        let context = desk.ctx.clone();
        desk.state_mut().finish_export(&context);
        copied.extend(context.output(|output| output.commands.clone()));
        desk.run();
        assert!(desk.says(said), "{:?}", desk.texts());
        desk.press(Key::Escape);
        copied
    };
    let svg = copy(choice(Format::Svg), "Copy as SVG", "as the text of an SVG");
    assert!(matches!(&svg[..], [OutputCommand::CopyText(text)] if text.starts_with("<svg")));
    let image = copy(choice(Format::Png), "Copy as image", "as an image");
    assert!(matches!(&image[..], [OutputCommand::CopyImage(image)] if image.width() > 100));
    let table = Choice { view: FigureView::Table, ..choice(Format::Csv) };
    let table = copy(table, "Copy as text", "The table of steps");
    assert!(
        matches!(&table[..], [OutputCommand::CopyText(text)] if text.starts_with("step,")),
        "{table:?}"
    );
}

#[test]
fn the_dialog_says_of_which_steps_its_picture_is() {
    let mut desk = Desk::new();
    let mut said = |choice: Choice, step: usize| {
        desk.state_mut().view.playback.step = step;
        desk.state_mut().view.export = choice;
        desk.open_export();
        let texts = desk.texts();
        desk.press(Key::Escape);
        texts
    };
    let table = |format| Choice { view: FigureView::Table, ..choice(format) };
    let series = Choice { steps: StepChoice::Range, range: [3, 5], ..choice(Format::Svg) };
    for (choice, step, told) in [
        (table(Format::Svg), 80, Some("The last 24 of 80 steps")),
        (table(Format::Csv), 80, Some("The text has all 173 steps, this picture 57 to 80")),
        (table(Format::Svg), 9, None),
        (series.clone(), 80, Some("Step 5, one of 3 to 5")),
        (series, 4, Some("Step 4, one of 3 to 5")),
        (choice(Format::Gif), 7, Some("Step 7, one of 0 to 173")),
        (choice(Format::Svg), 7, None),
    ] {
        let what = format!("{:?} {:?} {step}", choice.view, choice.format);
        let texts = said(choice, step);
        let known = ["The last ", "The text has", ", one of "];
        let found = texts.iter().find(|text| known.iter().any(|known| text.contains(known)));
        assert_eq!(found.map(String::as_str), told, "{what}: {texts:?}");
    }
}

#[test]
fn the_notation_of_a_formula_is_chosen_in_the_dialog() {
    let mut desk = Desk::new();
    desk.state_mut().view.export.view = FigureView::Formula;
    desk.press_with(Modifiers::COMMAND, Key::E);
    desk.click(Role::ComboBox, "Notation");
    desk.click(Role::Button, "As Frisken and Perry write");
    assert!(shown_command(&desk).contains("--notation=frisken-perry"), "{}", shown_command(&desk));
    assert_eq!(desk.state().view.notation, Notation::FriskenPerry);
}

#[test]
fn what_was_chosen_is_remembered() {
    let mut desk = Desk::new();
    desk.press_with(Modifiers::COMMAND, Key::E);
    desk.click(Role::Button, "PDF");
    assert!(desk.state().view.export.file.ends_with(".pdf"));
    desk.click(Role::ComboBox, "What");
    desk.click(Role::Button, "Worksheet");
    desk.click(Role::CheckBox, "with its solution");
    desk.press(Key::Escape);
    assert_eq!(desk.state().view.dialog, None);
    let json = serde_json::to_string(&desk.state().view).unwrap();
    let view: View = serde_json::from_str(&json).unwrap();
    assert_eq!(view.export.format, Format::Pdf);
    assert_eq!((view.export.view, view.export.solution), (FigureView::Worksheet, true));
}

#[test]
fn a_view_that_a_scenario_lacks_is_remembered_for_the_next_one() {
    let mut desk = Desk::new();
    desk.state_mut().view.export.view = FigureView::Region;
    desk.press_with(Modifiers::COMMAND, Key::E);
    assert!(shown_command(&desk).contains("--view=space"));
    desk.click(Role::Button, "PDF");
    assert_eq!(desk.state().view.export.view, FigureView::Region);
}

#[test]
fn a_page_like_a_thread_has_a_preview() {
    let mut desk = Desk::new();
    desk.state_mut().view.export = Choice {
        extent: Extent::Sized,
        sides: [1.0, 1e9],
        unit: Unit::Pixel,
        ..choice(Format::Svg)
    };
    desk.open_export();
    assert!(shown_command(&desk).contains("--size=1x16384px"));
    assert!(!desk.texts().iter().any(|text| text.contains("not possible")));
}

#[test]
fn a_path_that_cannot_be_written_stays_to_be_corrected() {
    let mut desk = Desk::new();
    desk.state_mut().view.export.file = "no/such/folder/a.svg".to_owned();
    desk.press_with(Modifiers::COMMAND, Key::E);
    desk.click(Role::Button, "Export");
    let context = desk.ctx.clone();
    desk.state_mut().finish_export(&context);
    desk.run();
    assert_eq!(desk.state().view.dialog, Some(Dialog::Export));
    assert_eq!(desk.state().view.export.file, "no/such/folder/a.svg");
    let is_told = |desk: &Desk| desk.texts().iter().any(|text| text.contains("no such folder"));
    assert!(is_told(&desk), "{:?}", desk.texts());

    desk.state_mut().view.export.file = "no/such/a.svg".to_owned();
    desk.run();
    desk.click(Role::Button, "Close");
    assert_eq!(desk.state().view.dialog, None);
    desk.press_with(Modifiers::COMMAND, Key::E);
    assert!(!is_told(&desk), "{:?}", desk.texts());
}

#[test]
fn the_dialog_says_where_the_file_will_be_and_what_is_there() {
    let folder = tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    std::fs::write(at("old.svg"), "old").unwrap();
    let mut desk = Desk::new();
    desk.press_with(Modifiers::COMMAND, Key::E);
    let here = std::path::absolute("figure.svg").unwrap().display().to_string();
    // In a long path the middle may be missing.
    let end = here.chars().rev().take(14).collect::<Vec<_>>().into_iter().rev();
    let end = end.collect::<String>();
    for (file, start, end, can) in [
        ("figure.svg".to_owned(), "Will be written to /", end.as_str(), true),
        (at("old.svg"), "Is there already and will be replaced: ", "/old.svg", true),
        (at(""), "This is a folder; add the name of a file to it: ", "", false),
        (" ".to_owned(), "Name a file.", "", false),
    ] {
        desk.state_mut().view.export.file = file.clone();
        desk.run();
        let said = desk.texts().into_iter().find(|text| text.starts_with(start));
        assert!(said.is_some_and(|said| said.ends_with(end)), "{file}: {:?}", desk.texts());
        let export = desk.get_by_role_and_label(Role::Button, "Export");
        assert_eq!(export.accesskit_node().is_disabled(), !can, "{file}");
        if !can {
            desk.press(Key::Enter);
            assert!(desk.says(start), "{file}: nothing is tried");
        }
    }
}

#[test]
fn what_is_no_number_is_refused_in_the_dialog_too() {
    for typed in ["nan", "inf", "1/0"] {
        let mut desk = Desk::new();
        desk.press_with(Modifiers::COMMAND, Key::E);
        desk.run_steps(2);
        desk.type_into("Type and lines", "2");
        desk.type_into("Type and lines", typed);
        assert!(desk.says(&format!("“{typed}” is no number from 0.25 to 8")), "{:?}", desk.texts());
        assert_eq!(desk.state().view.export.type_scale, 2.0, "{typed}");
        assert_eq!(desk.state().view.dialog, Some(Dialog::Export));
    }
}

#[test]
fn enter_does_what_the_dialog_is_for() {
    let folder = tempdir().unwrap();
    let path = folder.path().join("a.svg");
    let mut desk = Desk::new();
    desk.state_mut().view.export.file = path.to_string_lossy().into_owned();
    desk.press_with(Modifiers::COMMAND, Key::E);
    desk.run_steps(2);
    // In a field it is for the field.
    desk.type_into("Type and lines", "2");
    assert_eq!(desk.state().view.dialog, Some(Dialog::Export));
    assert!(!path.exists());
    desk.press(Key::Enter);
    let context = desk.ctx.clone();
    desk.state_mut().finish_export(&context);
    assert!(path.exists());
}
