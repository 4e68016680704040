//! The view of the tree and the ray, and what the mouse does in it.

mod ask;
mod base;
mod card;
mod coarse;
mod flight;
mod gesture;
mod grasp;
mod hover;
mod leaves;
mod of_query;
mod pick;
mod placed;
mod run;
mod scene;
mod section;
mod standpoint;
mod tree_layers;
mod why;

use crate::document::Document;
use crate::look::Look;
use crate::render::Pace;
use crate::view::{Flight, View};
use crate::widgets::{PageInWindow, paint_on_page};
pub use base::Layers;
use card::Seen;
use eframe::egui::{Event, Rect, Response, Sense, Ui, WidgetInfo, accesskit::Role};
use gesture::Under;
use grasp::{Grasp, drawn_arrow};
use hover::Told;
use octoscope_core::query::Query;
use octoscope_core::trace::Moment;
use octoscope_core::tree::NodeId;
use octoscope_figure::{Camera, Figure, Mark, Page, Role as MarkRole, Show};
use placed::Parts;
use scene::Scene;
use std::sync::Arc;
use tree_layers::Appearance;

/// What the view shows and changes.
pub struct Space<'a, const D: usize> {
    /// The scenario; handles change its ray and query.
    pub document: &'a mut Document<D>,
    /// State of the algorithm at the playhead.
    pub moment: &'a Moment<D>,
    /// The camera, what is shown.
    pub view: &'a mut View,
    /// Layers on the graphics adapter, if there is one.
    pub layers: Option<&'a mut Layers>,
}

/// Shows the space view in all the room there is.
pub fn ui<const D: usize>(ui: &mut Ui, look: &Look, space: Space<'_, D>) {
    let Space { document, moment, view, layers } = space;
    let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
    let name = look.text("space-name");
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, name.as_str()));
    if rect.width() < 8.0 || rect.height() < 8.0 {
        return;
    }
    let frame = PageInWindow { page: page_of(rect), corner: rect.min, scale: 1.0 };
    let (camera, under) = handled(ui, &response, frame, document, moment, view);
    if let Some(under) = &under {
        view.hover.offer(under.leaf);
    }
    // What is pointed at here is lit at once, what is elsewhere a frame later.
    let hovered = under.as_ref().map(|under| under.leaf);
    let hovered = hovered.or_else(|| view.hover.lit(&document.tree));
    let show = shown_now(ui, view, *view.show::<D>());
    let appearance = Appearance { show: &show, theme: view.theme };
    let scene = Scene { document, moment, appearance, camera: &camera, frame };

    let mut marks = scene.marks(layers.is_some());
    marks.extend(hover::marks(&document.tree, hovered, under.as_ref()));
    let is_busy = view.playback.playing || ui.input(|input| !input.events.is_empty());
    let pace = if is_busy { Pace::Busy } else { Pace::Rest };
    let figure = paint(ui, look, &scene, marks, layers.map(|layers| (layers, pace)));
    gesture::paint_region_being_drawn::<D>(ui, &ui.painter_at(rect), look, &response);
    tell(ui, look, &scene, view, (hovered, under), &figure);
    tell_away(&response, look, frame, &figure);
}

/// Where the camera stands after what the user does in this frame, and what the mouse
/// points at.
fn handled<const D: usize>(
    ui: &Ui,
    response: &Response,
    frame: PageInWindow,
    document: &mut Document<D>,
    moment: &Moment<D>,
    view: &mut View,
) -> (Camera<D>, Option<Under<D>>) {
    let rect = response.rect;
    let is_as_large = view.space.replace(rect).map(|room| room.size()) == Some(rect.size());
    // An eye for another dimension was refused where the scenario was opened.
    let asked = view.eye.take().and_then(|eye| eye.camera(document, frame.page).ok());
    let kept: Option<Camera<D>> = view.camera().or(asked);
    let mut camera = kept.unwrap_or_else(|| document.framed(frame.page));
    let (before, ray, query) = (camera, document.scenario.ray, document.scenario.query);
    view.fitted = (view.fitted || kept.is_none()) && asked.is_none();
    if view.fitted && kept.is_some() && !is_as_large {
        document.frame(&mut camera, frame.page);
    }
    standpoint::stand(view, &mut camera, frame.page, document, moment);
    if camera != before && is_as_large {
        let seen = flight::on_the_way(ui, view, before);
        view.flight = Some(Flight::from(seen, ui.input(|input| input.time)));
    }
    let goal = camera;
    camera = flight::on_the_way(ui, view, goal);
    let stood = camera;
    let mut grasp = Grasp { frame, camera: &mut camera, document };
    let under = gesture::handle(ui, response, &mut grasp);
    view.fitted &= (camera.target, camera.height) == (stood.target, stood.height);
    // Who takes hold of the picture stops it where it is.
    let is_dragged = response.dragged() && document.scenario.query != query;
    let is_moved = document.scenario.ray != ray || is_dragged;
    let held = camera != stood || is_moved;
    view.flight = view.flight.filter(|_| !held);
    let kept = if view.flight.is_some() { goal } else { camera };
    // While the ray or what is asked is dragged, the picture stays where it is, and
    // afterwards.
    if kept != before || is_moved || asked.is_some() {
        view.set_camera(kept);
    }
    (camera, under)
}

