//! What a request draws, and what it says it cannot.

use super::*;
use crate::export::Format;
use crate::open::{open_built_in, open_scenario};
use octoscope_core::event::End;
use octoscope_core::paper::counterexample;
use octoscope_core::query::Query;
use octoscope_core::scenario::StepAt;
use octoscope_core::traverse::{Method, Variant};
use std::path::Path;
use std::sync::Arc;

#[test]
fn a_figure_of_a_misprint_shows_what_would_be_right_where_a_frame_would_not_do() {
    let mut any = open_built_in("rings", &Progress::default()).unwrap();
    let AnyDocument::Plane(document) = &mut any else { panic!("not a quadtree") };
    assert!(document.tree.n_leaves() > 2000, "{}", document.tree.n_leaves());
    let method: Method = "parametric@B-1".parse().unwrap();
    document.scenario.query = Query::default().along_the_ray_by(method);
    document.trace_whole_within(&Progress::default()).unwrap();
    let last = document.trace.events.len();
    let svg = in_space(last).svg(&any, last, &Progress::default()).unwrap();
    assert!(svg.contains("expected"), "{}", svg.len());
    let cancelled = Progress::default();
    cancelled.cancel();
    assert!(in_space(last).svg(&any, last, &cancelled).is_err());
}

#[test]
fn a_worksheet_does_not_show_its_solution() {
    let any = open_scenario(counterexample(Variant::B2), Path::new(""), &Progress::default());
    let any = any.unwrap();
    let solved = in_space(0).svg(&any, 0, &Progress::default()).unwrap();
    assert!(solved.contains("expected"));
    for number in [None, Some(17)] {
        let exercise = (number, Fields::Empty);
        let request = Request { view: FigureView::Worksheet, exercise, ..in_space(0) };
        let svg = request.svg(&any, 0, &Progress::default()).unwrap();
        assert!(!svg.contains("expected"));
        let english = texts(Language::English);
        assert_eq!(with_document!(&any, d => request.left_out(&**d, &english)), None);
    }
}

fn in_space(step: usize) -> Request {
    Request {
        view: FigureView::Space,
        order: Order::default(),
        steps: Steps::One(StepAt::At(step)),
        moments: Moments::default(),
        exercise: (None, Fields::Empty),
        eye: None,
        show: None,
        language: Language::English,
        notation: Notation::default(),
    }
}

#[test]
fn a_figure_that_cannot_tell_what_is_right_says_so() {
    let any = open_built_in("quadtree-82", &Progress::default()).unwrap();
    let AnyDocument::Plane(mut document) = any else { panic!("not a quadtree") };
    let english = texts(Language::English);
    let mut left_out = |method: &str, is_cut: bool| {
        let query = Query::default().along_the_ray_by(method.parse().unwrap());
        document.scenario.query = query;
        document.trace_whole_within(&Progress::default()).unwrap();
        if is_cut {
            let mut trace = (*document.trace).clone();
            trace.outcome.end = End::Cut;
            document.trace = Arc::new(trace);
        }
        in_space(0).left_out(&document, &english)
    };
    assert_eq!(left_out("parametric@B-1", false), None);
    assert_eq!(left_out("parametric", true), None);
    let told = left_out("parametric@B-1", true).unwrap();
    assert!(told.contains("not marked"), "{told}");
}

#[test]
fn what_is_looked_at_and_copied_is_one_of_the_steps_that_are_asked_for() {
    let any = open_built_in("quadtree-82", &Progress::default()).unwrap();
    let last = any.n_events();
    let view = FigureView::TRail;
    let range = Steps::Range(StepAt::At(3), StepAt::At(5));
    for (steps, step, expected) in [
        (range, 80, 5),
        (range, 0, 3),
        (range, 4, 4),
        (Steps::One(StepAt::At(7)), 80, 7),
        (Steps::All, 80, 80),
        // Before the first event there is no rail.
        (Steps::All, 0, 1),
    ] {
        let request = Request { view, steps, ..in_space(0) };
        let preview = request.preview(&any, step, [200.0; 2], &Progress::default()).unwrap();
        assert_eq!(preview.of.step, expected, "{steps}");
        let one = Request { view, ..in_space(expected) };
        let [copied, alone] = [(&request, step), (&one, expected)]
            .map(|(request, at)| request.svg(&any, at, &Progress::default()).unwrap());
        assert!(copied == alone, "{steps}");
    }
    let order = Order { format: Format::Csv, ..Order::default() };
    let text = Request { view: FigureView::Table, order, steps: Steps::All, ..in_space(0) };
    let preview = text.preview(&any, 80, [200.0; 2], &Progress::default()).unwrap();
    assert_eq!(preview.of, crate::export::OneOf { step: 80, steps: 80..=80 });
    assert!(last > 80);
}

#[test]
fn a_table_says_which_steps_it_has_no_room_for() {
    let any = open_built_in("quadtree-82", &Progress::default()).unwrap();
    let english = texts(Language::English);
    let told = |step: usize, format: Format| {
        let order = Order { format, ..Order::default() };
        let request = Request { view: FigureView::Table, order, ..in_space(step) };
        with_document!(&any, d => request.left_out(&**d, &english))
    };
    assert_eq!(told(24, Format::Svg), None);
    assert_eq!(told(80, Format::Csv), None);
    let left_out = told(80, Format::Svg);
    assert_eq!(left_out.as_deref(), Some("the table shows the last 24 of 80 steps"));
}

#[test]
fn a_shell_reads_the_words_back() {
    let words = ["a", "b c", "it's", "", "ä.svg", "--ray=-0.1,2"].map(str::to_owned);
    assert_eq!(shell_line(&words), "a 'b c' 'it'\\''s' '' 'ä.svg' --ray=-0.1,2");
}
