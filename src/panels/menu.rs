//! Menu bar, and the choice of language and theme.

use crate::command::{COMMANDS, Command, Menu};
use crate::look::Look;
use crate::shortcut;
use crate::widgets::{hint_above, menu_style_with_ring, tick};
use eframe::egui::containers::menu::{MenuButton, MenuConfig};
use eframe::egui::{
    Align, Atom, Atoms, Button, Layout, MenuBar, Rangef, RichText, ScrollArea, Sense, Shape,
    Stroke, Ui, WidgetInfo, accesskit::Role, vec2,
};
use octoscope_core::text::Language;

/// How a command stands in its menu.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Entry {
    /// It can be given.
    Enabled,
    /// There is nothing to do for it now.
    Disabled,
    /// It turns something on or off, which is now on.
    On,
    /// The same, which is now off.
    Off,
}

/// The menus from the table of commands, each as `entry` says; what is chosen
/// goes to `commands`.
pub fn ui(
    ui: &mut Ui,
    look: &Look,
    title: &str,
    language: Language,
    entry: impl Fn(Command) -> Entry,
    commands: &mut Vec<Command>,
) {
    MenuBar::new().style(menu_style_with_ring).config(config()).ui(ui, |ui| {
        menus(ui, look, &entry, commands);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if theme_button(ui, look) {
                commands.push(Command::NextTheme);
            }
            // Menus come first where there is no room for everything.
            let has_room = ui.available_width() > 80.0;
            for choice in [Language::German, Language::English].into_iter().filter(|_| has_room) {
                let shown = choice.id().to_uppercase();
                let is_present = language == choice;
                // At the end of the frame, so that it speaks one language only.
                if ui.selectable_label(is_present, shown).clicked() && !is_present {
                    commands.push(Command::NextLanguage);
                }
            }
            ui.with_layout(
                Layout::centered_and_justified(eframe::egui::Direction::LeftToRight),
                |ui| {
                    let text = RichText::new(title).color(look.palette.quiet);
                    ui.add(eframe::egui::Label::new(text).truncate());
                },
            );
        });
    });
}

/// The same menus in one, below a button of three lines: a lecture has no room for more.
/// The hint of the button lies above `bar`.
pub fn folded(
    ui: &mut Ui,
    look: &Look,
    bar: Rangef,
    entry: impl Fn(Command) -> Entry,
    commands: &mut Vec<Command>,
) {
    let name = look.text("menu-all");
    let button = Button::new("").frame(false).min_size(vec2(34.0, 34.0));
    let (response, _) = MenuButton::from_button(button)
        .config(config())
        .ui(ui, |ui| menus(ui, look, &entry, commands));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.as_str()));
    let lit = response.hovered() || response.has_focus();
    let color = if lit { look.palette.accent } else { look.palette.ink };
    let middle = response.rect.center();
    for y in [-6.0, 0.0, 6.0] {
        let line = [middle + vec2(-9.0, y), middle + vec2(9.0, y)];
        ui.painter().line_segment(line, Stroke::new(2.0, color));
    }
    hint_above(ui, response, bar, &name);
}

/// How menus look: as the toolkit has them, but a focused row has its ring.
fn config() -> MenuConfig {
    MenuConfig::new().style(menu_style_with_ring)
}

/// All menus, side by side or one below the other.
fn menus(ui: &mut Ui, look: &Look, entry: &impl Fn(Command) -> Entry, commands: &mut Vec<Command>) {
    for menu in Menu::ALL {
        ui.menu_button(look.text(menu.id()), |ui| {
            let height = ui.ctx().content_rect().height() - 64.0;
            // The bar stands beside the keys.
            ui.spacing_mut().scroll.floating_allocated_width = 8.0;
            let scroll = ScrollArea::vertical().max_height(height).min_scrolled_height(height);
            scroll.show(ui, |ui| {
                for &inner in menu.inner() {
                    ui.menu_button(look.text(inner.id()), |ui| {
                        // In a low window, or in large type, a long menu is scrolled.
                        let scroll = ScrollArea::vertical().max_height(height);
                        scroll.min_scrolled_height(height).show(ui, |ui| {
                            rows(ui, look, inner, entry, commands);
                        });
                    });
                }
                if !menu.inner().is_empty() {
                    ui.separator();
                }
                rows(ui, look, menu, entry, commands);
            });
        });
    }
}

fn rows(
    ui: &mut Ui,
    look: &Look,
    menu: Menu,
    entry: &impl Fn(Command) -> Entry,
    commands: &mut Vec<Command>,
) {
    for row in COMMANDS.iter().filter(|row| row.menu == menu) {
        let name = look.text(row.id);
        let entry = entry(row.command);
        let response = match entry {
            Entry::Enabled | Entry::Disabled => {
                let mut button = Button::new(name);
                if let Some(key) = row.keys.first() {
                    button = button.shortcut_text(shortcut::shown(look, key));
                }
                ui.add_enabled(entry == Entry::Enabled, button)
            }
            Entry::On | Entry::Off => {
                let mut row_of = Atoms::new(name);
                if let Some(key) = row.keys.first() {
                    let key = RichText::new(shortcut::shown(look, key)).weak();
                    row_of.push_right(Atom::grow());
                    row_of.push_right(key);
                }
                tick(ui, look, &mut (entry == Entry::On), row_of)
            }
        };
        if response.clicked() {
            commands.push(row.command);
            ui.close();
        }
    }
}

/// A half-filled circle; true when it is clicked.
fn theme_button(ui: &mut Ui, look: &Look) -> bool {
    let (rect, response) = ui.allocate_exact_size(vec2(28.0, 24.0), Sense::click());
    let name = look.text(Command::NextTheme.row().id);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.as_str()));
    let (centre, radius) = (rect.center(), 7.0);
    let lit = response.hovered() || response.has_focus();
    let color = if lit { look.palette.accent } else { look.palette.ink };
    let half = (0..=16).map(|n| {
        let angle = (f32::from(n as u8) / 16.0 - 0.5) * std::f32::consts::PI;
        centre + radius * vec2(angle.cos(), angle.sin())
    });
    ui.painter().add(Shape::convex_polygon(half.collect(), color, Stroke::NONE));
    ui.painter().circle_stroke(centre, radius, Stroke::new(1.6, color));
    response.on_hover_text(name).clicked()
}
