//! Views of built-in scenes: their text, and that nothing covers anything.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod expected;
mod room;
mod scene;
mod worksheets;

use expected::{check_text, check_texts};
use octoscope_core::explain::sentence;
use octoscope_core::query::Query;
use octoscope_core::scenario::{AnyScenario, BUILT_IN, BuiltIn, Scenario, built_in};
use octoscope_core::text::Language;
use octoscope_core::trace::Moment;
use octoscope_core::traverse::Method;
use octoscope_figure::Figure;
use octoscope_figure::views::{FigureView, Layout, Panel, figure, storyboard};
use room::check_room;
use scene::{Scene, picture, queries, texts};

/// The views of a single moment.
const VIEWS: [FigureView; 9] = [
    FigureView::TRail,
    FigureView::Automaton,
    FigureView::Codes,
    FigureView::Region,
    FigureView::Neighbour,
    FigureView::Listing,
    FigureView::Table,
    FigureView::Chart,
    FigureView::Formula,
];

fn check_scene<const D: usize>(scenario: Scenario<D>, id: &str) -> usize {
    let scene = Scene::new(scenario);
    let mut n_figures = 0;
    for (number, query) in queries(&scene).into_iter().enumerate() {
        let trace = scene.trace(&query);
        let n_steps = trace.events.len();
        // The first algorithm step by step, the others here and there.
        let mut steps: Vec<usize> =
            if number == 0 { (1..=12.min(n_steps)).collect() } else { vec![2] };
        steps.extend([0, n_steps / 3, 2 * n_steps / 3, n_steps]);
        let language = Language::ALL[number % 2];
        let texts = texts(language);
        for &step in &steps {
            let moment = Moment::after(&scene.tree, &trace, step);
            let subject = scene.subject(&trace, &moment, &texts);
            for view in VIEWS.into_iter().filter(|view| view.fits(&query).is_ok()) {
                // Panels are as narrow as 268, pages as wide as the view wants.
                let widths = match view {
                    FigureView::Table if step == n_steps => vec![view.width::<D>()],
                    FigureView::Table => vec![],
                    _ => vec![268.0, view.width::<D>()],
                };
                for width in widths {
                    if let Ok(figure) = figure(view, &subject, width) {
                        let what = format!("{id} {view} {query:?} step {step} {language:?}");
                        check_room(&figure.cropped(6.0), &what);
                        n_figures += 1;
                    }
                }
            }
        }
    }
    n_figures
}

const LARGE: [&str; 7] =
    ["cloud", "rings", "cylinders", "objects", "spheres-512", "spheres-4096", "spheres-32768"];

#[test]
fn no_text_covers_another_or_leaves_the_page() {
    // What is said of a ray through a large tree is no longer.
    let is_small = |scene: &&BuiltIn| !LARGE.contains(&scene.id);
    for scene in BUILT_IN.iter().filter(is_small) {
        let n_figures = match built_in(scene.id).unwrap() {
            AnyScenario::Quadtree(scenario) => check_scene(scenario, scene.id),
            AnyScenario::Octree(scenario) => check_scene(scenario, scene.id),
        };
        assert!(n_figures > 300, "{n_figures} of {}", scene.id);
    }
}

fn check_views<const D: usize>(id: &str, scenario: Scenario<D>, cases: &[(FigureView, usize)]) {
    let scene = Scene::new(scenario);
    let all = queries(&scene);
    for &(view, step) in cases {
        let mut fitting = all.iter().filter(|query| view.fits(query).is_ok());
        let is_of_neighbours = view == FigureView::Neighbour;
        let query = if is_of_neighbours { fitting.next_back() } else { fitting.next() }.unwrap();
        // Of a view that is not about one kind of query, the traversal is shown.
        let query =
            if view.fits(&scene.scenario.query).is_ok() { &scene.scenario.query } else { query };
        let trace = scene.trace(query);
        let moment = Moment::after(&scene.tree, &trace, step);
        let language = if D == 2 { Language::English } else { Language::German };
        let texts = texts(language);
        let subject = scene.subject(&trace, &moment, &texts);
        let figure = figure(view, &subject, view.width::<D>()).unwrap();
        check_text(&format!("{id}-{view}"), figure);
    }
}

