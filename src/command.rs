//! All commands of the window, with their names, menus and keys: one table,
//! from which menus, tooltips and shortcuts follow.

mod menu;

use crate::show_change::{ShowChange, ShownPart};
use crate::view::{PanelKind, Standpoint};
use eframe::egui::{Key, KeyboardShortcut, Modifiers};
use octoscope_core::gallery::Degenerate;

pub use menu::Menu;

/// Something that the user can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Command {
    /// Choose a file and open it.
    Open,
    /// Save the scenario where it came from.
    Save,
    /// Choose where to save the scenario.
    SaveAs,
    /// Export the space view.
    Export,
    /// Close the window.
    Quit,
    /// Take the last change back.
    Undo,
    /// Do it again.
    Redo,
    /// One event forward.
    StepForward,
    /// One event back.
    StepBack,
    /// Before the first event.
    First,
    /// After the last event.
    Last,
    /// Take the number of the step to go to.
    GoToStep,
    /// To the next leaf or result.
    NextLeaf,
    /// To the previous leaf or result.
    PreviousLeaf,
    /// To the first step at which a misprint leads astray.
    FirstWrong,
    /// Play or pause.
    Play,
    /// Play twice as fast.
    Faster,
    /// Play half as fast.
    Slower,
    /// Show a preset of panels, by its index in [`crate::view::Preset::ALL`].
    Preset(u8),
    /// Show a panel, or close it.
    Panel(PanelKind),
    /// Show scene, ray, query and options beside the picture, or no longer.
    Question,
    /// Show the panels of the preset as at first.
    RestorePanels,
    /// Fit the tree and the ray into the view.
    FrameAll,
    /// Move the camera to a place by name.
    Stand(Standpoint),
    /// Let the camera go with the current node, or no longer.
    Follow,
    /// Perspective, parallel in turn.
    NextLens,
    /// Change what the picture shows.
    Show(ShowChange),
    /// No animations, or animations again.
    ReducedMotion,
    /// Turn the ray round.
    ReverseRay,
    /// Make the ray degenerate in the nearest way.
    SnapRay,
    /// The next ray of the gallery.
    NextDegenerate,
    /// A ray of the gallery.
    Degenerate(Degenerate),
    /// From a point, region or neighbour back to the ray.
    BackToRay,
    /// Show what the step computes as a formula, or no longer.
    Formulas,
    /// Notations of formulas in turn.
    NextNotation,
    /// Light, dark, projector in turn.
    NextTheme,
    /// English, German in turn.
    NextLanguage,
    /// Larger type and lines.
    ScaleUp,
    /// Smaller type and lines.
    ScaleDown,
    /// Normal type and lines.
    ScaleReset,
    /// Full screen on or off.
    FullScreen,
    /// Blank the window or show it again.
    Blank,
    /// Dim everything but the surroundings of the pointer, or no longer.
    Spotlight,
    /// Show notes on a second screen, or close them.
    Notes,
    /// Measure what algorithms cost.
    Lab,
    /// Search everything that has a name.
    Find,
    /// Show all keys.
    Keys,
    /// Show what this program is.
    About,
}

/// One row of the table of commands.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The command.
    pub command: Command,
    /// Key of its name in the language files.
    pub id: &'static str,
    /// The menu in which it stands.
    pub menu: Menu,
    /// Keys that give the command; the first one is shown.
    pub keys: &'static [KeyboardShortcut],
}

const fn key(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::NONE, key)
}

const fn ctrl(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::COMMAND, key)
}

const fn ctrl_shift(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), key)
}

/// A panel and the key of its title, [`PanelKind::id`].
const fn panel(kind: PanelKind, id: &'static str) -> Row {
    row(Command::Panel(kind), id, Menu::Panels, &[])
}

const fn shift(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::SHIFT, key)
}

const fn show(change: ShowChange, id: &'static str, keys: &'static [KeyboardShortcut]) -> Row {
    row(Command::Show(change), id, Menu::Show, keys)
}

const fn part(part: ShownPart, id: &'static str, keys: &'static [KeyboardShortcut]) -> Row {
    show(ShowChange::Part(part), id, keys)
}

const fn row(
    command: Command,
    id: &'static str,
    menu: Menu,
    keys: &'static [KeyboardShortcut],
) -> Row {
    Row { command, id, menu, keys }
}

const fn gallery(ray: Degenerate, id: &'static str) -> Row {
    row(Command::Degenerate(ray), id, Menu::Gallery, &[])
}

