//! Why the cell under the pointer is not visited, in words.

use super::gesture::Under;
use crate::look::Look;
use crate::widgets::{PageInWindow, rich_job};
use eframe::egui::{
    Align2, Label, Pos2, Rect, TextStyle, TextWrapMode, Ui, Vec2, WidgetInfo, WidgetText,
    accesskit::Role, vec2,
};
use octoscope_core::explain::{Naming, RichText, fate_sentence};
use octoscope_core::text::Language;
use octoscope_core::trace::{Fate, deciding_fate};
use octoscope_core::tree::NodeId;
use octoscope_figure::DiagramOf;

/// Why a node is not visited.
pub struct Why {
    text: RichText,
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
    let parent = tree.parent(decided).filter(|_| moment.current.is_some() && moment.end.is_none());
    let is_in_question = parent.is_some() && parent == moment.at_work(tree);
    let naming = if is_in_question { Naming::ByIndex } else { Naming::ByCode };
    Some(Why { text: fate_sentence(tree, decided, fate, naming, language), is_in_question })
}

/// Width of a text beside the pointer, in points.
const CARD: f32 = 290.0;
/// Height of the line in the corner of the view, and of the hint at the pointer.
const LINE: f32 = 26.0;

/// Writes why a node is not visited: above the pointer if that is decided now,
/// else above the line in the corner of the view.
pub fn label<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    (rect, frame): (Rect, PageInWindow),
    why: &Why,
    under: Option<&Under<D>>,
) {
    let whole = rect.width() - 32.0;
    let at_pointer = under.map(|under| frame.on_screen(under.at)).filter(|_| why.is_in_question);
    let (most, at) = match at_pointer {
        Some(pointer) => (CARD.min(whole), pointer + vec2(14.0, -14.0 - LINE)),
        None => (whole, rect.left_bottom() + vec2(10.0, -14.0 - LINE)),
    };
    let text: WidgetText = rich_job(&why.text, look, 14.0, most).into();
    let galley = text.into_galley(ui, Some(TextWrapMode::Wrap), most, TextStyle::Body);
    let ground = within(rect, at, galley.size() + vec2(12.0, 6.0));
    ui.painter().rect_filled(ground, 4.0, look.palette.panel);
    let response = ui.put(ground, Label::new(galley).selectable(false));
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, why.text.plain()));
}

/// Place of this size whose lower left corner is at `at`, but within `rect`.
fn within(rect: Rect, at: Pos2, size: Vec2) -> Rect {
    let room = rect.shrink(8.0);
    let ground = Align2::LEFT_BOTTOM.anchor_size(at, size);
    let beyond = (ground.max - room.max).max(vec2(0.0, 0.0));
    let before = (room.min - ground.min).max(vec2(0.0, 0.0));
    ground.translate(before - beyond)
}
