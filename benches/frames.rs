//! What a frame of the window costs, drawn off-screen by the renderer that the window
//! has: our own work on the CPU (marks, panels, layers), the bytes that are sent to the
//! graphics adapter, and how many frames a second come out, reading them back
//! included. Medians; run it with `cargo bench --bench frames`. The adapter is named:
//! one of the kind `Cpu` paints with the same processor, and much of its time is for
//! panels and letters.

use eframe::egui::{Event, pos2};
use egui_kittest::Harness;
use octoscope::app::App;
use octoscope::document::AnyDocument;
use octoscope::open::open_scenario;
use octoscope::render;
use octoscope_core::progress::Progress;
use octoscope_core::scenario::AnyScenario;
use octoscope_figure::{Camera, Slice};
use std::cell::RefCell;
use std::path::Path;
use std::rc::Rc;
use std::time::Instant;

const N_FRAMES: u32 = 30;
const SIZE: [f32; 2] = [1280.0, 800.0];

/// What happens to the window before the frame of this number. But for nothing, the
/// pointer moves as well, as it does while something is dragged.
type Change = fn(&mut App, u32);

/// What happens between two frames.
const CHANGES: [(&str, Change); 6] = [
    ("nothing", |_, _| ()),
    ("step", step),
    ("scrub", scrub),
    ("turn", turn),
    ("drag", drag),
    ("slice", slice),
];

fn main() {
    println!(
        "{:<22} {:>9} {:<8} {:>10} {:>14} {:>10} {:>9}",
        "scene, 1280 × 800", "leaves", "change", "own ms", "bytes sent", "frame ms", "a second"
    );
    for (name, json) in SCENES.into_iter() {
        measure(name, json);
    }
}

const SCENES: [(&str, &str); 7] = [
    (
        "4000 points, plane",
        r#"{"octoscope":1,"dimension":2,"scene":{"built-in":"quadtree-82","parameters":{"n":4000}},"build":{"depth":12,"capacity":1}}"#,
    ),
    (
        "40000 points, plane",
        r#"{"octoscope":1,"dimension":2,"scene":{"built-in":"quadtree-82","parameters":{"n":40000}},"build":{"depth":14,"capacity":1}}"#,
    ),
    (
        "400000 points, plane",
        r#"{"octoscope":1,"dimension":2,"scene":{"built-in":"quadtree-82","parameters":{"n":400000}},"build":{"depth":16,"capacity":1}}"#,
    ),
    (
        "512 spheres, depth 5",
        r#"{"octoscope":1,"dimension":3,"scene":{"built-in":"sphere-grid","parameters":{"n":3}},"build":{"depth":5}}"#,
    ),
    (
        "512 spheres, depth 6",
        r#"{"octoscope":1,"dimension":3,"scene":{"built-in":"sphere-grid","parameters":{"n":3}},"build":{"depth":6}}"#,
    ),
    (
        "32768 spheres, depth 7",
        r#"{"octoscope":1,"dimension":3,"scene":{"built-in":"sphere-grid","parameters":{"n":5}},"build":{"depth":7}}"#,
    ),
    (
        "the same, all leaves",
        r#"{"octoscope":1,"dimension":3,"scene":{"built-in":"sphere-grid","parameters":{"n":5}},"build":{"depth":7},"query":"ray","algorithm":"exhaustive"}"#,
    ),
];

