//! Letters and numbers of a scene: none covers another, and the ray covers none of an axis.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use octoscope_core::gallery::Degenerate;
use octoscope_core::geometry::Aabb;
use octoscope_core::paper::{counterexample, erratum_of};
use octoscope_core::scenario::{AnyScenario, Scenario, built_in};
use octoscope_core::trace::{Moment, record};
use octoscope_core::traverse::Variant;
use octoscope_figure::{
    Camera, Drawn, Figure, Form, Mark, Page, Part, Role, Shape, Show, axes, marks, metrics,
    space_figure, space_figure_over,
};

const PAGES: [Page; 3] = [
    Page { width: 336.0, height: 290.0 },
    Page { width: 449.0, height: 365.0 },
    Page { width: 608.0, height: 510.0 },
];

/// What is written, and where: middle and half extents, as high as capitals are.
fn written(figure: &Figure) -> Vec<(&Drawn, [[f64; 2]; 2])> {
    let areas = figure.drawn.iter().filter_map(|drawn| match &drawn.form {
        Form::Text { at, anchor, text } => {
            let (width, size) = (metrics::width(drawn.role, text), metrics::size(drawn.role));
            let middle = [at[0] + (0.5 - anchor.share()) * width, at[1]];
            Some((drawn, [middle, [0.5 * width, 0.37 * size]]))
        }
        Form::Polygon(_) | Form::Polyline(_) | Form::Circle { .. } | Form::Formula { .. } => None,
    });
    areas.collect()
}

/// What lies behind numbers: its middle and half extents, and the radius of its corners.
fn tags(figure: &Figure) -> impl Iterator<Item = (Role, [f64; 2], [f64; 2], f64)> {
    figure.drawn.iter().filter_map(|drawn| match (&drawn.form, drawn.role) {
        (&Form::Circle { centre, radius }, Role::OrderNumber) => {
            Some((drawn.role, centre, [0.0; 2], radius))
        }
        (Form::Polygon(corners), Role::ChildIndex) if corners.len() == 4 => {
            let bounds = Aabb::around(corners.iter().copied())?;
            Some((drawn.role, bounds.centre(), bounds.size().map(|x| 0.5 * x), 0.0))
        }
        _ => None,
    })
}

fn overlaps(figure: &Figure) -> Vec<String> {
    let written = written(figure);
    let mut faults = Vec::new();
    for (index, (a, [at, reach])) in written.iter().enumerate() {
        let told = format!("{:?} {:?}", a.role, a.form);
        for (b, [other, extent]) in &written[..index] {
            if (0..2).all(|e| (at[e] - other[e]).abs() < reach[e] + extent[e] - 0.01) {
                faults.push(format!("{told} on {:?} {:?}", b.role, b.form));
            }
        }
        for (role, centre, half, radius) in tags(figure) {
            let beyond = [0, 1].map(|e| (centre[e] - at[e]).abs() - reach[e] - half[e]);
            // A number lies in the middle of its own.
            let is_own = (centre[0] - at[0]).hypot(centre[1] - at[1]) < 0.01;
            let is_on = match radius > 0.0 {
                true => beyond[0].max(0.0).hypot(beyond[1].max(0.0)) < radius - 0.01,
                false => beyond[0].max(beyond[1]) < -0.01,
            };
            if !is_own && is_on {
                faults.push(format!("{role:?} at {centre:?} on {told}"));
            }
        }
        let is_of_axis = matches!(a.role, Role::AxisLabel(_));
        if is_of_axis && rays(figure).any(|line| meets(line, *at, *reach)) {
            faults.push(format!("the ray on {told}"));
        }
    }
    faults
}

fn rays(figure: &Figure) -> impl Iterator<Item = [[f64; 2]; 2]> {
    figure.drawn.iter().filter_map(|drawn| match (&drawn.form, drawn.role, drawn.part) {
        (Form::Polyline(points), Role::Ray, Part::Edge) => Some([points[0], points[1]]),
        _ => None,
    })
}

