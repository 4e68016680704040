//! Figures and tables for the clipboard, made on another thread.

use super::App;
use super::exporting::{Made, image};
use crate::export::Request;
use crate::job::Title;
use crate::with_document;
use eframe::egui::Context;
use octoscope_core::progress::Progress;

/// As what something is copied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Copying {
    /// The figure in as many pixels as a PNG of it would have.
    Image,
    /// The figure as the text of an SVG.
    Svg,
    /// The table of steps as text.
    Table,
}

impl App {
    /// Copies what is chosen, once it is made.
    pub(super) fn copy(&mut self, context: &Context, as_what: Copying, request: Request) {
        let (mut document, step) = (self.document.clone(), self.view.playback.step);
        let work = move |progress: &Progress| {
            // The window may keep less of a long run, or nothing of it yet.
            with_document!(&mut document, d => d.trace_whole_within(progress))?;
            Ok(match as_what {
                Copying::Image => Made::Image(image(&request.picture(&document, step, progress)?)),
                Copying::Svg => Made::Svg(request.svg(&document, step, progress)?),
                Copying::Table => Made::Table(request.text(&document)?),
            })
        };
        self.make(context, Title::Of("job-copy"), work);
    }
}