fn measure(name: &str, json: &str) {
    let scenario = AnyScenario::parse(json).expect("the scenario is sound");
    let document = open_scenario(scenario, Path::new("."), &Progress::default())
        .expect("the scene is built in");
    let n_leaves = match &document {
        AnyDocument::Plane(document) => document.tree.n_leaves(),
        AnyDocument::Space(document) => document.tree.n_leaves(),
    };
    let adapter = Rc::new(RefCell::new(None));
    let seen = Rc::clone(&adapter);
    let builder = Harness::builder().with_size(SIZE).wgpu();
    let mut harness = builder.build_eframe(move |creation| {
        *seen.borrow_mut() = creation.wgpu_render_state.clone();
        App::on(creation, document)
    });
    let adapter = adapter.borrow().clone().expect("the harness has a renderer");
    let sent = || render::stats(&adapter).map_or(0, |stats| stats.uploaded_bytes);
    let n_events = harness.state().document().n_events();
    harness.state_mut().view.playback.go_to(n_events / 2, n_events);
    let start = Instant::now();
    harness.step();
    let own = millis(start);
    harness.render().expect("the frame is drawn");
    let info = adapter.adapter.get_info();
    println!("{name:<22} {n_leaves:>9} {:<8} {own:>10.2} {:>14}", "first", sent());
    println!("{:<22} {n_events:>9} events", "");
    let is_plane = matches!(harness.state().document(), AnyDocument::Plane(_));
    for (change, make) in CHANGES {
        if is_plane && change == "slice" {
            continue;
        }
        let (mut owns, mut frames) = (Vec::new(), Vec::new());
        // The first frames after another change still settle.
        for n in 0..3 {
            make(harness.state_mut(), n);
            harness.step();
            harness.render().expect("the frame is drawn");
        }
        let before = sent();
        for n in 0..N_FRAMES {
            make(harness.state_mut(), n + 3);
            if change != "nothing" {
                harness.event(Event::PointerMoved(pos2(2.0 + n as f32 % 2.0, 400.0)));
            }
            let start = Instant::now();
            harness.step();
            owns.push(millis(start));
            harness.render().expect("the frame is drawn");
            frames.push(millis(start));
        }
        let bytes = (sent() - before) / u64::from(N_FRAMES);
        let [own, frame] = [owns, frames].map(median);
        let rate = 1000.0 / frame;
        println!(
            "{:<22} {:>9} {change:<8} {own:>10.2} {bytes:>14} {frame:>10.1} {rate:>9.1}",
            "", ""
        );
    }
    println!("{:<22} {:>9} drawn by {} ({:?})", "", "", info.name, info.device_type);
}

/// One step forwards, from the middle of the trace.
fn step(app: &mut App, frame: u32) {
    let n_events = app.document().n_events();
    app.view.playback.go_to(n_events / 2 + frame as usize, n_events);
}

/// To anywhere in the trace, far from where the playhead was.
fn scrub(app: &mut App, frame: u32) {
    let n_events = app.document().n_events();
    let share = (f64::from(frame) * 0.618_034).fract();
    app.view.playback.go_to((n_events as f64 * share) as usize, n_events);
}

/// The camera a little further round; in the plane, moved.
fn turn(app: &mut App, frame: u32) {
    let share = f64::from(frame) / f64::from(N_FRAMES);
    match app.document() {
        AnyDocument::Plane(document) => {
            let page = octoscope_figure::Page { width: 560.0, height: 640.0 };
            let mut camera = Camera::framing(&document.tree.domain().root_box(), page);
            camera.pan(page, 100.0 * share, 50.0 * share);
            app.view.set_camera(camera);
        }
        AnyDocument::Space(document) => {
            let page = octoscope_figure::Page { width: 560.0, height: 640.0 };
            let mut camera = Camera::framing(&document.tree.domain().root_box(), page);
            camera.orbit(page, 200.0 * share, 0.0);
            app.view.set_camera(camera);
        }
    }
}

/// The ray's tip a little further up.
fn drag(app: &mut App, frame: u32) {
    fn moved<const D: usize>(ray: &mut octoscope_core::geometry::Ray<D>, frame: u32) {
        let mut direction = ray.direction();
        direction[D - 1] += 1e-3 * f64::from(1 + frame % 3);
        *ray = octoscope_core::geometry::Ray::new(ray.origin(), direction).expect("finite");
    }
    match app.document_mut() {
        AnyDocument::Plane(document) => moved(&mut document.scenario.ray, frame),
        AnyDocument::Space(document) => moved(&mut document.scenario.ray, frame),
    }
}

/// The slice of an octree a little further.
fn slice(app: &mut App, frame: u32) {
    let at = 0.3 + 0.4 * f64::from(frame) / f64::from(N_FRAMES);
    app.view.space_show.slice = Some(Slice { axis: 1, at });
}

fn millis(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