/// Whether a line meets a rectangle.
fn meets([from, to]: [[f64; 2]; 2], at: [f64; 2], reach: [f64; 2]) -> bool {
    (0..=400).any(|n| {
        let share = f64::from(n) / 400.0;
        (0..2).all(|e| (from[e] + share * (to[e] - from[e]) - at[e]).abs() < reach[e])
    })
}

fn faults<const D: usize>(name: &str, scenario: &Scenario<D>) -> Vec<String> {
    let tree = scenario.tree().unwrap();
    let trace = record(&tree, &scenario.ray, &scenario.query);
    let show = Show::at_first::<D>();
    let mut faults = Vec::new();
    for page in PAGES {
        let root = tree.domain().root_box();
        let mut camera = Camera::framing(&root, page);
        camera.frame_question(&root, &scenario.ray, &scenario.query, page);
        // Some steps of long runs, all kinds of them.
        for step in (0..=trace.events.len()).step_by(1 + trace.events.len() / 24) {
            let moment = Moment::after(&tree, &trace, step);
            let event = step.checked_sub(1).and_then(|index| trace.events.get(index));
            let mut all = axes(tree.domain(), &show, &camera);
            all.extend(marks(&tree, &scenario.ray, &scenario.query, &moment, event, &show));
            all.sort_by_cached_key(|mark| mark.role.layer());
            let figure = space_figure(&all, &camera, page);
            let place = format!("{name} {}, step {step}", page.width);
            faults.extend(overlaps(&figure).into_iter().map(|fault| format!("{place}: {fault}")));
        }
    }
    faults
}

fn faults_of(name: &str, scenario: &AnyScenario) -> Vec<String> {
    match scenario {
        AnyScenario::Quadtree(scenario) => faults(name, scenario),
        AnyScenario::Octree(scenario) => faults(name, scenario),
    }
}

/// A scene along every ray of the gallery.
fn along_the_gallery(id: &str) -> Vec<(String, AnyScenario)> {
    let scenario = built_in(id).unwrap();
    let rays = Degenerate::ALL.into_iter().filter_map(|kind| {
        let mut scenario = scenario.clone();
        match &mut scenario {
            AnyScenario::Quadtree(scenario) => {
                scenario.ray = kind.ray(&scenario.tree().unwrap())?
            }
            AnyScenario::Octree(scenario) => scenario.ray = kind.ray(&scenario.tree().unwrap())?,
        }
        Some((format!("{id} {kind:?}"), scenario))
    });
    rays.collect()
}

#[test]
fn no_label_covers_another_along_the_rays_of_the_gallery_and_no_ray_one_of_an_axis() {
    let all = ["quadtree-82", "points-3d"].into_iter().flat_map(along_the_gallery);
    let all: Vec<String> = all.flat_map(|(name, scenario)| faults_of(&name, &scenario)).collect();
    assert!(all.is_empty(), "{}\n{}", all.len(), all.join("\n"));
}

#[test]
fn no_label_of_a_scene_covers_another_and_no_ray_an_axis() {
    let scenes = ["quadtree-82", "points-3d"].map(|id| (id, built_in(id).unwrap()));
    let misprints = Variant::ALL.into_iter().filter(|&variant| erratum_of(variant).is_some());
    let misprints = misprints.map(|variant| (variant.id(), counterexample(variant)));
    let all: Vec<String> = scenes
        .into_iter()
        .chain(misprints)
        .flat_map(|(name, scenario)| faults_of(name, &scenario))
        .collect();
    assert!(all.is_empty(), "{}\n{}", all.len(), all.join("\n"));
}

