//! The window: keeps the state, and runs one frame of it.

mod copying;
mod exporting;
mod hall;
mod jobs;
mod keeping;
mod keys;
mod measuring;
mod obey;
mod runs;
mod saving;
mod seen;
mod show;
mod telling;
mod undo;

use crate::command::Command;
use crate::document::{AnyDocument, Document};
use crate::files;
use crate::history::{History, Shared, Weighed};
use crate::job::Job;
use crate::look::Look;
use crate::map::Maps;
use crate::notice::Notice;
use crate::open::open_built_in;
use crate::save::Last;
use crate::space::Layers;
use crate::view::{Dialog, Preset, View};
use crate::widgets::refused_number;
use crate::{render, save, theme, with_document};
use eframe::egui::{CentralPanel, Context, Event, Frame, Id, Key, Ui, ViewportCommand};
use exporting::Exporting;
use jobs::Task;
use keeping::Keeping;
use keys::Taken;
use measuring::Measuring;
use octoscope_core::explain::short_title;
use octoscope_core::gallery::Degenerate;
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::scenario::BUILT_IN;
use octoscope_core::text::Language;
use octoscope_figure::{Show, Theme};
use saving::Saving;
use std::path::PathBuf;
use std::time::Duration;

/// The window's whole state.
pub struct App {
    document: AnyDocument,
    /// What was shown when it was last undisturbed, for undo.
    settled: Shown,
    history: History<Shown>,
    /// The document as its file has it, or as it was opened.
    saved: AnyDocument,
    /// Title of the window in the last frame.
    title: String,
    /// What the window remembers.
    pub view: View,
    look: Look,
    look_of: LookedAt,
    job: Option<(Job<anyhow::Result<AnyDocument>>, Task)>,
    /// What was open last, as long as it is not there.
    unrestored: Option<Last>,
    /// What the window is started on, while changes that no file has come before it: they
    /// are brought back by undo.
    started_on: Option<PathBuf>,
    /// The trace that is being made of a long run.
    tracing: Option<Job<Result<AnyDocument, Cancelled>>>,
    /// What is being found out about the run.
    judging: Option<Job<Result<AnyDocument, Cancelled>>>,
    exporting: Exporting,
    measuring: Measuring,
    keeping: Keeping,
    saving: Saving,
    chosen: files::Answers,
    notice: Notice,
    /// The last notice by its number, and the state that it was about.
    noticed: Option<(u64, AnyDocument)>,
    /// Whether the mirrored ray was shown, in the plane and in space, before a document
    /// was opened that gets it wrong.
    mirrored_before: Option<[bool; 2]>,
    /// Number of searches for another question: the seed of the next one.
    n_searches: u64,
    /// The ray of the gallery that was shown last.
    degenerate: Option<Degenerate>,
    /// Maps of rays, for the panel that shows them.
    maps: Maps,
    /// Whether a dialog lay over everything else in the last frame.
    was_covered: bool,
    /// The field that was edited in the last frame.
    edited: Option<Id>,
    /// Which keys were taken after the last frame.
    taken: Taken,
    /// What was typed for a dialog that was not there yet.
    held_back: Vec<Event>,
    /// Layers on the graphics adapter; `None` without one.
    layers: Option<Layers>,
}

/// What undo brings back: the document, where the playhead was in it, and what the
/// picture showed.
#[derive(Clone)]
struct Shown {
    document: AnyDocument,
    step: usize,
    show: Show,
}

impl Weighed for Shown {
    fn shared(&self) -> Vec<Shared> {
        self.document.shared()
    }
}

impl App {
    /// Window on `start`, else on what was open last, else on the first scene.
    pub fn new(creation: &eframe::CreationContext<'_>, start: Option<PathBuf>) -> Self {
        let mut view: View = creation
            .storage
            .and_then(|storage| storage.get_string(save::VIEW_KEY))
            .and_then(|json| serde_json::from_str(&json).ok())
            .unwrap_or_default();
        view.dialog = view.untold.take().map(Dialog::Error);
        let mut app = Self::with_document(first_scene(), view, layers(creation));
        theme::install_fonts(&creation.egui_ctx);
        let last = creation.storage.and_then(save::remembered);
        match (start, last) {
            (Some(path), Some(last)) if last.unchanged.is_some() => {
                app.restore(&creation.egui_ctx, last);
                app.started_on = Some(path);
            }
            (Some(path), last) => app.start_on(&creation.egui_ctx, path, last),
            (None, Some(last)) => app.restore(&creation.egui_ctx, last),
            (None, None) => {}
        }
        app
    }

