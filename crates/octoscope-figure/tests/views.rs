//! Views of built-in scenes: their text, and that nothing covers anything.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use octoscope_core::explain::{Notation, sentence};
use octoscope_core::progress::Progress;
use octoscope_core::query::Query;
use octoscope_core::scenario::{AnyScenario, BUILT_IN, BuiltIn, Scenario, built_in};
use octoscope_core::text::{Language, Texts};
use octoscope_core::trace::{Moment, Trace, record};
use octoscope_core::traverse::{Algorithm, Method, Variant, Variants};
use octoscope_core::tree::{Tree, build};
use octoscope_figure::views::{
    Exercise, Fields, FigureView, Layout, Panel, Subject, figure, figure_texts, storyboard,
    worksheet,
};
use octoscope_figure::{
    Camera, Figure, FileOptions, Form, Page, Role, Scale, Show, Theme, TikzForm, Unit, axes, cells,
    marks, metrics, space_figure, svg, tikz,
};

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

fn texts(language: Language) -> Texts {
    Texts::new(language, &[figure_texts(language)])
}

/// A text with its left, top, right and bottom.
type Written = (String, [f64; 4]);

fn written(figure: &Figure) -> Vec<Written> {
    let figure = figure.spelled_out();
    let texts = figure.drawn.iter().filter_map(|drawn| match &drawn.form {
        Form::Text { at: [x, y], anchor, text } => {
            let width = metrics::width(drawn.role, text);
            let left = x - anchor.share() * width;
            // Capitals and what hangs below the line.
            let size = metrics::size(drawn.role);
            Some((text.plain(), [left, y - 0.4 * size, left + width, y + 0.5 * size]))
        }
        Form::Polygon(_) | Form::Polyline(_) | Form::Circle { .. } | Form::Formula { .. } => None,
    });
    texts.collect()
}

#[track_caller]
fn check_room(figure: &Figure, what: &str) {
    let texts = written(figure);
    for (index, (text, [left, top, right, bottom])) in texts.iter().enumerate() {
        let Page { width, height } = figure.page;
        let is_on = *left > -0.5 && *top > -1.0 && *right < width + 0.5 && *bottom < height + 1.0;
        assert!(is_on, "{what}: ‘{text}’ leaves the page of {width} × {height}");
        for (other, [l, t, r, b]) in &texts[..index] {
            let is_apart = right <= l || r <= left || bottom <= t || b <= top;
            assert!(is_apart, "{what}: ‘{text}’ covers ‘{other}’");
        }
    }
}

struct Scene<const D: usize> {
    scenario: Scenario<D>,
    tree: Tree<D>,
}

impl<const D: usize> Scene<D> {
    fn new(scenario: Scenario<D>) -> Self {
        let content = scenario.source.content().unwrap();
        let grid = scenario.grid().unwrap();
        let tree = build(&content, grid, &scenario.recipe, &Progress::default()).unwrap();
        Self { scenario, tree }
    }

    fn trace(&self, query: &Query<D>) -> Trace<D> {
        record(&self.tree, &self.scenario.ray, query)
    }

    fn subject<'a>(
        &'a self,
        trace: &'a Trace<D>,
        moment: &'a Moment<D>,
        texts: &'a Texts,
    ) -> Subject<'a, D> {
        Subject {
            tree: &self.tree,
            ray: &self.scenario.ray,
            trace,
            moment,
            texts,
            notation: Notation::default(),
        }
    }
}

/// A traversal by every algorithm, and a point, a region and neighbours.
fn queries<const D: usize>(scene: &Scene<D>) -> Vec<Query<D>> {
    let by = |algorithm| {
        scene.scenario.query.along_the_ray_by(Method { algorithm, variants: Variants::NONE })
    };
    let domain = scene.tree.domain();
    let place = |share: f64| std::array::from_fn(|e| domain.min()[e] + share * domain.side());
    let mut queries: Vec<Query<D>> = Algorithm::ALL.into_iter().map(by).collect();
    queries.push(Query::Point {
        at: place(0.3),
        method: Default::default(),
        variants: Variants::NONE,
    });
    for [from, to] in [[0.3, 0.4], [0.1, 0.6]] {
        let [min, max] = [from, to].map(place);
        queries.push(Query::Region { min, max, variants: Variants::NONE });
    }
    // Corners that differ along x alone.
    for variant in [Variant::B24a, Variant::B24b, Variant::B24c] {
        let [min, max] = [5.0, 6.0].map(|x| {
            let sixteenths = |e: usize| if e == 0 { x } else { 9.0 };
            std::array::from_fn(|e| domain.min()[e] + domain.side() * sixteenths(e) / 16.0)
        });
        queries.push(Query::Region { min, max, variants: Variants::NONE.with(variant) });
    }
    for sign in [1, -1] {
        queries.push(Query::Neighbour {
            level: 1,
            code: [domain.grid_size() / 2; D],
            direction: octoscope_core::locate::Direction::new([sign; D]).unwrap(),
            reach: Default::default(),
            method: Default::default(),
            variants: Variants::NONE,
        });
    }
    queries
}

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

