//! The tree as a diagram, linked with the picture.

use crate::look::Look;
use crate::tree_view::TreeView;
use crate::view::Hover;
use crate::widgets::{PageInWindow, caption, node_note, paint_on_page, rich_label};
use eframe::egui::{
    Key, Painter, Rect, Response, Sense, Stroke, StrokeKind, Ui, Vec2, WidgetInfo, accesskit::Role,
    vec2,
};
use octoscope_core::explain::{Naming, fate_sentence};
use octoscope_core::text::Language;
use octoscope_core::trace::{Trace, fate};
use octoscope_core::tree::NodeId;
use octoscope_figure::{Diagram, DiagramNode, DiagramOf, NodeKind, Page, Theme, tree_diagram};

/// What the panel shows.
pub struct Shown<'a, const D: usize> {
    /// The tree and what has happened in it.
    pub of: DiagramOf<'a, D>,
    /// The whole run, in which a click finds its step.
    pub trace: &'a Trace<D>,
    /// Colours of the diagram.
    pub theme: Theme,
    /// Language of what is said of a node.
    pub language: Language,
    /// Height, in points.
    pub height: f32,
}

/// What a click on a node does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Click {
    /// The playhead moves to the first step in the node.
    Step(usize),
    /// Its children are shown.
    Unfold,
    /// They are shown no more.
    Fold,
}

/// Levels of the current and of the root.
pub fn note<const D: usize>(look: &Look, of: &DiagramOf<D>) -> String {
    node_note(look, of.tree, of.moment.current)
}

/// The diagram: nodes light each other here and in the picture; a click goes to
/// the step that comes to a node, or unfolds what no step comes to. Returns the
/// step to go to.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    shown: &Shown<D>,
    view: &mut TreeView,
    hover: &mut Hover,
) -> Option<usize> {
    let size = vec2(ui.available_width(), shown.height);
    // Not focusable: Tab goes from node to node.
    let (rect, canvas) = ui.allocate_exact_size(size, Sense::CLICK | Sense::DRAG);
    let name = look.text("tree-name");
    canvas.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, name.as_str()));
    let page = Page { width: f64::from(rect.width()), height: f64::from(rect.height()) };
    let frame = PageInWindow { page, corner: rect.min, scale: 1.0 };
    let (tree, step) = (shown.of.tree, shown.of.moment.step);
    let lens = view.lens(step);
    let diagram = tree_diagram(&shown.of, view.unfolded(tree), hover.lit(tree), page, lens);

    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 6.0, look.palette.background);
    paint_on_page(&painter, look, shown.theme, frame, &diagram.figure);

    let mut wish = None;
    let mut focused = false;
    for node in &diagram.nodes {
        let Some(response) = node_response(ui, rect, frame, &canvas, node) else { continue };
        response
            .widget_info(|| WidgetInfo::labeled(Role::Button, true, name_of(look, shown, node)));
        if response.has_focus() {
            paint_focus(&painter, look, frame, node);
            focused = true;
        }
        if response.hovered() || response.has_focus() {
            hover.offer(node.node);
        }
        if response.clicked() {
            let aside = ui.input(|input| input.modifiers.shift);
            match click_on(shown, view, node, aside) {
                Some(Click::Step(step)) => wish = Some(step),
                Some(Click::Unfold | Click::Fold) => view.toggle(tree, node.node),
                None => {}
            }
        }
        response.on_hover_ui(|ui| tell(ui, look, shown, view, node));
    }
    look_around(ui, view, &canvas, &diagram, (step, focused));
    canvas.on_hover_text(look.text("tree-hint"));
    wish
}

/// What the mouse and the keyboard do at a node, if it is in sight.
fn node_response(
    ui: &Ui,
    rect: Rect,
    frame: PageInWindow,
    canvas: &Response,
    node: &DiagramNode,
) -> Option<Response> {
    let reach = Vec2::splat(2.0 * node.half as f32 + 4.0);
    let place = Rect::from_center_size(frame.on_screen(node.at), reach).intersect(rect);
    if place.width() < 2.0 || place.height() < 2.0 {
        return None;
    }
    // Tab stops only where the algorithm is or was, and where it chooses.
    let sense = if node.matters { Sense::click() } else { Sense::CLICK };
    // A number alone would be that of the hint of the canvas.
    Some(ui.interact(place, canvas.id.with(("node", node.node)), sense))
}

fn paint_focus(painter: &Painter, look: &Look, frame: PageInWindow, node: &DiagramNode) {
    let side = Vec2::splat(2.0 * node.half as f32 + 7.0);
    let around = Rect::from_center_size(frame.on_screen(node.at), side);
    let stroke = Stroke::new(2.0, look.palette.accent);
    painter.rect_stroke(around, 4.0, stroke, StrokeKind::Outside);
}

