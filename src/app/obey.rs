//! Commands and what they do, undo among them.

use super::jobs::{self, file_name};
use super::{App, Shown};
use crate::arrangement::Change;
use crate::command::{COMMANDS, Command, belongs_to_focus};
use crate::document::AnyDocument;
use crate::files::{self, Chosen, Purpose};
use crate::finder::Target;
use crate::history::History;
use crate::kept_show::keep_show;
use crate::space::Standpoint;
use crate::view::{Dialog, PanelKind, Preset, Search, Typed, View};
use crate::{complaint, save, with_document};
use eframe::egui::{Context, Key, Popup, ViewportCommand};
use octoscope_core::explain::Notation;
use octoscope_core::gallery::{Degenerate, snap};
use octoscope_core::paper::paper_texts;
use octoscope_core::query::Query;
use octoscope_core::scenario::AnyScenario;
use octoscope_core::text::Language;
use octoscope_core::traverse::Algorithm;
use octoscope_core::tree::Tree;
use octoscope_figure::{Lens, Show, Theme};
use std::path::{Path, PathBuf};

/// Which keys are no commands, because something else takes them.
#[derive(Clone, Copy, Default)]
pub(super) struct Taken {
    /// All, by a field for text or a dialog.
    all: bool,
    /// Escape, by what lies over the picture: it closes that first.
    escape: bool,
    /// Those by which a control is operated or left, as it is focused.
    by_control: bool,
}

impl App {
    /// Remembers the state for undo once no gesture is going on.
    pub(super) fn settle(&mut self, context: &Context) {
        let busy = context.input(|input| input.pointer.any_down()) || self.job.is_some();
        if !busy {
            self.settle_now();
        }
    }

    pub(super) fn settle_now(&mut self) {
        let is_same = self.document.is_same_state(&self.settled.document)
            && self.settled.show == *self.show_of_document();
        if is_same {
            // Stepping is not undone, but where it led to is part of the state.
            self.settled.step = self.view.playback.step;
        } else {
            let shown = self.shown();
            self.history.record(std::mem::replace(&mut self.settled, shown));
        }
    }

    pub(super) fn shown(&self) -> Shown {
        Shown {
            document: self.document.clone(),
            step: self.view.playback.step,
            show: *self.show_of_document(),
        }
    }

    /// Which keys are taken as the window is now.
    pub(super) fn taken(&self, context: &Context) -> Taken {
        Taken {
            all: context.text_edit_focused() || self.view.dialog.is_some(),
            escape: Popup::is_any_open(context) || self.view.blank || !self.notice.is_empty(),
            by_control: context.memory(|memory| memory.focused().is_some()),
        }
    }

    /// Commands whose keys were pressed in the frame that is being shown. What a click
    /// in it has brought takes keys as well as what was there before: in a slow frame
    /// both come together.
    pub(super) fn pressed(&self, context: &Context) -> Vec<Command> {
        let (before, now) = (self.taken, self.taken(context));
        if before.all || now.all {
            return Vec::new();
        }
        let focused = before.by_control || now.by_control;
        let escape_is_free = !before.escape && !now.escape && self.is_enabled(Command::BackToRay);
        context.input_mut(|input| {
            let keys =
                COMMANDS.iter().flat_map(|row| row.keys.iter().map(|key| (row.command, key)));
            let free = keys.filter(|(_, key)| match key.logical_key {
                Key::Escape => escape_is_free,
                _ => !(focused && belongs_to_focus(key)),
            });
            // Longer shortcuts first: Ctrl+Shift+S is not Ctrl+S.
            let mut free: Vec<_> = free.collect();
            free.sort_by_key(|(_, key)| !key.modifiers.shift);
            // Each press counts, also where a slow frame brings several.
            let given = free.into_iter().flat_map(|(command, key)| {
                let n_presses = input.count_and_consume_key(key.modifiers, key.logical_key);
                std::iter::repeat_n(command, n_presses)
            });
            given.collect()
        })
    }

