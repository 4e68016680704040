//! What a picture of a question frames.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use octoscope_core::gallery::Degenerate;
use octoscope_core::geometry::{Aabb, Ray};
use octoscope_core::paper::{counterexample, erratum_of};
use octoscope_core::query::Query;
use octoscope_core::scenario::{AnyScenario, Scenario, built_in};
use octoscope_core::traverse::{Variant, Variants, mirrored_origin};
use octoscope_core::tree::Tree;
use octoscope_figure::{Camera, Page, far_end};

/// The space view in the lecture of a projector, with formulas below it and beside it, in
/// usual windows, and in the narrowest.
const PAGES: [Page; 5] = [
    Page { width: 336.0, height: 290.0 },
    Page { width: 352.0, height: 365.0 },
    Page { width: 608.0, height: 510.0 },
    Page { width: 384.0, height: 380.0 },
    Page { width: 240.0, height: 400.0 },
];

/// Length on the page of what is seen between two points.
fn seen<const D: usize>(camera: &Camera<D>, page: Page, ends: [[f64; D]; 2]) -> f64 {
    let line = camera.visible_segment(page, ends);
    line.map_or(0.0, |[from, to]| (to[0] - from[0]).hypot(to[1] - from[1]))
}

/// The root keeps this share of its size at least, where the ray is seen.
const USUAL: f64 = 0.64;

/// What is wrong with what is framed of a ray, for which the root keeps `least` of its size.
fn faults<const D: usize>(
    name: &str,
    tree: &Tree<D>,
    ray: &Ray<D>,
    query: &Query<D>,
    least: f64,
) -> Vec<String> {
    let root = tree.domain().root_box();
    let mut faults = Vec::new();
    for page in PAGES {
        let mut camera = Camera::framing(&root, page);
        let alone = camera.height;
        camera.frame_question(&root, ray, query, page);
        let mut fault = |what: String| {
            faults.push(format!("{name} {D} on {} by {}: {what}", page.width, page.height));
        };
        let corners = [root.min, root.max, root.centre()];
        if !corners.iter().all(|&corner| is_on(&camera, page, corner)) {
            fault("the root is cut".to_owned());
        }
        let share = alone / camera.height;
        if share < least {
            fault(format!("the root has {share:.2} of its size"));
        }
        let ends = before_root(tree, ray, &root);
        let length = seen(&camera, page, ends);
        // What lies in the root, or comes straight from the eye, cannot be longer.
        let wanted = 24.0_f64.min(0.99 * on_page(&camera, page, ends));
        if length < wanted {
            fault(format!("{length:.1} of the ray are seen before it"));
        }
    }
    faults
}

fn is_on<const D: usize>(camera: &Camera<D>, page: Page, point: [f64; D]) -> bool {
    camera.project(page, point).is_some_and(|projected| {
        let [x, y] = projected.at;
        (0.0..=page.width).contains(&x) && (0.0..=page.height).contains(&y)
    })
}

/// Length on the page, however large.
fn on_page<const D: usize>(camera: &Camera<D>, page: Page, ends: [[f64; D]; 2]) -> f64 {
    let line = camera.project_segment(page, ends).map(|ends| ends.map(|end| end.at));
    line.map_or(f64::INFINITY, |[from, to]| (to[0] - from[0]).hypot(to[1] - from[1]))
}

/// The part of a ray before it enters the root; all of one that misses it.
fn before_root<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, root: &Aabb<D>) -> [[f64; D]; 2] {
    let (origin, direction) = (ray.origin(), ray.direction());
    let (mut enter, mut exit) = (f64::NEG_INFINITY, f64::INFINITY);
    for e in 0..D {
        let planes = [root.min[e], root.max[e]].map(|plane| (plane - origin[e]) / direction[e]);
        if direction[e] != 0.0 {
            (enter, exit) =
                (enter.max(planes[0].min(planes[1])), exit.min(planes[0].max(planes[1])));
        } else if origin[e] < root.min[e] || origin[e] > root.max[e] {
            exit = f64::NEG_INFINITY;
        }
    }
    let is_hit = enter <= exit && exit >= 0.0;
    [origin, if is_hit { ray.at(enter.max(0.0)) } else { far_end(tree, ray) }]
}

