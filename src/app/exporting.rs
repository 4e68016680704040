//! Exports of the window: their dialog, their work on other threads.

use super::App;
use super::copying::Copying;
use super::telling::file_name;
use crate::document::AnyDocument;
use crate::export::{self, OneOf, Origin, Request};
use crate::export_dialog::{self, Answer, PREVIEW, Shown};
use crate::figures::views_of;
use crate::files::{self, Purpose};
use crate::job::{Job, Poll, Title};
use crate::panels::dialogs;
use crate::panels::show::Of;
use crate::text::texts;
use crate::view::Dialog;
use crate::{complaint, with_document};
use anyhow::anyhow;
use eframe::egui::{ColorImage, Context, TextureHandle, TextureOptions};
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::scenario::AnyScenario;
use octoscope_core::text::Texts;
use octoscope_figure::Pixels;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// State of the exports of a window.
#[derive(Default)]
pub(super) struct Exporting {
    preview: Preview,
    /// What is being written to a file or made for the clipboard, one after the other.
    making: Option<Job<anyhow::Result<Made>>>,
    /// Why the last file or copy was not made, in words, while the dialog is open.
    refused: Option<String>,
    /// The last scenario that was saved, and where.
    pub(super) saved: Option<(PathBuf, AnyScenario)>,
}

/// What another thread has made of a document.
pub(super) enum Made {
    /// A file at this path.
    File {
        path: PathBuf,
        /// What is not in it, in words.
        left_out: Option<String>,
    },
    /// The figure for the clipboard.
    Image(ColorImage),
    /// The figure for the clipboard, as SVG.
    Svg(String),
    /// The table of steps for the clipboard.
    Table(String),
}

/// The picture in the dialog, made again when what it shows has changed.
#[derive(Default)]
struct Preview {
    texture: Option<(TextureHandle, OneOf)>,
    /// Why there is none.
    fault: Option<String>,
    /// What the picture shows, or will show once it is made.
    wanted: Option<(AnyDocument, Request, usize)>,
    making: Option<Job<anyhow::Result<export::Preview>>>,
}

impl App {
    /// Shows the dialog of an export, if it is open.
    pub(super) fn show_export_dialog(&mut self, context: &Context) {
        if self.view.dialog != Some(Dialog::Export) {
            self.exporting.preview = Preview::default();
            self.exporting.refused = None;
            return;
        }
        let request = export_dialog::request(&self.document, &self.view);
        self.make_preview(context, &request);
        let origin = Origin::of(&self.document, self.exporting.saved.as_ref());
        let (mut choice, mut language) = (self.view.export.clone(), self.view.language);
        let mut notation = self.view.notation;
        let last_step = self.document.n_events();
        let views = with_document!(&self.document, d => views_of(&d.scenario.query));
        choice.view = request.view;
        let mut show = *self.show_of_document();
        let of = with_document!(&self.document, d => Of::tree(&d.tree, &d.scenario.query));
        let shown = Shown {
            choice: &mut choice,
            views: &views,
            show: &mut show,
            language: &mut language,
            notation: &mut notation,
            of,
            last_step,
            request: &request,
            origin: &origin,
            preview: self.exporting.preview.texture.as_ref(),
            fault: self.exporting.preview.fault.as_deref(),
            refused: self.exporting.refused.as_deref(),
        };
        let answer = export_dialog::ui(context, &self.look, shown);
        // A view that this scenario does not have stays chosen for the next one.
        if choice.view == request.view {
            choice.view = self.view.export.view;
        }
        if choice != self.view.export {
            self.exporting.refused = None;
        }
        (self.view.export, self.view.language) = (choice, language);
        self.view.notation = notation;
        *self.show_of_document_mut() = show;
        match answer {
            None => {}
            Some(Answer::Export) => {
                let path = PathBuf::from(self.view.export.file.trim());
                self.export_to(context, &path);
            }
            Some(Answer::Choose) => {
                self.chosen.ask_export(context, self.view.export.format.ending());
            }
            Some(Answer::CopyImage) => self.copy(context, Copying::Image, request),
            Some(Answer::CopyText) => self.copy(context, Copying::Table, request),
            Some(Answer::CopySvg) => self.copy(context, Copying::Svg, request),
            Some(Answer::CopyCommand) => {
                let line = export_dialog::line(&request, &origin, &self.view.export);
                context.copy_text(line);
                self.notice.say(self.look.text("status-copied-command"));
            }
            Some(Answer::Close) => self.view.dialog = None,
        }
    }

    /// Begins to make something on another thread, if nothing is being made.
    pub(super) fn make(
        &mut self,
        context: &Context,
        title: Title,
        work: impl FnOnce(&Progress) -> anyhow::Result<Made> + Send + 'static,
    ) {
        if self.exporting.making.is_some() {
            self.notice.say(self.look.text("status-still-exporting"));
            return;
        }
        self.notice.clear();
        self.exporting.refused = None;
        self.exporting.making = Some(Job::start(title, context, work));
    }

