//! What the mouse does in the space view.
//!
//! Handles of the ray are dragged, the head of its arrow turns it, its shaft moves it
//! whole; so are the point and the corners of the region that are asked about. Elsewhere a
//! drag pans the plane or orbits space, with Shift or in a region query it draws a box; the
//! wheel zooms to the pointer. A double click locates the point, a click picks what the
//! present query asks for.

use super::ask::{ask_point, ask_region, click};
use super::grasp::{Grasp, Grip, drawn_arrow, nearest};
use super::of_query;
use super::pick::{leaf_at, side_at};
use crate::look::Look;
use crate::short_number::rounded;
use crate::widgets::acted_at;
use eframe::egui::{
    CursorIcon, Id, Painter, PointerButton, Pos2, Rect, Response, Stroke, StrokeKind, Ui, pos2,
};
use octoscope_core::geometry::Ray;
use octoscope_core::locate::Direction;
use octoscope_core::query::Query;
use octoscope_core::tree::NodeId;
use octoscope_figure::far_end;

/// Points within which the shaft or a side is hit.
const SHAFT_REACH: f32 = 8.0;
pub(super) const SIDE_REACH: f32 = 8.0;

/// What a click asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Click<const D: usize> {
    /// The leaf that owns the point.
    Point,
    /// The neighbour of the leaf under the pointer.
    Neighbour(Direction<D>),
}

/// What lies under the pointer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Under<const D: usize> {
    /// Where the pointer is on the page.
    pub at: [f64; 2],
    /// The leaf there.
    pub leaf: NodeId,
    /// What a click there asks for, if anything.
    pub click: Option<Click<D>>,
}

/// Lets the mouse change the camera, the ray and the query. Returns what it
/// points at, unless that is the ray or something is being dragged.
pub fn handle<const D: usize>(
    ui: &Ui,
    response: &Response,
    grasp: &mut Grasp<'_, D>,
) -> Option<Under<D>> {
    zoom(ui, response, grasp);
    let memory = grip_id(response);
    if response.drag_started() {
        let pressed = ui.input(|input| input.pointer.press_origin());
        if let Some(at) = pressed.or_else(|| response.interact_pointer_pos()) {
            let grip = grip_at(ui, grasp, at);
            ui.data_mut(|data| data.insert_temp(memory, grip));
        }
    }
    let grip = ui.data(|data| data.get_temp::<Grip<D>>(memory));
    if response.dragged()
        && let (Some(grip), Some(at)) = (grip, response.interact_pointer_pos())
    {
        drag(ui, response, grasp, grip, at);
    }
    if response.drag_stopped() {
        if let (Some(Grip::Region(from)), Some(to)) = (grip, acted_at(response)) {
            ask_region(grasp, from, to);
        }
        ui.data_mut(|data| data.remove::<Grip<D>>(memory));
    }
    if response.double_clicked() {
        if let Some(at) = acted_at(response) {
            ask_point(grasp, at);
        }
    } else if response.clicked()
        && let Some(at) = acted_at(response)
        && !grip_at(ui, grasp, at).is_handle()
    {
        click(grasp, at);
    }
    if let Some(at) = response.hover_pos() {
        let over = grip.unwrap_or_else(|| grip_at(ui, grasp, at));
        ui.set_cursor_icon(match over {
            Grip::Region(_) => CursorIcon::Crosshair,
            Grip::Camera => CursorIcon::Default,
            Grip::Origin
            | Grip::Tip
            | Grip::Head { .. }
            | Grip::Shaft
            | Grip::Point
            | Grip::Corner { .. } => {
                if grip.is_some() {
                    CursorIcon::Grabbing
                } else {
                    CursorIcon::Grab
                }
            }
        });
        let is_free = grip.is_none() && !over.is_handle() && has_moved(ui, response, at);
        return is_free.then(|| under(grasp, at)).flatten();
    }
    None
}

/// Whether the pointer has been moved since it was first seen over the view: where the
/// window opened beneath it, nothing is pointed at.
fn has_moved(ui: &Ui, response: &Response, at: Pos2) -> bool {
    let memory = response.id.with("first-seen");
    let first = ui.data_mut(|data| *data.get_temp_mut_or(memory, Some(at)));
    if first.is_some_and(|first| first != at) {
        ui.data_mut(|data| data.insert_temp(memory, None::<Pos2>));
    }
    first != Some(at)
}

/// What lies at a place of the view.
pub(super) fn under<const D: usize>(grasp: &Grasp<'_, D>, at: Pos2) -> Option<Under<D>> {
    let Grasp { frame, camera, document } = grasp;
    let (leaf, _) = leaf_at(*frame, camera, &document.tree, at)?;
    let side = || side_at(*frame, camera, &document.tree, at).map(|(_, direction)| direction);
    let click = match document.scenario.query {
        // In space a click is too often the beginning of a turn.
        Query::Ray { .. } if D == 2 => side().map(Click::Neighbour),
        Query::Ray { .. } | Query::Region { .. } => None,
        Query::Point { .. } => Some(Click::Point),
        Query::Neighbour { direction, .. } => Some(Click::Neighbour(side().unwrap_or(direction))),
    };
    Some(Under { at: frame.on_page(at), leaf, click })
}

