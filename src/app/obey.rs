//! Commands and what they do.

use super::App;
use crate::command::Command;
use crate::document::AnyDocument;
use crate::finder::Target;
use crate::history::History;
use crate::query_kind::QueryKind;
use crate::view::{Dialog, PanelChange, PanelKind, Preset, Search, View};
use crate::with_document;
use eframe::egui::{Context, ViewportCommand};
use octoscope_core::explain::Notation;
use octoscope_core::gallery::{Degenerate, no_such_ray, snap};
use octoscope_core::paper::paper_texts;
use octoscope_core::query::Query;
use octoscope_core::text::Language;
use octoscope_core::traverse::Algorithm;
use octoscope_core::tree::Tree;
use octoscope_figure::{Lens, Show, Theme};

/// Where a misprint leads.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Off {
    /// To a wrong result.
    Astray,
    /// To the right one, by a longer way.
    RoundAbout,
}

impl App {
    /// Does what is asked for, if it can be done now.
    pub(super) fn obey(&mut self, context: &Context, command: Command) {
        if !self.is_enabled(command) {
            if let Some(why) = self.why_disabled(command) {
                self.notice.say(why);
            }
            return;
        }
        let length = self.document.n_events();
        let step = self.view.playback.step;
        // What was said before is read, and would lie over the dialog.
        if command.opens_dialog() {
            self.notice.clear();
        }
        match command {
            Command::Open => self.chosen.ask_open(context),
            Command::Save => self.save_or_ask(context),
            Command::SaveAs => self.chosen.ask_save(context),
            Command::Export => self.view.dialog = Some(Dialog::Export),
            Command::Quit => context.send_viewport_cmd(ViewportCommand::Close),
            Command::Undo => self.travel(History::undo),
            Command::Redo => self.travel(History::redo),
            Command::StepForward => self.go_to(step + 1),
            Command::StepBack => self.go_to(step.saturating_sub(1)),
            Command::First => self.go_to(0),
            Command::Last => self.go_to(length),
            Command::GoToStep => {
                self.view.blank = false;
                self.view.playback.ask_for_number();
            }
            Command::NextLeaf => {
                self.go_to(with_document!(&self.document, d => d.trace.next_leaf(step)));
            }
            Command::PreviousLeaf => {
                self.go_to(with_document!(&self.document, d => d.trace.previous_leaf(step)));
            }
            Command::FirstWrong => {
                if let Some((step, kind)) = self.first_step_off() {
                    self.go_to(step);
                    if kind == Off::RoundAbout {
                        self.notice.say(self.look.text("status-detour"));
                    }
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
                let last = self.degenerate;
                let next =
                    with_document!(&self.document, d => Degenerate::following(last, &d.tree));
                self.aim(next);
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
            Command::ScaleUp => self.change_scale(context, 1.1, "status-largest"),
            Command::ScaleDown => self.change_scale(context, 1.0 / 1.1, "status-smallest"),
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

    /// Makes type and lines larger or smaller, or says that it is at its limit.
    fn change_scale(&mut self, context: &Context, factor: f32, limit: &str) {
        let room = context.content_rect().size() * context.zoom_factor();
        if !self.view.change_scale(factor, room) {
            self.notice.say(self.look.text(limit));
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
            Target::Command(Command::Panel(kind)) => self.show_panel(kind),
            Target::Command(command) if self.is_enabled(command) => self.obey(context, command),
            Target::Command(_) => self.notice.say(self.look.text("find-disabled")),
            Target::Scene(id) => self.open_scene(context, id),
            Target::Theme(theme) => self.view.theme = theme,
            Target::Query(kind) => self.ask(kind),
            Target::Algorithm(algorithm) => self.run(algorithm),
            Target::Reading(variant) => self.open_counterexample(context, variant),
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

    /// Asks a question of this kind; what is asked already, from its first step on.
    fn ask(&mut self, kind: QueryKind) {
        let asked = with_document!(&self.document, d => QueryKind::of(&d.scenario.query));
        if asked == kind {
            self.go_to(0);
        } else {
            with_document!(&mut self.document, d => kind.ask(d));
        }
    }

    /// Follows the ray with an algorithm.
    fn run(&mut self, algorithm: Algorithm) {
        if !self.is_about_a_ray() {
            with_document!(&mut self.document, d => d.back_to_ray());
        }
        with_document!(&mut self.document, d => {
            d.scenario.query = d.scenario.query.with_algorithm(algorithm);
        });
    }

    /// Where a misprint leads astray first, as the timeline shows it, or round about.
    pub(super) fn first_step_off(&self) -> Option<(usize, Off)> {
        let verdict = with_document!(&self.document, d => {
            d.scenario.query.is_misprinted().then(|| d.known_verdict()).flatten()
        })?;
        let wrong = verdict.first_wrong_step.map(|step| (step, Off::Astray));
        wrong.or_else(|| Some((verdict.detour?, Off::RoundAbout)))
    }

    pub(super) fn is_about_a_ray(&self) -> bool {
        with_document!(&self.document, d => matches!(d.scenario.query, Query::Ray { .. }))
    }

    pub(super) fn dimension(&self) -> usize {
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
            self.notice.say(format!("{name}. {watch}"));
        } else {
            self.notice.say(no_such_ray(self.view.language));
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
            self.view.arrangement().change(kind, PanelChange::Close, &shown);
        } else {
            self.show_panel(kind);
        }
    }

    /// Shows a panel from its top.
    fn show_panel(&mut self, kind: PanelKind) {
        if self.panels().contains(&kind) {
            self.view.arrangement().unfold(kind);
        } else {
            self.view.arrangement().add(kind);
        }
        self.view.sought = Some(kind);
    }

    pub(super) fn go_to(&mut self, step: usize) {
        self.view.playback.playing = false;
        self.view.playback.go_to(step, self.document.n_events());
    }
}

/// What the picture shows of trees of the dimension of `tree`.
fn show_of<'a, const D: usize>(view: &'a mut View, _tree: &Tree<D>) -> &'a mut Show {
    view.show_mut::<D>()
}

/// The element after `present`, round and round.
fn following<T: Copy + PartialEq>(all: &[T], present: T) -> T {
    let index = all.iter().position(|&other| other == present).unwrap_or(0);
    all[(index + 1) % all.len()]
}
