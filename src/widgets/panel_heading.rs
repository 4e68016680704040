//! Heading of a panel that can be folded, moved and closed.

use crate::look::Look;
use crate::view::PanelChange;
use eframe::egui::{
    Align, Button, Label, Layout, Popup, RichText, Sense, Shape, Stroke, StrokeKind, Ui,
    WidgetInfo, accesskit::Role, vec2,
};

/// A panel among its neighbours.
#[derive(Clone, Copy, Debug)]
pub struct InColumn {
    /// Whether only its heading is shown.
    pub folded: bool,
    /// Number of panels before it.
    pub index: usize,
    /// Number of all panels.
    pub n_panels: usize,
}

/// Title of a panel, with a quiet note and a menu at its right end. Returns what
/// is chosen from the menu.
pub fn panel_heading(
    ui: &mut Ui,
    look: &Look,
    title: &str,
    note: &str,
    place: InColumn,
) -> Option<PanelChange> {
    let mut chosen = None;
    ui.horizontal(|ui| {
        let color = if place.folded { look.palette.quiet } else { look.palette.ink };
        let name = RichText::new(title).size(14.0).family(look.strong_family()).color(color);
        if place.folded {
            let name = ui.add(Label::new(name).sense(Sense::click()));
            let (mark, _) = ui.allocate_exact_size(vec2(8.0, 8.0), Sense::hover());
            let corners = [mark.left_top(), mark.right_center(), mark.left_bottom()];
            ui.painter().add(Shape::convex_polygon(corners.to_vec(), color, Stroke::NONE));
            let is_clicked = name.on_hover_text(look.text("panel-unfold")).clicked();
            chosen = is_clicked.then_some(PanelChange::Unfold);
        } else {
            ui.label(name);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            chosen = menu(ui, look, title, place).or(chosen);
            if !note.is_empty() && !place.folded {
                let text = RichText::new(note).size(13.0).color(look.palette.quiet);
                ui.add(Label::new(text).truncate());
            }
        });
    });
    chosen
}

/// Three dots that open the menu.
fn menu(ui: &mut Ui, look: &Look, title: &str, place: InColumn) -> Option<PanelChange> {
    let (rect, button) = ui.allocate_exact_size(vec2(24.0, 24.0), Sense::click());
    let name = look.texts.format("panel-menu", &[("title", title.to_owned().into())]);
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.as_str()));
    let lit = button.hovered() || button.has_focus();
    let color = if lit { look.palette.ink } else { look.palette.quiet };
    for offset in [-5.0, 0.0, 5.0] {
        ui.painter().circle_filled(rect.center() + vec2(offset, 0.0), 1.6, color);
    }
    if button.has_focus() {
        let stroke = Stroke::new(2.0, look.palette.accent);
        ui.painter().rect_stroke(rect, 4.0, stroke, StrokeKind::Inside);
    }
    let mut chosen = None;
    Popup::menu(&button).show(|ui| {
        let (fold, key) = if place.folded {
            (PanelChange::Unfold, "panel-unfold")
        } else {
            (PanelChange::Fold, "panel-fold")
        };
        for (change, key, enabled) in [
            (fold, key, true),
            (PanelChange::MoveUp, "panel-up", place.index > 0),
            (PanelChange::MoveDown, "panel-down", place.index + 1 < place.n_panels),
            (PanelChange::Close, "panel-close", true),
        ] {
            if ui.add_enabled(enabled, Button::new(look.text(key))).clicked() {
                chosen = Some(change);
                ui.close();
            }
        }
    });
    button.on_hover_text(name);
    chosen
}
