//! What is asked for by what is chosen.

use crate::document::{AnyDocument, Document};
use crate::export::{ExerciseChoice, Request};
use crate::eye::Eye;
use crate::figures::Moments;
use crate::view::View;
use crate::with_document;
use octoscope_core::explain::Notation;
use octoscope_figure::views::{Fields, FigureView};
use octoscope_figure::{Page, Show};

/// What is asked for of `document` as `view` shows it, by what is chosen there.
pub fn request(document: &AnyDocument, view: &View) -> Request {
    let choice = &view.export;
    let order = choice.order();
    let shown = choice.view_of(document);
    let in_space = shown.shows_space();
    let is_sheet = shown == FigureView::Worksheet;
    let is_numbered = is_sheet && choice.exercise == ExerciseChoice::Numbered;
    let fields = if is_sheet && choice.solution { Fields::Solved } else { Fields::Empty };
    // What a view does not tell is as at first, so that the command is short.
    Request {
        view: shown,
        order,
        steps: choice.steps(shown, view.playback.step, document.n_events()),
        moments: if shown == FigureView::Storyboard {
            choice.moments(document.n_events())
        } else {
            Moments::default()
        },
        exercise: (is_numbered.then_some(choice.seed), fields),
        eye: with_document!(document, d => eye(d, view, order.page())).filter(|_| in_space),
        show: with_document!(document, d => shown_of(d, view)).filter(|_| in_space),
        language: view.language,
        notation: if shown == FigureView::Formula { view.notation } else { Notation::default() },
    }
}

fn eye<const D: usize>(document: &Document<D>, view: &View, page: Page) -> Option<Eye> {
    view.camera::<D>().map(|camera| Eye::of(&camera, document, page))
}

/// What is shown of trees of the dimension of a document's, unless that is usual.
fn shown_of<const D: usize>(_: &Document<D>, view: &View) -> Option<Show> {
    Some(*view.show::<D>()).filter(|show| *show != Show::at_first::<D>())
}
