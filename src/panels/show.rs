//! What the space view shows.

mod cells;

use crate::look::Look;
use crate::show_change::ShownPart;
use crate::widgets::heading;
use eframe::egui::{CollapsingHeader, FontId, Grid, RichText, Ui};
use octoscope_core::query::Query;
use octoscope_core::tree::Tree;
use octoscope_figure::Show;

/// Size of type.
const SIZE: f32 = 14.0;

/// The tree that is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Of {
    /// Its dimension.
    pub dimension: usize,
    /// Level of its root.
    pub root_level: u8,
    /// What is asked of it.
    pub asked: Asked,
}

/// What is asked of a tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asked {
    /// The leaves on a ray.
    Ray,
    /// Something else, for which there is no ray.
    Other,
}

impl Asked {
    fn by<const D: usize>(query: &Query<D>) -> Self {
        match query {
            Query::Ray { .. } => Self::Ray,
            Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => Self::Other,
        }
    }
}

impl Of {
    /// That of a tree of which `query` asks something.
    pub fn tree<const D: usize>(tree: &Tree<D>, query: &Query<D>) -> Self {
        let root_level = tree.domain().root_level();
        Self { dimension: D, root_level, asked: Asked::by(query) }
    }
}

/// The parts that have a box in the panel itself.
const PARTS: [ShownPart; 8] = [
    ShownPart::OrderNumbers,
    ShownPart::Content,
    ShownPart::EmptyLeaves,
    ShownPart::Ancestors,
    ShownPart::MirroredRay,
    ShownPart::Children,
    ShownPart::HalfOpenSides,
    ShownPart::Codes,
];

/// One box to tick for every part, in two columns where there is room, and below them,
/// folded at first, which cells off the path are shown, and how.
pub fn ui(ui: &mut Ui, look: &Look, show: &mut Show, of: Of) {
    heading(ui, look, &look.text("panel-show"), "");
    let font = FontId::proportional(SIZE);
    // In space, what is asked for more rarely is folded as well.
    let is_beside = |part: &ShownPart| of.dimension == 2 || *part != ShownPart::HalfOpenSides;
    let is_of_ray =
        |part: &ShownPart| matches!(part, ShownPart::OrderNumbers | ShownPart::MirroredRay);
    let is_seen = |part: &ShownPart| of.asked == Asked::Ray || !is_of_ray(part);
    let parts: Vec<ShownPart> = PARTS.into_iter().filter(is_beside).filter(is_seen).collect();
    let names: Vec<String> = parts.iter().map(|part| look.text(part.id())).collect();
    let width = |name: &String| {
        ui.painter().layout_no_wrap(name.clone(), font.clone(), look.palette.ink).size().x
    };
    let widths: Vec<f32> = names.iter().map(|name| width(name) + 20.0).collect();
    let widest = |first: usize| widths.iter().skip(first).step_by(2).copied().fold(0.0, f32::max);
    let spare = ui.available_width() - widest(0) - widest(1);
    let n_columns = if spare >= 8.0 { 2 } else { 1 };
    let gap = spare.clamp(8.0, 24.0);
    // Low rows, for the sake of low windows.
    ui.spacing_mut().interact_size.y = 22.0;
    let grid = Grid::new("show").num_columns(n_columns).spacing([gap, 0.0]);
    grid.show(ui, |ui| {
        for (n, (part, name)) in parts.into_iter().zip(names).enumerate() {
            part_box(ui, look, show, part, name);
            if (n + 1) % n_columns == 0 {
                ui.end_row();
            }
        }
    });
    ui.spacing_mut().item_spacing.y = 2.0;
    ui.spacing_mut().interact_size.y = 18.0;
    let more = if of.dimension == 2 { "show-more-plane" } else { "show-more-space" };
    let more = RichText::new(look.text(more)).size(SIZE);
    CollapsingHeader::new(more).id_salt("show-more").show_unindented(ui, |ui| {
        ui.spacing_mut().interact_size.y = 24.0;
        cells::ui(ui, look, show, of);
    });
}

/// A box to tick for a part.
fn part_box(ui: &mut Ui, look: &Look, show: &mut Show, part: ShownPart, name: String) {
    let why = look.text(&format!("{}-why", part.id()));
    ui.checkbox(part.of(show), RichText::new(name).size(SIZE)).on_hover_text(why);
}