fn click_on<const D: usize>(
    shown: &Shown<D>,
    view: &TreeView,
    node: &DiagramNode,
    aside: bool,
) -> Option<Click> {
    let step = shown.trace.first_step_in(shown.of.tree, node.node).filter(|_| !aside);
    match (step, node.kind) {
        (Some(step), _) => Some(Click::Step(step)),
        (None, NodeKind::Folded { .. }) => Some(Click::Unfold),
        (None, NodeKind::Unfolded) => {
            let own = view.unfolded(shown.of.tree).contains(&node.node);
            own.then_some(Click::Fold)
        }
        (None, NodeKind::Leaf) => None,
    }
}

/// Drags pan, Ctrl with the wheel or two fingers zoom, so do + and − at a focused
/// node; a double click, or 0, shows all.
fn look_around(
    ui: &Ui,
    view: &mut TreeView,
    canvas: &Response,
    diagram: &Diagram,
    (step, focused): (usize, bool),
) {
    if canvas.dragged() {
        let by = canvas.drag_delta();
        view.pan(diagram, [f64::from(by.x), f64::from(by.y)], step);
    }
    let pressed = |key: Key| focused && ui.input(|input| input.key_pressed(key));
    if canvas.double_clicked() || pressed(Key::Num0) {
        view.fit();
    }
    if pressed(Key::Plus) || pressed(Key::Equals) {
        view.zoom(diagram, [0.0; 2], 1.25, step);
    }
    if pressed(Key::Minus) {
        view.zoom(diagram, [0.0; 2], 0.8, step);
    }
    let factor = ui.input(|input| input.zoom_delta());
    let pointer = ui.input(|input| input.pointer.hover_pos());
    if factor != 1.0
        && let Some(at) = pointer.filter(|_| canvas.contains_pointer())
    {
        let offset = at - canvas.rect.center();
        view.zoom(diagram, [f64::from(offset.x), f64::from(offset.y)], f64::from(factor), step);
    }
}

/// A node as a screen reader names it.
fn name_of<const D: usize>(look: &Look, shown: &Shown<D>, node: &DiagramNode) -> String {
    let tree = shown.of.tree;
    let codes = tree.code(node.node).map(|c| c.to_string()).join(", ");
    let place = [("level", tree.level(node.node).into()), ("codes", codes.into())];
    let note = look.texts.format("node-note", &place);
    let name = match tree.child_index(node.node) {
        None => look.text("tree-root"),
        Some(child) => look.texts.format("tree-child", &[("child", child.0.into())]),
    };
    let number = |id: NodeId| shown.of.moment.leaves.iter().position(|leaf| leaf.node == id);
    let more = match (node.kind, number(node.node)) {
        (NodeKind::Folded { n_leaves }, _) => {
            Some(look.texts.format("tree-folded", &[("n", (n_leaves as u64).into())]))
        }
        (NodeKind::Leaf, Some(n)) => {
            Some(look.texts.format("tree-visited", &[("n", (n as u64 + 1).into())]))
        }
        (NodeKind::Leaf | NodeKind::Unfolded, _) => None,
    };
    [Some(name), Some(note), more].into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// What is said of the node under the pointer, and what a click there does.
fn tell<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    shown: &Shown<D>,
    view: &TreeView,
    node: &DiagramNode,
) {
    ui.set_max_width(300.0);
    ui.label(name_of(look, shown, node));
    let DiagramOf { tree, ray, query, moment, .. } = shown.of;
    if let Some(fate) = fate(tree, ray, query, moment, node.node) {
        let text = fate_sentence(tree, node.node, fate, Naming::ByIndex, shown.language);
        rich_label(ui, look, &text, 14.0, 300.0);
    }
    let hint = |key: &str, n: usize| look.texts.format(key, &[("n", (n as u64).into())]);
    match (click_on(shown, view, node, false), node.kind) {
        (Some(Click::Step(step)), kind) => {
            caption(ui, look, hint("tree-click-step", step));
            if let NodeKind::Folded { .. } = kind {
                caption(ui, look, look.text("tree-shift-click"));
            }
        }
        (Some(Click::Unfold), NodeKind::Folded { n_leaves }) => {
            caption(ui, look, hint("tree-click-unfold", n_leaves));
        }
        (Some(Click::Fold), _) => caption(ui, look, look.text("tree-click-fold")),
        (Some(Click::Unfold) | None, _) => {}
    }
}