    /// Writes what is chosen to `path`, on another thread. The ending of the name
    /// tells the format, if it is one. The dialog is open until the file is there, and
    /// says why if it cannot be.
    pub(super) fn export_to(&mut self, context: &Context, path: &Path) {
        self.view.dialog = Some(Dialog::Export);
        self.view.export.set_file(&path.to_string_lossy());
        let request = export_dialog::request(&self.document, &self.view);
        let (name, mut document, path) = (file_name(path), self.document.clone(), path.to_owned());
        let title = Title::Named("job-export", name);
        let language = self.view.language;
        let work = move |progress: &Progress| {
            // The window may keep less of a long run, or nothing of it yet.
            with_document!(&mut document, d => d.trace_whole_within(progress))?;
            let left_out = with_document!(&document, d => request.left_out(d, &texts(language)));
            request.run(&document, Some(&path), progress)?;
            Ok(Made::File { path, left_out })
        };
        self.make(context, title, work);
    }

    /// Waits until what is being written or copied is there.
    pub fn finish_export(&mut self, context: &Context) {
        let Some(job) = self.exporting.making.take() else { return };
        let poll = job.wait();
        self.made(context, poll);
    }

    /// Gives up the file that is being written, which leaves nothing of it behind.
    pub fn give_up_export(&mut self) {
        if let Some(job) = self.exporting.making.take() {
            job.progress.cancel();
            // It takes its unfinished file away.
            job.wait();
        }
    }

    /// Looks whether what is being made is there, and shows how far it is.
    pub(super) fn poll_export(&mut self, context: &Context) {
        let Some(job) = self.exporting.making.take() else { return };
        match job.poll() {
            Poll::Running => {
                let done = job.progress.fraction();
                if job.is_shown() && dialogs::progress(context, &self.look, &job.title, done) {
                    job.progress.cancel();
                }
                context.request_repaint_after(Duration::from_millis(30));
                self.exporting.making = Some(job);
            }
            poll => self.made(context, poll),
        }
    }

    fn made(&mut self, context: &Context, poll: Poll<anyhow::Result<Made>>) {
        let result = match poll {
            Poll::Running => return,
            Poll::Done(result) => result,
            Poll::Broken => Err(anyhow!(self.look.text("job-broken"))),
        };
        match result {
            Ok(Made::File { path, left_out }) => {
                self.view.dialog.take_if(|dialog| *dialog == Dialog::Export);
                self.forget_typed();
                let path = files::whole(&path).display().to_string();
                let said = self.look.texts.format("status-exported", &[("path", path.into())]);
                let all = [Some(said), left_out].into_iter().flatten();
                self.notice.say(all.collect::<Vec<_>>().join(": "));
            }
            Ok(Made::Image(image)) => {
                context.copy_image(image);
                self.notice.say(self.look.text("status-copied-image"));
            }
            Ok(Made::Svg(text)) => {
                context.copy_text(text);
                self.notice.say(self.look.text("status-copied-svg"));
            }
            Ok(Made::Table(text)) => {
                context.copy_text(text);
                self.notice.say(self.look.text("status-copied-table"));
            }
            Err(error) if error.root_cause().is::<Cancelled>() => {
                self.notice.say(self.look.text("status-cancelled"));
            }
            Err(error) if self.view.dialog == Some(Dialog::Export) => {
                self.exporting.refused = Some(complaint::told(&self.look.texts, &error));
            }
            Err(error) => {
                self.refuse_path(&error, |typed| matches!(typed.purpose, Purpose::Lab(_)));
            }
        }
    }

    /// Has the picture made for `request`, if it is another one than before.
    fn make_preview(&mut self, context: &Context, request: &Request) {
        let preview = &mut self.exporting.preview;
        if let Some(job) = preview.making.take() {
            match job.poll() {
                Poll::Running => {
                    context.request_repaint_after(Duration::from_millis(30));
                    preview.making = Some(job);
                    return;
                }
                poll => preview.take(context, &self.look.texts, poll),
            }
        }
        let step = self.view.playback.step;
        let is_wanted = preview.wanted.as_ref().is_some_and(|(document, wanted, at)| {
            document.is_same_state(&self.document) && wanted == request && *at == step
        });
        if is_wanted {
            return;
        }
        let wanted = (self.document.clone(), request.clone(), step);
        preview.wanted = Some(wanted.clone());
        let most = PREVIEW.map(|side| f64::from(side * context.pixels_per_point()));
        let work = move |progress: &Progress| {
            let (document, request, step) = wanted;
            request.preview(&document, step, most, progress)
        };
        preview.making = Some(Job::start(Title::Silent, context, work));
    }

    /// Waits until the picture in the dialog is made.
    pub fn finish_preview(&mut self, context: &Context) {
        if let Some(job) = self.exporting.preview.making.take() {
            self.exporting.preview.take(context, &self.look.texts, job.wait());
        }
    }
}

impl Preview {
    /// Takes the picture that was made, or why it could not be made.
    fn take(
        &mut self,
        context: &Context,
        texts: &Texts,
        poll: Poll<anyhow::Result<export::Preview>>,
    ) {
        match poll {
            Poll::Done(Ok(export::Preview { pixels, of })) => {
                let (image, options) = (image(&pixels), TextureOptions::LINEAR);
                self.texture = Some((context.load_texture("export", image, options), of));
                self.fault = None;
            }
            Poll::Done(Err(error)) => self.fault = Some(complaint::told(texts, &error)),
            Poll::Broken | Poll::Running => {}
        }
    }
}

/// Pixels as the window takes them.
pub(super) fn image(pixels: &Pixels) -> ColorImage {
    let size = [pixels.width as usize, pixels.height as usize];
    ColorImage::from_rgba_unmultiplied(size, &pixels.rgba)
}
