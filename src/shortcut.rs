//! Keys as the user reads them on the keyboard.

use crate::look::Look;
use eframe::egui::{Key, KeyboardShortcut};

/// A key with its modifiers, in the language of the window.
pub fn shown(look: &Look, shortcut: &KeyboardShortcut) -> String {
    let modifiers = shortcut.modifiers;
    let command = if cfg!(target_os = "macos") { "Cmd".to_owned() } else { look.text("key-ctrl") };
    let mut parts = Vec::new();
    if modifiers.command || modifiers.ctrl {
        parts.push(command);
    }
    if modifiers.alt {
        parts.push("Alt".to_owned());
    }
    if modifiers.shift {
        parts.push(look.text("key-shift"));
    }
    parts.push(key(look, shortcut.logical_key));
    parts.join("+")
}

/// All keys of a command.
pub fn all_shown(look: &Look, shortcuts: &[KeyboardShortcut]) -> String {
    shortcuts.iter().map(|key| shown(look, key)).collect::<Vec<_>>().join(", ")
}

fn key(look: &Look, key: Key) -> String {
    match key {
        Key::ArrowRight => "→".to_owned(),
        Key::ArrowLeft => "←".to_owned(),
        Key::ArrowUp => "↑".to_owned(),
        Key::ArrowDown => "↓".to_owned(),
        Key::PageUp => look.text("key-page-up"),
        Key::PageDown => look.text("key-page-down"),
        Key::Home => look.text("key-home"),
        Key::End => look.text("key-end"),
        Key::Space => look.text("key-space"),
        Key::Escape => "Esc".to_owned(),
        Key::Minus => "−".to_owned(),
        // Signs are told by themselves, letters and function keys by their names.
        other => other.symbol_or_name().to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::COMMANDS;
    use crate::theme::look;
    use octoscope_core::text::Language;
    use octoscope_figure::Theme;

    #[test]
    fn keys_are_called_as_they_are_labelled() {
        let of = |id: &str, language| {
            let row = COMMANDS.iter().find(|row| row.id == id).unwrap();
            all_shown(&look(language, Theme::Light), row.keys)
        };
        for (id, english, german) in [
            ("command-faster", "]", "]"),
            ("command-slower", "[", "["),
            ("command-step-forward", "→, Page Down", "→, Bild ↓"),
            ("command-play", "Space", "Leertaste"),
            ("command-blank", "B, .", "B, ."),
            ("command-keys", "?", "?"),
            ("command-first", "Home", "Pos1"),
            ("command-last", "End", "Ende"),
            ("command-full-screen", "F11", "F11"),
            ("command-preset-bits", "1", "1"),
        ] {
            assert_eq!(of(id, Language::English), english, "{id}");
            assert_eq!(of(id, Language::German), german, "{id}");
        }
        if !cfg!(target_os = "macos") {
            assert_eq!(of("command-scale-up", Language::English), "+, =, Ctrl++, Ctrl+=");
            assert_eq!(of("command-scale-down", Language::German), "−, Strg+−");
            assert_eq!(of("command-save-as", Language::English), "Ctrl+Shift+S");
            assert_eq!(of("command-save-as", Language::German), "Strg+Umschalt+S");
        }
    }

    #[test]
    fn no_key_is_shown_by_a_name_from_the_program() {
        for language in Language::ALL {
            let look = look(language, Theme::Light);
            for shortcut in COMMANDS.iter().flat_map(|row| row.keys) {
                let name = key(&look, shortcut.logical_key);
                assert!(!name.contains("Bracket") && !name.contains("mark"), "{name}");
            }
        }
    }

    #[test]
    fn the_table_of_the_readme_has_every_key_once() {
        let page = include_str!("../README.md");
        let (_, table) = page.split_once("| key | does |\n|---|---|\n").unwrap();
        let rows = table.lines().map_while(|line| line.strip_prefix("| "));
        let keys = rows.map(|row| row.split_once(" | ").unwrap().0);
        // A command's keys are parted by commas, commands by semicolons.
        let mut told: Vec<_> = keys.flat_map(|keys| keys.split("; ")).collect();
        told.sort_unstable();
        let look = look(Language::English, Theme::Light);
        let with_keys = COMMANDS.iter().filter(|row| !row.keys.is_empty());
        let mut shown: Vec<_> = with_keys.map(|row| all_shown(&look, row.keys)).collect();
        if cfg!(target_os = "macos") {
            shown.iter_mut().for_each(|keys| *keys = keys.replace("Cmd", "Ctrl"));
        }
        shown.sort_unstable();
        assert_eq!(told, shown);
    }
}
