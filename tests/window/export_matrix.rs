//! Every view in every format: the window writes what the command that it shows writes.

use crate::desk::{Desk, sample};
use clap::Parser;
use eframe::egui::{Key, Modifiers, accesskit::Role};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use octoscope::cli::{self, Arguments};
use octoscope::export::{Choice, Extent, Format, StepChoice};
use octoscope::figures::views_of;
use octoscope::view::Dialog;
use octoscope::with_document;
use octoscope_core::scenario::built_in;
use octoscope_figure::Unit;
use octoscope_figure::views::FigureView;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::ExitCode;
use tempfile::tempdir;

/// Words of a line as a shell reads them that does no more than take quotes away.
fn words(line: &str) -> Vec<String> {
    let (mut words, mut word, mut is_quoted) = (Vec::new(), String::new(), false);
    for sign in line.chars() {
        match sign {
            '\'' => is_quoted = !is_quoted,
            ' ' if !is_quoted => words.push(std::mem::take(&mut word)),
            other => word.push(other),
        }
    }
    words.push(word);
    words
}

/// The names of the files in a folder with what is in them, which is then empty.
fn taken(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    let take = |path: &std::path::PathBuf| {
        let bytes = fs::read(path).unwrap();
        fs::remove_file(path).unwrap();
        (path.file_name().unwrap().to_string_lossy().into_owned(), bytes)
    };
    files.iter().map(take).collect()
}

/// Exports from the dialog, then by the command that it shows.
#[track_caller]
fn check(desk: &mut Desk, folder: &Path, choice: Choice) {
    let what = (choice.view, choice.format, choice.steps);
    desk.state_mut().view.export = choice;
    desk.key_press_modifiers(Modifiers::COMMAND, Key::E);
    // A dialog finds its place in its second frame.
    desk.step();
    desk.step();
    assert_eq!(desk.state().view.dialog, Some(Dialog::Export), "{what:?}");
    let texts = desk.texts();
    let command = texts.iter().find(|text| text.starts_with("octoscope export")).unwrap();
    desk.get_by_role_and_label(Role::Button, "Export").click();
    desk.step();
    let context = desk.ctx.clone();
    desk.state_mut().finish_export(&context);
    assert_eq!(desk.state().view.dialog, None, "{command}");
    let by_window = taken(folder);

    let parsed = Arguments::try_parse_from(words(command)).unwrap();
    let ended = cli::run(&parsed.command.expect("a command is shown"));
    assert_eq!(ended, ExitCode::SUCCESS, "{command}");
    let by_command = taken(folder);
    assert!(by_window.values().all(|bytes| bytes.len() > 300), "{command}");
    assert!(!by_window.is_empty() && by_window == by_command, "{command}");
}

/// Exports those of `views` that what is open has, in all formats; tells which these are.
fn check_all(desk: &mut Desk, step: usize, views: &[FigureView]) -> Vec<FigureView> {
    let folder = tempdir().unwrap();
    desk.state_mut().view.playback.step = step;
    desk.step();
    let had = with_document!(desk.state().document(), d => views_of(&d.scenario.query));
    let views: Vec<_> = had.into_iter().filter(|view| views.contains(view)).collect();
    for &view in &views {
        let fits = |format: &Format| !format.is_of_text() || view == FigureView::Table;
        for format in Format::ALL.into_iter().filter(fits) {
            let mut choice = Choice { view, ..Choice::default() };
            choice.set_format(format);
            choice.file = folder.path().join(&choice.file).display().to_string();
            if format.is_of_pixels() {
                (choice.extent, choice.unit) = (Extent::Sized, Unit::Pixel);
                choice.sides = [150.0, 120.0];
            }
            // Of one view also rows of files, pages and pictures.
            let is_row = format.moves() || view == FigureView::Tree;
            choice.steps = if is_row { StepChoice::Range } else { StepChoice::Here };
            choice.range = [step, step + 1];
            check(desk, folder.path(), choice);
        }
    }
    views
}

/// Exports all of these views, each where there is something to show.
fn check_views(views: &[FigureView]) {
    let mut desk = Desk::of(Harness::builder(), [700.0, 560.0]);
    let mut left = views.to_vec();
    for (name, step) in [("exercise.octo", 12), ("region.octo", 5), ("neighbour.octo", 3)] {
        desk.open(sample(name));
        let seen = check_all(&mut desk, step, &left);
        left.retain(|view| !seen.contains(view));
    }
    assert_eq!(left, []);
}

/// Those that have pictures or tables.
const LARGE: [FigureView; 4] =
    [FigureView::Space, FigureView::Table, FigureView::Storyboard, FigureView::Worksheet];

#[test]
fn large_views_in_every_format_are_what_the_command_in_the_dialog_writes() {
    check_views(&LARGE);
}

#[test]
fn other_views_in_every_format_are_what_the_command_in_the_dialog_writes() {
    let others: Vec<_> = FigureView::ALL.into_iter().filter(|view| !LARGE.contains(view)).collect();
    check_views(&others);
}

#[test]
fn the_space_view_of_an_octree_is_what_the_command_in_the_dialog_writes() {
    let mut desk = Desk::of(Harness::builder(), [700.0, 560.0]);
    let folder = tempdir().unwrap();
    let cube = folder.path().join("a cube.octo");
    fs::write(&cube, built_in("figure-7").unwrap().print()).unwrap();
    desk.open(&cube);
    check_all(&mut desk, 9, &[FigureView::Space]);
}
