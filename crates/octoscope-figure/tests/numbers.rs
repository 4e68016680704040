//! Where numbers of leaves and children stand, and letters of planes.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use octoscope_core::event::Event;
use octoscope_core::geometry::{Aabb, Ray};
use octoscope_core::paper::counterexample;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::scenario::{AnyScenario, Scenario, built_in};
use octoscope_core::trace::{Moment, record};
use octoscope_core::traverse::{Algorithm, Options, Variant};
use octoscope_core::tree::{NodeId, Tree};
use octoscope_figure::{
    Camera, Figure, Form, Mark, Page, Part, Role, Shape, Show, marks, space_figure_over,
};
use std::collections::HashSet;

const PAGE: Page = Page { width: 609.0, height: 510.0 };

fn along_the_ray<const D: usize>(algorithm: Algorithm) -> Query<D> {
    Query::Ray { algorithm, options: Options::default(), arithmetic: Arithmetic::Doubles }
}

fn plane() -> (Tree<2>, Ray<2>) {
    let Some(AnyScenario::Quadtree(scenario)) = built_in("quadtree-82") else {
        panic!("it is one of a plane");
    };
    let tree = scenario.tree().unwrap();
    (tree, Ray::new([-0.16, 0.13], [1.0, 0.62]).unwrap())
}

fn space() -> (Tree<3>, Ray<3>) {
    let Some(AnyScenario::Octree(scenario)) = built_in("points-3d") else {
        panic!("it is one of space");
    };
    let tree = scenario.tree().unwrap();
    (tree, Ray::new([-0.16, 0.13, 0.2], [1.0, 0.62, 0.41]).unwrap())
}

/// The figure after every `every`th step of an algorithm, with that step.
fn figures<const D: usize>(
    (tree, ray): &(Tree<D>, Ray<D>),
    algorithm: Algorithm,
    every: usize,
) -> Vec<(usize, Figure)> {
    let query = along_the_ray(algorithm);
    let trace = record(tree, ray, &query);
    let camera = Camera::framing(&framed(tree, ray), PAGE);
    let steps = (1..=trace.events.len()).filter(|step| step % every == 0);
    let figure = |step: usize| {
        let moment = Moment::after(tree, &trace, step);
        let event = trace.events.get(step - 1);
        let all = marks(tree, ray, &query, &moment, event, &Show::default());
        // In the window, boxes in space are drawn by others.
        let is_box = |mark: &Mark<D>| D == 3 && matches!(mark.shape, Shape::Box(_));
        let (below, above): (Vec<_>, Vec<_>) = all.into_iter().partition(is_box);
        (step, space_figure_over(&below, &above, &camera, PAGE))
    };
    steps.map(figure).collect()
}

/// The root and where the ray begins.
fn framed<const D: usize>(tree: &Tree<D>, ray: &Ray<D>) -> Aabb<D> {
    let root = tree.domain().root_box();
    Aabb::around([root.min, root.max, ray.origin()]).unwrap()
}

/// Discs of order numbers, and the lines from leaves to them.
struct Numbers {
    discs: Vec<(NodeId, [f64; 2], f64)>,
    lines: Vec<(NodeId, Vec<[f64; 2]>)>,
}

fn numbers(figure: &Figure) -> Numbers {
    let mut numbers = Numbers { discs: Vec::new(), lines: Vec::new() };
    for drawn in figure.drawn.iter().filter(|drawn| drawn.role == Role::OrderNumber) {
        let node = drawn.node.unwrap();
        match &drawn.form {
            Form::Circle { centre, radius } => numbers.discs.push((node, *centre, *radius)),
            Form::Polyline(line) => numbers.lines.push((node, line.clone())),
            Form::Polygon(_) | Form::Text { .. } | Form::Formula { .. } => {}
        }
    }
    numbers
}

#[test]
fn every_number_in_the_plane_stands_in_its_leaf_or_has_a_line_to_it() {
    let scene = plane();
    let (tree, ray) = &scene;
    let camera = Camera::framing(&framed(tree, ray), PAGE);
    let mut n_numbers = 0;
    for algorithm in Algorithm::ALL {
        for (step, figure) in figures(&scene, algorithm, 3) {
            let Numbers { discs, lines } = numbers(&figure);
            for (node, centre, _) in discs {
                n_numbers += 1;
                let bounds = tree.node_box(node);
                let ends = [bounds.min, bounds.max].map(|p| camera.project(PAGE, p).unwrap().at);
                let is_inside = (0..2).all(|e| {
                    let [low, high] = [ends[0][e].min(ends[1][e]), ends[0][e].max(ends[1][e])];
                    (low..=high).contains(&centre[e])
                });
                let has_line = lines.iter().any(|(of, _)| *of == node);
                assert!(is_inside || has_line, "{algorithm:?} step {step}: {node:?} at {centre:?}");
            }
        }
    }
    assert!(n_numbers > 1000, "{n_numbers}");
}

#[test]
fn no_number_of_a_few_is_missing_in_the_plane() {
    let scene = plane();
    let (tree, ray) = &scene;
    for algorithm in Algorithm::ALL {
        let trace = record(tree, ray, &along_the_ray(algorithm));
        for (step, figure) in figures(&scene, algorithm, 1) {
            let n_leaves = Moment::after(tree, &trace, step).leaves.len();
            let n_discs = numbers(&figure).discs.len();
            assert!(n_leaves <= 40);
            assert_eq!(n_discs, n_leaves, "{algorithm:?} step {step}");
        }
    }
}