fn check_worksheets<const D: usize>(scenario: Scenario<D>) {
    let scene = Scene::new(scenario);
    for number in 0..20 {
        let ray = Exercise::ray_of(&scene.tree, number).unwrap();
        let exercise = Exercise::of(&scene.tree, &ray, Some(number)).unwrap();
        for (language, fields, width) in [
            (Language::English, Fields::Solved, 500.0),
            (Language::German, Fields::Empty, 500.0),
            (Language::English, Fields::Empty, 309.0),
            (Language::German, Fields::Solved, 309.0),
            (Language::German, Fields::Solved, 280.0),
            (Language::English, Fields::Solved, 420.0),
        ] {
            let picture = Figure { page: Page { width: 220.0, height: 220.0 }, drawn: Vec::new() };
            let layout = (fields, width);
            let sheet = worksheet(&scene.tree, &exercise, picture, &texts(language), layout);
            let wide = sheet.extent().expect("something is drawn");
            assert!(wide.min[0] > -1.0 && wide.max[0] < width + 1.0, "{number}: {wide:?}");
            check_room(&sheet.cropped(6.0), &format!("worksheet {number}, {width} wide"));
        }
    }
}

#[test]
fn worksheets_have_room_for_every_solution() {
    for id in ["figure-1", "figure-7", "quadtree-82"] {
        match built_in(id).unwrap() {
            AnyScenario::Quadtree(scenario) => check_worksheets(scenario),
            AnyScenario::Octree(scenario) => check_worksheets(scenario),
        }
    }
}

#[test]
fn an_empty_worksheet_tells_nothing_of_the_solution() {
    let Some(AnyScenario::Quadtree(scenario)) = built_in("figure-1") else { panic!() };
    let scene = Scene::new(scenario);
    let ray = Exercise::ray_of(&scene.tree, 7).unwrap();
    let exercise = Exercise::of(&scene.tree, &ray, Some(7)).unwrap();
    let sheet = |fields| {
        let picture = Figure { page: Page { width: 220.0, height: 220.0 }, drawn: Vec::new() };
        let english = texts(Language::English);
        worksheet(&scene.tree, &exercise, picture, &english, (fields, 500.0))
    };
    let boxes = |figure: &Figure| figure.drawn.iter().filter(|d| d.role == Role::Blank).count();
    let [empty, solved] = [Fields::Empty, Fields::Solved].map(sheet);
    let texts_of = |figure: &Figure| -> Vec<String> {
        written(figure).into_iter().map(|(text, _)| text).collect()
    };
    let n_filled = texts_of(&solved).len() - texts_of(&empty).len();
    assert!(n_filled > 30, "{n_filled}");
    // The lines for a name and for the places of nodes are on the empty one only.
    assert!(boxes(&empty) > boxes(&solved));
    assert!(texts_of(&empty).iter().all(|text| !text.contains("level")));
}

/// Compares a figure with its text; UPDATE_EXPECT=1 writes it anew.
fn check_text(name: &str, figure: Figure) {
    let text = svg(&figure.cropped(6.0), &FileOptions::default());
    check_file(&format!("{name}.svg"), &text);
}

/// The same, as SVG and as TikZ.
fn check_texts(name: &str, figure: Figure) {
    let scale = Scale { factor: 1.0, unit: Unit::Point };
    let options = FileOptions { theme: Theme::Print, scale, ..FileOptions::default() };
    let text = tikz(&figure.clone().cropped(6.0), TikzForm::Snippet, &options);
    check_file(&format!("{name}.tex"), &text);
    check_text(name, figure);
}

fn check_file(name: &str, text: &str) {
    let path = format!("{}/tests/views/{name}", env!("CARGO_MANIFEST_DIR"));
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        std::fs::create_dir_all(std::path::Path::new(&path).parent().unwrap()).unwrap();
        std::fs::write(&path, text).unwrap();
    }
    let expected = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(text == expected, "{name}: UPDATE_EXPECT=1 writes it anew");
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

/// The picture of a scene after `step` events of its query.
fn picture(scene: &Scene<2>, step: usize, side: f64) -> Figure {
    let trace = scene.trace(&scene.scenario.query);
    let moment = Moment::after(&scene.tree, &trace, step);
    let event = step.checked_sub(1).map(|last| &trace.events[last]);
    let show = Show::at_first::<2>();
    let Scenario { ray, query, .. } = &scene.scenario;
    let mut all: Vec<_> = cells(&scene.tree, &show, None).into_iter().collect();
    let page = Page { width: side, height: side };
    let camera = Camera::framing(&scene.tree.domain().root_box(), page);
    all.extend(axes(scene.tree.domain(), &show, &camera));
    all.extend(marks(&scene.tree, ray, query, &moment, event, &show));
    space_figure(&all, &camera, page)
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
fn worksheets_are_written_as_expected() {
    let Some(AnyScenario::Quadtree(mut scenario)) = built_in("figure-1") else { panic!() };
    let tree = Scene::new(scenario.clone()).tree;
    scenario.ray = Exercise::ray_of(&tree, 7).unwrap();
    scenario.query = Query::default();
    let scene = Scene::new(scenario);
    let exercise = Exercise::of(&scene.tree, &scene.scenario.ray, Some(7)).unwrap();
    for (name, fields, language) in [
        ("figure-1-worksheet", Fields::Empty, Language::German),
        ("figure-1-solution", Fields::Solved, Language::English),
    ] {
        let (layout, texts) = ((fields, FigureView::Worksheet.width::<2>()), texts(language));
        let picture = picture(&scene, 0, 230.0).cropped(0.0);
        check_texts(name, worksheet(&scene.tree, &exercise, picture, &texts, layout));
    }
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
