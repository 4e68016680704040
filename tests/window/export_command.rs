//! The command in the dialog of exports gives the same bytes as the dialog.

use crate::desk::Desk;
use crate::export::{choice, shown_command};
use eframe::egui::{Key, accesskit::Role};
use egui_kittest::kittest::Queryable;
use octoscope::export::{Choice, ExerciseChoice, Extent, Format, MomentChoice, StepChoice};
use octoscope::view::Dialog;
use octoscope_core::scenario::built_in;
use octoscope_figure::views::FigureView;
use octoscope_figure::{Background, Camera, Page, Theme, TikzForm, Unit};
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::{TempDir, tempdir};

/// Exports from the dialog; then runs the command that it shows in `folder`, and
/// compares the files.
#[track_caller]
fn check(desk: &mut Desk, folder: &TempDir, choice: Choice) {
    let file = choice.file.clone();
    desk.state_mut().view.export = choice;
    desk.open_export();
    assert_eq!(desk.state().view.dialog, Some(Dialog::Export));
    let command = shown_command(desk);
    let path = folder.path().join(&file);
    let from_window = folder.path().join("window").join(&file);
    fs::create_dir_all(from_window.parent().unwrap()).unwrap();
    desk.state_mut().view.export.file = from_window.display().to_string();
    desk.run();
    desk.get_by_role_and_label(Role::Button, "Export").click();
    desk.step();
    desk.step();
    let context = desk.ctx.clone();
    desk.state_mut().finish_export(&context);
    desk.run();
    assert_eq!(desk.state().view.dialog, None, "{command}");

    let program = Path::new(env!("CARGO_BIN_EXE_octoscope"));
    let line = command.replacen("octoscope", &program.display().to_string(), 1);
    let output =
        Command::new("sh").args(["-c", &line]).current_dir(folder.path()).output().unwrap();
    assert!(output.status.success(), "{command}: {}", String::from_utf8_lossy(&output.stderr));
    let [by_command, by_window] = [path, from_window].map(|path| fs::read(path).unwrap());
    assert!(by_command.len() > 500 && by_command == by_window, "{command}");
}

#[test]
fn the_command_in_the_dialog_gives_the_same_bytes() {
    let folder = tempdir().unwrap();
    let mut desk = Desk::new();
    desk.press(Key::End);
    for format in [Format::Svg, Format::Pdf, Format::Png, Format::Tikz] {
        check(&mut desk, &folder, choice(format));
    }
    for view in [FigureView::TRail, FigureView::Storyboard, FigureView::Listing] {
        let format = if view == FigureView::TRail { Format::Tikz } else { Format::Svg };
        check(&mut desk, &folder, Choice { view, ..choice(format) });
    }
    // A ray that was turned round, from elsewhere, with other things shown.
    desk.press(Key::R);
    let page = Page { width: 640.0, height: 480.0 };
    let bounds = desk.plane().tree.domain().root_box();
    let mut camera = Camera::framing(&bounds, page);
    (camera.target, camera.height) = ([0.31, 0.42], camera.height / 1.7);
    desk.state_mut().view.plane_camera = Some(camera);
    desk.state_mut().view.plane_show.codes = true;
    for (unit, theme) in Unit::ALL.into_iter().zip(Theme::ALL) {
        let chosen = Choice {
            extent: Extent::Sized,
            sides: [200.0, 150.0],
            unit,
            theme,
            type_scale: 1.3,
            background: Background::Transparent,
            ..choice(Format::Svg)
        };
        check(&mut desk, &folder, chosen);
    }
}

#[test]
fn the_command_of_a_range_of_steps_gives_the_same_bytes() {
    let folder = tempdir().unwrap();
    let mut desk = Desk::new();
    desk.open_scenario(&built_in("figure-7").unwrap());
    let saved = folder.path().join("a scene.octo");
    fs::write(&saved, built_in("figure-7").unwrap().print()).unwrap();
    desk.open(&saved);
    let steps = |format| Choice {
        steps: StepChoice::Range,
        range: [3, 6],
        pause_secs: 0.25,
        extent: Extent::Sized,
        sides: [160.0, 120.0],
        unit: Unit::Pixel,
        tikz: TikzForm::Beamer,
        ..choice(format)
    };
    for format in [Format::Gif, Format::Apng, Format::Tikz, Format::Pdf] {
        check(&mut desk, &folder, steps(format));
    }
}

#[test]
fn storyboards_and_worksheets_of_the_dialog_are_those_of_its_command() {
    let folder = tempdir().unwrap();
    let mut desk = Desk::new();
    desk.press(Key::End);
    let story = |moments, line_scale| Choice {
        view: FigureView::Storyboard,
        moments,
        n_moments: 4,
        listed_moments: "3, 7, 12".to_owned(),
        line_scale,
        ..choice(Format::Svg)
    };
    check(&mut desk, &folder, story(MomentChoice::Leaves, 1.0));
    check(&mut desk, &folder, story(MomentChoice::Listed, 2.0));
    // Steps do not count here, so that what moves has a single frame.
    check(
        &mut desk,
        &folder,
        Choice { file: "a.gif".to_owned(), format: Format::Gif, ..story(MomentChoice::Even, 1.0) },
    );
    let sheet = |exercise, solution| Choice {
        view: FigureView::Worksheet,
        exercise,
        seed: 12,
        solution,
        ..choice(Format::Pdf)
    };
    // The ray of the exercise has fewer steps than the playhead has gone.
    check(&mut desk, &folder, sheet(ExerciseChoice::Numbered, false));
    check(&mut desk, &folder, sheet(ExerciseChoice::Numbered, true));
}

#[test]
fn tables_of_the_dialog_are_those_of_its_command() {
    let folder = tempdir().unwrap();
    let mut desk = Desk::new();
    for format in [Format::Markdown, Format::Csv, Format::Latex] {
        check(&mut desk, &folder, Choice { view: FigureView::Table, ..choice(format) });
    }
}
