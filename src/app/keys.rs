//! Which keys are commands, and which commands can be obeyed now.

use super::App;
use crate::command::{COMMANDS, Command, belongs_to_focus, belongs_to_list};
use crate::document::Found;
use crate::view::Standpoint;
use crate::with_document;
use eframe::egui::{Context, Event, Key, KeyboardShortcut, Popup};

/// Which keys are no commands, because something else takes them.
#[derive(Clone, Copy, Default)]
pub(super) struct Taken {
    /// All, by a field for text or a dialog.
    all: bool,
    /// Escape, by what lies over the picture: it closes that first.
    escape: bool,
    /// Those by which a control is operated or left, as it is focused.
    by_control: bool,
    /// Those that an open list or menu is operated by, see `belongs_to_list`.
    by_list: bool,
}

impl App {
    /// Which keys are taken as the window is now.
    pub(super) fn taken(&self, context: &Context) -> Taken {
        Taken {
            all: context.text_edit_focused() || self.view.dialog.is_some(),
            escape: Popup::is_any_open(context) || self.view.blank || !self.notice.is_empty(),
            by_control: context.memory(|memory| memory.focused().is_some()),
            by_list: Popup::is_any_open(context),
        }
    }

    /// Commands whose keys were pressed in the frame that is being shown. What a click
    /// in it has brought takes keys as well as what was there before: in a slow frame
    /// both come together. What follows the key of a dialog or of a field is left for that.
    pub(super) fn pressed(&self, context: &Context) -> Vec<Command> {
        let (before, now) = (self.taken, self.taken(context));
        if before.all || now.all {
            return Vec::new();
        }
        let focused = before.by_control || now.by_control;
        let listed = before.by_list || now.by_list;
        let escape_is_free = !before.escape && !now.escape && self.is_enabled(Command::BackToRay);
        context.input_mut(|input| {
            let keys =
                COMMANDS.iter().flat_map(|row| row.keys.iter().map(|key| (row.command, key)));
            let free = keys.filter(|(_, key)| match key.logical_key {
                Key::Escape => escape_is_free,
                _ => !(focused && belongs_to_focus(key) || listed && belongs_to_list(key)),
            });
            // Longer shortcuts first: Ctrl+Shift+S is not Ctrl+S.
            let mut free: Vec<_> = free.collect();
            free.sort_by_key(|(_, key)| !key.modifiers.shift);
            // Each press counts, also where a slow frame brings several.
            let (mut given, mut kept) = (Vec::new(), Vec::new());
            for event in std::mem::take(&mut input.events) {
                let are_taken = given.last().is_some_and(|command: &Command| command.takes_keys());
                match command_of(&event, &free).filter(|_| !are_taken) {
                    Some(command) => {
                        given.push(command);
                        if command.takes_keys() {
                            kept.clear();
                        }
                    }
                    None => kept.push(event),
                }
            }
            input.events = kept;
            given
        })
    }

    /// Keeps what was typed after the key of a dialog or of a field for the next frame, in
    /// which that takes it; `pressed` are the commands whose keys were pressed.
    pub(super) fn hold_back(&mut self, context: &Context, pressed: &[Command]) {
        if pressed.last().is_some_and(|command| command.takes_keys()) {
            let typed = |event: &Event| matches!(event, Event::Key { .. } | Event::Text(_));
            self.held_back = context
                .input(|input| input.events.iter().filter(|event| typed(event)).cloned().collect());
            context.request_repaint();
        }
    }

    /// Types what was held back, before what was typed since.
    pub(super) fn give_held_back(&mut self, context: &Context) {
        let held = std::mem::take(&mut self.held_back);
        context.input_mut(|input| drop(input.events.splice(0..0, held)));
    }

    /// Why a command whose key was pressed cannot be obeyed now, where that does not show.
    pub(super) fn why_disabled(&self, command: Command) -> Option<String> {
        use Command::{FirstWrong, NextDegenerate, NextLens, ReverseRay, SnapRay, Stand};
        let why = if matches!(command, ReverseRay | SnapRay | NextDegenerate) {
            "status-no-ray"
        } else if matches!(command, Stand(_) | NextLens) {
            "status-only-in-space"
        } else if command == FirstWrong {
            self.why_nothing_wrong()
        } else {
            return None;
        };
        Some(self.look.text(why))
    }

    /// Why there is no first wrong step.
    fn why_nothing_wrong(&self) -> &'static str {
        let (found, is_misprinted) = with_document!(&self.document, d => {
            (d.verdict_so_far(), d.scenario.query.is_misprinted())
        });
        match found {
            _ if !is_misprinted => "status-no-misprint",
            Found::Known(_) => "paper-agrees",
            Found::Coming(_) => "paper-coming",
            Found::Never => "paper-too-large",
        }
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
            Command::GoToStep => length > 0,
            Command::StepBack | Command::PreviousLeaf | Command::First => {
                step > 0 || self.view.playback.playing
            }
            Command::FirstWrong => self.first_step_off().is_some(),
            Command::ReverseRay | Command::SnapRay | Command::NextDegenerate => {
                self.is_about_a_ray()
            }
            Command::BackToRay => !self.is_about_a_ray(),
            Command::Degenerate(ray) => {
                let exists = with_document!(&self.document, d => ray.exists_in(&d.tree));
                self.is_about_a_ray() && exists
            }
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
}

/// The command whose key `event` presses, the first one in `free`.
fn command_of(event: &Event, free: &[(Command, &KeyboardShortcut)]) -> Option<Command> {
    let Event::Key { key, modifiers, pressed: true, .. } = event else { return None };
    let is_pressed = |shortcut: &KeyboardShortcut| {
        *key == shortcut.logical_key && modifiers.matches_logically(shortcut.modifiers)
    };
    free.iter().find(|(_, shortcut)| is_pressed(shortcut)).map(|(command, _)| *command)
}
