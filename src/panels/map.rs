//! The map of rays: every place is a ray, coloured by what becomes of it.

mod legend;
mod mark;
mod sides;

use crate::counted::counted_quickly;
use crate::look::Look;
use crate::map::{Asked, Colouring, Drawing, Raster, Rays, colours};
use crate::query_kind::QueryKind;
use crate::theme::color32;
use crate::view::{MapView, RaysOf};
use crate::widgets::{Listed, Present, caption, drop_down, segments};
use eframe::egui::{
    Color32, ColorImage, EventFilter, Id, Key, Modifiers, Pos2, ProgressBar, Rect, Response, Sense,
    Stroke, StrokeKind, TextureHandle, TextureOptions, Ui, WidgetInfo, accesskit::Role, pos2, vec2,
};
use mark::{Mark, on_screen};
use octoscope_core::family::Family;
use octoscope_core::geometry::{Aabb, Ray};
use octoscope_core::query::Query;
use octoscope_core::trace::Counter;
use octoscope_core::tree::Tree;
use octoscope_figure::{Camera, Page, Theme};
use std::sync::Arc;

/// Height of the map against its width.
const HEIGHT: f32 = 0.64;

/// What the map is about.
pub struct Subject<'a, const D: usize> {
    /// The tree.
    pub tree: &'a Arc<Tree<D>>,
    /// The search that is counted and checked.
    pub query: &'a Query<D>,
    /// The present ray.
    pub ray: &'a Ray<D>,
    /// Where the space view is seen from, if not from the usual side.
    pub camera: Option<Camera<D>>,
}

/// The choice, the map with the present ray in it, and in words what becomes of that
/// ray. Returns the ray that is pointed at with the button down, or gone to by arrow
/// keys.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    subject: &Subject<D>,
    view: &mut MapView,
    drawing: &mut Drawing<D>,
) -> Option<Ray<D>> {
    if !matches!(subject.query, Query::Ray { .. }) {
        let kind = QueryKind::of(subject.query).key();
        caption(ui, look, look.texts.format("map-none", &[("asked", kind.into())]));
        return None;
    }
    choice::<D>(ui, look, view);
    // The sides of a family are those of any page.
    let axes = asked(subject, view, vec2(1.0, 1.0)).rays.axes();
    let rect = sides::room(ui, look, axes.as_ref(), HEIGHT);
    let response = ui.interact(rect, ui.scope_id().with("map"), Sense::click_and_drag());
    let asked = asked(subject, view, rect.size());
    drawing.want(ui.ctx(), &asked);
    let painter = ui.painter_at(rect.expand(2.0));
    painter.rect_filled(rect, 0.0, look.palette.background);
    if let Some(texture) = texture(ui, look.theme, drawing, &asked) {
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        painter.image(texture.id(), rect, whole, Color32::WHITE);
    }
    painter.rect_stroke(rect, 0.0, Stroke::new(1.0, look.palette.quiet), StrokeKind::Outside);
    axes.iter().for_each(|axes| sides::paint(ui.painter(), look, rect, axes));
    let mark = Mark::of(&asked.rays, subject.tree, subject.ray);
    mark.into_iter().for_each(|mark| mark.paint(&painter, look, rect));
    if response.has_focus() {
        let stroke = Stroke::new(2.0, look.palette.accent);
        painter.rect_stroke(rect.expand(1.0), 0.0, stroke, StrokeKind::Outside);
    }
    let of_ray = told(look, &asked, subject.ray);
    let name = format!("{}: {of_ray}", look.text("panel-map"));
    response.widget_info(|| WidgetInfo::labeled(Role::Slider, true, name.as_str()));
    let chosen = pointed(ui, rect, &response, &asked, mark.and_then(Mark::place));
    if let Some(pointed) = response.hover_pos().and_then(|at| ray_at(rect, at, &asked)) {
        response.on_hover_text_at_pointer(told(look, &asked, &pointed));
    }
    caption(ui, look, of_ray);
    if axes.is_none() {
        caption(ui, look, look.text("map-extent-picture"));
    }
    explained(ui, look, drawing, &asked, mark);
    chosen
}

/// What the rays are, and what is asked of them.
fn choice<const D: usize>(ui: &mut Ui, look: &Look, view: &mut MapView) {
    if D == 3 {
        let choices = [RaysOf::Origin, RaysOf::Picture].map(|rays| (rays, look.text(rays.id())));
        segments(ui, &mut view.rays, &choices);
    }
    let label = look.text("map-colouring");
    let lines = Colouring::ALL.map(|one| Listed::Entry(one, look.text(one.id())));
    let value = look.text(view.colouring.id());
    let name = format!("{label}: {value}");
    let present = Present { entry: Some(view.colouring), name: value };
    let width = ui.available_width() - 8.0;
    let (list, chosen) = drop_down(ui, look, "map-colouring", width, present, &lines);
    list.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, name.as_str()));
    list.on_hover_text(label);
    view.colouring = chosen.unwrap_or(view.colouring);
}

