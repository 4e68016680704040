//! What lies below the marks: the leaves of the tree, its content and, in
//! space, the boxes of the marks. Drawn by the graphics adapter.

use super::leaves::{Leaves, TreeKey};
use super::scene::Scene;
use super::section;
use super::tree_layers::Appearance;
use crate::document::Document;
use crate::render::{self, BoxMark, Layer, Line, Pace, Picture, Plane, Speed};
use crate::theme::color32;
use eframe::egui::{Color32, Id, Ui};
use glam::Mat4;
use octoscope_core::scene::Content;
use octoscope_figure::{
    Camera, Colour, Cut, Dash, Mark, Page, Palette, Part, Role, Shape, Style, Theme, drawn_box,
    edge_part,
};

/// Layers that are kept as long as what they show stays the same.
pub struct Layers {
    speed: Speed,
    leaves: Leaves,
    section: Option<Section>,
    /// What of marks lies below the tree and its content, and what above.
    under: Boxes,
    over: Boxes,
}

/// Boxes of marks, and their layer.
type Boxes = Option<(Vec<BoxMark>, Layer)>;

/// Where a slice meets a tree.
struct Section {
    key: TreeKey,
    cut: Cut,
    /// So much that it can be drawn while it moves.
    coarse: Vec<Layer>,
    /// Everything, once the slice rests; at first `None`, if that is more.
    whole: Option<Vec<Layer>>,
}

impl Layers {
    /// No layers yet, for an adapter of this speed.
    pub fn new(speed: Speed) -> Self {
        Self { speed, leaves: Leaves::default(), section: None, under: None, over: None }
    }

    /// Paints the tree, and the boxes among `marks` if the tree is an octree.
    pub(super) fn paint<const D: usize>(
        &mut self,
        ui: &Ui,
        scene: &Scene<'_, D>,
        marks: &[Mark<D>],
        pace: Pace,
    ) {
        let Scene { document, appearance, camera, frame, .. } = *scene;
        let (page, rect) = (frame.page, frame.rect());
        let tree = self.leaves.of(ui.ctx(), document, appearance, self.speed).cloned();
        let cut = scene.cut();
        let view = view_of(camera, page);
        let section = cut.map(|cut| self.section(ui, document, appearance, &cut));
        let slice = cut.map_or([0.0; 4], |cut| section::plane(document.tree.domain(), &cut));
        let unit = camera.unit(page);
        let boxes: Vec<BoxMark> = marks
            .iter()
            .filter(|mark| draws(mark))
            .flat_map(|mark| box_marks(mark, appearance.theme, unit))
            .collect();
        // Points keep their colours: the sides of boxes lie below them. What is solid
        // would hide them.
        let is_cloud = D == 3 && matches!(*document.content, Content::Points(_));
        let (under, over) = if is_cloud { sides_and_edges(&boxes) } else { (Vec::new(), boxes) };
        let id = Id::unique("space");
        // Pictures of their own: the tree stays as it is drawn.
        let paint_marks = |name: &str, layer: Layer| {
            let (layers, background) = (vec![layer], Color32::TRANSPARENT);
            let picture = Picture { view, slice: [0.0; 4], layers, background };
            render::paint(ui, rect, id.with(name), &picture);
        };
        if is_cloud {
            paint_marks("below", layer_of(&mut self.under, under));
        }
        let background = match is_cloud {
            true => Color32::TRANSPARENT,
            false => color32(Palette::of(appearance.theme).background),
        };
        let [coarse, whole] = [true, false].map(|is_coarse| {
            let tree =
                tree.iter().flat_map(|tree| if is_coarse { &tree.coarse } else { &tree.whole });
            let section =
                section.iter().flat_map(|[coarse, whole]| if is_coarse { coarse } else { whole });
            let layers = tree.chain(section).cloned().collect();
            Picture { view, slice, layers, background }
        });
        render::paint_in_steps(ui, rect, id, [&coarse, &whole], (self.speed, pace));
        if D == 3 {
            paint_marks("marks", layer_of(&mut self.over, over));
        }
    }

    /// Waits for what is being made on other threads.
    pub fn finish(&mut self) {
        self.leaves.finish();
    }

    /// From now on draws everything whole, however long it takes.
    pub fn draw_whole(&mut self) {
        self.speed = Speed { vertices: u32::MAX };
    }