    /// Window on the first scene, whatever was open last.
    pub fn first(creation: &eframe::CreationContext<'_>) -> Self {
        Self::on(creation, first_scene())
    }

    /// Window on `document`, as at a first start.
    pub fn on(creation: &eframe::CreationContext<'_>, document: AnyDocument) -> Self {
        theme::install_fonts(&creation.egui_ctx);
        Self::with_document(document, View::default(), layers(creation))
    }

    fn with_document(document: AnyDocument, view: View, layers: Option<Layers>) -> Self {
        let look_of = looked_at(&view);
        let show = *with_document!(&document, d => shown_in(&view, d));
        let mut app = Self {
            settled: Shown { document: document.clone(), step: 0, show },
            saved: document.clone(),
            title: String::new(),
            document,
            history: History::default(),
            look: theme::look_of(&view),
            look_of,
            view,
            job: None,
            unrestored: None,
            started_on: None,
            tracing: None,
            judging: None,
            exporting: Exporting::default(),
            measuring: Measuring::default(),
            keeping: Keeping::default(),
            saving: Saving::default(),
            chosen: files::Answers::default(),
            notice: Notice::default(),
            noticed: None,
            mirrored_before: None,
            n_searches: 0,
            degenerate: None,
            maps: Maps::default(),
            was_covered: false,
            edited: None,
            taken: Taken::default(),
            held_back: Vec::new(),
            layers,
        };
        app.go_to_start();
        app.settled.step = app.view.playback.step;
        app
    }

    /// From now on the picture is drawn whole at once, as it is seen when it rests.
    pub fn draw_whole(&mut self) {
        if let Some(layers) = &mut self.layers {
            layers.draw_whole();
        }
    }

    /// What is open.
    pub fn document(&self) -> &AnyDocument {
        &self.document
    }

    /// What is open, to be changed as panels and handles do.
    pub fn document_mut(&mut self) -> &mut AnyDocument {
        &mut self.document
    }

    /// Whether the scenario differs from its file, or from what was opened.
    pub fn is_changed(&self) -> bool {
        match (&self.document, &self.saved) {
            (AnyDocument::Plane(now), AnyDocument::Plane(saved)) => now.differs_from(saved),
            (AnyDocument::Space(now), AnyDocument::Space(saved)) => now.differs_from(saved),
            (AnyDocument::Plane(now), AnyDocument::Space(_)) => now.differs_from_opened(),
            (AnyDocument::Space(now), AnyDocument::Plane(_)) => now.differs_from_opened(),
        }
    }

    /// Title of what is open, with a star where it has changes that no file has.
    fn titled(&self) -> String {
        let title = with_document!(&self.document, d => {
            let file = d.path.as_deref().map(telling::file_name);
            short_title(d.opened(), file.as_deref(), d.tree.n_leaves(), self.view.language, |id| {
                self.look.text(&format!("scene-{id}"))
            })
        });
        let mark = if self.is_changed() { " *" } else { "" };
        format!("{title}{mark}")
    }

    /// Gives the window the title of what is open.
    fn name_window(&mut self, context: &Context) {
        let title = format!("{} – Octoscope", self.titled());
        if self.title != title {
            context.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.title = title;
        }
    }
}

impl App {
    /// Takes texts, colours and type anew, if what they follow from has changed.
    fn take_look(&mut self, context: &Context) {
        let look_of = looked_at(&self.view);
        if self.look_of == look_of {
            return;
        }
        if self.look_of.language != look_of.language {
            self.notice.clear();
        }
        self.look = theme::look_of(&self.view);
        self.look_of = look_of;
        // Widths and letters still follow the old one: drawn once more, they do not.
        context.request_discard("another theme, language or type");
    }

