//! Numbers of children, and what of a small node at work is to be seen.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use octoscope_core::geometry::Aabb;
use octoscope_core::progress::Progress;
use octoscope_core::query::{Arithmetic, PointMethod, Query};
use octoscope_core::scenario::{AnyScenario, Scenario, built_in};
use octoscope_core::trace::{Moment, record};
use octoscope_core::traverse::{Algorithm, Options, Variants};
use octoscope_core::tree::{NodeId, Tree, build};
use octoscope_figure::{
    Camera, Drawn, Figure, Form, Mark, Page, Part, Role, Shape, Show, Style, Theme, marks,
    space_figure,
};
use std::sync::LazyLock;

const PAGE: Page = Page { width: 449.0, height: 365.0 };
/// The chosen child has its tag where it is so large on the page.
const LARGE: f64 = 30.0;
/// The middle of a tag outside of its child is so near.
const BESIDE: f64 = 10.0;

fn along<const D: usize>(algorithm: Algorithm) -> Query<D> {
    let (options, arithmetic) = (Options::default(), Arithmetic::default());
    Query::Ray { algorithm, options, arithmetic }
}

fn queries<const D: usize>() -> Vec<Query<D>> {
    let at = std::array::from_fn(|e| 0.546_875 + 0.031_25 * e as f64);
    let point = |method| Query::Point { at, method, variants: Variants::NONE };
    let points = [PointMethod::Codes, PointMethod::Comparison].map(point);
    Algorithm::ALL.map(along).into_iter().chain(points).collect()
}

/// What the laws ask of a moment of a run that is drawn. All tests share it: drawing all
/// moments takes much longer than asking.
struct Shown<const D: usize> {
    place: String,
    /// Children that have a number.
    children: Vec<Child<D>>,
    /// The node at work.
    current: Option<Aabb<D>>,
    /// Order numbers and points where the ray enters and leaves something.
    discs: Vec<Disc>,
}

struct Child<const D: usize> {
    node: NodeId,
    bounds: Aabb<D>,
    /// Whether it is the one that is taken.
    is_taken: bool,
    /// Where its number is written.
    tag: Option<[f64; 2]>,
    /// The corners of what points from that into the child.
    corners: Vec<[f64; 2]>,
}

struct Disc {
    role: Role,
    centre: [f64; 2],
    radius: f64,
}

/// Moments of all algorithms, and where from they are seen.
struct Runs<const D: usize> {
    camera: Camera<D>,
    moments: Vec<Shown<D>>,
}

static PLANE: LazyLock<Runs<2>> = LazyLock::new(|| {
    let AnyScenario::Quadtree(scenario) = built_in("quadtree-82").unwrap() else { panic!() };
    Runs::of(&scenario, 1)
});

static SPACE: LazyLock<Runs<3>> = LazyLock::new(|| {
    let AnyScenario::Octree(scenario) = built_in("points-3d").unwrap() else { panic!() };
    Runs::of(&scenario, 3)
});

impl<const D: usize> Runs<D> {
    /// Every so many of the moments.
    fn of(scenario: &Scenario<D>, every: usize) -> Self {
        let (content, grid) = (scenario.source.content().unwrap(), scenario.grid().unwrap());
        let tree = build(&content, grid, &scenario.recipe, &Progress::default()).unwrap();
        let camera = Camera::framing(&tree.domain().root_box(), PAGE);
        let mut moments = Vec::new();
        for query in queries::<D>() {
            let trace = record(&tree, &scenario.ray, &query);
            for step in (1..=trace.events.len()).step_by(every) {
                let moment = Moment::after(&tree, &trace, step);
                let (event, show) = (trace.events.get(step - 1), Show::at_first::<D>());
                let marks = marks(&tree, &scenario.ray, &query, &moment, event, &show);
                let figure = space_figure(&marks, &camera, PAGE);
                let place = format!("{query:?}, step {step}");
                moments.push(Shown::of(&tree, &marks, &figure, place));
            }
        }
        Self { camera, moments }
    }

    /// What a box covers on the page, from corner to corner.
    fn area(&self, bounds: &Aabb<D>) -> Aabb<2> {
        let ends = [bounds.min, bounds.max];
        let corners = (0..1usize << D)
            .map(|corner| std::array::from_fn(|e| ends[corner >> e & 1][e]))
            .map(|corner| self.camera.project(PAGE, corner).unwrap().at);
        Aabb::around(corners).unwrap()
    }
}

