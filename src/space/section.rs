//! Where a slice meets an octree, on the graphics adapter.

use crate::render::{BoxStyle, Cell, Grid, Layer};
use crate::theme::color32;
use eframe::egui::Color32;
use octoscope_core::geometry::Aabb;
use octoscope_core::tree::{Domain, Tree};
use octoscope_figure::{Cut, Role, Show, Style, Theme, section_role};

/// Planes that lie in a slice are moved so much behind it, in sides of the root, that
/// rounding does not take them away.
const BEHIND: f64 = 1e-5;

/// Plane of a slice for [`crate::render::Picture::slice`].
pub fn plane<const D: usize>(domain: &Domain<D>, cut: &Cut) -> [f64; 4] {
    let sign = if cut.keeps_lower { 1.0 } else { -1.0 };
    let mut plane = [0.0; 4];
    plane[cut.axis] = sign;
    plane[3] = -sign * cut.at - BEHIND * domain.side();
    plane
}

/// Roles of cells in the plane, the filled ones last.
const SECTIONS: [Role; 3] = [Role::FaintNode, Role::EmptySection, Role::FullSection];

/// The faces of full leaves in the plane, and the outlines of all cells in it. They are
/// whole: what the path leaves is not seen, as it is drawn over them. O(cells in the
/// plane).
pub fn layers<const D: usize>(tree: &Tree<D>, show: &Show, cut: &Cut, theme: Theme) -> Vec<Layer> {
    let nodes = cut.nodes(tree).filter(|&node| show.shows(tree, node));
    let (mut cells, mut triangles) = (Vec::new(), Vec::new());
    for node in nodes {
        let Some(section) = cut.section_of(&tree.node_box(node.id)) else { continue };
        let mut code = tree.code(node.id);
        code[cut.axis] = 0;
        let code = std::array::from_fn(|e| if e < D { code[e] } else { 0 });
        let role = section_role(show, node);
        let style = SECTIONS.iter().position(|other| *other == role).unwrap_or(0) as u8;
        cells.push(Cell { level: tree.level(node.id), style, code });
        if role == Role::FullSection {
            triangles.extend(halves(&section, cut.axis));
        }
    }
    let domain = tree.domain();
    let mut min: [f64; 3] = std::array::from_fn(|e| if e < D { domain.min()[e] } else { 0.0 });
    min[cut.axis] = cut.at;
    let grid = Grid { min, cell: domain.cell_side(0), root_level: domain.root_level() };
    let styles = SECTIONS.map(|role| Style::of(theme, role));
    let outlines = styles.map(|style| BoxStyle {
        fill: Color32::TRANSPARENT,
        edge: style.stroke.map_or(Color32::TRANSPARENT, color32),
        width: style.width as f32,
    });
    let fill = styles[2].fill.map_or(Color32::TRANSPARENT, color32);
    vec![Layer::triangles(&triangles, fill), Layer::faces_across(grid, cut.axis, &cells, &outlines)]
}

/// A rectangle across an axis as two triangles.
fn halves<const D: usize>(flat: &Aabb<D>, axis: usize) -> [[[f64; 3]; 3]; 2] {
    let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    let corner = |at: [bool; 2]| -> [f64; 3] {
        std::array::from_fn(|e| {
            let is_upper = e == u && at[0] || e == v && at[1];
            if e >= D {
                0.0
            } else if is_upper {
                flat.max[e]
            } else {
                flat.min[e]
            }
        })
    };
    let [a, b, c, d] = [[false; 2], [true, false], [true; 2], [false, true]].map(corner);
    [[a, b, c], [a, c, d]]
}