fn faults_of<const D: usize>(name: &str, scenario: &Scenario<D>) -> Vec<String> {
    if !matches!(scenario.query, Query::Ray { .. }) {
        return Vec::new();
    }
    faults(name, &scenario.tree().unwrap(), &scenario.ray, &scenario.query, USUAL)
}

#[test]
fn every_counterexample_shows_where_its_ray_comes_from() {
    let mut all = Vec::new();
    for variant in Variant::ALL.into_iter().filter(|&variant| erratum_of(variant).is_some()) {
        all.extend(match counterexample(variant) {
            AnyScenario::Quadtree(scenario) => faults_of(variant.id(), &scenario),
            AnyScenario::Octree(scenario) => faults_of(variant.id(), &scenario),
        });
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}

fn gallery<const D: usize>(scenario: &Scenario<D>) -> Vec<String> {
    let tree = scenario.tree().unwrap();
    let rays = Degenerate::ALL.into_iter().filter_map(|kind| Some((kind, kind.ray(&tree)?)));
    rays.flat_map(|(kind, ray)| faults(&format!("{kind:?}"), &tree, &ray, &scenario.query, USUAL))
        .collect()
}

#[test]
fn every_ray_of_the_gallery_shows_where_it_comes_from() {
    for scene in ["quadtree-82", "points-3d"] {
        let all = match built_in(scene).unwrap() {
            AnyScenario::Quadtree(scenario) => gallery(&scenario),
            AnyScenario::Octree(scenario) => gallery(&scenario),
        };
        assert!(all.is_empty(), "{scene}\n{}", all.join("\n"));
    }
}

#[test]
fn a_ray_that_passes_the_root_by_far_makes_it_smaller() {
    let AnyScenario::Quadtree(scenario) = built_in("quadtree-82").unwrap() else { panic!() };
    let tree = scenario.tree().unwrap();
    let root = tree.domain().root_box();
    let (centre, side) = (root.centre(), root.size()[0]);
    for off in [1.2, -1.2] {
        let ray = Ray::new([centre[0] - 20.0 * side, centre[1] + off * side], [1.0, 0.0]).unwrap();
        let all = faults("far", &tree, &ray, &scenario.query, 0.5);
        assert!(all.is_empty(), "{}", all.join("\n"));
        let mut camera = Camera::framing(&root, PAGES[2]);
        let alone = camera.height;
        camera.frame_question(&root, &ray, &scenario.query, PAGES[2]);
        assert!(alone / camera.height < USUAL, "{off}");
    }
}

#[test]
fn a_ray_through_a_root_that_is_seen_along_it_is_framed_too() {
    // It comes from the eye.
    let scenario = match built_in("points-3d").unwrap() {
        AnyScenario::Octree(scenario) => scenario,
        AnyScenario::Quadtree(_) => panic!("a quadtree"),
    };
    let tree = scenario.tree().unwrap();
    let root = tree.domain().root_box();
    let mut camera = Camera::framing(&root, PAGES[2]);
    let [_, _, back] = camera.basis();
    for sides in [0.5, 2.0, 50.0, 1e6] {
        let origin = std::array::from_fn(|e| root.centre()[e] + sides * back[e]);
        let ray = Ray::new(origin, back.map(|x| -x)).unwrap();
        camera.frame_question(&root, &ray, &scenario.query, PAGES[2]);
        assert!([root.min, root.max].iter().all(|&corner| is_on(&camera, PAGES[2], corner)));
    }
}

#[test]
fn where_a_ray_is_mirrored_wrongly_both_mirrored_rays_are_seen_from_their_beginning() {
    let AnyScenario::Quadtree(scenario) = counterexample(Variant::B7) else { panic!() };
    let (tree, Scenario { ray, query, .. }) = (scenario.tree().unwrap(), &scenario);
    let domain = tree.domain();
    let variants = query.variants_at_work();
    for page in PAGES {
        let mut camera = Camera::framing(&domain.root_box(), page);
        let alone = camera.height;
        camera.frame_mirrored(domain, ray, query, page);
        let mirrored = [Variants::NONE, variants].map(|rules| mirrored_origin(domain, ray, rules));
        for origin in [mirrored[0], mirrored[1], ray.origin()] {
            assert!(is_on(&camera, page, origin), "{origin:?} on {page:?}");
        }
        assert!(alone / camera.height > 0.28, "{page:?}");
    }
}
