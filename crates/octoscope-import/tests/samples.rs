//! The files in `assets/scenes` are what the generator makes, and they open.

#[path = "../examples/samples/mod.rs"]
mod samples;

use octoscope_core::event::Event;
use octoscope_core::progress::Progress;
use octoscope_core::scenario::{AnyScenario, Scenario};
use octoscope_core::scene::Content;
use octoscope_core::tree::build;
use octoscope_import::{Imported, cells, import, rays};
use std::path::Path;

fn committed(name: &str) -> Vec<u8> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes");
    std::fs::read(folder.join(name)).expect("the sample is there")
}

fn text(name: &str) -> String {
    String::from_utf8(committed(name)).expect("the sample is text")
}

fn open(name: &str) -> Imported {
    import(name, &committed(name), &Progress::default()).expect("the sample opens")
}

fn picture(name: &str) -> Content<2> {
    match open(name) {
        Imported::Plane { content, .. } => content,
        Imported::Space { .. } => panic!("{name} lies in space"),
    }
}

fn space(name: &str) -> Content<3> {
    match open(name) {
        Imported::Space { content, .. } => content,
        Imported::Plane { .. } => panic!("{name} lies in the plane"),
    }
}

#[test]
fn committed_files_are_what_the_generator_makes() {
    let mut total = 0;
    for (name, made) in samples::files() {
        let bytes = committed(name);
        total += bytes.len();
        // Pictures may be packed, and scenarios laid out, in another way.
        if name.ends_with(".png") || name.ends_with(".jpg") {
            let made = import(name, &made, &Progress::default()).expect("a picture");
            assert!(made == open(name), "{name}");
        } else if !name.ends_with(".octo") {
            assert!(bytes == made, "{name}");
        }
    }
    assert!(total < 1_500_000, "{total} bytes");
}

#[test]
fn pictures_have_their_sizes() {
    for (name, size) in [("landscape.png", [256, 256]), ("spheres.jpg", [320, 200])] {
        let Content::Image(image) = picture(name) else { panic!("{name} is a picture") };
        assert_eq!([image.width, image.height], size, "{name}");
    }
}

#[test]
fn the_knot_is_the_same_in_every_format() {
    let expected = Content::Triangles(samples::knot::knot().triangles());
    assert_eq!(expected.len(), 3072);
    for name in ["knot.obj", "knot.stl", "knot.ply"] {
        assert!(space(name) == expected, "{name}");
    }
}

#[test]
fn the_knot_is_closed_and_turned_outwards() {
    let mesh = samples::knot::knot();
    let mut edges: Vec<[usize; 2]> =
        mesh.faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    let mut turned: Vec<_> = edges.iter().map(|&[a, b]| [b, a]).collect();
    edges.sort_unstable();
    turned.sort_unstable();
    assert_eq!(edges, turned);
    edges.dedup();
    assert_eq!(edges.len(), 3 * mesh.faces.len());
    let volume = mesh.triangles().iter().fold(0.0, |sum, [a, b, c]| {
        let cross = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
        sum + a[0] * cross(1, 2) + a[1] * cross(2, 0) + a[2] * cross(0, 1)
    });
    assert!(volume > 0.0);
}

#[test]
fn the_galaxy_is_the_same_in_every_format() {
    let expected = Content::Points(samples::galaxy::galaxy());
    assert_eq!(expected.len(), 5000);
    for name in ["galaxy.xyz", "galaxy.csv", "galaxy.ply"] {
        assert!(space(name) == expected, "{name}");
    }
}

#[test]
fn cells_and_rays_are_read() {
    assert_eq!(cells::<3>(&text("example.cells"), 3).map(|cells| cells.len()), Ok(56));
    assert_eq!(rays::<3>(&text("example.rays")).map(|rays| rays.len()), Ok(16));
}

#[test]
fn scenarios_ask_about_the_committed_files() {
    let lecture = AnyScenario::parse(&text("lecture.octo"));
    let landscape = samples::landscape::landscape();
    assert_eq!(lecture, Ok(samples::scenarios::lecture(&landscape, &committed("landscape.png"))));

    let knot = AnyScenario::parse(&text("knot.octo"));
    let mesh = samples::knot::knot();
    assert_eq!(knot, Ok(samples::scenarios::knot(&mesh, &committed("knot.obj"))));

    let (Ok(AnyScenario::Quadtree(lecture)), Ok(AnyScenario::Octree(knot))) = (lecture, knot)
    else {
        panic!("the landscape lies in the plane, the knot in space");
    };
    check_leaves(&lecture, &picture("landscape.png"));
    check_leaves(&knot, &space("knot.obj"));
}

/// The tree of a scenario is worth looking at, and so is its ray.
fn check_leaves<const D: usize>(scenario: &Scenario<D>, content: &Content<D>) {
    let domain = scenario.grid().expect("a domain");
    let tree = build(content, domain, &scenario.recipe, &Progress::default()).expect("a tree");
    let mut events: Vec<Event<D>> = Vec::new();
    scenario.query.run(&tree, &scenario.ray, &mut events);
    let n_visited = events.iter().filter(|event| matches!(event, Event::Leaf { .. })).count();
    assert!(tree.n_leaves() > 1000, "{} leaves", tree.n_leaves());
    assert!((20..120).contains(&n_visited), "{n_visited} of {} leaves visited", tree.n_leaves());
}