/// Paints the box that is being drawn.
pub fn paint_region_being_drawn<const D: usize>(
    ui: &Ui,
    painter: &Painter,
    look: &Look,
    response: &Response,
) {
    let grip = ui.data(|data| data.get_temp::<Grip<D>>(grip_id(response)));
    if let (Some(Grip::Region(from)), Some(to)) = (grip, response.interact_pointer_pos()) {
        let rect = Rect::from_two_pos(from, to);
        painter.rect_filled(rect, 0.0, look.palette.current_fill);
        let stroke = Stroke::new(1.5, look.palette.current_line);
        painter.rect_stroke(rect, 0.0, stroke, StrokeKind::Middle);
    }
}

fn grip_id(response: &Response) -> Id {
    response.id.with("grip")
}

/// What a press at `at` would take hold of.
fn grip_at<const D: usize>(ui: &Ui, grasp: &Grasp<'_, D>, at: Pos2) -> Grip<D> {
    let query = &grasp.document.scenario.query;
    let (shift, secondary) = ui.input(|input| {
        (
            input.modifiers.shift,
            !input.pointer.button_down(PointerButton::Primary) && input.pointer.any_down(),
        )
    });
    if secondary {
        return Grip::Camera;
    }
    let handle = match query {
        Query::Ray { .. } => ray_grip_at(grasp, at),
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => {
            of_query::grip_at(grasp, at)
        }
    };
    if let Some(handle) = handle.filter(|_| !shift) {
        return handle;
    }
    if shift || matches!(query, Query::Region { .. }) {
        return Grip::Region(at);
    }
    Grip::Camera
}

/// The part of the ray at `at`: the nearest handle, else the shaft.
fn ray_grip_at<const D: usize>(grasp: &Grasp<'_, D>, at: Pos2) -> Option<Grip<D>> {
    let Grasp { frame, camera, document } = grasp;
    let ray = document.scenario.ray;
    let ends = [ray.origin(), ray.at(1.0)];
    let tip = camera.tip_handle(frame.page, ends).map(|tip| (Grip::Tip, frame.on_screen(tip)));
    let origin = frame.place(camera, ends[0]).map(|origin| (Grip::Origin, origin));
    let head = Grip::Head { length: length(ray.direction()) };
    let arrow = drawn_arrow(document, camera, frame.page);
    let head = arrow.map(|arrow| (head, frame.on_screen(arrow.on_page[1])));
    if let Some(handle) = nearest([tip, origin, head].into_iter().flatten(), at) {
        return Some(handle);
    }
    let line = [ends[0], far_end(&document.tree, &ray)];
    let [from, to] = camera.visible_segment(frame.page, line)?.map(|p| frame.on_screen(p));
    (distance_to_segment(at, from, to) < SHAFT_REACH).then_some(Grip::Shaft)
}

/// Point of the ray's line as far from the eye as a grip on it: its tip or head if that
/// is held and in sight, else the point nearest to the middle of the tree.
fn depth_of<const D: usize>(grasp: &Grasp<'_, D>, grip: Grip<D>) -> [f64; D] {
    let Grasp { frame, camera, document } = grasp;
    let ray = document.scenario.ray;
    let [width, height] = [frame.page.width, frame.page.height];
    /// What is drawn at the border is in sight.
    const BORDER: f64 = 1e-6;
    let is_within = |x: f64, most: f64| (-BORDER..=most + BORDER).contains(&x);
    let in_sight = |at: [f64; 2]| is_within(at[0], width) && is_within(at[1], height);
    let held = match grip {
        Grip::Tip => Some(ray.at(1.0)),
        Grip::Head { .. } => {
            let arrow = drawn_arrow(document, camera, frame.page);
            arrow.map(|arrow| camera.point_at(frame.page, arrow.ends, arrow.on_page[1]))
        }
        Grip::Origin
        | Grip::Shaft
        | Grip::Point
        | Grip::Corner { .. }
        | Grip::Camera
        | Grip::Region(_) => None,
    };
    let is_in_sight =
        |end: &[f64; D]| camera.project(frame.page, *end).is_some_and(|end| in_sight(end.at));
    if let Some(end) = held.filter(is_in_sight) {
        return end;
    }
    // Squares of very large or small components would be no numbers.
    let largest = ray.direction().into_iter().fold(0.0, |m: f64, d| m.max(d.abs()));
    let along = ray.direction().map(|d| d / largest);
    let centre = document.tree.domain().root_box().centre();
    let way = (0..D).map(|e| (centre[e] - ray.origin()[e]) * along[e]).sum::<f64>();
    let square = along.iter().map(|d| d * d).sum::<f64>();
    let way = (way / square).max(0.0);
    std::array::from_fn(|e| ray.origin()[e] + way * along[e])
}