/// Paints the tree and `marks`, what the graphics adapter draws first.
fn paint<const D: usize>(
    ui: &Ui,
    look: &Look,
    scene: &Scene<'_, D>,
    mut marks: Vec<Mark<D>>,
    layers: Option<(&mut Layers, Pace)>,
) -> Arc<Figure> {
    let painter = ui.painter_at(scene.frame.rect());
    painter.rect_filled(scene.frame.rect(), 0.0, look.palette.background);
    // Boxes that the graphics adapter draws.
    let mut below = Vec::new();
    if let Some((layers, pace)) = layers {
        layers.paint(ui, scene, &marks, pace);
        (below, marks) = marks.into_iter().partition(base::draws);
    } else {
        marks.extend(scene.cells());
    }
    let parts = Parts { below, marks, camera: *scene.camera, page: scene.frame.page };
    let figure = parts.placed(ui);
    paint_on_page(&painter, look, scene.appearance.theme, scene.frame, &figure);
    figure
}

/// Tells of the cell that is pointed at, and of what a click on it does.
fn tell<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    scene: &Scene<'_, D>,
    view: &mut View,
    (hovered, under): (Option<NodeId>, Option<Under<D>>),
    figure: &Figure,
) {
    let Scene { document, moment, camera, frame, .. } = *scene;
    let is_move = |event: &Event| matches!(event, Event::PointerMoved(_));
    let moved = ui.input(|input| input.events.iter().any(is_move));
    if moved || view.pointed.is_none() {
        view.pointed = Some(moment.step);
    }
    // A light is there to point with: what is pointed at is told by whoever points.
    if let Some(node) = hovered.filter(|_| !view.spotlight) {
        let why = why::why(&document.shown(moment), node, view.language);
        let is_of_axis = |role: MarkRole| matches!(role, MarkRole::AxisLabel(_));
        let axes = frame.places_of(figure, is_of_axis);
        let seen = Seen { axes, ..seen(document, frame, camera, node) };
        hover::card(ui, look, frame.rect(), &document.tree, &Told { node, why, seen });
    }
    let hint = under.filter(|_| view.pointed == Some(moment.step) && !view.spotlight);
    if let Some(under) = hint {
        let numbers = frame.places_of(figure, |role| role == MarkRole::OrderNumber);
        hover::hint(ui, look, frame, &under, &numbers);
    }
}

/// What is to be seen beside what is said of a node: its cell, and the ray that is asked for.
fn seen<const D: usize>(
    document: &Document<D>,
    frame: PageInWindow,
    camera: &Camera<D>,
    node: NodeId,
) -> Seen {
    let cell = frame.bounds_of(camera, &document.tree.node_box(node));
    let is_asked = matches!(document.scenario.query, Query::Ray { .. });
    let arrow = is_asked.then(|| drawn_arrow(document, camera, frame.page)).flatten();
    let ray = arrow.map(|arrow| arrow.on_page.map(|end| frame.on_screen(end)));
    Seen { cell, ray, axes: Vec::new() }
}

/// Says what the number is at which the ray is broken, where that is pointed at.
fn tell_away(response: &Response, look: &Look, frame: PageInWindow, figure: &Figure) {
    const NEAR: f32 = 3.0;
    let Some(pointer) = response.hover_pos() else { return };
    let places = frame.places_of(figure, |role| role == MarkRole::RayAway);
    if places.into_iter().any(|place| place.expand(NEAR).contains(pointer)) {
        response.clone().on_hover_text_at_pointer(look.text("space-ray-away"));
    }
}

/// What is shown in this frame: children move apart, and back together, in a short time.
fn shown_now(ui: &Ui, view: &View, show: Show) -> Show {
    const SECS: f32 = 0.25;
    let secs = if view.reduced_motion { 0.0 } else { SECS };
    let goal = show.explosion as f32;
    let now = ui.ctx().animate_value_with_time(ui.scope_id().with("apart"), goal, secs);
    // At rest exactly what is asked for.
    if now == goal { show } else { Show { explosion: f64::from(now), ..show } }
}

fn page_of(rect: Rect) -> Page {
    Page { width: f64::from(rect.width()), height: f64::from(rect.height()) }
}
