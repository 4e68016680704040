//! The view of the tree and the ray, and what the mouse does in it.

mod ask;
mod base;
mod card;
mod coarse;
mod flight;
mod gesture;
mod hover;
mod leaves;
mod pick;
mod run;
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
use eframe::egui::{Event, Rect, Sense, Ui, WidgetInfo, accesskit::Role};
use hover::Told;
use octoscope_core::geometry::Ray;
use octoscope_core::query::Query;
use octoscope_core::trace::Moment;
use octoscope_core::tree::NodeId;
use octoscope_figure::{
    Camera, Page, Role as MarkRole, Show, axes, cells, content, crosses, node_mark,
    space_figure_over,
};
use run::run_marks;

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

/// More leaves, or parts of the content, than this are not painted one by one.
const MOST_PAINTED: usize = 20_000;

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
    let room = view.space.replace(rect);
    let kept: Option<Camera<D>> = view.camera();
    let mut camera = kept.unwrap_or_else(|| document.framed(frame.page));
    let (before, ray) = (camera, document.scenario.ray);
    view.fitted |= kept.is_none();
    if view.fitted && kept.is_some() && room.map(|room| room.size()) != Some(rect.size()) {
        document.frame(&mut camera, frame.page);
    }
    standpoint::stand(view, &mut camera, frame.page, document, moment);
    if camera != before && room.map(|room| room.size()) == Some(rect.size()) {
        let seen = flight::on_the_way(ui, view, before);
        view.flight = Some(Flight::from(seen, ui.input(|input| input.time)));
    }
    let goal = camera;
    camera = flight::on_the_way(ui, view, goal);
    let stood = camera;
    let under = gesture::handle(ui, &response, frame, &mut camera, document);
    view.fitted &= (camera.target, camera.height) == (stood.target, stood.height);
    if let Some(under) = &under {
        view.hover.offer(under.leaf);
    }
    let tree = std::sync::Arc::clone(&document.tree);
    // What is pointed at here is lit at once, what is elsewhere a frame later.
    let hovered = under.as_ref().map(|under| under.leaf).or_else(|| view.hover.lit(&tree));
    // Who takes hold of the picture stops it where it is.
    let held = camera != stood || document.scenario.ray != ray;
    view.flight = view.flight.filter(|_| !held);
    let kept = if view.flight.is_some() { goal } else { camera };
    // While the ray is dragged, the picture stays where it is, and afterwards.
    if kept != before || document.scenario.ray != ray {
        view.set_camera(kept);
    }
    let show = shown_now(ui, view, *view.show::<D>());
    let show = &show;

    let marks = run_marks(document, moment, show);
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 0.0, look.palette.background);
    let mut painted = axes(document.tree.domain(), show, &camera);
    let is_painted = document.content.len() <= MOST_PAINTED
        && (layers.is_none() || !tree_layers::is_cloud(&document.content));
    if D == 2 && show.content && is_painted {
        painted.extend(content(&document.content, None));
    }
    painted.extend(marks);
    let expected = |&node: &NodeId| node_mark(&tree, node, MarkRole::Expected);
    painted.extend(document.right_nodes().iter().map(expected));
    painted.extend(hover::marks(&tree, hovered, under.as_ref()));
    // Boxes that the graphics adapter draws.
    let mut below = Vec::new();
    if let Some(layers) = layers {
        let is_busy = view.playback.playing || ui.input(|input| !input.events.is_empty());
        let pace = if is_busy { Pace::Busy } else { Pace::Rest };
        layers.paint(ui, rect, &camera, document, (show, view.theme), (&painted, pace));
        (below, painted) = painted.into_iter().partition(base::draws);
    } else if document.tree.n_leaves() <= MOST_PAINTED {
        let cut = show.slice.and_then(|slice| slice.cut(document.tree.domain(), &camera));
        painted.extend(cells(&document.tree, show, cut.as_ref()));
    }
    painted.sort_by_cached_key(|mark| mark.role.layer());
    let mut figure = space_figure_over(&below, &painted, &camera, frame.page);
    // What the adapter cannot draw of its boxes.
    figure.drawn.splice(..0, crosses(&below, &camera, frame.page));
    paint_on_page(&painter, look, view.theme, frame, &figure);
    gesture::paint_region_being_drawn(ui, &painter, look, &response);
    let is_move = |event: &Event| matches!(event, Event::PointerMoved(_));
    let moved = ui.input(|input| input.events.iter().any(is_move));
    if moved || view.pointed.is_none() {
        view.pointed = Some(moment.step);
    }
    if let Some(node) = hovered {
        let why = why::why(&document.shown(moment), node, view.language);
        let seen = seen(document, frame, &camera, node);
        hover::card(ui, look, rect, &tree, &Told { node, why, seen });
    }
    let hint = under.filter(|_| view.pointed == Some(moment.step) && !view.spotlight);
    if let Some(under) = hint {
        hover::hint(ui, look, frame, &under);
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
    let ray = is_asked.then_some(document.scenario.ray);
    let ends = |ray: Ray<D>| [ray.origin(), ray.at(1.0)].map(|end| frame.place(camera, end));
    let ray = ray.map(ends).and_then(|[from, to]| Some([from?, to?]));
    Seen { cell, ray }
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