/// All commands, in the order of the menus.
pub const COMMANDS: &[Row] = &[
    row(Command::Open, "command-open", Menu::File, &[ctrl(Key::O)]),
    row(Command::Save, "command-save", Menu::File, &[ctrl(Key::S)]),
    row(Command::SaveAs, "command-save-as", Menu::File, &[ctrl_shift(Key::S)]),
    row(Command::Export, "command-export", Menu::File, &[ctrl(Key::E)]),
    row(Command::Quit, "command-quit", Menu::File, &[ctrl(Key::Q)]),
    row(Command::Undo, "command-undo", Menu::Edit, &[ctrl(Key::Z)]),
    row(Command::Redo, "command-redo", Menu::Edit, &[ctrl(Key::Y), ctrl_shift(Key::Z)]),
    row(Command::Preset(0), "command-preset-bits", Menu::View, &[key(Key::Num1)]),
    row(Command::Preset(1), "command-preset-rail", Menu::View, &[key(Key::Num2)]),
    row(Command::Preset(2), "command-preset-automaton", Menu::View, &[key(Key::Num3)]),
    row(Command::Preset(3), "command-preset-debug", Menu::View, &[key(Key::Num4)]),
    row(Command::Preset(4), "command-preset-compare", Menu::View, &[key(Key::Num5)]),
    row(Command::Preset(5), "command-preset-lecture", Menu::View, &[key(Key::Num6)]),
    row(Command::Preset(6), "command-preset-tree", Menu::View, &[key(Key::Num7)]),
    row(Command::Preset(7), "command-preset-map", Menu::View, &[key(Key::Num8)]),
    panel(PanelKind::Tree, "panel-tree"),
    panel(PanelKind::WhyNot, "panel-why-not"),
    panel(PanelKind::Rail, "panel-t-rail"),
    panel(PanelKind::Automaton, "panel-automaton"),
    panel(PanelKind::Codes, "panel-codes"),
    panel(PanelKind::Region, "panel-region"),
    panel(PanelKind::Neighbour, "panel-neighbour"),
    panel(PanelKind::Listing, "panel-listing"),
    panel(PanelKind::Variables, "panel-variables"),
    panel(PanelKind::Stack, "panel-stack"),
    panel(PanelKind::Counters, "panel-counters"),
    panel(PanelKind::Tables, "panel-tables"),
    panel(PanelKind::Cuts, "panel-cuts"),
    panel(PanelKind::Children, "panel-children"),
    panel(PanelKind::WayDown, "panel-way-down"),
    panel(PanelKind::Links, "panel-links"),
    panel(PanelKind::Halves, "panel-halves"),
    panel(PanelKind::MidPlanes, "panel-mid-planes"),
    panel(PanelKind::Grid, "panel-grid"),
    panel(PanelKind::Compare, "panel-compare"),
    panel(PanelKind::Paper, "panel-paper"),
    panel(PanelKind::Map, "panel-map"),
    part(ShownPart::OrderNumbers, "command-show-order-numbers", &[]),
    part(ShownPart::Content, "command-show-content", &[]),
    part(ShownPart::EmptyLeaves, "command-show-empty-leaves", &[]),
    part(ShownPart::InnerNodes, "command-show-inner-nodes", &[key(Key::I)]),
    part(ShownPart::Ancestors, "command-show-ancestors", &[]),
    part(ShownPart::Children, "command-show-children", &[]),
    part(ShownPart::MirroredRay, "command-show-mirrored-ray", &[key(Key::J)]),
    part(ShownPart::HalfOpenSides, "command-show-half-open-sides", &[key(Key::U)]),
    part(ShownPart::Codes, "command-show-codes", &[key(Key::D)]),
    show(ShowChange::Apart, "command-show-apart", &[key(Key::A)]),
    show(ShowChange::NextRest, "command-next-rest", &[key(Key::H)]),
    show(ShowChange::FewerSmall, "command-fewer-small", &[shift(Key::ArrowUp)]),
    show(ShowChange::MoreSmall, "command-more-small", &[shift(Key::ArrowDown)]),
    show(ShowChange::FewerLarge, "command-fewer-large", &[ctrl_shift(Key::ArrowDown)]),
    show(ShowChange::MoreLarge, "command-more-large", &[ctrl_shift(Key::ArrowUp)]),
    show(ShowChange::AllLevels, "command-all-levels", &[]),
    show(ShowChange::NextSlice, "command-next-slice", &[key(Key::K)]),
    show(ShowChange::SliceDown, "command-slice-down", &[shift(Key::ArrowLeft)]),
    show(ShowChange::SliceUp, "command-slice-up", &[shift(Key::ArrowRight)]),
    row(Command::Question, "command-question", Menu::View, &[key(Key::Q)]),
    row(Command::RestorePanels, "command-restore-panels", Menu::View, &[ctrl(Key::R)]),
    row(Command::FrameAll, "command-frame-all", Menu::View, &[key(Key::F)]),
    row(Command::Stand(Standpoint::Node), "command-stand-node", Menu::View, &[key(Key::C)]),
    row(Command::Stand(Standpoint::Right), "command-stand-right", Menu::View, &[key(Key::X)]),
    row(Command::Stand(Standpoint::Front), "command-stand-front", Menu::View, &[key(Key::Y)]),
    row(Command::Stand(Standpoint::Above), "command-stand-above", Menu::View, &[key(Key::Z)]),
    row(Command::NextLens, "command-next-lens", Menu::View, &[key(Key::O)]),
    row(Command::Follow, "command-follow", Menu::View, &[key(Key::V)]),
    row(Command::ReducedMotion, "command-reduced-motion", Menu::View, &[]),
    row(Command::Formulas, "command-formulas", Menu::View, &[key(Key::E)]),
    row(Command::NextNotation, "command-next-notation", Menu::View, &[key(Key::M)]),
    row(Command::NextTheme, "command-next-theme", Menu::View, &[key(Key::T)]),
    row(Command::NextLanguage, "command-next-language", Menu::View, &[key(Key::L)]),
    row(
        Command::ScaleUp,
        "command-scale-up",
        Menu::View,
        &[key(Key::Plus), key(Key::Equals), ctrl(Key::Plus), ctrl(Key::Equals)],
    ),
    row(Command::ScaleDown, "command-scale-down", Menu::View, &[key(Key::Minus), ctrl(Key::Minus)]),
    row(Command::ScaleReset, "command-scale-reset", Menu::View, &[key(Key::Num0), ctrl(Key::Num0)]),
    row(Command::FullScreen, "command-full-screen", Menu::View, &[key(Key::F11)]),
    row(Command::Blank, "command-blank", Menu::View, &[key(Key::B), key(Key::Period)]),
    row(Command::Spotlight, "command-spotlight", Menu::View, &[key(Key::S)]),
    row(Command::Notes, "command-notes", Menu::View, &[key(Key::P)]),
    row(Command::Lab, "command-lab", Menu::View, &[ctrl(Key::B)]),
    row(Command::ReverseRay, "command-reverse-ray", Menu::Ray, &[key(Key::R)]),
    row(Command::SnapRay, "command-snap-ray", Menu::Ray, &[key(Key::N)]),
    row(Command::NextDegenerate, "command-next-degenerate", Menu::Ray, &[key(Key::G)]),
    gallery(Degenerate::AxisParallel, "gallery-axis-parallel"),
    gallery(Degenerate::FacePlane, "gallery-face-plane"),
    gallery(Degenerate::LowerFace, "gallery-lower-face"),
    gallery(Degenerate::UpperFace, "gallery-upper-face"),
    gallery(Degenerate::Edge, "gallery-edge"),
    gallery(Degenerate::Corner, "gallery-corner"),
    gallery(Degenerate::Centre, "gallery-centre"),
    gallery(Degenerate::Diagonal, "gallery-diagonal"),
    gallery(Degenerate::NegativeZero, "gallery-negative-zero"),
    gallery(Degenerate::Tiny, "gallery-tiny"),
    gallery(Degenerate::OnFace, "gallery-on-face"),
    gallery(Degenerate::OnCorner, "gallery-on-corner"),
    gallery(Degenerate::Inside, "gallery-inside"),
    gallery(Degenerate::Behind, "gallery-behind"),
    gallery(Degenerate::Leaving, "gallery-leaving"),
    gallery(Degenerate::Grazing, "gallery-grazing"),
    gallery(Degenerate::Miss, "gallery-miss"),
    gallery(Degenerate::Lattice, "gallery-lattice"),
    gallery(Degenerate::LatticeSpace, "gallery-lattice-space"),
    gallery(Degenerate::Thirds, "gallery-thirds"),
    gallery(Degenerate::Far, "gallery-far"),
    gallery(Degenerate::Slow, "gallery-slow"),
    row(Command::BackToRay, "command-back-to-ray", Menu::Ray, &[key(Key::Escape)]),
    row(
        Command::StepForward,
        "command-step-forward",
        Menu::Step,
        &[key(Key::ArrowRight), key(Key::PageDown)],
    ),
    row(
        Command::StepBack,
        "command-step-back",
        Menu::Step,
        &[key(Key::ArrowLeft), key(Key::PageUp)],
    ),
    row(Command::NextLeaf, "command-next-leaf", Menu::Step, &[key(Key::ArrowDown)]),
    row(Command::PreviousLeaf, "command-previous-leaf", Menu::Step, &[key(Key::ArrowUp)]),
    row(Command::First, "command-first", Menu::Step, &[key(Key::Home)]),
    row(Command::Last, "command-last", Menu::Step, &[key(Key::End)]),
    row(Command::GoToStep, "command-go-to-step", Menu::Step, &[ctrl(Key::G)]),
    row(Command::FirstWrong, "command-first-wrong", Menu::Step, &[key(Key::W)]),
    row(Command::Play, "command-play", Menu::Step, &[key(Key::Space)]),
    row(Command::Faster, "command-faster", Menu::Step, &[key(Key::CloseBracket)]),
    row(Command::Slower, "command-slower", Menu::Step, &[key(Key::OpenBracket)]),
    row(Command::Find, "command-find", Menu::Help, &[ctrl(Key::K), key(Key::F1)]),
    row(Command::Keys, "command-keys", Menu::Help, &[key(Key::Questionmark)]),
    row(Command::About, "command-about", Menu::Help, &[]),
];