    pub(super) fn is_enabled(&self, command: Command) -> bool {
        let (step, length) = (self.view.playback.step, self.document.n_events());
        match command {
            // What is being changed right now is undone, too.
            Command::Undo => {
                self.history.can_undo() || !self.document.is_same_state(&self.settled.document)
            }
            Command::Redo => self.history.can_redo(),
            Command::StepForward | Command::NextLeaf | Command::Last => step < length,
            Command::StepBack | Command::PreviousLeaf | Command::First => {
                step > 0 || self.view.playback.playing
            }
            Command::FirstWrong => self.first_wrong_step().is_some(),
            Command::ReverseRay | Command::SnapRay | Command::NextDegenerate => {
                self.is_about_a_ray()
            }
            Command::BackToRay => !self.is_about_a_ray(),
            Command::Degenerate(ray) => self.is_about_a_ray() && ray.exists_in(self.dimension()),
            Command::Stand(Standpoint::Right | Standpoint::Front | Standpoint::Above)
            | Command::NextLens => self.dimension() == 3,
            Command::Show(change) => change.is_possible(self.show_of_document(), self.dimension()),
            Command::Open
            | Command::Stand(Standpoint::Node | Standpoint::Everything)
            | Command::Follow
            | Command::Save
            | Command::SaveAs
            | Command::Export
            | Command::Quit
            | Command::Play
            | Command::Faster
            | Command::Slower
            | Command::Preset(_)
            | Command::Panel(_)
            | Command::Question
            | Command::RestorePanels
            | Command::FrameAll
            | Command::ReducedMotion
            | Command::Formulas
            | Command::NextNotation
            | Command::NextTheme
            | Command::NextLanguage
            | Command::ScaleUp
            | Command::ScaleDown
            | Command::ScaleReset
            | Command::FullScreen
            | Command::Blank
            | Command::Spotlight
            | Command::Notes
            | Command::Lab
            | Command::Find
            | Command::Keys
            | Command::About => true,
        }
    }

