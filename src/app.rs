//! The window: keeps the state, shows the panels, obeys the commands.

use crate::command::{COMMANDS, Command, belongs_to_focus};
use crate::document::{AnyDocument, Document};
use crate::files::{self, Chosen};
use crate::history::History;
use crate::job::{Job, Poll};
use crate::look::Look;
use crate::open::{open, open_built_in, open_scenario};
use crate::panels::{dialogs, menu, sentence, timeline};
use crate::space::Layers;
use crate::view::{Dialog, View};
use crate::{export, render, save, sidebar, theme, with_document};
use anyhow::anyhow;
use eframe::egui::{CentralPanel, Context, Frame, Key, Margin, Panel, Ui, ViewportCommand, vec2};
use octoscope_core::explain::{sentence as sentence_of, short_title};
use octoscope_core::gallery::{Degenerate, snap};
use octoscope_core::progress::Progress;
use octoscope_core::query::Query;
use octoscope_core::scenario::{AnyScenario, BUILT_IN, StepAt};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The window's whole state.
pub struct App {
    document: AnyDocument,
    /// The document when it was last undisturbed, for undo.
    settled: AnyDocument,
    history: History<AnyDocument>,
    /// What the window remembers.
    pub view: View,
    look: Look,
    look_of: (octoscope_core::text::Language, octoscope_figure::Theme),
    job: Option<(Job<anyhow::Result<AnyDocument>>, Purpose)>,
    chosen: files::Answers,
    /// One line that says what has just happened.
    status: String,
    /// The ray of the gallery that was shown last.
    degenerate: Option<Degenerate>,
    /// Layers on the graphics adapter; `None` without one.
    layers: Option<Layers>,
}

