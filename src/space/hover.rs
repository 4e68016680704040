//! What the view tells of the cell under the pointer: its outline, its level
//! and codes, and what a click there asks for.

use super::PageInWindow;
use super::gesture::{Click, Under};
use crate::look::Look;
use eframe::egui::{Align2, FontId, Label, Pos2, Rect, RichText, Ui, vec2};
use octoscope_core::locate::Direction;
use octoscope_core::tree::{NodeId, Tree};
use octoscope_figure::{Mark, Role, Shape};

/// Marks of a hovered node, and of the side of it that a click would cross.
pub fn marks<const D: usize>(
    tree: &Tree<D>,
    hovered: Option<NodeId>,
    under: Option<&Under<D>>,
) -> Vec<Mark<D>> {
    let outline = |node| Mark::new(Shape::Box(tree.node_box(node)), Role::Hover).of_node(node);
    let side = under.and_then(|under| match under.click {
        Some(Click::Neighbour(direction)) => Some((under.leaf, direction)),
        Some(Click::Point) | None => None,
    });
    let side = side.and_then(|(leaf, direction)| side_mark(tree, leaf, direction));
    hovered.map(outline).into_iter().chain(side).collect()
}

fn side_mark<const D: usize>(
    tree: &Tree<D>,
    leaf: NodeId,
    direction: Direction<D>,
) -> Option<Mark<D>> {
    let components = direction.components();
    let mut axes = (0..D).filter(|&axis| components[axis] != 0);
    // Directions along several axes cross an edge or a corner.
    let (Some(axis), None) = (axes.next(), axes.next()) else { return None };
    let mut bounds = tree.node_box(leaf);
    let at = if components[axis] > 0 { bounds.max[axis] } else { bounds.min[axis] };
    (bounds.min[axis], bounds.max[axis]) = (at, at);
    Some(Mark::new(Shape::Plane { axis, bounds }, Role::HoverSide).of_node(leaf))
}

/// Writes level and codes of a node into the corner of the view, and beside
/// the pointer what a click does.
pub fn labels<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    (rect, frame): (Rect, PageInWindow),
    tree: &Tree<D>,
    hovered: Option<NodeId>,
    under: Option<&Under<D>>,
) {
    let Some(node) = hovered else { return };
    let codes = tree.code(node).map(|code| code.to_string()).join(", ");
    let arguments = [("level", tree.level(node).into()), ("codes", codes.into())];
    let note = look.texts.format("node-note", &arguments);
    label(ui, look, rect, rect.left_bottom() + vec2(10.0, -10.0), Align2::LEFT_BOTTOM, note);
    if let Some(Under { at, click: Some(Click::Neighbour(_)), .. }) = under {
        let hint = look.text("space-click-neighbour");
        label(ui, look, rect, frame.on_screen(*at) + vec2(14.0, 18.0), Align2::LEFT_TOP, hint);
    }
}

/// A line of quiet text on its own ground, within `rect`.
fn label(ui: &mut Ui, look: &Look, rect: Rect, at: Pos2, anchor: Align2, text: String) {
    let font = FontId::proportional(13.0);
    let color = look.palette.quiet;
    let size = ui.painter().layout_no_wrap(text.clone(), font.clone(), color).size();
    let ground = anchor.anchor_size(at, size + vec2(12.0, 6.0));
    let overhang = (ground.max - rect.shrink(8.0).max).max(vec2(0.0, 0.0));
    let ground = ground.translate(-overhang);
    ui.painter().rect_filled(ground, 4.0, look.palette.panel);
    let text = RichText::new(text).font(font).color(color);
    ui.put(ground, Label::new(text).selectable(false));
}