    /// Does what is asked for, if it can be done now.
    pub(super) fn obey(&mut self, context: &Context, command: Command) {
        if !self.is_enabled(command) {
            return;
        }
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
            Command::FirstWrong => {
                if let Some(step) = self.first_wrong_step() {
                    self.go_to(step);
                }
            }
            Command::Play => self.view.playback.toggle(length),
            Command::Faster => self.view.playback.change_speed(2.0),
            Command::Slower => self.view.playback.change_speed(0.5),
            Command::FrameAll => self.view.show_everything(),
            Command::Stand(standpoint) => self.view.standpoint = Some(standpoint),
            Command::NextLens => self.view.lens = following(&Lens::ALL, self.view.lens),
            Command::Show(change) => {
                with_document!(&self.document, d => {
                    change.make(show_of(&mut self.view, &d.tree), d.tree.domain());
                });
            }
            Command::ReducedMotion => self.view.reduced_motion = !self.view.reduced_motion,
            Command::Follow => self.view.follow = !self.view.follow,
            Command::ReverseRay => with_document!(&mut self.document, d => d.reverse_ray()),
            Command::BackToRay => with_document!(&mut self.document, d => d.back_to_ray()),
            Command::SnapRay => self.snap_ray(),
            Command::NextDegenerate => {
                let first = Degenerate::ALL[0];
                let dimension = self.dimension();
                self.aim(self.degenerate.map_or(first, |last| last.following(dimension)));
            }
            Command::Degenerate(ray) => self.aim(ray),
            Command::FullScreen => {
                let full = context.input(|input| input.viewport().fullscreen.unwrap_or(false));
                context.send_viewport_cmd(ViewportCommand::Fullscreen(!full));
            }
            Command::Preset(index) => {
                self.view.preset = Preset::ALL.get(usize::from(index)).copied().unwrap_or_default();
                self.view.question = None;
            }
            Command::Panel(kind) => self.show_or_close(kind),
            Command::Question => self.view.question = Some(!self.view.question_shown),
            Command::RestorePanels => {
                self.view.arrangement().restore();
                self.view.question = None;
            }
            Command::Formulas => self.view.formulas = !self.view.formulas,
            Command::NextNotation => self.take_next_notation(),
            Command::NextTheme => self.view.theme = following(&Theme::ALL, self.view.theme),
            Command::NextLanguage => {
                self.view.language = following(&Language::ALL, self.view.language);
            }
            Command::ScaleUp => self.view.change_scale(1.1),
            Command::ScaleDown => self.view.change_scale(1.0 / 1.1),
            Command::ScaleReset => self.view.scale = 1.0,
            Command::Blank => self.view.blank = !self.view.blank,
            Command::Spotlight => self.view.spotlight = !self.view.spotlight,
            Command::Notes => {
                let now = context.input(|input| input.time);
                self.view.notes_since = self.view.notes_since.is_none().then_some(now);
            }
            Command::Lab => self.view.dialog = Some(Dialog::Lab),
            Command::Find => self.view.dialog = Some(Dialog::Find(Search::default())),
            Command::Keys => self.view.dialog = Some(Dialog::Keys),
            Command::About => self.view.dialog = Some(Dialog::About),
        }
    }

    /// Writes formulas as the next paper does, and says as which.
    fn take_next_notation(&mut self) {
        self.view.notation = following(&Notation::ALL, self.view.notation);
        self.view.formulas = true;
        self.notice.say(self.look.text(&format!("notation-{}", self.view.notation)));
    }

    /// Does what was found by its name.
    pub(super) fn take(&mut self, context: &Context, target: Target) {
        match target {
            Target::Command(command) if self.is_enabled(command) => self.obey(context, command),
            Target::Command(_) => self.notice.say(self.look.text("find-disabled")),
            Target::Scene(id) => self.open_scene(context, id),
            Target::Algorithm(algorithm) => self.run(algorithm),
            Target::Erratum(erratum) => match erratum.variants.first() {
                Some(&variant) => self.open_counterexample(context, variant),
                None => {
                    let texts = paper_texts(self.view.language);
                    let [title, why] = ["title", "why"].map(|part| texts.get(&erratum.key(part)));
                    self.notice.say(format!("{} · {title}: {why}", erratum.id));
                }
            },
        }
    }

    /// Follows the ray with an algorithm.
    fn run(&mut self, algorithm: Algorithm) {
        if !self.is_about_a_ray() {
            with_document!(&mut self.document, d => d.back_to_ray());
        }
        with_document!(&mut self.document, d => {
            if let Query::Ray { algorithm: present, options, .. } = &mut d.scenario.query {
                *present = algorithm;
                // Those of another algorithm mean nothing here.
                let own = options.variants.iter().filter(|variant| variant.belongs_to(algorithm));
                options.variants = own.collect();
            }
        });
    }

    /// Where a misprint leads astray first, as the timeline shows it.
    fn first_wrong_step(&self) -> Option<usize> {
        with_document!(&self.document, d => d.known_verdict()?.first_wrong_step)
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
            self.view.show_everything();
            let [name, watch] = [degenerate.name(language), degenerate.watch(language)];
            self.notice.say(format!("{name}: {watch}"));
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
            self.notice.say(snap.told(self.view.language));
        }
    }

    /// The panels beside the space view.
    pub(super) fn panels(&self) -> Vec<PanelKind> {
        with_document!(&self.document, d => self.view.panels(&d.scenario.query))
    }

    fn show_or_close(&mut self, kind: PanelKind) {
        let shown = self.panels();
        if shown.contains(&kind) {
            self.view.arrangement().change(kind, Change::Close, &shown);
        } else {
            self.view.arrangement().add(kind);
        }
    }

    pub(super) fn go_to(&mut self, step: usize) {
        self.view.playback.playing = false;
        self.view.playback.go_to(step, self.document.n_events());
    }

    /// Undoes or redoes. The playhead goes back to where it was in that state.
    fn travel(&mut self, direction: impl FnOnce(&mut History<Shown>, Shown) -> Option<Shown>) {
        // What is being changed right now is a state of its own, and a tree
        // that is being built for it belongs to no other document.
        self.settle_now();
        self.job.take_if(|(_, purpose)| *purpose == jobs::Purpose::Rebuild);
        let present = self.shown();
        if let Some(shown) = direction(&mut self.history, present) {
            if !shown.document.is_same_place(&self.document) {
                self.view.forget_cameras();
            }
            self.judging = None;
            let mut document = shown.document;
            document.keep_file(&self.document);
            self.document = document;
            *self.show_of_document_mut() = shown.show;
            self.tracing = None;
            self.go_to(shown.step);
            self.settled = self.shown();
        }
    }

    /// The scenario with the playhead where it is.
    fn scenario_now(&self) -> AnyScenario {
        self.document.scenario_at(self.view.playback.step)
    }

    /// The same with what the picture shows.
    pub(super) fn scenario_to_keep(&self) -> AnyScenario {
        let mut scenario = self.scenario_now();
        keep_show(&mut scenario, self.show_of_document());
        scenario
    }

    fn save(&mut self, context: &Context, ask: bool) {
        let path = with_document!(&self.document, document => document.path.clone());
        match path {
            Some(path) if !ask => self.save_to(&path),
            Some(_) | None => self.chosen.ask_save(context),
        }
    }

    fn save_to(&mut self, path: &Path) {
        match save::scenario(&self.document, self.scenario_to_keep(), path) {
            Ok(()) => {
                with_document!(&mut self.document, d => d.path = Some(path.to_owned()));
                self.saved = self.document.clone();
                self.exporting.saved = Some((path.to_owned(), self.scenario_now()));
                let name = file_name(path);
                self.notice.say(self.look.texts.format("status-saved", &[("name", name.into())]));
            }
            Err(error) => {
                self.view.dialog = Some(Dialog::Error(complaint::told(&self.look.texts, &error)))
            }
        }
    }

    pub(super) fn take_answers(&mut self, context: &Context) {
        if let Some(chosen) = self.chosen.take() {
            self.take_chosen(context, chosen);
        }
    }

    /// Does what a file was chosen for.
    pub fn take_chosen(&mut self, context: &Context, chosen: Chosen) {
        match chosen {
            Chosen::Path(purpose, path) => {
                if matches!(purpose, Purpose::Export(_)) {
                    self.view.dialog = None;
                }
                // The dialog has asked about the name as it was chosen.
                let named = purpose.named(&path);
                let asked = if named == path { Replacing::Agreed } else { Replacing::Asks };
                self.use_path(context, purpose, named, asked);
            }
            Chosen::NoDialog(purpose) => {
                let path = self.suggested(purpose).to_string_lossy().into_owned();
                // What is typed from now on is the path.
                context.memory_mut(|memory| {
                    if let Some(focused) = memory.focused() {
                        memory.surrender_focus(focused);
                    }
                });
                self.view.dialog = Some(Dialog::Path(Typed { purpose, path, replaces: false }));
            }
        }
    }

    /// Path to begin with where one is typed.
    fn suggested(&self, purpose: Purpose) -> PathBuf {
        let (path, folder) =
            with_document!(&self.document, d => (d.path.clone(), d.folder.clone()));
        match purpose {
            // With a separator at its end, behind which the name is typed.
            Purpose::Open if folder.as_os_str().is_empty() => folder,
            Purpose::Open => folder.join(""),
            Purpose::Save => path.unwrap_or_else(|| folder.join("scenario.octo")),
            Purpose::Export(_) => folder.join(self.view.export.file.trim()),
            Purpose::Lab(ending) => folder.join(format!("bench.{ending}")),
        }
    }

    /// Does what a path was typed for; asks once before a file is replaced.
    pub(super) fn take_path(&mut self, context: &Context, typed: Typed) {
        let path = typed.purpose.named(Path::new(typed.path.trim()));
        let asked = if typed.replaces { Replacing::Agreed } else { Replacing::Asks };
        self.use_path(context, typed.purpose, path, asked);
    }

    fn use_path(&mut self, context: &Context, purpose: Purpose, path: PathBuf, asked: Replacing) {
        let is_written = match purpose {
            Purpose::Open => false,
            Purpose::Save | Purpose::Export(_) | Purpose::Lab(_) => true,
        };
        if is_written && asked == Replacing::Asks && files::is_there(&path) {
            let path = path.to_string_lossy().into_owned();
            self.view.dialog = Some(Dialog::Path(Typed { purpose, path, replaces: true }));
            return;
        }
        match purpose {
            Purpose::Open => self.open(context, path),
            Purpose::Save => self.save_to(&path),
            Purpose::Export(_) => self.export_to(context, &path),
            Purpose::Lab(_) => self.save_lab(&path),
        }
    }
}

/// What the picture shows of trees of the dimension of `tree`.
fn show_of<'a, const D: usize>(view: &'a mut View, _tree: &Tree<D>) -> &'a mut Show {
    view.show_mut::<D>()
}

/// Whether a file may be replaced.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Replacing {
    /// The user is asked.
    Asks,
    /// The user has agreed.
    Agreed,
}

/// The element after `present`, round and round.
fn following<T: Copy + PartialEq>(all: &[T], present: T) -> T {
    let index = all.iter().position(|&other| other == present).unwrap_or(0);
    all[(index + 1) % all.len()]
}
