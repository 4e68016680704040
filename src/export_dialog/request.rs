//! What is asked for by what is chosen.

use crate::document::{AnyDocument, Document};
use crate::export::{ExerciseChoice, Eye, Format, Order, Request, StepChoice, Steps};
use crate::figures::Moments;
use crate::view::View;
use crate::with_document;
use octoscope_core::explain::Notation;
use octoscope_core::scenario::StepAt;
use octoscope_figure::views::{Fields, FigureView};
use octoscope_figure::{Show, TikzForm};

/// What is asked for of `document` as `view` shows it, by what is chosen there.
pub fn request(document: &AnyDocument, view: &View) -> Request {
    let choice = &view.export;
    let short = |x: f64, [least, most]: [f64; 2]| ((x * 100.0).round() / 100.0).clamp(least, most);
    let enlarged = short(choice.enlarged, [0.01, 100.0]);
    let is_tikz = choice.format == Format::Tikz;
    let figure = Order {
        format: choice.format,
        theme: choice.theme,
        background: choice.background,
        size: choice.size(),
        enlarged: Some(enlarged).filter(|x| choice.can_be_enlarged() && *x != 1.0),
        type_scale: short(choice.type_scale, [0.25, 8.0]),
        line_scale: short(choice.line_scale, [0.25, 8.0]),
        tikz: if is_tikz { choice.tikz } else { TikzForm::default() },
        pause_secs: match choice.format.moves() {
            true => short(choice.pause_secs, [0.02, 60.0]),
            false => Order::default().pause_secs,
        },
    };
    // Text has no looks.
    let order = match choice.format.is_of_text() {
        true => Order { format: choice.format, ..Order::default() },
        false => figure,
    };
    let shown = choice.view_of(document);
    let chosen = match shown.is_of_a_step() {
        true if choice.format.is_of_text() => StepChoice::All,
        true => choice.steps,
        false => StepChoice::Here,
    };
    let steps = match chosen {
        StepChoice::Here => Steps::One(StepAt::At(view.playback.step)),
        StepChoice::All => Steps::All,
        StepChoice::Range => {
            let [first, last] = choice.range.map(|step| step.min(document.n_events()));
            Steps::Range(StepAt::At(first.min(last)), StepAt::At(first.max(last)))
        }
    };
    let in_space = shown.shows_space();
    let eye = with_document!(document, d => eye(d, view, &order)).filter(|_| in_space);
    let show = with_document!(document, d => shown_of(d, view)).filter(|_| in_space);
    let (is_story, is_sheet) = (shown == FigureView::Storyboard, shown == FigureView::Worksheet);
    let moments = if is_story { choice.moments(document.n_events()) } else { Moments::default() };
    let is_numbered = is_sheet && choice.exercise == ExerciseChoice::Numbered;
    let fields = if is_sheet && choice.solution { Fields::Solved } else { Fields::Empty };
    Request {
        view: shown,
        order,
        steps,
        moments,
        exercise: (is_numbered.then_some(choice.seed), fields),
        eye,
        show,
        language: view.language,
        notation: match shown {
            FigureView::Formula => view.notation,
            FigureView::Space
            | FigureView::Tree
            | FigureView::Automaton
            | FigureView::TRail
            | FigureView::Codes
            | FigureView::Region
            | FigureView::Neighbour
            | FigureView::Listing
            | FigureView::Table
            | FigureView::Chart
            | FigureView::Storyboard
            | FigureView::Worksheet => Notation::default(),
        },
    }
}

fn eye<const D: usize>(document: &Document<D>, view: &View, order: &Order) -> Option<Eye> {
    view.camera::<D>().map(|camera| Eye::of(&camera, document, order.page()))
}

fn shown_of<const D: usize>(_: &Document<D>, view: &View) -> Option<Show> {
    Some(*view.show::<D>()).filter(|show| *show != Show::at_first::<D>())
}
