//! What a movement of the ray costs: the trace, the state at its end, the marks,
//! the figure, and the whole frame of the window without the graphics adapter.
//! Median over many rays; run it with `cargo bench --bench drag`.

use egui_kittest::Harness;
use octoscope::app::App;
use octoscope::document::{AnyDocument, Document};
use octoscope::open::open_scenario;
use octoscope_core::geometry::Ray;
use octoscope_core::progress::Progress;
use octoscope_core::random::Random;
use octoscope_core::scenario::AnyScenario;
use octoscope_core::trace::record;
use octoscope_figure::{Camera, Page, Show, marks, space_figure};
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

const N_RAYS: usize = 200;
const PAGE: Page = Page { width: 640.0, height: 640.0 };

fn main() {
    println!(
        "{:<34} {:>9} {:>8} {:>9} {:>9} {:>9} {:>9} {:>9}",
        "scene, depth 8, medians in µs",
        "leaves",
        "events",
        "trace",
        "moment",
        "marks",
        "figure",
        "frame"
    );
    for (name, json) in [
        (
            "quadtree of 100000 points",
            r#"{"octoscope":1,"dimension":2,"scene":{"built-in":"quadtree-82","parameters":{"n":100000}},"build":{"depth":8,"capacity":4}}"#,
        ),
        (
            "octree of 32768 spheres",
            r#"{"octoscope":1,"dimension":3,"scene":{"built-in":"sphere-grid","parameters":{"n":5}},"build":{"depth":8}}"#,
        ),
    ] {
        let scenario = AnyScenario::parse(json).expect("the scenario is sound");
        let document = open_scenario(scenario, Path::new("."), &Progress::default())
            .expect("the scene is built in");
        let figures = match &document {
            AnyDocument::Plane(document) => measure(document),
            AnyDocument::Space(document) => measure(document),
        };
        let frame = measure_frames(document);
        let [leaves, events, trace, moment, marks, figure] = figures;
        println!(
            "{name:<34} {leaves:>9} {events:>8} {trace:>9.1} {moment:>9.1} {marks:>9.1} {figure:>9.1} {frame:>9.1}"
        );
    }
}

/// Leaves of the tree, median events of a trace, and the medians of the parts.
fn measure<const D: usize>(document: &Document<D>) -> [f64; 6] {
    let query = document.scenario.query;
    let show = Show::at_first::<D>();
    let camera = Camera::framing(&document.tree.domain().root_box(), PAGE);
    let mut times: [Vec<f64>; 5] = Default::default();
    let mut random = Random::new(8);
    for _ in 0..N_RAYS {
        let ray = random_ray(document, &mut random);
        let start = Instant::now();
        let trace = black_box(record(&document.tree, &ray, &query));
        times[1].push(micros(start));
        times[0].push(trace.events.len() as f64);

        let n_events = trace.events.len();
        let start = Instant::now();
        let moment =
            black_box(octoscope_core::trace::Moment::after(&document.tree, &trace, n_events));
        times[2].push(micros(start));

        let start = Instant::now();
        let event = trace.events.last();
        let marks = black_box(marks(&document.tree, &ray, &query, &moment, event, &show));
        times[3].push(micros(start));

        let start = Instant::now();
        black_box(space_figure(&marks, &camera, PAGE));
        times[4].push(micros(start));
    }
    let [events, trace, moment, marks, figure] = times.map(median);
    [document.tree.n_leaves() as f64, events, trace, moment, marks, figure]
}

/// Median time of a frame of the window in which the ray has moved.
fn measure_frames(document: AnyDocument) -> f64 {
    let mut random = Random::new(9);
    let mut harness = Harness::builder()
        .with_size([1280.0, 800.0])
        .build_eframe(|creation| App::on(creation, document));
    harness.step();
    let n_events = harness.state().document().n_events();
    harness.state_mut().view.playback.go_to(n_events, n_events);
    let mut times = Vec::new();
    for _ in 0..N_RAYS {
        match harness.state_mut().document_mut() {
            AnyDocument::Plane(document) => {
                document.scenario.ray = random_ray(document, &mut random)
            }
            AnyDocument::Space(document) => {
                document.scenario.ray = random_ray(document, &mut random)
            }
        }
        let start = Instant::now();
        harness.step();
        times.push(micros(start));
    }
    median(times)
}

fn random_ray<const D: usize>(document: &Document<D>, random: &mut Random) -> Ray<D> {
    let domain = document.tree.domain();
    let mut inside = || std::array::from_fn(|e| domain.min()[e] + domain.side() * random.unit());
    let [through, towards]: [[f64; D]; 2] = [inside(), inside()];
    let direction: [f64; D] = std::array::from_fn(|e| towards[e] - through[e] + 1e-9);
    let origin = std::array::from_fn(|e| through[e] - 4.0 * direction[e]);
    Ray::new(origin, direction).expect("finite and not zero")
}

fn micros(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e6
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
