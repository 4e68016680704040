//! Views of a query beside the picture in space, each a pure function from a
//! [`Subject`] to a [`Figure`]: panels and exported figures show the same.
//!
//! Where a panel shows its entries one by one, for readers that cannot see them,
//! both share the values: [`Table`], [`BitTable`] and the like.

mod automaton;
mod bits;
mod chart;
mod codes;
mod columns;
mod exercise;
mod formula;
mod formula_breaks;
mod formula_short;
mod kind;
pub mod lab;
mod legend;
mod listing;
mod neighbour;
mod rail;
mod region;
mod sheet;
mod steps;
mod storyboard;
mod subject;
mod t_rail;
mod table;
mod words;
mod worksheet;

pub use automaton::Automaton;
pub use bits::{Beside, BitRow, BitTable, Carries, Conclusion, Spacing};
pub use codes::{CodeTable, child_rule, code_table};
pub use exercise::{Exercise, ExerciseError};
pub use formula::{FormulaRows, formula_figure, formula_height, formulas_alike};
pub use kind::{FigureView, UnknownView, ViewError};
pub use listing::{Changed, changed_variables};
pub use neighbour::{NeighbourTables, neighbour_heights, neighbour_tables};
pub use rail::{RailOf, planes_ahead};
pub use region::region_table;
pub use steps::rows_of_table;
pub use storyboard::{Layout, Panel, common_extent, storyboard};
pub use subject::Subject;
pub use t_rail::{RailFigure, RailRows, rail_of, t_rail, t_rail_height};
pub use table::{Entry, EntryKind, Table, Tone};
pub use worksheet::{Fields, worksheet};

use crate::Figure;
use octoscope_core::text::{Language, Texts};
use octoscope_core::trace::Moment;
use octoscope_core::tree::{Code, NodeId};

/// Source of the texts of all views in `language`.
pub fn figure_texts(language: Language) -> &'static str {
    match language {
        Language::English => concat!(
            include_str!("../../../../assets/texts/en/figures.ftl"),
            "\n",
            include_str!("../../../../assets/texts/en/lab.ftl"),
        ),
        Language::German => concat!(
            include_str!("../../../../assets/texts/de/figures.ftl"),
            "\n",
            include_str!("../../../../assets/texts/de/lab.ftl"),
        ),
    }
}

/// The figure of one of the views that are about a single moment and need no
/// picture, on a page of this width.
///
/// # Errors
/// Says which query or step would be right.
pub fn figure<const D: usize>(
    view: FigureView,
    subject: &Subject<D>,
    width: f64,
) -> Result<Figure, ViewError> {
    view.fits(subject.query())?;
    if let Some(figure) = drawn(view, subject, width) {
        return Ok(figure);
    }
    let mut moment = Moment::default();
    let mut first = None;
    for (index, event) in subject.trace.events.iter().enumerate() {
        moment.apply(subject.tree, event);
        let later = Subject { moment: &moment, ..*subject };
        if drawn(view, &later, width).is_some() {
            first = Some(index + 1);
            break;
        }
    }
    let step = subject.moment.step;
    Err(match first {
        Some(first) => ViewError::Step { view, step, first },
        None => ViewError::Never { view },
    })
}

fn drawn<const D: usize>(view: FigureView, subject: &Subject<D>, width: f64) -> Option<Figure> {
    match view {
        FigureView::Automaton => Some(automaton::view(subject, width)),
        FigureView::TRail => t_rail::view(subject, width),
        FigureView::Codes => Some(codes::view(subject, width)),
        FigureView::Region => region::view(subject, width),
        FigureView::Neighbour => neighbour::view(subject, width),
        FigureView::Listing => Some(listing::view(subject, width)),
        FigureView::Table => Some(steps::view(subject, width)),
        FigureView::Chart => Some(chart::view(subject, width)),
        FigureView::Formula => Some(formula::view(subject, width)),
        FigureView::Space | FigureView::Tree | FigureView::Storyboard | FigureView::Worksheet => {
            None
        }
    }
}

/// Level and codes of a node in words.
pub fn node_note<const D: usize>(subject: &Subject<D>, node: NodeId) -> String {
    place_note(subject.texts, (subject.tree.level(node), subject.tree.code(node)))
}

/// Level and codes in words.
pub fn place_note<const D: usize>(texts: &Texts, (level, code): (u8, Code<D>)) -> String {
    let codes = code.map(|c| c.to_string()).join(", ");
    texts.format("node-note", &[("level", level.into()), ("codes", codes.into())])
}
