//! Arrows from node to node, and what keeps off them.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use octoscope_core::locate::{Direction, NeighbourMethod, Reach};
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::scenario::{AnyScenario, Scenario, built_in};
use octoscope_core::trace::{Moment, record};
use octoscope_core::traverse::{Algorithm, Options, Variants};
use octoscope_core::tree::{NodeId, Tree};
use octoscope_figure::{Camera, Figure, Form, Mark, Page, Part, Role, Show, marks, space_figure};

/// The space view of a lecture on a projector and in a window of 1280 × 800, and beside
/// panels.
const PAGES: [Page; 3] = [
    Page { width: 336.0, height: 362.0 },
    Page { width: 440.0, height: 362.0 },
    Page { width: 609.0, height: 510.0 },
];

/// Runs that go from node to node: along the ray, and to neighbours on all sides of some
/// of its leaves.
fn queries<const D: usize>(tree: &Tree<D>, leaves: &[NodeId]) -> Vec<Query<D>> {
    let (options, arithmetic) = (Options::default(), Arithmetic::default());
    let along = [Algorithm::Samet, Algorithm::SametCorner, Algorithm::SametNet]
        .map(|algorithm| Query::Ray { algorithm, options, arithmetic });
    let beside =
        Direction::all().zip(leaves.iter().cycle()).map(|(direction, leaf)| Query::Neighbour {
            level: tree.level(*leaf),
            code: tree.code(*leaf),
            direction,
            reach: Reach::Leaf,
            method: NeighbourMethod::Tables,
            variants: Variants::NONE,
        });
    along.into_iter().chain(beside).collect()
}

/// Looks at all moments of such runs of a scene.
fn look<const D: usize>(scenario: &Scenario<D>, mut at: impl FnMut(&str, &Figure)) {
    let tree = scenario.tree().unwrap();
    let leaves = record(&tree, &scenario.ray, &scenario.query);
    let leaves: Vec<NodeId> = leaves.leaves().map(|(leaf, _)| leaf).collect();
    for (n, query) in queries(&tree, &leaves).iter().enumerate() {
        let (trace, page) = (record(&tree, &scenario.ray, query), PAGES[n % PAGES.len()]);
        let root = tree.domain().root_box();
        let mut camera = Camera::framing(&root, page);
        camera.frame_question(&root, &scenario.ray, query, page);
        for step in 1..=trace.events.len() {
            let moment = Moment::after(&tree, &trace, step);
            let (event, show) = (trace.events.get(step - 1), Show::at_first::<D>());
            let marks = marks(&tree, &scenario.ray, query, &moment, event, &show);
            let has_arrow = |mark: &Mark<D>| matches!(mark.role, Role::WayUp | Role::WayDown);
            if !marks.iter().any(has_arrow) {
                continue;
            }
            at(&format!("{query:?}, step {step}"), &space_figure(&marks, &camera, page));
        }
    }
}

fn look_everywhere(mut at: impl FnMut(&str, &Figure)) {
    for id in ["quadtree-82", "points-3d"] {
        match built_in(id).unwrap() {
            AnyScenario::Quadtree(scenario) => look(&scenario, &mut at),
            AnyScenario::Octree(scenario) => look(&scenario, &mut at),
        }
    }
}

/// Points on the outline of a head, and its middle.
fn points_of([a, b, c]: [[f64; 2]; 3]) -> Vec<[f64; 2]> {
    let sides = [[a, b], [b, c], [c, a]].into_iter();
    let outline = sides.flat_map(|[from, to]| {
        (0..8)
            .map(move |n| std::array::from_fn(|e| from[e] + f64::from(n) / 8.0 * (to[e] - from[e])))
    });
    outline.chain([[0, 1].map(|e| (a[e] + b[e] + c[e]) / 3.0)]).collect()
}

/// Whether a point lies in a convex polygon, not at its rim.
fn lies_in(corners: &[[f64; 2]], at: [f64; 2]) -> bool {
    let next = corners.iter().cycle().skip(1);
    let offs = corners.iter().zip(next).map(|(a, b)| {
        let [x, y] = [0, 1].map(|e| b[e] - a[e]);
        (x * (at[1] - a[1]) - y * (at[0] - a[0])) / x.hypot(y)
    });
    let offs: Vec<f64> = offs.collect();
    offs.iter().all(|off| *off > 0.01) || offs.iter().all(|off| *off < -0.01)
}

/// What hides a point, if a number or a tag does.
fn hides(figure: &Figure, at: [f64; 2]) -> Option<Role> {
    let hides = figure.drawn.iter().find(|drawn| match (&drawn.form, drawn.role) {
        (Form::Circle { centre, radius }, Role::OrderNumber) => {
            (at[0] - centre[0]).hypot(at[1] - centre[1]) < radius - 0.01
        }
        (Form::Polygon(corners), Role::ChildIndex) => lies_in(corners, at),
        _ => false,
    });
    hides.map(|drawn| drawn.role)
}

#[test]
fn no_number_and_no_tag_lies_on_the_head_of_an_arrow() {
    let mut n_heads = 0;
    let mut faults = Vec::new();
    look_everywhere(|place, figure| {
        for drawn in figure.drawn.iter().filter(|drawn| drawn.part == Part::Head) {
            let Form::Polygon(corners) = &drawn.form else { panic!("{drawn:?}") };
            let points = points_of(corners[..].try_into().unwrap());
            let hidden = points.into_iter().find_map(|at| hides(figure, at));
            faults.extend(hidden.map(|role| format!("{place}: {role:?} on {drawn:?}")));
            n_heads += 1;
        }
    });
    assert!(faults.is_empty(), "{} of {n_heads}\n{}", faults.len(), faults.join("\n"));
    assert!(n_heads > 1000, "{n_heads}");
}