/// Marks of a built-in scene in space after a share of its run, and a camera.
fn in_space(show: &Show, share: f64) -> (Vec<Mark<3>>, Camera<3>) {
    let AnyScenario::Octree(scenario) = built_in("points-3d").unwrap() else { panic!() };
    let tree = scenario.tree().unwrap();
    let trace = record(&tree, &scenario.ray, &scenario.query);
    let step = 1 + (share * (trace.events.len() - 1) as f64) as usize;
    let moment = Moment::after(&tree, &trace, step);
    let event = trace.events.get(step - 1);
    let camera = Camera::framing(&tree.domain().root_box(), PAGES[2]);
    let mut all = axes(tree.domain(), show, &camera);
    all.extend(marks(&tree, &scenario.ray, &scenario.query, &moment, event, show));
    all.sort_by_cached_key(|mark| mark.role.layer());
    (all, camera)
}

#[test]
fn labels_keep_off_boxes_whoever_draws_them() {
    let texts = |figure: &Figure| -> Vec<Drawn> {
        written(figure).into_iter().map(|(drawn, _)| drawn.clone()).collect()
    };
    let mut n_labels = 0;
    for n in 0..40 {
        let show = Show { codes: n % 2 == 0, ..Show::at_first::<3>() };
        let (all, camera) = in_space(&show, f64::from(n) / 40.0);
        let is_box = |mark: &Mark<3>| {
            let is_here = matches!(mark.role, Role::Region | Role::Strayed);
            matches!(mark.shape, Shape::Box(_)) && !is_here
        };
        let (below, above): (Vec<_>, Vec<_>) = all.iter().cloned().partition(is_box);
        let [whole, parted] = [
            space_figure(&all, &camera, PAGES[2]),
            space_figure_over(&below, &above, &camera, PAGES[2]),
        ];
        assert_eq!(texts(&parted), texts(&whole), "{n}");
        n_labels += texts(&whole).len();
    }
    assert!(n_labels > 300, "{n_labels}");
}

#[test]
fn edges_yield_to_a_stronger_box_whoever_draws_that() {
    let (all, camera) = in_space(&Show::at_first::<3>(), 0.5);
    let is_strong = |mark: &Mark<3>| mark.role == Role::Current;
    let (below, above): (Vec<_>, Vec<_>) = all.iter().cloned().partition(is_strong);
    let edges = |figure: &Figure| -> Vec<Drawn> {
        let yields = |role| matches!(role, Role::Root | Role::Ancestor { .. });
        figure.drawn.iter().filter(|drawn| yields(drawn.role)).cloned().collect()
    };
    let [whole, parted] = [
        space_figure(&all, &camera, PAGES[2]),
        space_figure_over(&below, &above, &camera, PAGES[2]),
    ];
    assert_eq!(below.len(), 1);
    assert_eq!(edges(&parted), edges(&whole));
}

#[test]
fn codes_are_written_once_a_cell_and_off_the_ray() {
    let AnyScenario::Quadtree(scenario) = built_in("quadtree-82").unwrap() else { panic!() };
    let tree = scenario.tree().unwrap();
    let trace = record(&tree, &scenario.ray, &scenario.query);
    let show = Show { codes: true, ..Show::at_first::<2>() };
    let camera = Camera::framing(&tree.domain().root_box(), PAGES[2]);
    let mut n_codes = 0;
    for step in 1..=trace.events.len() {
        let moment = Moment::after(&tree, &trace, step);
        let event = trace.events.get(step - 1);
        let mut all = marks(&tree, &scenario.ray, &scenario.query, &moment, event, &show);
        all.sort_by_cached_key(|mark| mark.role.layer());
        let figure = space_figure(&all, &camera, PAGES[2]);
        let written = written(&figure);
        let codes = written.iter().filter(|(drawn, _)| drawn.role == Role::CellCode);
        let codes: Vec<_> = codes.collect();
        for (index, (code, [at, reach])) in codes.iter().enumerate() {
            assert!(codes[..index].iter().all(|(other, _)| other.node != code.node), "{code:?}");
            let is_current = code.node == moment.current;
            let is_struck = rays(&figure).any(|line| meets(line, *at, *reach));
            assert!(is_current || !is_struck, "step {step}: {code:?}");
        }
        n_codes += codes.len();
    }
    assert!(n_codes > 200, "{n_codes}");
}