/// What the result of a job is for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Purpose {
    /// It is shown instead of the present document.
    Open,
    /// It is what was open last; if it cannot be opened any more, nothing is said.
    Restore,
    /// Its tree is taken into the present document.
    Rebuild,
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
            settled: document.clone(),
            document,
            history: History::default(),
            look: theme::look(view.language, view.theme),
            look_of,
            view,
            job: None,
            chosen: files::Answers::default(),
            status: String::new(),
            degenerate: None,
            layers,
        };
        app.go_to_start();
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
        let step: StepAt = with_document!(&self.document, document => document.scenario.step);
        self.view.playback.playing = false;
        self.view.playback.go_to(step.position(length), length);
        (self.view.plane_camera, self.view.orbit_camera) = (None, None);
    }

    /// Opens a file on another thread.
    pub fn open(&mut self, context: &Context, path: PathBuf) {
        let title = self.look.texts.format("job-open", &[("name", file_name(&path).into())]);
        let work = move |progress: &Progress| open(&path, progress);
        self.job = Some((Job::start(title, context, work), Purpose::Open));
    }

    /// Opens what was open last, on another thread as well.
    fn restore(&mut self, context: &Context, (scenario, folder): (AnyScenario, PathBuf)) {
        let title = self.look.text("job-restore");
        let work = move |progress: &Progress| {
            let mut document = open_scenario(scenario, &folder, progress)?;
            with_document!(&mut document, document => document.folder = folder);
            Ok(document)
        };
        self.job = Some((Job::start(title, context, work), Purpose::Restore));
    }

    fn open_scene(&mut self, context: &Context, id: &'static str) {
        let title = self.look.texts.format("job-open", &[("name", id.into())]);
        let work = move |progress: &Progress| open_built_in(id, progress);
        self.job = Some((Job::start(title, context, work), Purpose::Open));
    }

    fn open_dropped(&mut self, context: &Context) {
        let dropped = context.input(|input| input.raw.dropped_files.clone());
        let Some(file) = dropped.into_iter().next() else { return };
        let path = file.path().to_owned();
        self.open(context, path);
    }

    fn rebuild_if_needed(&mut self, context: &Context) {
        let needs = with_document!(&self.document, document => document.needs_building());
        if !needs || self.job.is_some() {
            return;
        }
        let title = self.look.text("job-build");
        let document = self.document.clone();
        let work = move |progress: &Progress| match document {
            AnyDocument::Plane(document) => {
                let document = Document::new(document.scenario, document.content, progress)?;
                Ok(AnyDocument::Plane(Box::new(document)))
            }
            AnyDocument::Space(document) => {
                let document = Document::new(document.scenario, document.content, progress)?;
                Ok(AnyDocument::Space(Box::new(document)))
            }
        };
        self.job = Some((Job::start(title, context, work), Purpose::Rebuild));
    }

    /// Waits until what is being opened or built is there; without work, not at all.
    pub fn finish_work(&mut self) {
        if let Some((job, purpose)) = &self.job {
            self.conclude(job.wait(), *purpose);
        }
    }

    fn poll_job(&mut self) {
        if let Some((job, purpose)) = &self.job {
            self.conclude(job.poll(), *purpose);
        }
    }

    /// Takes what a job has come to.
    fn conclude(&mut self, poll: Poll<anyhow::Result<AnyDocument>>, purpose: Purpose) {
        let result = match poll {
            Poll::Running => return,
            Poll::Done(result) => result,
            Poll::Broken => Err(anyhow!(self.look.text("job-broken"))),
        };
        self.job = None;
        match (result, purpose) {
            (Ok(document), Purpose::Open) => {
                self.settle_now();
                self.history.record(std::mem::replace(&mut self.document, document));
                self.settled = self.document.clone();
                self.status.clear();
                self.go_to_start();
            }
            (Ok(document), Purpose::Restore) => {
                self.document = document;
                self.settled = self.document.clone();
                self.go_to_start();
            }
            (Err(_), Purpose::Restore) => {}
            (Ok(rebuilt), Purpose::Rebuild) => match (&mut self.document, rebuilt) {
                (AnyDocument::Plane(now), AnyDocument::Plane(rebuilt)) => now.adopt(&rebuilt),
                (AnyDocument::Space(now), AnyDocument::Space(rebuilt)) => now.adopt(&rebuilt),
                (AnyDocument::Plane(_), AnyDocument::Space(_))
                | (AnyDocument::Space(_), AnyDocument::Plane(_)) => {}
            },
            (Err(error), Purpose::Open | Purpose::Rebuild) => {
                if purpose == Purpose::Rebuild {
                    with_document!(&mut self.document, document => document.keep_tree());
                }
                if !error.root_cause().is::<octoscope_core::progress::Cancelled>() {
                    self.view.dialog = Some(Dialog::Error(format!("{error:#}")));
                }
            }
        }
    }

    /// Remembers the state for undo once no gesture is going on.
    fn settle(&mut self, context: &Context) {
        let busy = context.input(|input| input.pointer.any_down()) || self.job.is_some();
        if !busy {
            self.settle_now();
        }
    }

    fn settle_now(&mut self) {
        if !self.document.is_same_state(&self.settled) {
            self.history.record(std::mem::replace(&mut self.settled, self.document.clone()));
        }
    }

    /// Commands whose keys were pressed.
    fn pressed(&self, context: &Context) -> Vec<Command> {
        if context.text_edit_focused() {
            return Vec::new();
        }
        let focused = context.memory(|memory| memory.focused().is_some());
        context.input_mut(|input| {
            let keys =
                COMMANDS.iter().flat_map(|row| row.keys.iter().map(|key| (row.command, key)));
            let free = keys.filter(|(_, key)| !(focused && belongs_to_focus(key)));
            // Longer shortcuts first: Ctrl+Shift+S is not Ctrl+S.
            let mut free: Vec<_> = free.collect();
            free.sort_by_key(|(_, key)| !key.modifiers.shift);
            free.into_iter()
                .filter(|(_, key)| input.consume_shortcut(key))
                .map(|(c, _)| c)
                .collect()
        })
    }

    fn is_enabled(&self, command: Command) -> bool {
        let (step, length) = (self.view.playback.step, self.document.n_events());
        match command {
            Command::Undo => self.history.can_undo(),
            Command::Redo => self.history.can_redo(),
            Command::StepForward | Command::NextLeaf | Command::Last => step < length,
            Command::StepBack | Command::PreviousLeaf | Command::First => step > 0,
            Command::ReverseRay | Command::SnapRay | Command::NextDegenerate => {
                self.is_about_a_ray()
            }
            Command::Degenerate(ray) => self.is_about_a_ray() && ray.exists_in(self.dimension()),
            Command::Open
            | Command::Save
            | Command::SaveAs
            | Command::Export
            | Command::Quit
            | Command::Play
            | Command::Faster
            | Command::Slower
            | Command::Preset(_)
            | Command::FrameAll
            | Command::NextTheme
            | Command::NextLanguage
            | Command::ScaleUp
            | Command::ScaleDown
            | Command::ScaleReset
            | Command::FullScreen
            | Command::Blank
            | Command::Keys
            | Command::About => true,
        }
    }

    fn obey(&mut self, context: &Context, command: Command) {
        let length = self.document.n_events();
        let step = self.view.playback.step;
        match command {
            Command::Open => self.chosen.ask_open(context),
            Command::Save => self.save(context, false),
            Command::SaveAs => self.save(context, true),
            Command::Export => self.view.dialog = Some(Dialog::Export),
            Command::Quit => context.send_viewport_cmd(ViewportCommand::Close),
            Command::Undo => self.travel(History::undo),
            Command::Redo => self.travel(History::redo),
            Command::StepForward => self.go_to(step + 1),
            Command::StepBack => self.go_to(step.saturating_sub(1)),
            Command::First => self.go_to(0),
            Command::Last => self.go_to(length),
            Command::NextLeaf => {
                self.go_to(with_document!(&self.document, d => d.trace.next_leaf(step)));
            }
            Command::PreviousLeaf => {
                self.go_to(with_document!(&self.document, d => d.trace.previous_leaf(step)));
            }
            Command::Play => self.view.playback.toggle(length),
            Command::Faster => self.view.playback.change_speed(2.0),
            Command::Slower => self.view.playback.change_speed(0.5),
            Command::FrameAll => (self.view.plane_camera, self.view.orbit_camera) = (None, None),
            Command::ReverseRay => with_document!(&mut self.document, d => d.reverse_ray()),
            Command::SnapRay if self.is_enabled(command) => self.snap_ray(),
            Command::NextDegenerate if self.is_enabled(command) => {
                let first = Degenerate::ALL[0];
                let dimension = self.dimension();
                self.aim(self.degenerate.map_or(first, |last| last.following(dimension)));
            }
            Command::Degenerate(ray) => self.aim(ray),
            Command::SnapRay | Command::NextDegenerate => {}
            Command::FullScreen => {
                let full = context.input(|input| input.viewport().fullscreen.unwrap_or(false));
                context.send_viewport_cmd(ViewportCommand::Fullscreen(!full));
            }
            Command::Preset(_)
            | Command::NextTheme
            | Command::NextLanguage
            | Command::ScaleUp
            | Command::ScaleDown
            | Command::ScaleReset
            | Command::Blank
            | Command::Keys
            | Command::About => self.view.obey(command),
        }
    }

    fn is_about_a_ray(&self) -> bool {
        with_document!(&self.document, d => matches!(d.scenario.query, Query::Ray { .. }))
    }

    fn dimension(&self) -> usize {
        match self.document {
            AnyDocument::Plane(_) => 2,
            AnyDocument::Space(_) => 3,
        }
    }

    /// Takes a ray of the gallery, into the view as well, and says what is to be
    /// watched on it.
    fn aim(&mut self, degenerate: Degenerate) {
        self.degenerate = Some(degenerate);
        let found = with_document!(&mut self.document, d => {
            let ray = degenerate.ray(&d.tree);
            ray.map(|ray| d.scenario.ray = ray).is_some()
        });
        if found {
            let language = self.view.language;
            (self.view.plane_camera, self.view.orbit_camera) = (None, None);
            self.status = format!("{}: {}", degenerate.name(language), degenerate.watch(language));
        }
    }

    /// Makes the ray degenerate in the nearest way and says in which.
    fn snap_ray(&mut self) {
        let snapped = with_document!(&mut self.document, d => {
            snap(&d.tree, &d.scenario.ray).map(|snapped| {
                d.scenario.ray = snapped.ray;
                snapped.snap
            })
        });
        if let Some(snap) = snapped {
            self.status = snap.told(self.view.language);
        }
    }

    fn go_to(&mut self, step: usize) {
        self.view.playback.playing = false;
        self.view.playback.go_to(step, self.document.n_events());
    }

    fn travel(
        &mut self,
        direction: impl FnOnce(&mut History<AnyDocument>, AnyDocument) -> Option<AnyDocument>,
    ) {
        // What is being changed right now is a state of its own, and a tree
        // that is being built for it belongs to no other document.
        self.settle_now();
        self.job.take_if(|(_, purpose)| *purpose == Purpose::Rebuild);
        if let Some(document) = direction(&mut self.history, self.document.clone()) {
            if !document.is_same_place(&self.document) {
                (self.view.plane_camera, self.view.orbit_camera) = (None, None);
            }
            self.document = document;
            self.settled = self.document.clone();
        }
    }

    /// The scenario with the playhead where it is.
    fn scenario_now(&self) -> AnyScenario {
        self.document.scenario_at(self.view.playback.step)
    }

    fn save(&mut self, context: &Context, ask: bool) {
        let path = with_document!(&self.document, document => document.path.clone());
        match path {
            Some(path) if !ask => self.save_to(&path),
            Some(_) | None => self.chosen.ask_save(context),
        }
    }

    fn save_to(&mut self, path: &Path) {
        match save::scenario(&self.document, self.scenario_now(), path) {
            Ok(()) => {
                with_document!(&mut self.document, d => d.path = Some(path.to_owned()));
                let name = file_name(path);
                self.status = self.look.texts.format("status-saved", &[("name", name.into())]);
            }
            Err(error) => self.view.dialog = Some(Dialog::Error(format!("{error:#}"))),
        }
    }

    fn export_to(&mut self, path: &Path) {
        match export::space_view(&self.document, &self.scenario_now(), &self.view, path) {
            Ok(()) => {
                let name = file_name(path);
                self.status = self.look.texts.format("status-exported", &[("name", name.into())]);
            }
            Err(error) => self.view.dialog = Some(Dialog::Error(format!("{error:#}"))),
        }
    }

    fn take_answers(&mut self, context: &Context) {
        match self.chosen.take() {
            None => {}
            Some(Chosen::Open(path)) => self.open(context, path),
            Some(Chosen::Save(path)) => self.save_to(&path),
            Some(Chosen::Export(path)) => self.export_to(&path),
            Some(Chosen::NoDialog) => {
                self.view.dialog = Some(Dialog::Path(String::new()));
            }
        }
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

fn file_name(path: &Path) -> String {
    path.file_name()
        .map_or_else(|| path.display().to_string(), |n| n.to_string_lossy().into_owned())
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

impl App {
    /// Shows all panels.
    fn show(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let step = self.view.playback.step;
        let bar = |fill| Frame::new().fill(fill).inner_margin(Margin::symmetric(12, 6));
        let palette = self.look.palette;
        let title = with_document!(&self.document, d => {
            short_title(&d.scenario, d.tree.n_leaves(), self.view.language)
        });
        Panel::top("menu").frame(bar(palette.panel)).show(ui, |ui| {
            let mut language = self.view.language;
            menu::ui(ui, &self.look, &title, &mut language, |c| self.is_enabled(c), commands);
            self.view.language = language;
        });
        let bottom = Frame::new().fill(palette.background).inner_margin(Margin::symmetric(20, 12));
        Panel::bottom("sentence").frame(bottom).show(ui, |ui| {
            let height = if self.view.preset.scale() > 1.0 { 62.0 } else { 60.0 };
            ui.allocate_ui(vec2(ui.available_width(), height), |ui| {
                ui.set_min_height(height);
                let text = with_document!(&self.document, d => {
                    sentence_of(&d.tree, &d.scenario.ray, &d.trace, step, self.view.language)
                });
                sentence::ui(ui, &self.look, &text);
            });
            with_document!(&self.document, d => {
                timeline::ui(ui, &self.look, &d.trace, &d.rounded, &mut self.view.playback, commands);
            });
        });
        let layers = self.layers.as_mut();
        let scene = with_document!(&mut self.document, d => {
            sidebar::ui(ui, &self.look, d, &mut self.view, layers, &mut self.status)
        });
        if let Some(id) = scene {
            self.open_scene(&ui.ctx().clone(), id);
        }
        self.show_dialogs(ui, commands);
    }

    fn show_dialogs(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let context = ui.ctx().clone();
        if let Some((job, _)) = &self.job
            && job.is_shown()
            && dialogs::progress(&context, &self.look, &job.title, job.progress.fraction())
        {
            job.progress.cancel();
        }
        let answer = dialogs::ui(&context, &self.look, &mut self.view.dialog, commands);
        match answer {
            None => {}
            Some(dialogs::Answer::Export(format)) => self.chosen.ask_export(&context, format),
            Some(dialogs::Answer::Path(path)) => self.open(&context, path),
        }
        dialogs::status(&context, &self.look, &mut self.status);
    }
}
