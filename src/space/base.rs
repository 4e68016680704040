//! What lies below the marks: the leaves of the tree, its content and, in
//! space, the boxes of the marks. Drawn by the graphics adapter.

use super::section;
use crate::document::Document;
use crate::render::{self, BoxMark, BoxStyle, Cell, Grid, Layer, Line, Picture, Plane};
use crate::theme::color32;
use eframe::egui::{Color32, Id, Rect, Ui};
use glam::Mat4;
use octoscope_core::scene::Content;
use octoscope_core::tree::Node;
use octoscope_figure::{
    Camera, Cut, Dash, Levels, Mark, Palette, Rest, Role, Shape, Show, Style, Theme, cell_role,
};
use std::any::Any;
use std::sync::Arc;

/// Layers that are kept as long as what they show stays the same.
#[derive(Debug, Default)]
pub struct Layers {
    tree: Option<(TreeKey, Vec<Layer>)>,
    /// Keeps the shown tree alive, so that no other one takes its address.
    shown: Option<Arc<dyn Any>>,
    section: Option<(TreeKey, Cut, Vec<Layer>)>,
    marks: Option<(Vec<BoxMark>, Layer)>,
}

/// What the layers of the tree depend on.
#[derive(Clone, Debug, PartialEq)]
struct TreeKey {
    /// Address of the tree, which is kept as long as it is the key.
    tree: usize,
    content: bool,
    empty_leaves: bool,
    inner_nodes: bool,
    levels: Levels,
    rest: Rest,
    theme: Theme,
}

impl Layers {
    /// Paints the tree, and the boxes among `marks` if the tree is an octree.
    pub fn paint<const D: usize>(
        &mut self,
        ui: &Ui,
        rect: Rect,
        camera: &Camera<D>,
        document: &Document<D>,
        (show, theme): (&Show, Theme),
        marks: &[Mark<D>],
    ) {
        let key = TreeKey {
            tree: Arc::as_ptr(&document.tree) as usize,
            content: show.content,
            empty_leaves: show.empty_leaves,
            inner_nodes: show.inner_nodes,
            levels: show.levels,
            rest: show.rest,
            theme,
        };
        let cut = show.slice.and_then(|slice| slice.cut(document.tree.domain(), camera));
        if self.tree.as_ref().is_none_or(|(old, _)| *old != key) {
            let layers = tree_layers(document, show, theme);
            self.tree = Some((key.clone(), layers));
            self.shown = Some(Arc::clone(&document.tree) as Arc<dyn Any>);
        }
        let mut layers = self.tree.as_ref().map(|(_, layers)| layers.clone()).unwrap_or_default();
        let page = super::page_of(rect);
        let view = if D == 2 {
            let centre = [camera.target[0], camera.target[1]];
            render::View::Plane(Plane { centre, scale: page.height / camera.height })
        } else {
            if let Some(cut) = &cut {
                layers.extend(self.section(&key, cut, document, show));
            }
            layers.push(self.mark_layer(marks, theme));
            render::View::Space(Mat4::from_cols_array_2d(&camera.clip_from_world(page)))
        };
        let background = color32(Palette::of(theme).background);
        let slice = cut.map_or([0.0; 4], |cut| section::plane(document.tree.domain(), &cut));
        let picture = Picture { view, slice, layers, background };
        render::paint(ui, rect, Id::unique("space"), &picture);
    }

    /// Where a slice meets the tree; the same layers as long as it stays where it is.
    fn section<const D: usize>(
        &mut self,
        key: &TreeKey,
        cut: &Cut,
        document: &Document<D>,
        show: &Show,
    ) -> Vec<Layer> {
        match &self.section {
            Some((old, at, layers)) if old == key && at == cut => layers.clone(),
            Some(_) | None => {
                let layers = section::layers(&document.tree, show, cut, key.theme);
                self.section = Some((key.clone(), *cut, layers.clone()));
                layers
            }
        }
    }

    fn mark_layer<const D: usize>(&mut self, marks: &[Mark<D>], theme: Theme) -> Layer {
        let boxes: Vec<BoxMark> = marks
            .iter()
            .filter(|mark| draws(mark))
            .filter_map(|mark| box_mark(mark, theme))
            .collect();
        match &self.marks {
            Some((old, layer)) if *old == boxes => layer.clone(),
            Some(_) | None => {
                let layer = Layer::marks(boxes.clone());
                self.marks = Some((boxes, layer.clone()));
                layer
            }
        }
    }
}

/// Whether the graphics adapter draws a mark, so that the painter need not.
pub fn draws<const D: usize>(mark: &Mark<D>) -> bool {
    let is_above = matches!(mark.role, Role::Apart | Role::ApartTaken);
    D == 3 && matches!(mark.shape, Shape::Box(_)) && !is_above
}