impl Command {
    /// The row of this command.
    pub fn row(self) -> &'static Row {
        COMMANDS.iter().find(|row| row.command == self).expect("every command has a row")
    }

    /// Whether what is typed after it is meant for a dialog or a field, and for no command.
    pub fn takes_keys(self) -> bool {
        self.opens_dialog() || self == Self::GoToStep
    }

    /// Whether a dialog follows it, of this program or of the system.
    pub fn opens_dialog(self) -> bool {
        use Command::{About, Export, Find, Keys, Lab, Open, Save, SaveAs};
        matches!(self, About | Export | Find | Keys | Lab | Open | Save | SaveAs)
    }
}

/// Keys that a focused control keeps for itself: it is operated or left by them.
pub fn belongs_to_focus(shortcut: &KeyboardShortcut) -> bool {
    use Key::{ArrowDown, ArrowLeft, ArrowRight, ArrowUp, End, Enter, Escape, Home, Space, Tab};
    let operates = matches!(
        shortcut.logical_key,
        ArrowDown | ArrowLeft | ArrowRight | ArrowUp | End | Enter | Escape | Home | Space | Tab
    );
    shortcut.modifiers == Modifiers::NONE && operates
}

/// Keys that an open list or menu keeps for itself; letters, as they may be meant for it.
pub fn belongs_to_list(shortcut: &KeyboardShortcut) -> bool {
    let function_key = matches!(shortcut.logical_key, Key::F1 | Key::F11);
    let presenter_key = matches!(shortcut.logical_key, Key::PageUp | Key::PageDown);
    shortcut.modifiers == Modifiers::NONE && !function_key && !presenter_key
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn no_two_commands_share_a_key_or_a_name() {
        let mut keys = HashSet::new();
        let mut ids = HashSet::new();
        for row in COMMANDS {
            assert!(ids.insert(row.id), "{} twice", row.id);
            for shortcut in row.keys {
                let shown = (shortcut.logical_key, format!("{:?}", shortcut.modifiers));
                assert!(keys.insert(shown), "{shortcut:?} of {} clashes", row.id);
            }
        }
    }

    #[test]
    fn every_degenerate_ray_has_a_command() {
        for ray in Degenerate::ALL {
            let row = Command::Degenerate(ray).row();
            assert_eq!(row.id, format!("gallery-{}", ray.id()));
            assert_eq!([row.menu], Menu::Ray.inner());
        }
    }

    #[test]
    fn every_preset_has_a_command() {
        for index in 0..crate::view::Preset::ALL.len() {
            assert_eq!(Command::Preset(index as u8).row().menu, Menu::View);
        }
    }

    #[test]
    fn everything_that_can_be_shown_has_a_command_of_its_name() {
        for part in ShownPart::ALL {
            let row = Command::Show(ShowChange::Part(part)).row();
            assert_eq!(row.id, format!("command-{}", part.id()));
            assert_eq!(row.menu, Menu::Show);
        }
    }

    #[test]
    fn every_panel_has_a_command_of_its_name() {
        for kind in PanelKind::ALL {
            let row = Command::Panel(kind).row();
            assert_eq!((row.menu, row.id), (Menu::Panels, kind.id()));
        }
    }
}