#[test]
fn views_of_a_quadtree_are_written_as_expected() {
    let Some(AnyScenario::Quadtree(scenario)) = built_in("figure-1") else { panic!() };
    let cases = [
        (FigureView::TRail, 6),
        (FigureView::Automaton, 8),
        (FigureView::Codes, 6),
        (FigureView::Region, 9),
        (FigureView::Neighbour, 9),
        (FigureView::Listing, 6),
        (FigureView::Table, 8),
        (FigureView::Chart, 20),
    ];
    check_views("figure-1", scenario, &cases);
}

#[test]
fn views_of_an_octree_are_written_as_expected() {
    let Some(AnyScenario::Octree(scenario)) = built_in("figure-7") else { panic!() };
    let cases = [
        (FigureView::TRail, 7),
        (FigureView::Automaton, 7),
        (FigureView::Codes, 6),
        (FigureView::Region, 9),
        (FigureView::Table, 9),
    ];
    check_views("figure-7", scenario, &cases);
}

/// A view of the traversal of a scene by an algorithm after `step` events.
fn view_of<const D: usize>(scene: &Scene<D>, view: FigureView, id: &str, step: usize) -> Figure {
    let method: Method = id.parse().unwrap();
    let query = scene.scenario.query.along_the_ray_by(method);
    let trace = scene.trace(&query);
    let moment = Moment::after(&scene.tree, &trace, step);
    let english = texts(Language::English);
    figure(view, &scene.subject(&trace, &moment, &english), view.width::<D>()).unwrap()
}

#[test]
fn the_neighbour_the_listing_and_the_costs_of_figure_7_are_written_as_expected() {
    let Some(AnyScenario::Octree(scenario)) = built_in("figure-7") else { panic!() };
    let scene = Scene::new(scenario);
    let of = |view, id, step| view_of(&scene, view, id, step);
    check_texts("figure-7-neighbour", of(FigureView::Neighbour, "codes", 8));
    check_texts("figure-7-listing", of(FigureView::Listing, "parametric", 6));
    check_texts("figure-7-chart", of(FigureView::Chart, "parametric", 9));
}

#[test]
fn a_storyboard_is_written_as_expected() {
    let Some(AnyScenario::Quadtree(mut scenario)) = built_in("figure-1") else { panic!() };
    scenario.query = scenario.query.along_the_ray_by("parametric".parse().unwrap());
    let scene = Scene::new(scenario);
    let trace = scene.trace(&scene.scenario.query);
    let width = FigureView::Storyboard.width::<2>();
    let layout = Layout::of(2, width);
    let panel = |step| Panel {
        step,
        picture: picture(&scene, step, layout.column),
        caption: sentence(&scene.tree, &scene.scenario.ray, &trace, step, Language::English),
    };
    let panels = vec![panel(4), panel(trace.events.len())];
    let english = texts(Language::English);
    check_texts("figure-1-storyboard", storyboard(panels, layout, &english, width));
}

#[test]
fn a_view_that_does_not_fit_says_what_would_be_right() {
    let Some(AnyScenario::Quadtree(scenario)) = built_in("figure-1") else { panic!() };
    let scene = Scene::new(scenario);
    let english = texts(Language::English);
    let message = |view, query: &Query<2>, step| {
        let trace = scene.trace(query);
        let moment = Moment::after(&scene.tree, &trace, step);
        let subject = scene.subject(&trace, &moment, &english);
        figure(view, &subject, 300.0).unwrap_err().to_string()
    };
    let ray = Query::default();
    let region =
        queries(&scene).into_iter().find(|query| matches!(query, Query::Region { .. })).unwrap();
    for (view, query, step, wanted) in [
        (FigureView::Neighbour, &ray, 9, "give --algorithm codes"),
        (FigureView::Region, &ray, 9, "query is ‘region’"),
        (FigureView::Automaton, &region, 2, "--algorithm parametric"),
        (FigureView::TRail, &region, 2, "query is ‘ray’"),
        (FigureView::TRail, &ray, 0, "nothing to show after step 0; it has after step 1"),
        (FigureView::Region, &region, 0, "it has after step 1"),
    ] {
        let said = message(view, query, step);
        assert!(said.contains(wanted), "{view}: {said}");
    }
}