#[test]
fn a_leaf_that_is_met_is_seen_as_visited_before_it_has_its_number() {
    let scene = plane();
    let (tree, ray) = &scene;
    let query = along_the_ray(Algorithm::Exhaustive);
    let trace = record(tree, ray, &query);
    let mut n_unnumbered = 0;
    for (step, figure) in figures(&scene, Algorithm::Exhaustive, 1) {
        let moment = Moment::after(tree, &trace, step);
        let is_visited = |role: Role| matches!(role, Role::Visited { .. });
        let shown = figure.drawn.iter().filter(|drawn| is_visited(drawn.role));
        let shown: HashSet<NodeId> = shown.filter_map(|drawn| drawn.node).collect();
        let past = &trace.events[..step];
        let cut = past.iter().filter_map(|event| match *event {
            Event::Test { node, interval: Some(_), touch: false, .. } => Some(node),
            _ => None,
        });
        let numbered = moment.leaves.iter().map(|leaf| leaf.node);
        let expected: HashSet<NodeId> = match moment.end {
            None => cut.chain(numbered).collect(),
            Some(_) => numbered.collect(),
        };
        assert_eq!(shown, expected, "step {step}");
        n_unnumbered += shown.len() - moment.leaves.len();
    }
    assert!(n_unnumbered > 100, "{n_unnumbered}");
}

#[test]
fn tags_of_children_are_square_and_keep_apart_from_numbers() {
    fn check<const D: usize>(scene: &(Tree<D>, Ray<D>)) {
        let mut n_tags = 0;
        for algorithm in [Algorithm::Glassner, Algorithm::DdaOctree, Algorithm::Parametric] {
            for (step, figure) in figures(scene, algorithm, 3) {
                let discs = numbers(&figure).discs;
                for drawn in figure.drawn.iter().filter(|drawn| drawn.role == Role::ChildIndex) {
                    let corners = match &drawn.form {
                        Form::Polygon(corners) => corners,
                        Form::Text { .. } => continue,
                        other => panic!("{other:?}"),
                    };
                    n_tags += 1;
                    let ([left, top], [right, bottom]) = (corners[0], corners[2]);
                    for (_, [x, y], radius) in &discs {
                        let is_apart = x + radius + 2.0 < left
                            || right + 2.0 < x - radius
                            || y + radius < top
                            || bottom < y - radius;
                        assert!(is_apart, "{algorithm:?} step {step}: {corners:?} at {x} {y}");
                    }
                }
            }
        }
        assert!(n_tags > 50, "{n_tags}");
    }
    check(&plane());
    check(&space());
}

#[test]
fn the_head_of_the_ray_lies_beyond_the_point_where_it_leaves_the_root() {
    let scene = space();
    let (tree, ray) = &scene;
    let camera = Camera::framing(&framed(tree, ray), PAGE);
    let root = tree.domain().root_box();
    let exit = (0..3).map(|e| (root.max[e] - ray.origin()[e]) / ray.direction()[e]);
    let exit = camera.project(PAGE, ray.at(exit.fold(f64::INFINITY, f64::min))).unwrap().at;
    let away = |at: &[f64; 2]| (at[0] - exit[0]).hypot(at[1] - exit[1]);
    for (step, figure) in figures(&scene, Algorithm::Glassner, 5) {
        let is_head = |part: Part, role: Role| part == Part::Head && role == Role::Ray;
        let head = figure.drawn.iter().find(|drawn| is_head(drawn.part, drawn.role)).unwrap();
        let Form::Polygon(corners) = &head.form else { panic!("{head:?}") };
        let nearest = corners.iter().map(away).fold(f64::INFINITY, f64::min);
        assert!(nearest > 5.0, "step {step}: {nearest}");
    }
}

#[test]
fn letters_of_planes_in_space_have_ground_of_their_own() {
    let mut n_letters = 0;
    for (step, figure) in figures(&space(), Algorithm::Glassner, 5) {
        for (n, drawn) in figure.drawn.iter().enumerate() {
            let is_of_plane = matches!(drawn.role, Role::MidPlane(_) | Role::ExitPlane(_));
            let Form::Text { at, .. } = &drawn.form else { continue };
            if is_of_plane {
                n_letters += 1;
                let before = &figure.drawn[n - 1];
                let Form::Polygon(corners) = &before.form else { panic!("step {step}") };
                assert!(before.role == Role::Ground && before.part == Part::Face(0));
                assert!((0..2).all(|e| corners[0][e] < at[e] && at[e] < corners[2][e]));
            }
        }
    }
    assert!(n_letters > 20, "{n_letters}");
}

#[test]
fn a_ray_that_is_mirrored_wrongly_is_seen_beside_the_right_one() {
    let AnyScenario::Quadtree(scenario) = counterexample(Variant::B7) else {
        panic!("it is one of a plane");
    };
    let tree = scenario.tree().unwrap();
    let Scenario { ray, query, .. } = &scenario;
    let trace = record(&tree, ray, query);
    let show = Show { mirrored_ray: true, ..Show::default() };
    let moment = Moment::after(&tree, &trace, trace.events.len());
    let marks = marks(&tree, ray, query, &moment, trace.events.last(), &show);
    let arrow = |role: Role| {
        let ends =
            marks.iter().filter(|mark| mark.role == role).find_map(|mark| match mark.shape {
                Shape::Arrow(ends) => Some(ends),
                _ => None,
            });
        ends.unwrap()
    };
    let [right, wrong] = [Role::MirroredRay, Role::Strayed].map(arrow);
    assert_ne!(right[0], wrong[0]);
    let slope = |[from, to]: [[f64; 2]; 2]| (to[1] - from[1]) / (to[0] - from[0]);
    assert!((slope(right) - slope(wrong)).abs() < 1e-9, "{right:?} {wrong:?}");
}
