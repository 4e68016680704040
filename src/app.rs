//! The window: keeps the state, and runs one frame of it.

mod exporting;
mod jobs;
mod obey;
mod show;

use crate::command::Command;
use crate::document::AnyDocument;
use crate::files;
use crate::history::{History, Shared, Weighed};
use crate::job::Job;
use crate::look::Look;
use crate::open::open_built_in;
use crate::space::Layers;
use crate::view::View;
use crate::{render, save, theme, with_document};
use eframe::egui::{CentralPanel, Frame, Key, Ui};
use exporting::Exporting;
use jobs::Purpose;
use octoscope_core::gallery::Degenerate;
use octoscope_core::progress::Progress;
use octoscope_core::scenario::{BUILT_IN, StepAt};
use std::path::PathBuf;
use std::time::Duration;

/// The window's whole state.
pub struct App {
    document: AnyDocument,
    /// What was shown when it was last undisturbed, for undo.
    settled: Shown,
    history: History<Shown>,
    /// What the window remembers.
    pub view: View,
    look: Look,
    look_of: (octoscope_core::text::Language, octoscope_figure::Theme),
    job: Option<(Job<anyhow::Result<AnyDocument>>, Purpose)>,
    exporting: Exporting,
    chosen: files::Answers,
    /// One line that says what has just happened.
    status: String,
    /// Number of searches for another ray: the seed of the next one.
    n_searches: u64,
    /// The ray of the gallery that was shown last.
    degenerate: Option<Degenerate>,
    /// Layers on the graphics adapter; `None` without one.
    layers: Option<Layers>,
}

/// What undo brings back: the document, and where the playhead was in it.
#[derive(Clone)]
struct Shown {
    document: AnyDocument,
    step: usize,
}

impl Weighed for Shown {
    fn shared(&self) -> Vec<Shared> {
        self.document.shared()
    }
}

impl App {
    /// Window on `start`, else on what was open last, else on the first scene.
    pub fn new(creation: &eframe::CreationContext<'_>, start: Option<PathBuf>) -> Self {
        let view: View = creation
            .storage
            .and_then(|storage| storage.get_string(save::VIEW_KEY))
            .and_then(|json| serde_json::from_str(&json).ok())
            .unwrap_or_default();
        let mut app = Self::with_document(first_scene(), view, layers(creation));
        theme::install_fonts(&creation.egui_ctx);
        if let Some(path) = start {
            app.open(&creation.egui_ctx, path);
        } else if let Some(last) = creation.storage.and_then(save::remembered) {
            app.restore(&creation.egui_ctx, last);
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
        let look_of = (view.language, view.theme);
        let mut app = Self {
            settled: Shown { document: document.clone(), step: 0 },
            document,
            history: History::default(),
            look: theme::look(view.language, view.theme),
            look_of,
            view,
            job: None,
            exporting: Exporting::default(),
            chosen: files::Answers::default(),
            status: String::new(),
            n_searches: 0,
            degenerate: None,
            layers,
        };
        app.go_to_start();
        app.settled.step = app.view.playback.step;
        app
    }

    /// What is open.
    pub fn document(&self) -> &AnyDocument {
        &self.document
    }

    /// What is open, to be changed as panels and handles do.
    pub fn document_mut(&mut self) -> &mut AnyDocument {
        &mut self.document
    }

    /// Moves the playhead to where the scenario wants it.
    fn go_to_start(&mut self) {
        let length = self.document.n_events();
        let step: StepAt = with_document!(&self.document, document => document.opened().step);
        self.view.playback.playing = false;
        self.view.playback.go_to(step.position(length), length);
        (self.view.plane_camera, self.view.orbit_camera) = (None, None);
    }
}

/// Layers for the space view, if there is a graphics adapter.
fn layers(creation: &eframe::CreationContext<'_>) -> Option<Layers> {
    let state = creation.wgpu_render_state.as_ref()?;
    render::install(state);
    Some(Layers::default())
}

/// The scene that a first start shows.
fn first_scene() -> AnyDocument {
    open_built_in(BUILT_IN[0].id, &Progress::default()).expect("built-in scenes are sound")
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        let context = ui.ctx().clone();
        self.poll_job();
        self.take_answers(&context);
        self.open_dropped(&context);
        let mut commands = self.pressed(&context);
        let dt_secs = f64::from(context.input(|input| input.stable_dt)).min(0.25);
        self.view.playback.advance(dt_secs, self.document.n_events());

        let look_of = (self.view.language, self.view.theme);
        if self.look_of != look_of {
            self.look = theme::look(look_of.0, look_of.1);
            self.look_of = look_of;
        }
        theme::apply(&context, &self.view);

        if self.view.blank {
            let frame = Frame::new().fill(self.look.palette.background);
            CentralPanel::default().frame(frame).show(ui, |_| {});
            let woken = context
                .input(|input| input.pointer.any_pressed() || input.key_pressed(Key::Escape));
            if woken {
                commands.push(Command::Blank);
            }
        } else {
            self.show(ui, &mut commands);
        }
        for command in commands {
            self.obey(&context, command);
        }
        let step = self.view.playback.step;
        let step_now = with_document!(&mut self.document, document => document.refresh(step));
        if step_now != step {
            self.go_to(step_now);
        }
        self.rebuild_if_needed(&context);
        self.settle(&context);
        if self.view.hover.turn() {
            context.request_repaint();
        }

        if self.job.is_some() {
            context.request_repaint_after(Duration::from_millis(30));
        }
        if let Some(secs) = self.view.playback.secs_to_next() {
            context.request_repaint_after(Duration::from_secs_f64(secs.clamp(0.001, 1.0)));
        }
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        if let Ok(view) = serde_json::to_string(&self.view) {
            storage.set_string(save::VIEW_KEY, view);
        }
        save::remember(storage, &self.document, self.scenario_now());
    }
}
