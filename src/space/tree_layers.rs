//! What is seen of a tree and its content, as layers: all of it, and so little in its
//! place that it can be drawn while it moves.

use super::base::in_space;
use super::coarse::{Seen, coarser};
use crate::document::colours_of_leaves;
use crate::render::{BoxStyle, Cell, Grid, Layer, Speed};
use crate::theme::color32;
use eframe::egui::Color32;
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::scene::{Content, Sphere};
use octoscope_core::tree::{Node, Tree};
use octoscope_figure::{Palette, Rest, Role, Show, Style, Theme, cell_role};

/// What is shown, and in which colours.
#[derive(Clone, Copy, Debug)]
pub struct Appearance<'a> {
    /// What.
    pub show: &'a Show,
    /// The colours.
    pub theme: Theme,
}

/// How much is drawn in a small part of a second, for the tree and for its content.
fn halves(speed: Speed) -> usize {
    speed.vertices as usize / 2
}

/// The layers of a tree, whole and coarse. Stops when `progress` is cancelled.
pub fn layers<const D: usize>(
    tree: &Tree<D>,
    content: &Content<D>,
    appearance: Appearance<'_>,
    speed: Speed,
    progress: &Progress,
) -> Result<[Vec<Layer>; 2], Cancelled> {
    let [mut whole, mut coarse] = if D == 2 {
        plane_layers(tree, content, appearance, speed, progress)?
    } else {
        space_layers(tree, appearance, speed, progress)?
    };
    if (D == 3 || is_cloud(content))
        && appearance.show.content
        && let Some(layer) = content_layer(content, appearance.theme)
    {
        coarse.push(layer.within(halves(speed)));
        whole.push(layer);
    }
    Ok([whole, coarse])
}

fn grid_of<const D: usize>(tree: &Tree<D>) -> Grid {
    let domain = tree.domain();
    Grid { min: in_space(domain.min()), cell: domain.cell_side(0), root_level: domain.root_level() }
}

fn cell<T, const D: usize>(seen: &Seen<T, D>, style: u8) -> Cell {
    let code = std::array::from_fn(|e| if e < D { seen.code[e] } else { 0 });
    Cell { level: seen.level, style, code }
}

fn color(colour: Option<octoscope_figure::Colour>) -> Color32 {
    colour.map_or(Color32::TRANSPARENT, color32)
}

/// Cells, and fewer of them in their place if there are too many.
type Cells<T, const D: usize> = (Vec<Seen<T, D>>, Option<Vec<Seen<T, D>>>);

/// The cells that are shown and, if they are more than `most`, so few in their place.
fn cells<T: Copy, const D: usize>(
    tree: &Tree<D>,
    show: &Show,
    look: impl Fn(Node) -> T,
    (most, merged): (usize, impl Fn(&[Seen<T, D>]) -> T),
    progress: &Progress,
) -> Result<Cells<T, D>, Cancelled> {
    let seen = |node: Node| {
        let (level, code) = (tree.level(node.id), tree.code(node.id));
        Seen { level, code, look: look(node) }
    };
    let whole: Vec<_> = show.nodes(tree).map(seen).collect();
    progress.check()?;
    let is_much = whole.len() > most;
    let coarse = is_much.then(|| coarser(whole.clone(), tree.domain().root_level(), most, merged));
    progress.check()?;
    Ok((whole, coarse))
}

/// The cells of a quadtree.
fn plane_layers<const D: usize>(
    tree: &Tree<D>,
    content: &Content<D>,
    Appearance { show, theme }: Appearance<'_>,
    speed: Speed,
    progress: &Progress,
) -> Result<[Vec<Layer>; 2], Cancelled> {
    let style = |role| Style::of(theme, role);
    let pictures =
        colours_of_leaves(tree, content).filter(|_| show.content && show.rest == Rest::Plain);
    let roles = [Role::EmptyLeaf, Role::FullLeaf, Role::FaintNode, Role::InnerNode];
    let fills = roles.map(|role| color(style(role).fill));
    let fill = |role| roles.iter().position(|r| *r == role).map_or(fills[0], |i| fills[i]);
    let look = |node: Node| {
        let own = pictures.as_ref().and_then(|colours| colours[node.id.index()]);
        let plain = || fill(cell_role(show, node));
        own.map_or_else(plain, |[r, g, b]| Color32::from_rgb(r, g, b))
    };
    let line = match show.rest {
        Rest::Plain | Rest::Hidden => style(Role::EmptyLeaf),
        Rest::Faint => style(Role::FaintNode),
    };
    // Two triangles a cell.
    let most = speed.vertices as usize / 6;
    let cells = cells(tree, show, look, (most, mean), progress)?;
    let grid = grid_of(tree);
    let layer = |cells: Vec<Seen<Color32, D>>| {
        let cells: Vec<_> = cells.iter().map(|seen| (cell(seen, 0), seen.look)).collect();
        Layer::cells(grid, &cells, color(line.stroke), line.width as f32)
    };
    Ok(both(cells, layer))
}