impl<const D: usize> Shown<D> {
    fn of(tree: &Tree<D>, marks: &[Mark<D>], figure: &Figure, place: String) -> Self {
        let is_taken =
            |mark: &&Mark<D>| matches!(mark.role, Role::Taken | Role::Current | Role::Found);
        let taken: Vec<_> = marks.iter().filter(is_taken).filter_map(|mark| mark.node).collect();
        let numbered = marks.iter().filter(|mark| mark.role == Role::ChildIndex);
        let child = |node: NodeId| Child {
            node,
            bounds: tree.node_box(node),
            is_taken: taken.contains(&node),
            tag: tag(figure, node),
            corners: corners(figure, node),
        };
        let current = marks.iter().find(|mark| mark.role == Role::Current);
        let current = current.map(|mark| match mark.shape {
            Shape::Box(bounds) => bounds,
            _ => panic!("{mark:?}"),
        });
        let disc = |drawn: &Drawn| match (drawn.role, &drawn.form) {
            (
                role @ (Role::OrderNumber | Role::EntryPoint | Role::ExitPoint),
                &Form::Circle { centre, radius },
            ) => Some(Disc { role, centre, radius }),
            _ => None,
        };
        let whole = figure.drawn.iter().filter(|drawn| drawn.part == Part::Whole);
        Self {
            place,
            children: numbered.filter_map(|mark| mark.node).map(child).collect(),
            current,
            discs: whole.filter_map(disc).collect(),
        }
    }

    fn others(&self) -> impl Iterator<Item = &Child<D>> {
        self.children.iter().filter(|child| !child.is_taken)
    }
}

/// What is drawn for the number of a child.
fn of_number(figure: &Figure, node: NodeId) -> impl Iterator<Item = &Form> {
    let is_own = move |drawn: &&Drawn| drawn.role == Role::ChildIndex && drawn.node == Some(node);
    figure.drawn.iter().filter(is_own).map(|drawn| &drawn.form)
}

/// Where the number of a child is written.
fn tag(figure: &Figure, node: NodeId) -> Option<[f64; 2]> {
    of_number(figure, node).find_map(|form| match form {
        Form::Text { at, .. } => Some(*at),
        _ => None,
    })
}

/// The corners of what points from that into the child, if anything does.
fn corners(figure: &Figure, node: NodeId) -> Vec<[f64; 2]> {
    let corners = of_number(figure, node).find_map(|form| match form {
        Form::Polygon(corners) if corners.len() == 3 => Some(corners.clone()),
        _ => None,
    });
    corners.unwrap_or_default()
}

#[test]
fn the_child_that_is_taken_has_its_tag_wherever_its_cell_has_room_for_one() {
    fn check<const D: usize>(runs: &Runs<D>) -> usize {
        let mut n_tags = 0;
        for shown in &runs.moments {
            for Child { node, bounds, tag, .. } in shown.children.iter().filter(|c| c.is_taken) {
                let area = runs.area(bounds);
                let is_large = area.size().into_iter().all(|side| side >= LARGE);
                assert!(tag.is_some() || !is_large, "{}: {node:?} {area:?}", shown.place);
                // Outside where ray and ways leave no room in it, though at its frame.
                let is_at = |at: [f64; 2]| {
                    (0..2).all(|e| area.min[e] - BESIDE < at[e] && at[e] < area.max[e] + BESIDE)
                };
                assert!(tag.is_none_or(is_at), "{}: {tag:?} {area:?}", shown.place);
                n_tags += usize::from(tag.is_some());
            }
        }
        n_tags
    }
    let (in_plane, in_space) = (check(&PLANE), check(&SPACE));
    assert!(in_plane > 50 && in_space > 50, "{in_plane} {in_space}");
}

#[test]
fn a_tag_outside_of_its_child_points_into_it() {
    fn check<const D: usize>(runs: &Runs<D>) -> [usize; 2] {
        let [mut n_outside, mut n_pointing] = [0; 2];
        for child in runs.moments.iter().flat_map(|shown| &shown.children) {
            let area = runs.area(&child.bounds);
            let holds =
                |at: &[f64; 2]| (0..2).all(|e| (area.min[e]..=area.max[e]).contains(&at[e]));
            if child.tag.is_some_and(|tag| !holds(&tag)) {
                n_outside += 1;
                n_pointing += usize::from(child.corners.iter().any(holds));
            }
        }
        [n_outside, n_pointing]
    }
    for [n_outside, n_pointing] in [check(&PLANE), check(&SPACE)] {
        // But for where a line at its frame would be covered.
        assert!(n_outside > 10 && 5 * n_pointing >= 4 * n_outside, "{n_pointing} {n_outside}");
    }
}

