//! Opens the window.

use crate::app::App;
use crate::open::open;
use anyhow::anyhow;
use eframe::egui::{ColorImage, ScreenshotCallback, ViewportBuilder, ViewportCommand};
use octoscope_core::progress::Progress;
use octoscope_figure::Pixels;
use std::cell::Cell;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What the window is opened for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Opening {
    /// File to open; without it, what was open last.
    pub file: Option<PathBuf>,
    /// Where to write a picture of the first scene, stepped to its end; the
    /// window then closes.
    pub picture: Option<PathBuf>,
}

/// Opens the window and returns when it is closed.
///
/// # Errors
/// Says why there can be no window, and what to install.
pub fn run(opening: Opening) -> anyhow::Result<()> {
    let viewport = ViewportBuilder::default()
        .with_title("Octoscope")
        .with_app_id("octoscope")
        .with_inner_size([1280.0, 800.0])
        .with_min_inner_size([800.0, 560.0])
        .with_drag_and_drop(true);
    let options = eframe::NativeOptions { viewport, ..Default::default() };
    let named = opening.file.clone();
    let was_there = Cell::new(false);
    let result = eframe::run_native(
        "Octoscope",
        options,
        Box::new(|creation| {
            was_there.set(true);
            Ok(match opening.picture {
                Some(picture) => Box::new(Demonstration::new(App::first(creation), picture)),
                None => Box::new(App::new(creation, opening.file)),
            })
        }),
    );
    result.map_err(|error| {
        // Some causes begin with a place in a source file, which helps nobody.
        let cause = error.to_string();
        let cause = cause.rsplit(".rs:").next().unwrap_or_default();
        let cause = cause.trim_start_matches(|c: char| c.is_ascii_digit() || ": ".contains(c));
        let none = format!(
            "no window can be opened: {cause}\n\
             On Debian or Ubuntu, `cargo xtask run` installs what is missing. \
             The commands of `octoscope help` need no window."
        );
        // The window would have told what is wrong with the file.
        let untold = named.filter(|_| !was_there.get());
        match untold.map(|name| open(&name, &Progress::default())) {
            Some(Err(of_file)) => anyhow!("{of_file:#}\n{none}"),
            Some(Ok(_)) | None => anyhow!(none),
        }
    })
}

/// The window for one picture: the first scene after its last step.
struct Demonstration {
    app: App,
    picture: PathBuf,
    frames: u32,
}

impl Demonstration {
    /// Frames until layout and layers have settled.
    const FRAMES: u32 = 6;

    fn new(mut app: App, picture: PathBuf) -> Self {
        let length = app.document().n_events();
        app.view.playback.go_to(length, length);
        Self { app, picture, frames: 0 }
    }
}

impl eframe::App for Demonstration {
    fn ui(&mut self, ui: &mut eframe::egui::Ui, frame: &mut eframe::Frame) {
        self.app.ui(ui, frame);
        let context = ui.ctx().clone();
        self.frames += 1;
        if self.frames == Self::FRAMES {
            let (picture, context) = (self.picture.clone(), context.clone());
            let write = move |image: Arc<ColorImage>| {
                if let Err(error) = write_picture(&picture, &image) {
                    eprintln!("octoscope: {error:#}");
                }
                context.send_viewport_cmd(ViewportCommand::Close);
            };
            let callback = ScreenshotCallback::new(write);
            ui.ctx().send_viewport_cmd(ViewportCommand::Screenshot(callback));
        }
        context.request_repaint();
    }
}

fn write_picture(path: &Path, image: &ColorImage) -> anyhow::Result<()> {
    let [width, height] = image.size.map(|side| side as u32);
    let rgba = image.pixels.iter().flat_map(|pixel| pixel.to_array()).collect();
    let png = octoscope_figure::png_of_pixels(&Pixels { width, height, rgba }, "", "")?;
    crate::files::write(path, &png)
}
