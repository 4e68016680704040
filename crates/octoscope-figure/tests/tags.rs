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
    Camera, Figure, Form, Mark, Page, Part, Role, Shape, Show, Style, Theme, marks, space_figure,
};

const PAGE: Page = Page { width: 449.0, height: 365.0 };
/// The chosen child has its tag where it is so large on the page.
const LARGE: f64 = 30.0;

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

/// A moment of a run, drawn.
struct Shown<'a, const D: usize> {
    tree: &'a Tree<D>,
    camera: &'a Camera<D>,
    marks: Vec<Mark<D>>,
    figure: Figure,
    place: String,
}

/// Looks at all moments of all algorithms, every so many of them.
fn look<const D: usize>(scenario: &Scenario<D>, every: usize, mut at: impl FnMut(&Shown<'_, D>)) {
    let (content, grid) = (scenario.source.content().unwrap(), scenario.grid().unwrap());
    let tree = build(&content, grid, &scenario.recipe, &Progress::default()).unwrap();
    let camera = &Camera::framing(&tree.domain().root_box(), PAGE);
    for query in queries::<D>() {
        let trace = record(&tree, &scenario.ray, &query);
        for step in (1..=trace.events.len()).step_by(every) {
            let moment = Moment::after(&tree, &trace, step);
            let (event, show) = (trace.events.get(step - 1), Show::at_first::<D>());
            let marks = marks(&tree, &scenario.ray, &query, &moment, event, &show);
            let figure = space_figure(&marks, camera, PAGE);
            let place = format!("{query:?}, step {step}");
            at(&Shown { tree: &tree, camera, marks, figure, place });
        }
    }
}

fn plane(at: impl FnMut(&Shown<'_, 2>)) {
    let AnyScenario::Quadtree(scenario) = built_in("quadtree-82").unwrap() else { panic!() };
    look(&scenario, 1, at);
}

fn space(at: impl FnMut(&Shown<'_, 3>)) {
    let AnyScenario::Octree(scenario) = built_in("points-3d").unwrap() else { panic!() };
    look(&scenario, 3, at);
}

impl<const D: usize> Shown<'_, D> {
    /// Children that have a number, and whether each is the one that is taken.
    fn children(&self) -> Vec<(NodeId, bool)> {
        let is_taken =
            |mark: &&Mark<D>| matches!(mark.role, Role::Taken | Role::Current | Role::Found);
        let taken: Vec<_> =
            self.marks.iter().filter(is_taken).filter_map(|mark| mark.node).collect();
        let numbered = self.marks.iter().filter(|mark| mark.role == Role::ChildIndex);
        let nodes = numbered.filter_map(|mark| mark.node);
        nodes.map(|node| (node, taken.contains(&node))).collect()
    }

    fn tag(&self, node: NodeId) -> Option<[f64; 2]> {
        let own = self.figure.drawn.iter();
        let own = own.filter(|drawn| drawn.role == Role::ChildIndex && drawn.node == Some(node));
        own.filter_map(|drawn| match &drawn.form {
            Form::Text { at, .. } => Some(*at),
            _ => None,
        })
        .next()
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

#[test]
fn the_child_that_is_taken_has_its_tag_wherever_its_cell_has_room_for_one() {
    fn check<const D: usize>(shown: &Shown<'_, D>) -> usize {
        let mut n_tags = 0;
        for (node, _) in shown.children().into_iter().filter(|(_, is_taken)| *is_taken) {
            let area = shown.area(&shown.tree.node_box(node));
            let is_large = area.size().into_iter().all(|side| side >= LARGE);
            let tag = shown.tag(node);
            assert!(tag.is_some() || !is_large, "{}: {node:?} {area:?}", shown.place);
            let is_in = |at: [f64; 2]| (0..2).all(|e| area.min[e] < at[e] && at[e] < area.max[e]);
            assert!(tag.is_none_or(is_in), "{}: {tag:?} {area:?}", shown.place);
            n_tags += usize::from(tag.is_some());
        }
        n_tags
    }
    let (mut in_plane, mut in_space) = (0, 0);
    plane(|shown| in_plane += check(shown));
    space(|shown| in_space += check(shown));
    assert!(in_plane > 50 && in_space > 50, "{in_plane} {in_space}");
}

#[test]
fn in_space_a_tag_lies_on_its_own_child_and_not_on_one_before_it() {
    let mut n_tags = 0;
    space(|shown| {
        let all = shown.children();
        let boxes = || all.iter().map(|(node, _)| (*node, shown.tree.node_box(*node)));
        for (node, _) in all.iter().filter(|(_, is_taken)| !is_taken) {
            let Some(at) = shown.tag(*node) else { continue };
            let sight = shown.camera.sight(PAGE, at).unwrap();
            let (from, along) = (sight.origin(), sight.direction());
            let enter = |bounds: &Aabb<3>| {
                let planes: [[f64; 2]; 3] = std::array::from_fn(|e| {
                    [bounds.min[e], bounds.max[e]].map(|side| (side - from[e]) / along[e])
                });
                let enter = planes.map(|[a, b]| a.min(b)).into_iter().fold(f64::MIN, f64::max);
                let exit = planes.map(|[a, b]| a.max(b)).into_iter().fold(f64::MAX, f64::min);
                (enter < exit).then_some(enter)
            };
            let met = boxes().filter_map(|(node, bounds)| Some((enter(&bounds)?, node)));
            let nearest = met.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, node)| node);
            assert_eq!(nearest, Some(*node), "{}", shown.place);
            n_tags += 1;
        }
    });
    assert!(n_tags > 20, "{n_tags}");
}

#[test]
fn of_the_children_that_are_not_taken_all_have_their_tag_or_none_has() {
    fn check<const D: usize>(shown: &Shown<'_, D>) -> usize {
        let others = shown.children().into_iter().filter(|(_, is_taken)| !is_taken);
        let tagged: Vec<bool> = others.map(|(node, _)| shown.tag(node).is_some()).collect();
        let n_tags = tagged.iter().filter(|has| **has).count();
        assert!(n_tags == 0 || n_tags == tagged.len(), "{}: {tagged:?}", shown.place);
        n_tags
    }
    let (mut in_plane, mut in_space) = (0, 0);
    plane(|shown| in_plane += check(shown));
    space(|shown| in_space += check(shown));
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
    fn check<const D: usize>(shown: &Shown<'_, D>) -> [usize; 2] {
        let is_current = |mark: &&Mark<D>| mark.role == Role::Current;
        let Some(mark) = shown.marks.iter().find(is_current) else { return [0; 2] };
        let Shape::Box(bounds) = mark.shape else { panic!("{mark:?}") };
        let area = shown.area(&bounds);
        let side = bounds.size().into_iter().fold(0.0, f64::max) / shown.camera.unit(PAGE);
        let small = if D == 2 { 34.0 } else { 44.0 };
        let [mut n_discs, mut n_dots] = [0; 2];
        for drawn in shown.figure.drawn.iter().filter(|drawn| drawn.part == Part::Whole) {
            let Form::Circle { centre, radius } = drawn.form else { continue };
            let reach = radius + 0.5 * Style::of(Theme::Light, drawn.role).width;
            match drawn.role {
                Role::OrderNumber if area.size().into_iter().all(|side| side < small) => {
                    let beyond: [f64; 2] = std::array::from_fn(|e| {
                        (area.min[e] - centre[e]).max(centre[e] - area.max[e]).max(0.0)
                    });
                    let away = beyond[0].hypot(beyond[1]);
                    assert!(away > radius - 0.01, "{}: {centre:?} {area:?}", shown.place);
                    n_discs += 1;
                }
                Role::EntryPoint | Role::ExitPoint => {
                    let most = (side / 3.0).max(4.01);
                    assert!(2.0 * reach <= most, "{}: {reach} of {side}", shown.place);
                    n_dots += 1;
                }
                _ => {}
            }
        }
        [n_discs, n_dots]
    }
    let (mut in_plane, mut in_space) = (Vec::new(), Vec::new());
    plane(|shown| in_plane.push(check(shown)));
    space(|shown| in_space.push(check(shown)));
    for n in [in_plane, in_space] {
        let [n_discs, n_dots] = [0, 1].map(|of| n.iter().map(|n| n[of]).sum::<usize>());
        assert!(n_discs > 500 && n_dots > 500, "{n_discs} {n_dots}");
    }
}
