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
    Camera, Figure, Form, Mark, Page, Part, Role, Shape, Show, axes, marks, space_figure_over,
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

/// The space view of a lecture on a projector and in a window of 1280 × 800, and beside
/// panels.
const PAGES: [Page; 3] =
    [Page { width: 336.0, height: 362.0 }, Page { width: 440.0, height: 362.0 }, PAGE];

/// A moment of a run on a page, with its order numbers.
struct Shown<'a, const D: usize> {
    camera: &'a Camera<D>,
    page: Page,
    moment: &'a Moment<D>,
    marks: &'a [Mark<D>],
    numbers: Numbers,
    place: String,
}

/// Looks at every so many moments of all algorithms, as the window shows them.
fn on_pages<const D: usize>(
    (tree, ray): &(Tree<D>, Ray<D>),
    every: usize,
    mut look: impl FnMut(&Shown<'_, D>),
) {
    for (n, algorithm) in Algorithm::ALL.into_iter().enumerate() {
        let query = along_the_ray(algorithm);
        let trace = record(tree, ray, &query);
        let page = PAGES[n % PAGES.len()];
        let root = tree.domain().root_box();
        let mut camera = Camera::framing(&root, page);
        camera.frame_question(&root, ray, &query, page);
        for step in (1..=trace.events.len()).rev().step_by(every) {
            let (moment, event) = (&Moment::after(tree, &trace, step), trace.events.get(step - 1));
            let show = Show::at_first::<D>();
            let mut all = axes(tree.domain(), &show, &camera);
            all.extend(marks(tree, ray, &query, moment, event, &show));
            all.sort_by_cached_key(|mark| mark.role.layer());
            let is_box = |mark: &&Mark<D>| D == 3 && matches!(mark.shape, Shape::Box(_));
            let (below, above): (Vec<_>, Vec<_>) = all.iter().partition(is_box);
            let [below, above] =
                [below, above].map(|part| part.into_iter().cloned().collect::<Vec<_>>());
            let numbers = numbers(&space_figure_over(&below, &above, &camera, page));
            let place = format!("{algorithm:?} step {step} on {}", page.width);
            look(&Shown { camera: &camera, page, moment, marks: &all, numbers, place });
        }
    }
}

/// Length of the lines to numbers, the shortest first; of at most `few` none is missing.
fn lines_on_pages<const D: usize>(scene: &(Tree<D>, Ray<D>), every: usize, few: usize) -> Vec<f64> {
    let mut lengths = Vec::new();
    on_pages(scene, every, |shown| {
        let Shown { camera, page, numbers: Numbers { discs, lines }, place, .. } = shown;
        let leaves: HashSet<NodeId> = shown.moment.leaves.iter().map(|leaf| leaf.node).collect();
        let numbered: HashSet<NodeId> = discs.iter().map(|(node, ..)| *node).collect();
        if leaves.len() <= few {
            assert_eq!(numbered, leaves, "{place}");
        }
        let last = shown.moment.leaves.last().map(|leaf| leaf.node);
        assert!(last.is_none_or(|last| numbered.contains(&last)), "{place}");
        let boxes = shown.marks.iter().filter_map(|mark| match (mark.role, mark.shape) {
            (Role::Visited { .. }, Shape::Box(bounds)) => Some((mark.node.unwrap(), bounds)),
            _ => None,
        });
        let boxes: Vec<(NodeId, Aabb<D>)> = boxes.collect();
        // In space the nearest, and in the plane the only one.
        let seen_at = |at: [f64; 2]| {
            let met = boxes
                .iter()
                .filter_map(|(node, bounds)| Some((nearness(camera, *page, at, bounds)?, *node)));
            met.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, node)| node)
        };
        for (node, centre, _) in discs {
            match lines.iter().find(|(of, _)| of == node) {
                None => {
                    assert_eq!(seen_at(*centre), Some(*node), "{place}: {node:?} at {centre:?}")
                }
                Some((_, line)) => {
                    let bounds = boxes.iter().find(|(of, _)| of == node).unwrap().1;
                    let foot = nearness(camera, *page, line[0], &bounds);
                    assert!(foot.is_some(), "{place}: {line:?}");
                    lengths.push((line[1][0] - line[0][0]).hypot(line[1][1] - line[0][1]));
                }
            }
        }
    });
    lengths.sort_by(f64::total_cmp);
    lengths
}

#[test]
fn every_number_of_a_few_stands_in_its_leaf_or_has_a_short_line_to_it() {
    fn check(lengths: &[f64], least: usize, most: [f64; 3]) {
        assert!(lengths.len() > least, "{}", lengths.len());
        let at = |share: f64| lengths[(share * (lengths.len() - 1) as f64) as usize];
        let told = [0.5, 0.9, 1.0].map(at);
        assert!((0..3).all(|n| told[n] < most[n]), "{told:?}");
    }
    // The longest lead out of small nodes that are looked at, which bear no numbers.
    check(&lines_on_pages(&plane(), 5, 40), 1500, [12.0, 30.0, 80.0]);
    check(&lines_on_pages(&space(), 5, 12), 500, [12.0, 12.0, 48.0]);
}

/// How far before the eye a box lies at a place on the page, if it is there.
fn nearness<const D: usize>(
    camera: &Camera<D>,
    page: Page,
    at: [f64; 2],
    bounds: &Aabb<D>,
) -> Option<f64> {
    if D == 2 {
        let at = camera.unproject(page, at, bounds.min);
        let is_in = |e: usize| (bounds.min[e] - 1e-9..=bounds.max[e] + 1e-9).contains(&at[e]);
        return (0..D).all(is_in).then_some(0.0);
    }
    let sight = camera.sight(page, at)?;
    let (from, along) = (sight.origin(), sight.direction());
    let planes: [[f64; 2]; D] = std::array::from_fn(|e| {
        [bounds.min[e], bounds.max[e]].map(|side| (side - from[e]) / along[e])
    });
    let enter = planes.map(|[a, b]| a.min(b)).into_iter().fold(f64::MIN, f64::max);
    let exit = planes.map(|[a, b]| a.max(b)).into_iter().fold(f64::MAX, f64::min);
    (enter < exit).then_some(enter)
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
    let [right, wrong] = [Role::MirroredRay, Role::MirroredWrongly].map(arrow);
    assert_ne!(right[0], wrong[0]);
    let slope = |[from, to]: [[f64; 2]; 2]| (to[1] - from[1]) / (to[0] - from[0]);
    assert!((slope(right) - slope(wrong)).abs() < 1e-9, "{right:?} {wrong:?}");
}
