//! What the view tells of the cell under the pointer: its outline, its level
//! and codes, why it is not visited, and what a click there asks for.

use super::PageInWindow;
use super::gesture::{Click, Under};
use crate::look::Look;
use crate::widgets::rich_job;
use eframe::egui::{
    Align2, FontId, Label, Pos2, Rect, RichText, TextStyle, TextWrapMode, Ui, WidgetText, vec2,
};
use octoscope_core::explain::{Naming, RichText as Coloured, fate_sentence};
use octoscope_core::locate::Direction;
use octoscope_core::text::Language;
use octoscope_core::trace::{Fate, deciding_fate};
use octoscope_core::tree::{NodeId, Tree};
use octoscope_figure::{DiagramOf, Mark, Role, Shape};

/// Why a node is not visited.
pub struct Why {
    text: Coloured,
    /// Whether it is a child of the node at work that is ruled out.
    is_in_question: bool,
}

/// What rules out a node, or a node that it lies in.
pub fn why<const D: usize>(of: &DiagramOf<D>, node: NodeId, language: Language) -> Option<Why> {
    let DiagramOf { tree, ray, query, moment, .. } = *of;
    let (decided, fate) = deciding_fate(tree, ray, query, moment, node)?;
    match fate {
        Fate::RuledOut(_) | Fate::Strayed(_) | Fate::PassedBy(_) => {}
        Fate::Visited(_) | Fate::Entered(_) | Fate::Ahead(_) => return None,
    }
    let parent = tree.parent(decided);
    let is_in_question = moment.current.is_some()
        && moment.end.is_none()
        && parent.is_some()
        && parent == moment.at_work(tree);
    let naming = if is_in_question { Naming::ByIndex } else { Naming::ByCode };
    Some(Why { text: fate_sentence(tree, decided, fate, naming, language), is_in_question })
}

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

/// Writes level and codes of a node into the corner of the view, and beside the
/// pointer what a click does. Why the node is not visited stands beside the
/// pointer as well if that is decided now, else in the corner.
pub fn labels<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    (rect, frame): (Rect, PageInWindow),
    tree: &Tree<D>,
    hovered: Option<NodeId>,
    under: Option<&Under<D>>,
    why: Option<&Why>,
) {
    let Some(node) = hovered else { return };
    let codes = tree.code(node).map(|code| code.to_string()).join(", ");
    let arguments = [("level", tree.level(node).into()), ("codes", codes.into())];
    let note = look.texts.format("node-note", &arguments);
    let quiet = |text: String| {
        let text = RichText::new(text).font(FontId::proportional(13.0));
        text.color(look.palette.quiet).into()
    };
    let corner = rect.left_bottom() + vec2(10.0, -10.0);
    let whole = rect.width() - 32.0;
    let ground = label(ui, look, (rect, whole), corner, Align2::LEFT_BOTTOM, quiet(note));
    let mut beside = under.map(|under| frame.on_screen(under.at) + vec2(14.0, 18.0));
    if let Some(Why { text, is_in_question }) = why {
        let place = beside.filter(|_| *is_in_question);
        let job = rich_job(text, look, 14.0, whole).into();
        match place {
            Some(at) => {
                let card = label(ui, look, (rect, CARD.min(whole)), at, Align2::LEFT_TOP, job);
                beside = Some(card.left_bottom() + vec2(0.0, 4.0));
            }
            None => {
                let above = ground.left_top() + vec2(0.0, -4.0);
                label(ui, look, (rect, whole), above, Align2::LEFT_BOTTOM, job);
            }
        }
    }
    if let (Some(at), Some(Click::Neighbour(_))) = (beside, under.and_then(|under| under.click)) {
        let hint = quiet(look.text("space-click-neighbour"));
        label(ui, look, (rect, whole), at, Align2::LEFT_TOP, hint);
    }
}

/// Width of a text beside the pointer, in points.
const CARD: f32 = 290.0;

/// A text of `most` points on its own ground, within `rect`. Returns the ground.
fn label(
    ui: &mut Ui,
    look: &Look,
    (rect, most): (Rect, f32),
    at: Pos2,
    anchor: Align2,
    text: WidgetText,
) -> Rect {
    let wrap = Some(TextWrapMode::Wrap);
    let galley = text.into_galley(ui, wrap, most, TextStyle::Body);
    let size = galley.size();
    let ground = anchor.anchor_size(at, size + vec2(12.0, 6.0));
    let overhang = (ground.max - rect.shrink(8.0).max).max(vec2(0.0, 0.0));
    let ground = ground.translate(-overhang);
    ui.painter().rect_filled(ground, 4.0, look.palette.panel);
    ui.put(ground, Label::new(galley).selectable(false));
    ground
}