#[test]
fn in_space_a_tag_lies_on_its_own_child_and_not_on_one_before_it() {
    let mut n_tags = 0;
    for shown in &SPACE.moments {
        for child in shown.others() {
            let Some(at) = child.tag else { continue };
            let sight = SPACE.camera.sight(PAGE, at).unwrap();
            let (from, along) = (sight.origin(), sight.direction());
            let enter = |bounds: &Aabb<3>| {
                let planes: [[f64; 2]; 3] = std::array::from_fn(|e| {
                    [bounds.min[e], bounds.max[e]].map(|side| (side - from[e]) / along[e])
                });
                let enter = planes.map(|[a, b]| a.min(b)).into_iter().fold(f64::MIN, f64::max);
                let exit = planes.map(|[a, b]| a.max(b)).into_iter().fold(f64::MAX, f64::min);
                (enter < exit).then_some(enter)
            };
            let met = shown.children.iter().filter_map(|c| Some((enter(&c.bounds)?, c.node)));
            let nearest = met.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, node)| node);
            assert_eq!(nearest, Some(child.node), "{}", shown.place);
            n_tags += 1;
        }
    }
    assert!(n_tags > 20, "{n_tags}");
}

#[test]
fn of_the_children_that_are_not_taken_all_have_their_tag_or_none_has() {
    fn check<const D: usize>(runs: &Runs<D>) -> usize {
        let mut n_tags = 0;
        for shown in &runs.moments {
            let tagged: Vec<bool> = shown.others().map(|child| child.tag.is_some()).collect();
            let n = tagged.iter().filter(|has| **has).count();
            assert!(n == 0 || n == tagged.len(), "{}: {tagged:?}", shown.place);
            n_tags += n;
        }
        n_tags
    }
    let (in_plane, in_space) = (check(&PLANE), check(&SPACE));
    assert!(in_plane > 100 && in_space > 20, "{in_plane} {in_space}");
}

#[test]
fn what_is_at_work_or_looked_for_is_seen_as_an_outline_however_small_it_is() {
    fn check<const D: usize>(from: &Aabb<D>) {
        let camera = Camera::framing(from, PAGE);
        let roles = [Role::Current, Role::Missed, Role::Found, Role::GridCell, Role::Target];
        for role in roles {
            for share in [0.5, 0.02, 1e-4, 1e-9] {
                let max = std::array::from_fn(|e| from.min[e] + share * from.size()[e]);
                let mark = Mark::new(Shape::Box(Aabb { min: from.min, max }), role);
                let figure = space_figure(&[mark], &camera, PAGE);
                let extent = figure.extent().unwrap().size();
                assert!(extent.into_iter().all(|side| side >= 10.0), "{role:?} {share} {extent:?}");
            }
        }
    }
    check(&Aabb { min: [0.0; 2], max: [4.0; 2] });
    check(&Aabb { min: [-1.0; 3], max: [1.0; 3] });
}

#[test]
fn a_small_node_at_work_is_hidden_by_no_order_number_and_by_no_large_point() {
    fn check<const D: usize>(runs: &Runs<D>) -> [usize; 2] {
        let [mut n_discs, mut n_dots] = [0; 2];
        for shown in &runs.moments {
            let Some(bounds) = &shown.current else { continue };
            let area = runs.area(bounds);
            let side = bounds.size().into_iter().fold(0.0, f64::max) / runs.camera.unit(PAGE);
            let small = if D == 2 { 34.0 } else { 44.0 };
            let is_small = area.size().into_iter().all(|side| side < small);
            for &Disc { role, centre, radius } in &shown.discs {
                if role != Role::OrderNumber {
                    let reach = radius + 0.5 * Style::of(Theme::Light, role).width;
                    let most = (side / 3.0).max(4.01);
                    assert!(2.0 * reach <= most, "{}: {reach} of {side}", shown.place);
                    n_dots += 1;
                } else if is_small {
                    let beyond: [f64; 2] = std::array::from_fn(|e| {
                        (area.min[e] - centre[e]).max(centre[e] - area.max[e]).max(0.0)
                    });
                    let away = beyond[0].hypot(beyond[1]);
                    assert!(away > radius - 0.01, "{}: {centre:?} {area:?}", shown.place);
                    n_discs += 1;
                }
            }
        }
        [n_discs, n_dots]
    }
    for [n_discs, n_dots] in [check(&PLANE), check(&SPACE)] {
        assert!(n_discs > 500 && n_dots > 500, "{n_discs} {n_dots}");
    }
}