/// A whole layer and a coarse one; the same if there is only one.
fn both<C>((whole, coarse): (C, Option<C>), layer: impl Fn(C) -> Layer) -> [Vec<Layer>; 2] {
    let whole = layer(whole);
    let coarse = coarse.map_or_else(|| whole.clone(), layer);
    [whole, coarse].map(|layer| vec![layer])
}

/// Mean colour of cells, by their areas.
fn mean<const D: usize>(parts: &[Seen<Color32, D>]) -> Color32 {
    let area = |part: &Seen<Color32, D>| 4f64.powi(part.level.into());
    let total: f64 = parts.iter().map(area).sum();
    let channel = |index: usize| {
        let value = |part: &Seen<Color32, D>| f64::from(part.look.to_array()[index]);
        let sum: f64 = parts.iter().map(|part| area(part) * value(part)).sum();
        (sum / total).round() as u8
    };
    Color32::from_rgba_premultiplied(channel(0), channel(1), channel(2), channel(3))
}

/// Styles of boxes: leaves without and with contents, inner nodes.
const EMPTY: u8 = 0;
const FULL: u8 = 1;
const INNER: u8 = 2;

/// The boxes of an octree.
fn space_layers<const D: usize>(
    tree: &Tree<D>,
    Appearance { show, theme }: Appearance<'_>,
    speed: Speed,
    progress: &Progress,
) -> Result<[Vec<Layer>; 2], Cancelled> {
    let hint = |role, strength: f64| {
        let style = Style::of(theme, role);
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
    let look = |node: Node| match (node.is_leaf(), node.is_full()) {
        (true, true) => FULL,
        (true, false) => EMPTY,
        (false, _) => INNER,
    };
    // A box with something in it looks full.
    let merged = |parts: &[Seen<u8, D>]| {
        let has = |style: u8| parts.iter().any(|part| part.look == style);
        [FULL, INNER].into_iter().find(|&style| has(style)).unwrap_or(EMPTY)
    };
    // Neighbours share edges: about four a box, of two triangles each.
    let most = halves(speed) / (4 * 6);
    let cells = cells(tree, show, look, (most, merged), progress)?;
    let grid = grid_of(tree);
    let layer = |cells: Vec<Seen<u8, D>>| {
        let cells: Vec<_> = cells.iter().map(|seen| cell(seen, seen.look)).collect();
        Layer::boxes(grid, &cells, &box_styles)
    };
    Ok(both(cells, layer))
}

/// Whether points are too many to be painted one by one, in the plane.
pub fn is_cloud<const D: usize>(content: &Content<D>) -> bool {
    const MOST_ONE_BY_ONE: usize = 2000;
    matches!(content, Content::Points(points) if points.len() > MOST_ONE_BY_ONE)
}

/// More points of a cloud than this are not drawn at once.
const MOST_POINTS: usize = 200_000;

/// The content of an octree, or the points of a quadtree.
fn content_layer<const D: usize>(content: &Content<D>, theme: Theme) -> Option<Layer> {
    let palette = Palette::of(theme);
    let surface = match theme {
        Theme::Light | Theme::Print | Theme::Projector => palette.grid,
        // What is turned from the light would be lost on dark ground.
        Theme::Dark => palette.quiet_ink.faded(0.65).over(palette.background),
    };
    let (colour, surface) = (color32(palette.quiet_ink), color32(surface));
    let point = |p: &[f64; D]| in_space(*p);
    match content {
        Content::Points(points) => {
            // An even choice of a large cloud shows its shape as well.
            let every = points.len().div_ceil(MOST_POINTS).max(1);
            let shown: Vec<_> = points.iter().step_by(every).map(point).collect();
            Some(Layer::points(&shown, colour, Style::POINT_IN_SPACE as f32))
        }
        Content::Triangles(triangles) => {
            let triangles: Vec<_> = triangles.iter().map(|t| t.map(in_space)).collect();
            Some(Layer::triangles(&triangles, surface))
        }
        Content::Spheres(spheres) => {
            let ball = |sphere: &Sphere<D>| {
                let [x, y, z] = in_space(sphere.centre);
                [x, y, z, sphere.radius]
            };
            let balls: Vec<_> = spheres.iter().map(ball).collect();
            Some(Layer::spheres(&balls, surface))
        }
        Content::Cells(_) | Content::Boxes(_) | Content::Image(_) => None,
    }
}