    /// Shows nothing; whoever presses anything wakes it.
    fn show_blank(&self, ui: &mut Ui) -> Option<Command> {
        let blank = Frame::new().fill(self.look.palette.blank);
        CentralPanel::default().frame(blank).show(ui, |_| {});
        let is_woken =
            ui.input(|input| input.pointer.any_pressed() || input.key_pressed(Key::Escape));
        is_woken.then_some(Command::Blank)
    }

    /// Asks for another frame where something goes on by itself.
    fn plan_next_frame(&self, context: &Context) {
        let is_working = self.job.is_some() || self.tracing.is_some() || self.judging.is_some();
        if is_working || self.is_saving() {
            context.request_repaint_after(Duration::from_millis(30));
        }
        if let Some(secs) = self.view.playback.secs_to_next() {
            context.request_repaint_after(Duration::from_secs_f64(secs.clamp(0.001, 1.0)));
        }
    }
}

fn shown_in<'a, const D: usize>(view: &'a View, _document: &Document<D>) -> &'a Show {
    view.show::<D>()
}

/// Layers for the space view, if there is a graphics adapter.
fn layers(creation: &eframe::CreationContext<'_>) -> Option<Layers> {
    let state = creation.wgpu_render_state.as_ref()?;
    Some(Layers::new(render::install(state)))
}

/// The scene that a first start shows.
fn first_scene() -> AnyDocument {
    open_built_in(BUILT_IN[0].id, &Progress::default()).expect("built-in scenes are sound")
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        let context = ui.ctx().clone();
        self.poll_job();
        self.poll_tracing();
        self.poll_judging();
        self.poll_saving();
        self.take_answers(&context);
        self.open_dropped(&context);
        self.leave_field(&context);
        self.give_held_back(&context);
        let mut commands = Vec::new();
        let dt_secs = f64::from(context.input(|input| input.stable_dt)).min(0.25);
        self.view.playback.advance(dt_secs, self.document.n_events());

        self.take_look(&context);
        theme::apply(&context, &self.view);
        // What encloses the frame was made before, in the old colours.
        ui.reset_style();

        if self.view.blank {
            commands.extend(self.show_blank(ui));
        } else {
            self.show(ui, &mut commands);
        }
        let pressed = self.pressed(&context);
        self.hold_back(&context, &pressed);
        commands.extend(pressed);
        self.show_hall(&context, &mut commands);
        if let Some(wrong) = refused_number(&context) {
            match wrong.as_str() {
                "" => self.notice.clear(),
                wrong if wrong == self.notice.text() => {}
                wrong => self.notice.say(wrong),
            }
        }
        for command in commands {
            self.obey(&context, command);
        }
        let step = self.view.playback.step;
        let step_now = with_document!(&mut self.document, document => document.refresh(step));
        self.follow(step_now);
        self.rebuild_if_needed(&context);
        self.trace_if_needed(&context);
        self.judge_if_needed(&context);
        self.settle(&context);
        self.outdate_notice();
        self.name_window(&context);
        self.keep_now_and_then(&context, frame);
        self.taken = self.taken(&context);
        if self.view.hover.turn() {
            context.request_repaint();
        }

        self.plan_next_frame(&context);
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        let shown = self.view.dialog.take();
        self.forget_typed();
        self.finish_saving();
        // Nobody sees any more what comes of it: the next start tells it.
        if let Some(Dialog::Error(untold)) = &self.view.dialog {
            self.view.untold = Some(untold.clone());
        }
        self.view.dialog = self.view.dialog.take().or(shown);
        self.keep_at_the_end(storage);
    }

    /// What is kept before the end is printed on another thread, see `keeping`.
    fn auto_save_interval(&self) -> Duration {
        Duration::MAX
    }

    fn on_exit(&mut self) {
        self.finish_saving();
        self.give_up_export();
    }
}

/// What texts, colours and type follow from.
#[derive(Clone, Copy, PartialEq, Eq)]
struct LookedAt {
    language: Language,
    theme: Theme,
    preset: Preset,
}

fn looked_at(view: &View) -> LookedAt {
    let View { language, theme, preset, .. } = *view;
    LookedAt { language, theme, preset }
}