fn box_mark<const D: usize>(mark: &Mark<D>, theme: Theme) -> Option<BoxMark> {
    let Shape::Box(bounds) = mark.shape else { return None };
    let style = Style::of(theme, mark.role);
    let corner = |p: [f64; D]| std::array::from_fn(|e| if e < D { p[e] as f32 } else { 0.0 });
    Some(BoxMark {
        min: corner(bounds.min),
        max: corner(bounds.max),
        fill: style
            .fill
            .map_or(Color32::TRANSPARENT, |fill| color32(fill.faded(fill.opacity * 0.6))),
        edge: style.stroke.map_or(Color32::TRANSPARENT, color32),
        width: style.width as f32,
        line: if style.dash == Dash::Solid { Line::Solid } else { Line::Dashed },
    })
}

fn tree_layers<const D: usize>(document: &Document<D>, show: &Show, theme: Theme) -> Vec<Layer> {
    let tree = &document.tree;
    let domain = tree.domain();
    let min = std::array::from_fn(|e| if e < D { domain.min()[e] } else { 0.0 });
    let grid = Grid { min, cell: domain.cell_side(0), root_level: domain.root_level() };
    let cell = |leaf: Node, style: u8| {
        let code = tree.code(leaf.id);
        let code = std::array::from_fn(|e| if e < D { code[e] } else { 0 });
        Cell { level: tree.level(leaf.id), style, code }
    };
    let style = |role| Style::of(theme, role);
    let color =
        |colour: Option<octoscope_figure::Colour>| colour.map_or(Color32::TRANSPARENT, color32);
    let mut layers = Vec::new();
    if D == 2 {
        let shown = show.content && show.rest == Rest::Plain;
        let pictures = document.leaf_colours().filter(|_| shown);
        let roles = [Role::EmptyLeaf, Role::FullLeaf, Role::FaintNode, Role::InnerNode];
        let fills = roles.map(|role| color(style(role).fill));
        let fill = |role| roles.iter().position(|r| *r == role).map_or(fills[0], |i| fills[i]);
        let cells: Vec<_> = show
            .nodes(tree)
            .map(|node| {
                let own = pictures.as_ref().and_then(|colours| colours[node.id.index()]);
                let plain = || fill(cell_role(show, node));
                let shown = own.map_or_else(plain, |[r, g, b]| Color32::from_rgb(r, g, b));
                (cell(node, 0), shown)
            })
            .collect();
        let line = match show.rest {
            Rest::Plain | Rest::Hidden => style(Role::EmptyLeaf),
            Rest::Faint => style(Role::FaintNode),
        };
        layers.push(Layer::cells(grid, &cells, color(line.stroke), line.width as f32));
    } else {
        let hint = |role, strength: f64| {
            let style = style(role);
            let edge = style.stroke.map(|c| c.faded(strength * c.opacity));
            BoxStyle { fill: Color32::TRANSPARENT, edge: color(edge), width: style.width as f32 }
        };
        let is_faint = show.rest == Rest::Faint;
        let [full, empty] = if is_faint { [0.5, 0.3] } else { [0.8, 0.22] };
        let box_styles = [
            hint(if is_faint { Role::FaintNode } else { Role::EmptyLeaf }, empty),
            hint(if is_faint { Role::FaintNode } else { Role::FullLeaf }, full),
            hint(if is_faint { Role::FaintNode } else { Role::InnerNode }, full),
        ];
        let number = |node: Node| if node.is_leaf() { u8::from(node.is_full()) } else { 2 };
        let cells: Vec<_> = show.nodes(tree).map(|node| cell(node, number(node))).collect();
        layers.push(Layer::boxes(grid, &cells, &box_styles));
        if show.content {
            layers.extend(content_layer(&document.content, theme));
        }
    }
    layers
}

/// More points of a cloud than this are not drawn at once.
const MOST_POINTS: usize = 200_000;

/// The content of an octree.
fn content_layer<const D: usize>(content: &Content<D>, theme: Theme) -> Option<Layer> {
    let palette = Palette::of(theme);
    let (colour, surface) = (color32(palette.quiet_ink), color32(palette.grid));
    let point = |p: &[f64; D]| std::array::from_fn(|e| if e < D { p[e] as f32 } else { 0.0 });
    match content {
        Content::Points(points) => {
            // An even choice of a large cloud shows its shape as well.
            let every = points.len().div_ceil(MOST_POINTS).max(1);
            let shown = points.iter().step_by(every).map(point);
            Some(Layer::points(shown.collect(), colour, 1.8))
        }
        Content::Triangles(triangles) => {
            let triangles: Vec<[[f32; 3]; 3]> =
                triangles.iter().map(|t| [point(&t[0]), point(&t[1]), point(&t[2])]).collect();
            Some(Layer::triangles(&triangles, surface))
        }
        Content::Spheres(spheres) => {
            let balls = spheres.iter().map(|sphere| {
                let [x, y, z]: [f32; 3] = point(&sphere.centre);
                [x, y, z, sphere.radius as f32]
            });
            Some(Layer::spheres(balls.collect(), surface))
        }
        Content::Cells(_) | Content::Boxes(_) | Content::Image(_) => None,
    }
}
