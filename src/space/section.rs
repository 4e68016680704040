//! Where a slice meets an octree, on the graphics adapter.

use super::coarse::{Seen, coarser};
use crate::render::{BoxStyle, Cell, Grid, Layer};
use crate::theme::color32;
use eframe::egui::Color32;
use octoscope_core::geometry::Aabb;
use octoscope_core::tree::{Domain, Node, Tree};
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

/// A cell in the plane of a slice, with its place in [`SECTIONS`].
pub type Sectioned<const D: usize> = Seen<u8, D>;

/// The cells in the plane that are shown. O(cells in the plane).
pub fn cells<const D: usize>(tree: &Tree<D>, show: &Show, cut: &Cut) -> Vec<Sectioned<D>> {
    let nodes = cut.nodes(tree).filter(|&node| show.shows(tree, node));
    let sectioned = |node: Node| {
        let role = section_role(show, node);
        let look = SECTIONS.iter().position(|other| *other == role).unwrap_or(0) as u8;
        Seen { level: tree.level(node.id), code: tree.code(node.id), look }
    };
    nodes.map(sectioned).collect()
}

/// So few of these cells that about `most_vertices` draw them; `None` if they are few.
/// O(n log n).
pub fn coarse<const D: usize>(
    domain: &Domain<D>,
    cells: &[Sectioned<D>],
    most_vertices: usize,
) -> Option<Vec<Sectioned<D>>> {
    // A face, and about two edges of each; what is merged looks as the fullest of it.
    let most = most_vertices / (3 * 6);
    let fullest =
        |parts: &[Sectioned<D>]| parts.iter().map(|part| part.look).max().unwrap_or_default();
    let is_much = cells.len() > most;
    is_much.then(|| coarser(cells.to_vec(), domain.root_level(), most, fullest))
}

/// The faces of full leaves in the plane, and the outlines of all cells in it. They are
/// whole: what the path leaves is not seen, as it is drawn over them. O(n log n).
pub fn layers<const D: usize>(
    domain: &Domain<D>,
    cut: &Cut,
    theme: Theme,
    sectioned: &[Sectioned<D>],
) -> Vec<Layer> {
    let (mut cells, mut triangles) = (Vec::new(), Vec::new());
    for seen in sectioned {
        let Some(section) = cut.section_of(&domain.cell_box(seen.level, seen.code)) else {
            continue;
        };
        let mut code = seen.code;
        code[cut.axis] = 0;
        let code = std::array::from_fn(|e| if e < D { code[e] } else { 0 });
        cells.push(Cell { level: seen.level, style: seen.look, code });
        if SECTIONS[usize::from(seen.look)] == Role::FullSection {
            triangles.extend(halves(&section, cut.axis));
        }
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::AnyDocument;
    use crate::open::open_built_in;
    use octoscope_core::progress::Progress;

    #[test]
    fn few_cells_in_the_place_of_many_cover_the_same_part_of_the_plane() {
        let any = open_built_in("sphere-grid", &Progress::default()).unwrap();
        let AnyDocument::Space(document) = any else { panic!() };
        let (tree, domain) = (&document.tree, document.tree.domain());
        let cut = Cut { axis: 1, at: domain.min()[1] + 0.4 * domain.side(), keeps_lower: true };
        let show = Show { empty_leaves: true, ..Show::at_first::<3>() };
        let whole = cells(tree, &show, &cut);
        let few = coarse(domain, &whole, 18 * 20).unwrap();
        assert!(few.len() <= 20 && whole.len() > 20, "{} of {}", few.len(), whole.len());
        let area =
            |cells: &[Sectioned<3>]| cells.iter().map(|c| 4u64.pow(c.level.into())).sum::<u64>();
        assert_eq!([area(&few), area(&whole)], [4u64.pow(domain.root_level().into()); 2]);
        let is_full = |cell: &Sectioned<3>| SECTIONS[usize::from(cell.look)] == Role::FullSection;
        assert!(few.iter().any(is_full) && whole.iter().any(is_full));
        assert_eq!(coarse(domain, &whole, 18 * whole.len()), None);
    }
}