fn asked<const D: usize>(
    subject: &Subject<D>,
    view: &MapView,
    size: eframe::egui::Vec2,
) -> Asked<D> {
    let domain = subject.tree.domain();
    let (min, side) = (domain.min(), domain.side());
    let rays = match view.rays {
        _ if D == 2 => Rays::Family(Family::lines(min, side)),
        RaysOf::Origin => {
            let ray = subject.ray;
            let length = ray.direction().iter().map(|d| d * d).sum::<f64>().sqrt();
            Rays::Family(Family::sight(ray.origin(), min, side, length))
        }
        RaysOf::Picture => {
            let page = Page { width: f64::from(size.x), height: f64::from(size.y) };
            let all = Aabb { min, max: min.map(|x| x + side) };
            Rays::Picture(subject.camera.unwrap_or_else(|| Camera::framing(&all, page)), page)
        }
    };
    let query = match *subject.query {
        Query::Ray { algorithm, mut options, arithmetic } => {
            // A map is of whole rays.
            options.segment_end = None;
            Query::Ray { algorithm, options, arithmetic }
        }
        query @ (Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. }) => query,
    };
    Asked {
        tree: Arc::clone(subject.tree),
        rays,
        colouring: view.colouring,
        query,
        size: [size.x as usize, size.y as usize].map(|n| n.max(1)),
    }
}

/// The picture of the last map, if it is of what is asked.
fn texture<const D: usize>(
    ui: &Ui,
    theme: Theme,
    drawing: &Drawing<D>,
    asked: &Asked<D>,
) -> Option<TextureHandle> {
    let (done, raster) = drawing.done.as_ref()?;
    if !Arc::ptr_eq(&done.tree, &asked.tree) {
        return None;
    }
    // Made once for every raster and theme, and kept by the window.
    let id = Id::unique(("map-texture", D));
    type Kept = (Arc<Raster>, Theme, TextureHandle);
    if let Some((of, in_theme, kept)) = ui.data(|data| data.get_temp::<Kept>(id))
        && Arc::ptr_eq(&of, raster)
        && in_theme == theme
    {
        return Some(kept);
    }
    let pixels = colours(theme, done.colouring, raster).into_iter().map(color32).collect();
    let image = ColorImage::new(raster.size, pixels);
    let texture = ui.ctx().load_texture("map", image, TextureOptions::NEAREST);
    ui.data_mut(|data| data.insert_temp::<Kept>(id, (Arc::clone(raster), theme, texture.clone())));
    Some(texture)
}

/// The ray of the cell at a place in the window.
fn ray_at<const D: usize>(rect: Rect, at: Pos2, asked: &Asked<D>) -> Option<Ray<D>> {
    let share = (at - rect.min) / rect.size();
    let cell = |share: f32, n: usize| ((share * n as f32).max(0.0) as usize).min(n - 1);
    asked.ray_of(cell(share.x, asked.size[0]), cell(share.y, asked.size[1]))
}

/// The ray that is chosen in this frame, by mouse or arrow keys.
fn pointed<const D: usize>(
    ui: &Ui,
    rect: Rect,
    response: &Response,
    asked: &Asked<D>,
    place: Option<[f64; 2]>,
) -> Option<Ray<D>> {
    if let Some(at) = response.interact_pointer_pos() {
        return ray_at(rect, at, asked);
    }
    if !response.has_focus() {
        return None;
    }
    let arrows =
        EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
    let [u, v] = place.unwrap_or([0.5; 2]);
    let moved = ui.input_mut(|input| {
        let mut pressed = |key| {
            let far = 10 * input.count_and_consume_key(Modifiers::SHIFT, key);
            (far + input.count_and_consume_key(Modifiers::NONE, key)) as f64
        };
        let right = pressed(Key::ArrowRight) - pressed(Key::ArrowLeft);
        let up = pressed(Key::ArrowUp) - pressed(Key::ArrowDown);
        (right != 0.0 || up != 0.0).then_some([right, up])
    });
    let [right, up] = moved?;
    let [columns, rows] = asked.size.map(|n| n as f64);
    let at = on_screen(rect, [u + right / columns, v + up / rows]);
    ray_at(rect, at, asked)
}

/// What becomes of a ray, if that is quickly found out.
fn told<const D: usize>(look: &Look, asked: &Asked<D>, ray: &Ray<D>) -> String {
    let Some(counted) = counted_quickly(&asked.tree, ray, &asked.query) else {
        return look.text("map-ray-long");
    };
    look.texts.format(
        "map-ray",
        &[
            ("leaves", counted.leaves.len().into()),
            ("steps", counted.n_steps.into()),
            ("comparisons", counted.counters.comparisons().into()),
            ("touches", counted.counters.get(Counter::NodeTouches).into()),
        ],
    )
}

/// What the colours and the mark mean, who has found that out, and how far the next map
/// is.
fn explained<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    drawing: &Drawing<D>,
    asked: &Asked<D>,
    mark: Option<Mark>,
) {
    if let Some((done, raster)) = drawing.done.as_ref().filter(|(d, _)| d.shows_the_same(asked)) {
        legend::ui(ui, look, done.colouring, raster, mark);
    }
    let by = match asked.colouring {
        Colouring::Sequence | Colouring::Leaves if asked.query.is_misprinted() => {
            "map-by-batch-right"
        }
        Colouring::Sequence | Colouring::Leaves => "map-by-batch",
        Colouring::Steps | Colouring::Comparisons => "map-by-algorithm",
        Colouring::Differences => "map-by-both",
    };
    caption(ui, look, look.text(by));
    if drawing.is_broken(asked) {
        caption(ui, look, look.text("job-broken"));
    }
    if let Some(fraction) = drawing.progress() {
        let bar = ProgressBar::new(fraction as f32).desired_height(6.0);
        let name = look.text("map-progress");
        ui.add(bar).on_hover_text(name);
    }
}
