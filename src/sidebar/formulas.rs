//! Where the formulas of the step are: in as much room in every step of a walk.

use crate::document::Document;
use crate::look::Look;
use crate::panels::{
    children, codes, cuts, formula, grid, halves, links, mid_planes, neighbour, paper, region,
    t_rail, tables, way_down,
};
use crate::view::{PanelKind, Preset, View};
use eframe::egui::{Frame, Margin, Panel, Ui, Vec2};
use octoscope_core::explain::{RichText, formulas};
use octoscope_core::trace::Trace;
use octoscope_figure::views::FormulaRows;
use std::sync::Arc;

/// Where the formulas of the step are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OfFormulas {
    /// Below the picture, which is so much lower.
    BelowPicture,
    /// Beside the picture, in a room of this height.
    BelowPanel(f32),
}

/// Room above and below formulas.
const MARGIN: f32 = 6.0;

impl OfFormulas {
    /// Where they are beside `panels` in a column of this size: in a lecture below its
    /// panel, if they have room there in every step.
    pub fn of<const D: usize>(
        ui: &Ui,
        look: &Look,
        view: &View,
        trace: &Arc<Trace<D>>,
        panels: &[PanelKind],
        column: Vec2,
    ) -> Self {
        let [panel] = panels else { return Self::BelowPicture };
        let is_alone = view.preset == Preset::Lecture && !view.question_shown;
        if !is_alone {
            return Self::BelowPicture;
        }
        let most = most_height(ui, look, *panel, trace, column.x);
        let room = most.map(|most| column.y - most - 2.0 * MARGIN);
        room.and_then(formula::height_below_panel).map_or(Self::BelowPicture, Self::BelowPanel)
    }
}

/// Height of a panel of a lecture with its heading, in points, in the step of the walk in
/// which it is highest, in a column of this width; `None` where that is not known.
fn most_height<const D: usize>(
    ui: &Ui,
    look: &Look,
    panel: PanelKind,
    trace: &Arc<Trace<D>>,
    width: f32,
) -> Option<f32> {
    use PanelKind::{
        Automaton, Children, Codes, Compare, Counters, Cuts, Grid, Halves, Links, Listing, Map,
        MidPlanes, Neighbour, Paper, Rail, Region, Stack, Tables, Tree, Variables, WayDown, WhyNot,
    };
    const HEADING: f32 = 30.0;
    /// Room below a table that ends with a line, so that no rule seems to cut it.
    const BELOW: f32 = 6.0;
    let body = match panel {
        Codes => codes::lecture_height::<D>(),
        Region => region::lecture_height::<D>(),
        Neighbour => neighbour::most_height(ui, trace),
        Rail => t_rail::lecture_height::<D>(),
        Tables => tables::LECTURE_HEIGHT,
        Cuts => cuts::lecture_height::<D>(),
        Children => children::lecture_height::<D>(),
        WayDown => way_down::LECTURE_HEIGHT,
        Links => links::lecture_height::<D>(),
        Halves => halves::LECTURE_HEIGHT,
        MidPlanes => mid_planes::lecture_height::<D>(),
        Grid => grid::lecture_height::<D>(),
        Paper => paper::most_height(look, &trace.query, width),
        Automaton | Listing | Variables | Stack | Counters | Compare | Tree | WhyNot | Map => {
            return None;
        }
    };
    let is_table = matches!(panel, Children | Links | Tables);
    let below = if is_table { BELOW } else { 0.0 };
    Some(HEADING + body + below)
}

/// The formulas of the step, if they are shown and have room, at the lower edge.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    document: &Document<D>,
    view: &View,
    place: OfFormulas,
) {
    let room = ui.available_height();
    let height = match (place, view.preset) {
        (OfFormulas::BelowPanel(height), _) => Some(height),
        (OfFormulas::BelowPicture, Preset::Lecture) => formula::height(room, FormulaRows::One),
        (OfFormulas::BelowPicture, _) => formula::height(room, FormulaRows::Two),
    };
    let Some(height) = height.filter(|_| view.formulas) else { return };
    let (fill, side) = match place {
        OfFormulas::BelowPicture => (look.palette.background, 16),
        // The margin there is that of the panel.
        OfFormulas::BelowPanel(_) => (look.palette.panel, 0),
    };
    let frame = Frame::new().fill(fill).inner_margin(Margin::symmetric(side, MARGIN as i8));
    let told = formulas(
        &document.tree,
        document.traced_ray(),
        &document.trace,
        view.playback.step,
        view.notation,
        view.language,
    );
    let words = if told.is_empty() { words_instead(look, document, view, place) } else { None };
    // Without anything in it, it is part of the ground of what is above it.
    let is_empty = told.is_empty() && words.is_none();
    let panel = Panel::bottom("formula").frame(frame).show_separator_line(!is_empty);
    panel.resizable(false).exact_size(height + 2.0 * MARGIN).show(ui, |ui| match words {
        Some(words) => formula::words_instead(ui, look, &words),
        None => formula::ui(ui, look, &told, view.notation),
    });
}

/// What is said in the room of formulas in a step that has none: why a misprint is one, or
/// that there is none, where the room would be taken for a part of the picture.
fn words_instead<const D: usize>(
    look: &Look,
    document: &Document<D>,
    view: &View,
    place: OfFormulas,
) -> Option<Vec<RichText>> {
    match place {
        OfFormulas::BelowPanel(_) => paper::why(look, &document.scenario.query).map(Vec::from),
        OfFormulas::BelowPicture => {
            let is_said = view.preset == Preset::Lecture && view.playback.step > 0;
            is_said.then(|| vec![look.text("formula-none").into()])
        }
    }
}