    /// Where a slice meets the tree, coarse and whole; the same layers as long as it stays
    /// where it is. In the first frame there is only the coarse one if it is large.
    fn section<const D: usize>(
        &mut self,
        ui: &Ui,
        document: &Document<D>,
        appearance: Appearance<'_>,
        cut: &Cut,
    ) -> [Vec<Layer>; 2] {
        let key = TreeKey::of(document, appearance);
        let show = appearance.show;
        let (tree, domain) = (&document.tree, document.tree.domain());
        let layers = |cells: &[_]| section::layers(domain, cut, appearance.theme, cells);
        let rests = self.section.as_ref().is_some_and(|of| of.key == key && of.cut == *cut);
        let (coarse, whole) = match self.section.take().filter(|_| rests) {
            Some(Section { coarse, whole: Some(whole), .. }) => (coarse, Some(whole)),
            Some(Section { coarse, whole: None, .. }) => {
                (coarse, Some(layers(&section::cells(tree, show, cut))))
            }
            None => {
                let cells = section::cells(tree, show, cut);
                let most = self.speed.vertices as usize / 2;
                match section::coarse(domain, &cells, most) {
                    Some(coarse) => {
                        ui.ctx().request_repaint();
                        (layers(&coarse), None)
                    }
                    None => {
                        let whole = layers(&cells);
                        (whole.clone(), Some(whole))
                    }
                }
            }
        };
        let both = [&coarse, whole.as_ref().unwrap_or(&coarse)].map(Vec::clone);
        self.section = Some(Section { key, cut: *cut, coarse, whole });
        both
    }
}

/// The layer of boxes; the same as long as they stay the same.
fn layer_of(kept: &mut Boxes, boxes: Vec<BoxMark>) -> Layer {
    match kept {
        Some((old, layer)) if *old == boxes => layer.clone(),
        Some(_) | None => {
            let layer = Layer::marks(boxes.clone());
            *kept = Some((boxes, layer.clone()));
            layer
        }
    }
}

/// The sides of boxes, and their edges.
fn sides_and_edges(boxes: &[BoxMark]) -> (Vec<BoxMark>, Vec<BoxMark>) {
    let none = Color32::TRANSPARENT;
    let sides = boxes.iter().map(|&mark| BoxMark { edge: none, ..mark });
    let edges = boxes.iter().map(|&mark| BoxMark { fill: none, ..mark });
    (sides.collect(), edges.collect())
}

/// The view of a camera on a page.
fn view_of<const D: usize>(camera: &Camera<D>, page: Page) -> render::View {
    if D == 2 {
        let centre = [camera.target[0], camera.target[1]];
        return render::View::Plane(Plane { centre, scale: page.height / camera.height });
    }
    let clip = camera.clip_from_offset(page, camera.target);
    let clip_from_offset = Mat4::from_cols_array_2d(&clip);
    render::View::Space(render::Space { origin: in_space(camera.target), clip_from_offset })
}

/// Whether the graphics adapter draws a mark, so that the painter need not.
pub fn draws<const D: usize>(mark: &Mark<D>) -> bool {
    // What is asked stays above planes, cells of the grid and what is looked for are never
    // too small to be seen, what is ruled out is drawn as one body, and planes lie before or
    // behind the frame of what is at work.
    let is_of_painter = matches!(
        mark.role,
        Role::Current
            | Role::Missed
            | Role::Found
            | Role::Taken
            | Role::Apart
            | Role::ApartTaken
            | Role::Region
            | Role::GridCell
            | Role::Target
            | Role::Rejected
    );
    D == 3 && matches!(mark.shape, Shape::Box(_)) && !is_of_painter
}

/// The box of a mark, above what parts it from all else; `unit` is a page unit in world
/// units.
fn box_marks<const D: usize>(mark: &Mark<D>, theme: Theme, unit: f64) -> Vec<BoxMark> {
    let Shape::Box(bounds) = mark.shape else { return Vec::new() };
    let bounds = drawn_box(mark.role, &bounds, unit);
    let style = Style::of(theme, mark.role);
    let is_fine = edge_part(&style, &bounds, unit) == Part::FineEdge;
    let fine = (Part::FineEdge.width() * style.width).max(1.0);
    let width = if is_fine { fine } else { style.width };
    let layer = mark.role.layer();
    let line = match style.dash {
        Dash::Solid => Line::Solid,
        Dash::Dashed | Dash::DashDotted => Line::Dashed,
        Dash::Dotted => Line::Dotted,
    };
    let weak = |fill: Colour| color32(fill.faded(fill.opacity * 0.6));
    let own = BoxMark {
        min: in_space(bounds.min),
        max: in_space(bounds.max),
        fill: style.fill.map_or(Color32::TRANSPARENT, weak),
        edge: style.stroke.map_or(Color32::TRANSPARENT, color32),
        width: width as f32,
        line: if is_fine { Line::Solid } else { line },
        // What is quieter lies among the faces.
        layer: if layer < Role::Taken.layer() { 0 } else { 2 * layer + 1 },
        is_crossed: mark.role == Role::Strayed,
    };
    let casing = (style.casing > 0.0).then(|| BoxMark {
        fill: Color32::TRANSPARENT,
        edge: color32(Palette::of(theme).background),
        width: (width + 2.0 * style.casing) as f32,
        line: Line::Solid,
        layer: own.layer.saturating_sub(1),
        is_crossed: false,
        ..own
    });
    casing.into_iter().chain([own]).collect()
}

/// A point with three coordinates, z 0 in the plane.
pub fn in_space<const D: usize>(point: [f64; D]) -> [f64; 3] {
    std::array::from_fn(|e| if e < D { point[e] } else { 0.0 })
}