fn drag<const D: usize>(
    ui: &Ui,
    response: &Response,
    grasp: &mut Grasp<'_, D>,
    grip: Grip<D>,
    at: Pos2,
) {
    let (frame, ray) = (grasp.frame, grasp.document.scenario.ray);
    let camera = &*grasp.camera;
    let moved = |through: [f64; D]| -> [f64; D] {
        let now = frame.world(camera, at, through);
        let then = frame.world(camera, at - response.drag_delta(), through);
        std::array::from_fn(|e| now[e] - then[e])
    };
    let ends = match grip {
        Grip::Origin => Some((frame.world(camera, at, ray.origin()), ray.at(1.0))),
        Grip::Tip => {
            let through = depth_of(grasp, grip);
            Some((ray.origin(), frame.world(camera, at, through)))
        }
        Grip::Head { length } => {
            let through = depth_of(grasp, grip);
            turn_to(grasp, frame.world(camera, at, through), length);
            None
        }
        Grip::Shaft => {
            let by = moved(depth_of(grasp, grip));
            let shifted = |p: [f64; D]| std::array::from_fn(|e| p[e] + by[e]);
            Some((shifted(ray.origin()), shifted(ray.at(1.0))))
        }
        Grip::Point => {
            of_query::move_point(grasp, at);
            None
        }
        Grip::Corner { held, opposite } => {
            of_query::move_corner(grasp, [held, opposite], at);
            None
        }
        Grip::Camera => {
            turn(ui, response, grasp);
            None
        }
        Grip::Region(_) => None,
    };
    if let Some((origin, tip)) = ends {
        let resolution = grasp.camera.unit(frame.page);
        let [origin, tip] = [origin, tip].map(|p| p.map(|x| rounded(x, resolution)));
        // Moved as a whole it keeps its direction to the last bit.
        let direction = if grip == Grip::Shaft {
            ray.direction()
        } else {
            std::array::from_fn(|e| rounded(tip[e] - origin[e], resolution))
        };
        // A ray of no length is refused; the last one stays.
        if let Ok(ray) = Ray::new(origin, direction) {
            grasp.document.scenario.ray = ray;
        }
    }
}

/// Turns the ray towards a point; its direction gets this length.
fn turn_to<const D: usize>(grasp: &mut Grasp<'_, D>, point: [f64; D], long: f64) {
    let ray = grasp.document.scenario.ray;
    let towards: [f64; D] = std::array::from_fn(|e| point[e] - ray.origin()[e]);
    let by = long / length(towards);
    let resolution = grasp.camera.unit(grasp.frame.page);
    let direction = towards.map(|x| rounded(x, resolution) * by);
    let direction = direction.map(|x| rounded(x, resolution * by));
    // Towards its origin it cannot be turned.
    if let Ok(turned) = Ray::new(ray.origin(), direction) {
        grasp.document.scenario.ray = turned;
    }
}

/// Length of a vector, also where squares of its components would be no numbers.
fn length<const D: usize>(way: [f64; D]) -> f64 {
    way.into_iter().fold(0.0, f64::hypot)
}

/// Pans the plane; orbits space, or pans it with the other buttons or Ctrl.
fn turn<const D: usize>(ui: &Ui, response: &Response, grasp: &mut Grasp<'_, D>) {
    let Grasp { frame, camera, .. } = grasp;
    let pan = response.dragged_by(PointerButton::Secondary)
        || response.dragged_by(PointerButton::Middle)
        || ui.input(|input| input.modifiers.command);
    let [dx, dy] = [f64::from(response.drag_delta().x), f64::from(response.drag_delta().y)];
    if D == 2 || pan {
        camera.pan(frame.page, dx, dy);
    } else {
        camera.orbit(frame.page, dx, dy);
    }
}

/// Zooms with the wheel or two fingers; what is under the pointer stays there.
fn zoom<const D: usize>(ui: &Ui, response: &Response, grasp: &mut Grasp<'_, D>) {
    let Grasp { frame, camera, document } = grasp;
    let Some(at) = response.hover_pos() else { return };
    let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
    let factor = (f64::from(scroll) * 0.0025).exp() * f64::from(pinch);
    if factor == 1.0 {
        return;
    }
    camera.zoom(frame.page, frame.on_page(at), factor);
    let side = document.tree.domain().side();
    camera.height = camera.height.clamp(side * 1e-6, side * 100.0);
}

fn distance_to_segment(at: Pos2, from: Pos2, to: Pos2) -> f32 {
    let along = to - from;
    let length = along.length_sq();
    if length == 0.0 {
        return at.distance(from);
    }
    let share = ((at - from).dot(along) / length).clamp(0.0, 1.0);
    at.distance(pos2(from.x + share * along.x, from.y + share * along.y))
}
